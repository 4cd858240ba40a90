/* SPDX-License-Identifier: MIT */
#include "options/drawing_options.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/argp.h"
#include "base/parse.h"
#include "draw/paths.h"
#include "options/map_options.h"
#include "options/mesh_options.h"
#include "options/shading_options.h"

/* Beyond those of shading_options.c. */
enum key { KEY_ALBEDO = 320, KEY_GLOSS, KEY_PATH, KEY_BACKGROUND };

static const struct argp_option argp_options[] = {
    {"albedo", KEY_ALBEDO, "FILE", 0, "The surface's colour; alpha is ignored", 2},
    {"gloss", KEY_GLOSS, "FILE", 0, "A map that scales the highlight: white full, black none", 2},
    {"background", KEY_BACKGROUND, "COLOR", 0,
     "What the picture is drawn over, where --mask leaves pixels out or a mesh does not cover them: R,G,B or #rrggbb, "
     "or a "
     "FILE of the picture's size (default: black). A built-in scene is drawn without its wall then, a logo of --bevel "
     "alone",
     4},
    {"path", KEY_PATH, "NAME", 0,
     "The way through the library: exact (default), from normals of 8 bits exact-int8, from spans span; by tables of "
     "20 KB (rgb565 only; --dither needs --space gamma) from normals of 16 or 8 bits or from spans: colour-int16, "
     "colour-int8, colour-span; by tables of 9 KB (rgb565) over an albedo map in RGB565: albedo-int16, albedo-int8, "
     "albedo-span; or by a palette of 4096 normals (rgb565): palette",
     4},
    {NULL, 0, NULL, 0, NULL, 0}};

static bool is_color(const char *text)
{
    return *text == '#' || strspn(text, "0123456789.,") == strlen(text);
}

static void parse_background(const struct argp_state *state, const char *text, struct scene_options *o)
{
    double values[3];
    unsigned rgb[3];
    int end = 0;
    o->has_backdrop = true;
    o->backdrop = is_color(text) ? NULL : text;
    if (o->backdrop)
        return;
    if (*text != '#') {
        parse_reals(state, "--background", text, values, 3, 0, 255);
    } else {
        if (strspn(text + 1, "0123456789abcdefABCDEF") != 6 || strlen(text) != 7 ||
            sscanf(text + 1, "%2x%2x%2x%n", &rgb[0], &rgb[1], &rgb[2], &end) != 3)
            refuse(state, "--background: '%s' is not #rrggbb, six hexadecimal digits", text);
        for (unsigned k = 0; k < 3; k++)
            values[k] = rgb[k];
    }
    for (unsigned k = 0; k < 3; k++)
        o->backdrop_color[k] = (uint8_t)lround(values[k]);
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct shading_options *o = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = o;
        state->child_inputs[1] = &o->scene;
        state->child_inputs[2] = &o->scene;
        state->child_inputs[3] = &o->view;
        return 0;
    case KEY_ALBEDO:
        o->scene.albedo = text;
        return 0;
    case KEY_GLOSS:
        o->scene.gloss = text;
        return 0;
    case KEY_BACKGROUND:
        parse_background(state, text, &o->scene);
        return 0;
    case KEY_PATH:
        o->shading.path = parse_choice(state, "--path", "path", text, path_names);
        return 0;
    case ARGP_KEY_END:
        if (o->scene.albedo && o->has_color)
            refuse(state, "give only one of --albedo and --color");
        view_options_check(state, &o->view, o->scene.mesh.name);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = {{&shading_options_argp, 0, NULL, 0},
                                             {&map_options_argp, 0, NULL, 0},
                                             {&mesh_options_argp, 0, NULL, 0},
                                             {&view_options_argp, 0, NULL, 0},
                                             {NULL, 0, NULL, 0}};
const struct argp drawing_options_argp = {argp_options, parse_option, NULL, NULL, children, NULL, NULL};
