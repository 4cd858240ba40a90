/* SPDX-License-Identifier: MIT */
#include "options/map_options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/argp.h"
#include "base/parse.h"
#include "image/picture.h"
#include "scene/logo.h"
#include "scene/maps.h"

/* Beyond those of scene_options.c. */
enum key {
    KEY_HEIGHT = 544,
    KEY_NORMALS,
    KEY_SCALE,
    KEY_BEVEL,
    KEY_FIT,
    KEY_WRAP,
    KEY_FLIP_Y,
    KEY_MASK,
    KEY_SIZE,
    KEY_GRAIN,
    KEY_CUT_OUT,
    KEY_FILTER
};

static const struct argp_option argp_options[] = {
    {"height", KEY_HEIGHT, "FILE", 0,
     "A height map: white near, black far; of colours the brightness counts. With --bevel a logo", 1},
    {"normals", KEY_NORMALS, "FILE", 0,
     "A normal map with 8 or 16 bits a sample: red right, green up, blue towards the viewer. Vectors are renormalised; "
     "z is reconstructed if blue is 0 everywhere, or if grey and alpha are x and y. Of RGB with alpha, pixels that are "
     "transparent are left out, as by --mask",
     1},

    {NULL, 0, NULL, 0, "The maps, PNG or SVG files of one size (- is standard input):", 2},
    {"mask", KEY_MASK, "FILE", 0,
     "What is drawn: black pixels have no surface, show the background and are not compared; greys are soft edges. If "
     "a mask has transparent pixels, its alpha counts instead",
     2},
    {"scale", KEY_SCALE, "S", 0,
     "The height of white above black in pixels; negative turns hills into hollows (default 8, or --bevel's WIDTH)", 2},
    {"bevel", KEY_BEVEL, "WIDTH", 0,
     "The picture of --height is a logo: a rounded edge rises over WIDTH pixels from the edge of its shape inwards. "
     "The shape is what alpha covers, or in an opaque picture what differs in brightness from the picture's rim",
     2},
    {"fit", KEY_FIT, "PERCENT", 0,
     "The logo of --bevel in the middle of --size, its shape scaled so that it takes PERCENT of the width or of the "
     "height, 1..100",
     2},
    {"wrap", KEY_WRAP, NULL, 0,
     "The height map is seamless: take slopes across its edges (the default if --size repeats it)", 2},
    {"flip-y", KEY_FLIP_Y, NULL, 0, "The normal map's green points down, as in DirectX", 2},
    {"cut-out", KEY_CUT_OUT, NULL, 0,
     "Leave out the wall behind a built-in scene, or with --bevel what is not the logo, with a soft edge", 2},
    {"filter", KEY_FILTER, "N", 0,
     "Draw at 1/N of the size, 2..64: N x N pixels of the maps become one. What their normals scatter becomes a wider, "
     "weaker "
     "highlight (a map of shininess and one of gloss), so that fine details do not glitter. A built-in scene is first "
     "drawn N times as large",
     2},
    {"grain", KEY_GRAIN, "KIND", 0,
     "Which way the scratches of brushed metal run, for a material with --across: brushed:ANGLE, degrees "
     "counterclockwise "
     "from the right (default brushed:0); spun, round the picture's middle, or spun:X,Y, round a pixel; sunray, away "
     "from "
     "it, or sunray:X,Y; or a grey FILE, in which 256 levels are a half turn. On a mesh it runs along an axis: "
     "brushed:ANGLE in its x and y, or axis:X,Y,Z",
     2},
    {"size", KEY_SIZE, "WxH", 0,
     "Draw a scene at this size (default 320x320; glint stream: see SCENE). A map is cut or repeated to this size, "
     "never scaled (a logo: see --fit); an SVG is drawn at it (default: the map's own size)",
     2},

    {NULL, 0, NULL, 0, NULL, 0}};

/* ---- the options ---- */

bool map_options_in_parts;

static void parse_size(const struct argp_state *state, const char *text, struct scene_options *o)
{
    unsigned width, height;
    int end = 0;
    if (strspn(text, "0123456789x") == strlen(text) && sscanf(text, "%5ux%5u%n", &width, &height, &end) == 2 &&
        !text[end] && width >= 1 && width <= SIDE_MAX && height >= 1 && height <= SIDE_MAX &&
        (map_options_in_parts || width * height <= PIXELS_MAX)) {
        o->width = width;
        o->height = height;
        return;
    }
    if (map_options_in_parts)
        refuse(state, "--size: '%s' is not WxH, two numbers from 1 to %d", text, SIDE_MAX);
    refuse(state, "--size: '%s' is not WxH, two numbers from 1 to %d with at most %d pixels in all", text, SIDE_MAX,
           PIXELS_MAX);
}

unsigned map_options_standard_input(const struct scene_options *o)
{
    const char *const maps[] = {
        o->heights,  o->normals, o->albedo, o->gloss, o->mask, o->grain_map, o->has_backdrop ? o->backdrop : NULL,
        o->mesh.name};
    unsigned count = 0;
    for (size_t i = 0; i < sizeof maps / sizeof *maps; i++)
        count += maps[i] && strcmp(maps[i], "-") == 0;
    return count;
}

/* Where a kind is named, what follows its colon, "" where nothing does; else NULL. */
static const char *after_kind(const char *text, const char *kind)
{
    const size_t length = strlen(kind);
    if (strncmp(text, kind, length) != 0 || (text[length] && text[length] != ':'))
        return NULL;
    return text[length] ? text + length + 1 : "";
}

