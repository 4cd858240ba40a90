/* SPDX-License-Identifier: MIT */
#include "mesh/obj_materials.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "mesh/lines.h"

static const struct mesh_material plain = {.has_color = true, .color = {153, 153, 153}, .factor = {1, 1, 1}};

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
        materials->of = enlarge(materials->of, materials->room, sizeof *materials->of);
    }
    materials->of[materials->count] = (struct obj_material){.name = copied(name), .look = plain, .scale = {1, 1}};
    return materials->count++;
}

/* ---- what an MTL says ---- */

static bool take_color(char *at, double out[3])
{
    for (int k = 0; k < 3; k++) {
        const char *word = lines_word(&at);
        if (!word || !lines_number(word, &out[k]))
            return false;
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

/* Up to three numbers, as far as they go: a picture's name may begin as what is not a number. */
static char *take_numbers(char *at, double numbers[3])
{
    for (int k = 0; k < 3; k++) {
        char *end = at, *stop = at + strspn(at, " \t\v\f");
        stop += strcspn(stop, " \t\v\f");
        const char blank = *stop; /* which becomes 0 */
        double number;
        const char *word = lines_word(&end);
        if (!word || !lines_number(word, &number) || isnan(number)) {
            *stop = blank;
            break;
        }
        numbers[k] = number;
        at = end;
    }
    return at;
}

static bool are_equal(const double a[3], const double b[3])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

static void leave_out(const struct obj_materials *materials, const char *option, const char *what)
{
    char text[120];
    snprintf(text, sizeof text, "%s %.30s of a map_Kd is left out", what, option);
    materials->note(text);
}

/* Options stand before the name: each has a word behind it, or numbers. */
static void take_picture(const struct obj_materials *materials, struct obj_material *material, char *at)
{
    enum { SCALE, MOVE, OTHER };
    static const char *const words = " -blendu -blendv -cc -clamp -texres -type -imfchan -boost -bm ";
    static const struct {
        const char *name;
        double usual[3];
    } options[] = {{"-s", {1, 1, 1}}, {"-o", {0}}, {"-t", {0}}, {"-mm", {0, 1}}};
    double numbers[sizeof options / sizeof *options][3];
    bool clamps = false;
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        memcpy(numbers[i], options[i].usual, sizeof numbers[i]);
    while (*at == '-') {
        char spaced[24];
        const char *option = lines_word(&at), *word;
        size_t i = 0;
        while (i < sizeof options / sizeof *options && strcmp(options[i].name, option) != 0)
            i++;
        snprintf(spaced, sizeof spaced, " %.20s ", option);
        if (i < sizeof options / sizeof *options) {
            at = take_numbers(at, numbers[i]);
            if (i >= OTHER && !are_equal(numbers[i], options[i].usual))
                leave_out(materials, option, "the option");
        } else if (!strstr(words, spaced)) {
            leave_out(materials, option, "the picture behind the unknown option");
            return;
        } else if ((word = lines_word(&at)) == NULL) {
            return;
        } else if (strcmp(option, "-clamp") == 0) {
            clamps = strcmp(word, "on") == 0;
        }
        at += strspn(at, " \t\v\f");
    }
    if (!*at)
        return;
    free(material->picture);
    material->picture = copied(at);
    material->look.clamps = clamps;
    for (int k = 0; k < 2; k++) {
        material->scale[k] = numbers[SCALE][k];
        material->move[k] = numbers[MOVE][k];
    }
}

void obj_materials_read(struct obj_materials *materials, const char *text, size_t len)
{
    struct lines lines;
    struct obj_material *now = NULL;
    char *rest;
    double parts[3];
    materials->bytes += len;
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
            double n;
            const char *word = lines_word(&rest);
            if (word && lines_number(word, &n))
                now->look.n = n >= 1 ? (unsigned)fmin(1000, n) : 0;
        } else if (lines_begins(&lines, "illum", &rest)) {
            now->look.unlit = strcmp(rest, "0") == 0;
        } else if (lines_begins(&lines, "map_Kd", &rest)) {
            take_picture(materials, now, rest);
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
    soup->pictures[soup->picture_count].name = copied(name);
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
