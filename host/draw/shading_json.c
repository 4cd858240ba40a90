/* SPDX-License-Identifier: MIT */
#include "draw/shading_json.h"

#include <jansson.h>

#include "base/message.h"
#include "image/format.h"
#include "models/models.h"

static json_t *channels(const uint32_t values[3])
{
    return json_pack("[I, I, I]", (json_int_t)values[0], (json_int_t)values[1], (json_int_t)values[2]);
}

static json_t *direction(const double values[3])
{
    int32_t whole[3];
    direction_integers(values, whole);
    return json_pack("[i, i, i]", whole[0], whole[1], whole[2]);
}

void shading_print_json(const struct shading *shading, FILE *out)
{
    const struct glint_material m = shading_material(shading);
    json_t *root = json_pack(
        "{s:s, s:i, s:i, s:i, s:o, s:o, s:o, s:o, s:o, s:[i, i, i], s:s, s:s, s:b, s:b}", "model",
        model_names[shading->model], "n", (int)shading->n, "n_across", (int)shading->n_across, "q", (int)shading->q,
        "to_light", direction(shading->lamps[0].direction), "to_viewer", direction(shading->view), "ambient_q16",
        channels(m.ambient_q16), "diffuse_q16", channels(m.diffuse_q16), "specular_q16", channels(m.specular_q16),
        "albedo", m.albedo[0], m.albedo[1], m.albedo[2], "format", format_names[shading->format], "space",
        space_names[shading->space], "dither", (int)shading->dither, "clamp_peak", (int)shading->clamp_peak);
    if (!root || json_dumpf(root, out, JSON_INDENT(2)) != 0)
        fail("the material could not be written as JSON");
    fputc('\n', out);
    json_decref(root);
}
