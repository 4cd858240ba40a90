/* SPDX-License-Identifier: MIT
 * glint material: the material, the output and the lights that glint render's options describe, for a program of one's own. */
#include <ctype.h>
#include <inttypes.h>
#include <string.h>

#include "base/argp.h"
#include "base/c_names.h"
#include "base/message.h"
#include "base/output.h"
#include "base/parse.h"
#include "commands/commands.h"
#include "draw/shading.h"
#include "draw/shading_json.h"
#include "image/format.h"
#include "models/models.h"
#include "options/shading_options.h"
#include "scene/maps.h"
#include "scene/materials.h"
#include "scene/scenes.h"

enum { KEY_NAME = 384, KEY_JSON, KEY_PRESET, KEY_LIST, KEY_ALL };

struct request {
    struct shading_options look;
    const char *name, *path;
    bool json, list, all;
};

static const struct argp_option options[] = {
    {"preset", KEY_PRESET, "NAME", 0, "The same as --material", 3},
    {NULL, 'o', "FILE", 0, "Where it goes; default: standard output", 4},
    {"name", KEY_NAME, "NAME", 0, "The material's name in C and C++; default: material", 4},
    {"json", KEY_JSON, NULL, 0, "JSON instead of C source", 4},
    {"list", KEY_LIST, NULL, 0, "Instead: list the materials that have names, and where their colours are from", 4},
    {"all", KEY_ALL, NULL, 0, "Instead: all of them as one C header (lib/examples/materials.h)", 4},
    {0}};

static const char doc[] =
    "Prints a material, a pixel format and lights as C source: the struct glint_material and struct glint_output by "
    "which "
    "glint render draws under the same options, and a function that lights a paint so."
    "\v"
    "No surface is needed; --scene NAME takes the material of a built-in scene. Maps are not part of a material: hand "
    "them to glint_draw_rect in a struct glint_maps.\n"
    "The source defines NAME, a struct glint_material, NAME_output and NAME_light(paint, lights), which takes "
    "NAME_light_count lights to fill.\n"
    "In JSON, numbers are those of glint.h: _q16 is 65536 for 1.0; directions are whole numbers of any length. Its "
    "light "
    "must be one --light without a colour.\n"
    "\n"
    "Examples:\n"
    "  glint material --model cayley -n 60 --ambient .2 --format rgb565\n"
    "  glint material --list\n"
    "  glint material --preset brushed-steel --name steel -o steel.h\n"
    "  glint material --scene coin --name coin -o coin-material.h\n"
    "  glint material -n 200 --specular .8,.7,.5 --json\n";

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct request *request = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &request->look;
        return 0;
    case KEY_NAME:
        request->name = parse_c_name(state, text);
        return 0;
    case KEY_JSON:
        request->json = true;
        return 0;
    case KEY_PRESET:
        request->look.material = parse_choice(state, "--preset", "material", text, preset_names);
        request->look.has_material = true;
        return 0;
    case KEY_LIST:
        request->list = true;
        return 0;
    case KEY_ALL:
        request->all = true;
        return 0;
    case 'o':
        request->path = parse_output(state, "-o", text);
        return 0;
    case ARGP_KEY_ARG:
        refuse(state, "unexpected argument '%s'; -o names a file", text);
    case ARGP_KEY_END:
        if (request->list + request->all + request->json > 1)
            refuse(state, "give only one of --list, --all and --json");
        if ((request->list || request->all) && (request->name || request->look.has_material))
            refuse(state, "%s is of all materials; leave out %s", request->list ? "--list" : "--all",
                   request->name ? "--name" : "--material and --preset");
        if (request->name && request->json)
            refuse(state, "--name is for C source; leave it out with --json");
        if (request->json && !shading_is_plain(&request->look.shading))
            refuse(state, "--json: has one --light without a colour; leave --json out for other lights");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* ---- C source ---- */

/* "rgb565-swapped" is GLINT_RGB565_SWAPPED. */
static void put_constant(FILE *out, const char *name)
{
    fputs("GLINT_", out);
    for (; *name; name++)
        fputc(*name == '-' ? '_' : toupper((unsigned char)*name), out);
}

static void put_channels(FILE *out, const uint32_t values[3], const char *name)
{
    fprintf(out, "    {%" PRIu32 ", %" PRIu32 ", %" PRIu32 "}, /* %s */\n", values[0], values[1], values[2], name);
}

