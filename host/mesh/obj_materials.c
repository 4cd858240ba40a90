/* SPDX-License-Identifier: MIT */
#include "mesh/obj_materials.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "mesh/lines.h"

static const struct mesh_material plain = {.has_color = true, .color = {153, 153, 153}, .factor = {1, 1, 1}};

static char *copy_of(const char *text)
{
    char *copy = strdup(text);
    if (!copy)
        fail("out of memory");
    return copy;
}

void obj_materials_free(struct obj_materials *materials)
{
    for (unsigned i = 0; i < materials->count; i++) {
        free(materials->of[i].name);
        free(materials->of[i].picture);
    }
    free(materials->of);
}

unsigned obj_materials_find(struct obj_materials *materials, const char *name)
{
    for (unsigned i = 0; i < materials->count; i++)
        if (strcmp(materials->of[i].name, name) == 0)
            return i;
    if (materials->count == OBJ_MATERIALS_MAX)
        return OBJ_MATERIALS_MAX;
    if (materials->count == materials->room) {
        materials->room = materials->room ? 2 * materials->room : 4;
        struct obj_material *grown = realloc(materials->of, materials->room * sizeof *grown);
        if (!grown)
            fail("out of memory");
        materials->of = grown;
    }
    materials->of[materials->count] = (struct obj_material){.name = copy_of(name), .look = plain};
    return materials->count++;
}

/* ---- what an MTL says ---- */

static bool take_color(char *at, double out[3])
{
    for (int k = 0; k < 3; k++) {
        const char *word = lines_word(&at);
        float part;
        if (!word || !lines_number(word, &part))
            return false;
        out[k] = (double)part;
    }
    return true;
}

/* Its hue: how strong it is the command says. Programs write black for what they do not know. */
static void take_highlight(struct mesh_material *look, const double parts[3])
{
    const double positive[3] = {fmax(0, parts[0]), fmax(0, parts[1]), fmax(0, parts[2])};
    const double most = fmax(positive[0], fmax(positive[1], positive[2]));
    look->has_highlight = most > 0 && most < 1e30;
    for (int k = 0; k < 3; k++)
        look->highlight[k] = look->has_highlight ? positive[k] / most : 0;
}

/* Options stand before the name: each has so many words behind it, or numbers. */
static void take_picture(struct obj_material *material, char *at)
{
    static const struct {
        const char *name;
        int words, numbers;
    } options[] = {{"-blendu", 1, 0}, {"-blendv", 1, 0},  {"-cc", 1, 0},    {"-clamp", 1, 0}, {"-texres", 1, 0},
                   {"-type", 1, 0},   {"-imfchan", 1, 0}, {"-boost", 1, 0}, {"-bm", 1, 0},    {"-mm", 0, 2},
                   {"-o", 0, 3},      {"-s", 0, 3},       {"-t", 0, 3}};
    bool clamps = false;
    while (*at == '-') {
        const char *option = lines_word(&at), *word = "";
        size_t i = 0;
        float number;
        while (i < sizeof options / sizeof *options && strcmp(options[i].name, option) != 0)
            i++;
        if (i == sizeof options / sizeof *options)
            return; /* of another kind */
        if (options[i].words && (word = lines_word(&at)) == NULL)
            return;
        if (strcmp(option, "-clamp") == 0)
            clamps = strcmp(word, "on") == 0;
        for (int k = 0; k < options[i].numbers; k++) {
            char *behind = at, *copy = copy_of(at), *in_copy = copy;
            const bool good = (word = lines_word(&in_copy)) != NULL && lines_number(word, &number);
            behind += in_copy - copy;
            free(copy);
            if (!good)
                break;
            at = behind;
        }
        at += strspn(at, " \t\v\f");
    }
    if (!*at)
        return;
    free(material->picture);
    material->picture = copy_of(at);
    material->look.clamps = clamps;
}

void obj_materials_read(struct obj_materials *materials, const char *text, size_t len)
{
    struct lines lines;
    struct obj_material *now = NULL;
    char *rest;
    double parts[3];
    lines_begin(&lines, text, len);
    while (lines_next(&lines)) {
        if (lines_begins(&lines, "newmtl", &rest)) {
            const unsigned found = obj_materials_find(materials, rest);
            now = found < OBJ_MATERIALS_MAX ? &materials->of[found] : NULL;
            if (now && !now->part)
                now->part = ++materials->part_count;
            continue;
        }
        if (!now)
            continue;
        if (lines_begins(&lines, "Kd", &rest) && take_color(rest, parts)) {
            for (int k = 0; k < 3; k++)
                now->look.color[k] = mesh_level(parts[k]);
        } else if (lines_begins(&lines, "Ks", &rest) && take_color(rest, parts)) {
            take_highlight(&now->look, parts);
        } else if (lines_begins(&lines, "Ns", &rest)) {
            float n;
            const char *word = lines_word(&rest);
            if (word && lines_number(word, &n))
                now->look.n = n >= 1 ? (unsigned)fminf(1000, n) : 0;
        } else if (lines_begins(&lines, "illum", &rest)) {
            now->look.unlit = strcmp(rest, "0") == 0;
        } else if (lines_begins(&lines, "map_Kd", &rest)) {
            take_picture(now, rest);
        }
    }
    lines_end(&lines);
}

/* ---- parts ---- */

/* Programs name one picture in many materials. */
static unsigned picture_of(struct soup *soup, const char *name)
{
    for (unsigned i = 0; i < soup->picture_count; i++)
        if (strcmp(soup->pictures[i].name, name) == 0)
            return i + 1;
    soup->pictures[soup->picture_count].name = copy_of(name);
    return ++soup->picture_count;
}

void obj_materials_give(const struct obj_materials *materials, struct soup *soup, bool pictures)
{
    soup->part_count = materials->part_count + 1;
    soup->materials = allocate(soup->part_count, sizeof *soup->materials);
    soup->pictures = allocate(soup->part_count, sizeof *soup->pictures);
    soup->materials[materials->part_count] = plain;
    for (unsigned i = 0; i < materials->count; i++) {
        const struct obj_material *from = &materials->of[i];
        if (!from->part)
            continue;
        struct mesh_material *to = &soup->materials[from->part - 1];
        *to = from->look;
        if (from->picture && pictures) {
            to->picture = picture_of(soup, from->picture);
            mesh_material_set_factor(to);
        } else {
            to->clamps = false;
        }
    }
}
