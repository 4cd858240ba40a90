/* SPDX-License-Identifier: MIT */
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "base/argp.h"
#include "base/output.h"
#include "base/parse.h"
#include "base/unknown.h"
#include "image/format.h"
#include "draw/paths.h"
#include "image/write.h"
#include "options/drawing_options.h"
#include "options/render_options.h"

enum key { KEY_IMAGE = 384, KEY_COMPARE, KEY_JSON, KEY_ERROR_MAP, KEY_AGAINST, KEY_GOURAUD, KEY_REPLICATE };

/* Beside those of shading_options.c, where group 4 has its heading. */
static const struct argp_option argp_options[] = {
    {NULL, 'o', "FILE", 0, "The picture to write; - is standard output. With --compare it may be left out", 4},
    {"image", KEY_IMAGE, "KIND", 0,
     "png, ppm or qoi (default: by FILE's ending, png where it has none), or raw: the pixels of --format as they lie "
     "in memory, lines from the top without gaps or a header",
     4},
    {"replicate", KEY_REPLICATE, NULL, 0,
     "Widen the levels of RGB565 to the picture's 8 bits as many panels do, by repeating their high bits, not to the "
     "nearest; at most 1 of 255 differs",
     4},
    {"gouraud", KEY_GOURAUD, NULL, 0,
     "Draw a mesh as Gouraud shading would, in double precision, to compare: colours at the corners, interpolated "
     "between them, as renderers without a highlight at every pixel do",
     4},
    {NULL, 0, NULL, 0, "Quality:", 5},
    {"compare", KEY_COMPARE, NULL, 0,
     "Print the errors against the same model and against Blinn in double precision, "
     "each rounded to the format and not; on standard error with -o -",
     5},
    {"json", KEY_JSON, NULL, 0, "What --compare prints, as JSON", 5},
    {"error-map", KEY_ERROR_MAP, "FILE", 0,
     "Also write the absolute error against the unrounded reference as a "
     "picture, amplified by a power of two, which is printed",
     5},
    {"against", KEY_AGAINST, "NAME", 0, "The error map's reference: same (default: the same model) or blinn", 5},
    {NULL, 0, NULL, 0, NULL, 0}};

static const char doc[] =
    "Shades a height map, a normal map, a mesh or a built-in scene with the integer library and writes the picture."
    "\v"
    "PNG, PPM and QOI have 8 bits a sample: a level v of 0..m becomes v 255 / m, rounded to the nearest. In RGB565 m "
    "is 31 for red and blue and 63 for green, so 16 of 31 becomes 132; 3 of 31 becomes 25, by --replicate 24.\n"
    "\n"
    "Examples:\n"
    "  glint render --height wall.png --albedo wall-color.png -o out.png\n"
    "  glint render --normals brick.png --flip-y -n 120 --light 1,1,0.5 -o out.png\n"
    "  glint render --scene coin --size 240x240 --format rgb565 --dither -o c.png\n"
    "  glint render --scene watchface -o - | chafa\n"
    "  glint render --scene dial --size 240x240 --format rgb565-swapped \\\n"
    "      --image raw -o dial.bin\n"
    "  glint render --scene coin --light=-1,1,2,.5,.5,.5 \\\n"
    "      --point 240,80,60,300,1,.7,.3 -o lamps.png\n"
    "  glint render --mesh part.stl --turn 20,30,0 --perspective -o part.png\n"
    "  glint render --scene teapot --size 240x240 --compare -o teapot.png\n"
    "  glint render --scene sphere -n 300 --error-map e.png --against blinn\n";

static enum image_kind kind_of_file(const struct argp_state *state, const char *option, const char *path)
{
    const enum image_kind kind = image_kind_by_ending(path);
    if (kind == IMAGE_KINDS)
        refuse(state, "%s: '%s' does not end in .png, .ppm or .qoi; rename it, or give --image", option, path);
    return kind;
}

static void parse_image_kind(const struct argp_state *state, const char *text, struct render_options *o)
{
    const char *names[IMAGE_KINDS + 2] = {NULL};
    for (int i = 0; i < IMAGE_KINDS; i++)
        names[i] = image_kind_names[i];
    names[IMAGE_KINDS] = "raw";
    o->raw = strcasecmp(text, "raw") == 0;
    if ((o->kind = image_kind_by_name(text)) == IMAGE_KINDS && !o->raw)
        refuse_unknown(state, "--image", "file format", text, names);
}