static void put_material(FILE *out, const struct glint_material *material, const char *name)
{
    const struct glint_material m = *material;
    fprintf(out, "static const struct glint_material %s = {\n    ", name);
    put_constant(out, model_names[m.model]);
    fprintf(out, ", %u, %u, %u, /* model, q, n, n_across */\n", m.q, m.n, m.n_across);
    put_channels(out, m.ambient_q16, "ambient");
    put_channels(out, m.diffuse_q16, "diffuse");
    put_channels(out, m.specular_q16, "specular");
    fprintf(out, "    {%u, %u, %u}, /* albedo */\n    %s /* clamp_peak */\n};\n", m.albedo[0], m.albedo[1], m.albedo[2],
            m.clamp_peak ? "true" : "false");
}

static void write_material(FILE *out, const struct shading *shading, const char *name)
{
    const struct glint_material material = shading_material(shading);
    put_material(out, &material, name);
    fprintf(out, "static const struct glint_output %s_output = {", name);
    put_constant(out, format_names[shading->format]);
    fputs(", ", out);
    put_constant(out, space_names[shading->space]);
    fprintf(out, ", %s /* dither */};\n\n", shading->dither ? "true" : "false");
}

static void put_numbers(FILE *out, const char *name, unsigned i, const int32_t values[3])
{
    fprintf(out, "    static const int32_t %s_%u_[3] = {%" PRId32 ", %" PRId32 ", %" PRId32 "};\n", name, i, values[0],
            values[1], values[2]);
}

/* What a light's function takes. */
static void put_light_data(FILE *out, const struct lamp *lamp, unsigned i)
{
    int32_t to_light[3];
    direction_integers(lamp->direction, to_light);
    if (lamp->kind == LAMP_DIRECTIONAL) {
        put_numbers(out, "to_light", i, to_light);
        return;
    }
    const double target[3] = {lamp->target[0], lamp->target[1], 0};
    int32_t whole[3];
    place_integers(lamp->position, whole);
    put_numbers(out, "position", i, whole);
    place_integers(target, whole);
    if (lamp->kind == LAMP_SPOT)
        put_numbers(out, "target", i, whole);
}

static void put_light(FILE *out, const struct lamp *lamp, const struct glint_light *light, unsigned i)
{
    fputs("    if (error_ == GLINT_OK)\n        error_ = ", out);
    if (lamp->kind == LAMP_DIRECTIONAL)
        fprintf(out, "glint_light_directional(&lights_[%u], to_light_%u_);\n", i, i);
    else if (lamp->kind == LAMP_POINT)
        fprintf(out, "glint_light_point(&lights_[%u], position_%u_, %" PRIu32 "u);\n", i, i, light->range);
    else
        fprintf(out,
                "glint_light_spot(&lights_[%u], position_%u_, target_%u_, %" PRIu32 "u, %" PRId32 ", %" PRId32 ");\n",
                i, i, i, light->range, light->cos_inner_q30, light->cos_outer_q30);
    for (unsigned k = 0; k < 3; k++)
        if (light->color_q16[k] != 65536)
            fprintf(out, "    lights_[%u].color_q16[%u] = %" PRIu32 "u;\n", i, k, light->color_q16[k]);
}

/* Names of locals end in _, as the material's name does not. */
static void write_lights(FILE *out, const struct shading *shading, const char *name)
{
    struct glint_light lights[GLINT_LIGHTS_MAX];
    int32_t to_viewer[3];
    shading_lights(shading, lights);
    direction_integers(shading->view, to_viewer);
    fprintf(out,
            "enum { %s_light_count = %u };\n\n"
            "/* Lights a paint. The lights stay as they are until the drawing is done; one --light is copied. */\n"
            "static inline enum glint_err %s_light(struct glint_paint *paint_, struct glint_light *lights_)\n{\n",
            name, shading->lamp_count, name);
    for (unsigned i = 0; i < shading->lamp_count; i++)
        put_light_data(out, &shading->lamps[i], i);
    fprintf(out, "    static const int32_t to_viewer_[3] = {%" PRId32 ", %" PRId32 ", %" PRId32 "};\n", to_viewer[0],
            to_viewer[1], to_viewer[2]);
    fputs("    enum glint_err error_ = GLINT_OK;\n", out);
    for (unsigned i = 0; i < shading->lamp_count; i++)
        put_light(out, &shading->lamps[i], &lights[i], i);
    fprintf(out,
            "    return error_ == GLINT_OK ? glint_paint_light(paint_, lights_, %s_light_count, to_viewer_) : error_;\n"
            "}\n",
            name);
}

