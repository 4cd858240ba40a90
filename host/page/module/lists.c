/* SPDX-License-Identifier: MIT
 * What can be chosen by name, for the page's controls. */
#include <stdio.h>

#include "base/message.h"
#include "draw/paths.h"
#include "image/format.h"
#include "mesh/load.h"
#include "models/models.h"
#include "page.h"
#include "scene/materials.h"
#include "scene/scenes.h"

const char *page_lists(void)
{
    static char *text;
    static size_t len;
    if (text)
        return text;
    FILE *out = open_memstream(&text, &len);
    if (!out)
        fail("out of memory");
    for (unsigned i = 0; model_names[i]; i++) {
        const struct model_facts *facts = model_facts[i];
        fprintf(out, "models\t%s\t%s\t%s\t%s\n", model_names[i], facts->title, facts->meaning, facts->formula);
    }
    for (unsigned i = 0; format_names[i]; i++)
        fprintf(out, "formats\t%s\t%s\t%s\t\n", format_names[i], format_names[i], format_meaning((enum glint_format)i));
    for (unsigned i = 0; path_names[i]; i++)
        fprintf(out, "paths\t%s\t%s\t\t\n", path_names[i], path_names[i]);
    for (unsigned i = 0; preset_names[i]; i++) {
        const struct preset preset = preset_of(i);
        fprintf(out, "materials\t%s\t%s\t%s\t\n", preset.name, preset.name, preset.meaning);
    }
    for (unsigned i = 0; scene_names[i]; i++)
        fprintf(out, "scenes\t%s\t%s\t\t\n", scene_names[i], scene_names[i]);
    for (unsigned i = 0; mesh_names[i]; i++)
        fprintf(out, "scenes\t%s\t%s\t\t\n", mesh_names[i], mesh_names[i]);
    if (fclose(out) != 0)
        fail("out of memory");
    return text;
}