/* A picture that memory does not hold is drawn in parts. */
static void check_size(const struct argp_state *state, const struct render_options *o)
{
    const struct scene_options *scene = &o->look.scene;
    const char *why = scene->mesh.name                        ? "a mesh"
                      : o->compare                            ? "--compare"
                      : !path_draws_all(o->look.shading.path) ? "this --path"
                      : scene->bevel > 0                      ? "--bevel"
                      : scene->filter                         ? "--filter"
                                                              : NULL;
    if (why && scene->width * scene->height > PIXELS_MAX)
        refuse(state, "--size: with %s a picture has at most %d pixels in all", why, PIXELS_MAX);
}

static void check_outputs(const struct argp_state *state, struct render_options *o)
{
    if (!o->output && !o->compare)
        refuse(state, "no output; give -o FILE, or --compare");
    if (o->output && output_is_standard(o->output) && isatty(STDOUT_FILENO))
        refuse(state, "-o -: standard output is a terminal; pipe or redirect it, or name a file");
    if (o->gouraud && (!o->look.scene.mesh.name || o->raw))
        refuse(state, o->raw ? "--image raw is what the library writes; it cannot be used with --gouraud"
                             : "--gouraud needs a mesh; give --mesh FILE or --scene teapot");
    if (o->gouraud && format_has_alpha(o->look.shading.format))
        refuse(state, "--gouraud draws no alpha; choose another --format than %s",
               format_names[o->look.shading.format]);
    if (o->widen == WIDEN_REPLICATE && (o->raw || !o->output))
        refuse(state, o->raw ? "--replicate cannot be used with --image raw, whose pixels are as the library wrote them"
                             : "--replicate is for the picture of -o; give -o FILE");
    if (o->widen == WIDEN_REPLICATE && format_max(o->look.shading.format, 0) == 255)
        refuse(state, "--replicate needs --format rgb565 or rgb565-swapped: other levels have 8 bits");
    if (o->error_map && output_is_standard(o->error_map))
        refuse(state, "--error-map: name a file; only the picture of -o can go to standard output");
    if (o->error_map && o->output && output_same(o->error_map, o->output))
        refuse(state, "--error-map: this is the file of -o, too; name another");
    if (o->against_blinn && !o->error_map)
        refuse(state, "--against needs --error-map");
    if (o->output && o->kind == IMAGE_KINDS && !o->raw)
        o->kind = kind_of_file(state, "-o", o->output);
    if (o->output && o->kind == IMAGE_PPM && !o->raw && !o->gouraud && format_has_alpha(o->look.shading.format))
        refuse(state, "--format %s: a PPM file has no alpha; choose another format, or PNG, QOI or raw by --image",
               format_names[o->look.shading.format]);
    if (o->error_map)
        o->error_map_kind = kind_of_file(state, "--error-map", o->error_map);
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    static const char *const references[] = {"same", "blinn", NULL};
    struct render_options *o = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &o->look;
        return 0;
    case 'o':
        o->output = parse_output(state, "-o", text);
        return 0;
    case KEY_GOURAUD:
        o->gouraud = true;
        return 0;
    case KEY_REPLICATE:
        o->widen = WIDEN_REPLICATE;
        return 0;
    case KEY_IMAGE:
        parse_image_kind(state, text, o);
        return 0;
    case KEY_JSON:
        o->json = true;
        o->compare = true;
        return 0;
    case KEY_COMPARE:
        o->compare = true;
        return 0;
    case KEY_ERROR_MAP:
        o->error_map = parse_output(state, "--error-map", text);
        o->compare = true;
        return 0;
    case KEY_AGAINST:
        o->against_blinn = parse_choice(state, "--against", "reference", text, references);
        return 0;
    case ARGP_KEY_ARG:
        scene_options_argument(state, text, &o->look.scene);
        return 0;
    case ARGP_KEY_END:
        check_size(state, o);
        check_outputs(state, o);
        shading_options_check(state, &o->look, &o->look.shading);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

void render_options_parse(struct render_options *options, int argc, char **argv)
{
    static const struct argp_child children[] = {{&drawing_options_argp, 0, NULL, 0}, {NULL, 0, NULL, 0}};
    static const struct argp argp = {argp_options, parse_option, SCENE_ARGUMENT, doc, children, NULL, NULL};
    *options = (struct render_options){.kind = IMAGE_KINDS};
    parse_command(&argp, 0, argc, argv, options);
}