/* Of enum glint_use_format's names: which makes the exact paint of this output. */
static const char *use_of_format(const struct shading *shading)
{
    if (shading->space == GLINT_LINEAR)
        return "linear";
    if (format_channels(shading->format) == 1)
        return "grey";
    return format_is_565(shading->format) ? "rgb565" : "rgb888";
}

static void write_source(FILE *out, const struct shading *shading, const char *name)
{
    fprintf(out,
            "/* Written by glint material, version " GLINT_VERSION_STRING ": %s, n = %u, q = %u, %s%s, %s.\n"
            " *\n"
            " *   struct glint_light lights[%s_light_count];\n"
            " *   glint_paint_exact_for(&paint, &%s, &%s_output, &glint_use_%s%s, &glint_use_%s);\n"
            " *   %s_light(&paint, lights);\n"
            " */\n"
            "#include \"glint.h\"\n\n",
            model_names[shading->model], shading->n, shading->q, format_names[shading->format],
            shading->dither ? " dithered" : "", space_names[shading->space], name, name, name,
            model_names[shading->model], shading->n_across && shading->n_across != shading->n ? "_grain" : "",
            use_of_format(shading), name);
    write_material(out, shading, name);
    write_lights(out, shading, name);
}

/* ---- all that have names ---- */

static void write_list(FILE *out)
{
    for (unsigned i = 0; preset_names[i]; i++) {
        const struct preset preset = preset_of(i);
        fprintf(out, "%-14s %s\n%-14s   %s\n", preset.name, preset.meaning, "", preset.source);
    }
}

/* material_brushed_steel */
static void name_in_c(const char *name, char *out, size_t size)
{
    snprintf(out, size, "material_%s", name);
    for (; *out; out++)
        if (*out == '-')
            *out = '_';
}

/* q = 0: what the output needs. */
static struct glint_material material_of_preset(const struct preset *preset)
{
    struct shading shading = {.model = GLINT_MSH, .n = preset->finish.n, .n_across = preset->finish.n_across};
    memcpy(shading.ambient, preset->finish.ambient, sizeof shading.ambient);
    memcpy(shading.diffuse, preset->finish.diffuse, sizeof shading.diffuse);
    memcpy(shading.specular, preset->finish.specular, sizeof shading.specular);
    memcpy(shading.color, preset->color, sizeof shading.color);
    return shading_material(&shading);
}

static void write_all(FILE *out)
{
    fputs("/* SPDX-License-Identifier: MIT\n"
          " * Materials by name, written by `glint material --all`, version " GLINT_VERSION_STRING
          ": make a paint of one by glint_paint_exact.\n"
          " * One with n_across has a grain: say its direction in struct glint_maps. */\n"
          "#ifndef GLINT_EXAMPLES_MATERIALS_H\n#define GLINT_EXAMPLES_MATERIALS_H\n\n#include \"glint.h\"\n\n/* "
          "clang-format off */\n",
          out);
    for (unsigned i = 0; preset_names[i]; i++) {
        const struct preset preset = preset_of(i);
        char name[64];
        name_in_c(preset.name, name, sizeof name);
        const struct glint_material material = material_of_preset(&preset);
        fprintf(out, "\n/* %s: %s. */\n", preset.meaning, preset.source);
        put_material(out, &material, name);
    }
    fputs("\n#endif\n", out);
}

/* ---- the command ---- */

/* What suits the scene where the user says nothing; the plain finish without one. */
static struct shading shading_of_request(const struct request *request)
{
    return shading_of_options(&request->look, request->look.shading.format, scene_finish(request->look.scene.scene));
}

static void write_one(const struct request *request, FILE *out)
{
    const struct shading shading = shading_of_request(request);
    if (request->json)
        shading_print_json(&shading, out);
    else
        write_source(out, &shading, request->name ? request->name : "material");
}

int command_material(int argc, char **argv)
{
    static const struct argp_child children[] = {{&shading_options_argp, 0, NULL, 0}, {NULL, 0, NULL, 0}};
    static const struct argp argp = {options, parse_option, NULL, doc, children, NULL, NULL};
    struct request request = {.path = "-"};
    parse_command(&argp, 0, argc, argv, &request);
    struct output *output = output_open(request.path);
    if (request.list)
        write_list(output->stream);
    else if (request.all)
        write_all(output->stream);
    else
        write_one(&request, output->stream);
    output_close(output);
    return EXIT_GOOD;
}