static void parse_grain(const struct argp_state *state, const char *text, struct scene_options *o)
{
    const char *spun = after_kind(text, "spun"), *sunray = after_kind(text, "sunray");
    const char *brushed = after_kind(text, "brushed"), *axis = after_kind(text, "axis");
    const char *const centre = spun ? spun : sunray;
    o->has_grain = true;
    o->grain_map = NULL;
    o->grain_is_axis = axis;
    o->grain = (struct grain){.kind = spun ? GLINT_GRAIN_SPUN : sunray ? GLINT_GRAIN_SUNRAY : GLINT_GRAIN_BRUSHED};
    if (centre && !*centre) {
        o->grain.at[0] = o->grain.at[1] = NAN;
    } else if (centre) {
        parse_reals(state, "--grain", centre, o->grain.at, 2, -SIDE_MAX, 2 * SIDE_MAX);
    } else if (axis) {
        double *const at = o->grain.at;
        parse_reals(state, "--grain", axis, at, 3, -1e6, 1e6);
        const double largest = fmax(fabs(at[0]), fmax(fabs(at[1]), fabs(at[2])));
        if (largest == 0)
            refuse(state, "--grain: axis:0,0,0 is no direction");
        for (int k = 0; k < 3; k++)
            at[k] /= largest; /* whose squares may be too small or large */
        const double length = sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
        for (int k = 0; k < 3; k++)
            at[k] /= length;
    } else if (brushed) {
        const double turn = *brushed ? parse_real(state, "--grain", brushed, -360, 360) * M_PI / 180 : 0;
        o->grain.at[0] = cos(turn);
        o->grain.at[1] = sin(turn);
    } else {
        o->grain_map = text;
    }
}

static void check(const struct argp_state *state, struct scene_options *o)
{
    if (o->cut_out && !(o->scene && !o->mesh.name) && !(o->bevel > 0))
        refuse(state, "--cut-out needs a built-in scene, or a logo with --bevel");
    if (o->filter && o->width * o->filter > SIDE_MAX)
        refuse(state, "--filter %u: a surface %u times as wide as --size is more than %d pixels", o->filter, o->filter,
               SIDE_MAX);
    if (o->mesh.name && o->filter)
        refuse(state, "--filter is for maps; it cannot be used with a mesh");
    if (o->mesh.name && o->has_grain && (o->grain_map || o->grain.kind != GLINT_GRAIN_BRUSHED))
        refuse(state, "--grain: a mesh takes brushed:ANGLE or axis:X,Y,Z");
    if (!o->mesh.name && o->has_grain && o->grain_is_axis)
        refuse(state, "--grain: axis:X,Y,Z is for a mesh; choose brushed:ANGLE");
    const int sources = !!o->heights + !!o->normals + !!o->scene + (o->mesh.name && !o->mesh.built_in);
    if (sources > 1)
        refuse(state, "give only one of --height, --normals, --scene and --mesh");
    if (sources == 0 && !o->on_device)
        refuse(state, "no surface; give --height FILE, --normals FILE, --scene NAME or --mesh FILE");
    if (map_options_standard_input(o) > 1)
        refuse(state, "only one map can come from standard input; name files for the others");
    if (!o->heights && (o->wraps || !isnan(o->scale)))
        refuse(state, "%s needs --height", o->wraps ? "--wrap" : "--scale");
    if (o->bevel > 0 && !o->heights)
        refuse(state, "--bevel needs --height");
    if (o->bevel > 0 && o->wraps)
        refuse(state, "--wrap cannot be used with --bevel: a logo has no seams");
    if (o->fit > 0 && !(o->bevel > 0))
        refuse(state, "--fit needs a logo, with --bevel");
    if (o->fit > 0 && (o->width < LOGO_SIDE_MIN || o->height < LOGO_SIDE_MIN))
        refuse(state, "--fit needs --size, of at least %dx%d", LOGO_SIDE_MIN, LOGO_SIDE_MIN);
    if (o->fit > 0 && o->filter && !picture_size_fits(o->filter * o->width, o->filter * o->height))
        refuse(state, "--fit: with --filter %u the logo is drawn with more than %d pixels", o->filter, PIXELS_MAX);
    if (!o->normals && o->flip_y)
        refuse(state, "--flip-y needs --normals");
    if (isnan(o->scale))
        o->scale = o->bevel > 0 ? o->bevel : 8;
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct scene_options *o = state->input;
    switch (key) {
    case KEY_HEIGHT:
        o->heights = text;
        return 0;
    case KEY_NORMALS:
        o->normals = text;
        return 0;
    case KEY_SCALE:
        o->scale = parse_real(state, "--scale", text, -10000, 10000);
        return 0;
    case KEY_BEVEL:
        o->bevel = parse_real(state, "--bevel", text, 1, 10000);
        return 0;
    case KEY_FIT:
        o->fit = parse_real(state, "--fit", text, 1, 100);
        return 0;
    case KEY_WRAP:
        o->wraps = true;
        return 0;
    case KEY_FLIP_Y:
        o->flip_y = true;
        return 0;
    case KEY_MASK:
        o->mask = text;
        return 0;
    case KEY_GRAIN:
        parse_grain(state, text, o);
        return 0;
    case KEY_FILTER:
        o->filter = (unsigned)parse_integer(state, "--filter", text, 2, 64);
        return 0;
    case KEY_CUT_OUT:
        o->cut_out = true;
        return 0;
    case KEY_SIZE:
        parse_size(state, text, o);
        return 0;
    case ARGP_KEY_END:
        check(state, o);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp map_options_argp = {argp_options, parse_option, NULL, NULL, NULL, NULL, NULL};
