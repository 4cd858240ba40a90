/* SPDX-License-Identifier: MIT
 * glint material: the shader that glint render's options describe, for a program that fills it in itself. */
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
#include "scene/scenes.h"

enum { KEY_NAME = 384, KEY_JSON };

struct request {
    struct shading_options look;
    const char *name, *path;
    bool json;
};

static const struct argp_option options[] = {
    {NULL, 'o', "FILE", 0, "Where it goes; default: standard output", 4},
    {"name", KEY_NAME, "NAME", 0, "The function's name in C and C++; default: material", 4},
    {"json", KEY_JSON, NULL, 0, "JSON instead of C source", 4},
    {0}};

static const char doc[] =
    "Prints a material, a light and a pixel format as a C function that fills a struct glint_shader: the shader with "
    "which glint render draws under the same options."
    "\v"
    "No surface is needed; --scene NAME takes the material of a built-in scene. Maps are not part of a shader: hand "
    "them to glint_shade_rect in a struct glint_source.\n"
    "The light must be one --light without a colour; points, spots and colours are lamps of glint_shade_lights.\n"
    "In JSON, numbers are those of glint.h: _q16 is 65536 for 1.0; directions are whole numbers of any length.\n"
    "\n"
    "Examples:\n"
    "  glint material --model cayley -n 60 --ambient .2 --format rgb565\n"
    "  glint material --scene coin --name coin_init -o coin-material.h\n"
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
    case 'o':
        request->path = parse_output(state, "-o", text);
        return 0;
    case ARGP_KEY_ARG:
        refuse(state, "unexpected argument '%s'; -o names a file", text);
    case ARGP_KEY_END:
        if (request->name && request->json)
            refuse(state, "--name is for C source; leave it out with --json");
        if (!shading_is_plain(&request->look.shading))
            refuse(state, "a shader has one --light without a colour; others are lamps of glint_shade_lights");
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

static void put_direction(FILE *out, const char *name, const double direction[3])
{
    int32_t whole[3];
    direction_integers(direction, whole);
    fprintf(out, "    static const int32_t %s[3] = {%" PRId32 ", %" PRId32 ", %" PRId32 "};\n", name, whole[0],
            whole[1], whole[2]);
}

static void put_channels(FILE *out, const char *name, const uint32_t values[3])
{
    for (int k = 0; k < 3; k++)
        fprintf(out, "    shader_->material.%s[%d] = %" PRIu32 ";\n", name, k, values[k]);
}

/* Assignments, not an initialiser with names, which C++11 has not; names end in _, as the function's name does not. */
static void write_source(FILE *out, const struct shading *shading, const char *name)
{
    const struct glint_shader shader = shading_shader(shading);
    const uint32_t albedo[3] = {shader.material.albedo[0], shader.material.albedo[1], shader.material.albedo[2]};
    fprintf(out,
            "/* Written by glint material, version " GLINT_VERSION_STRING ": %s, n = %u, q = %u, %s%s, %s. */\n"
            "#include \"glint.h\"\n\n"
            "/* Fills the whole shader. A light that moves: glint_light_init(&shader->light, ...) again. */\n"
            "static inline void %s(struct glint_shader *shader_)\n{\n",
            model_names[shading->model], shading->n, shading->q, format_names[shading->format],
            shading->dither ? " dithered" : "", space_names[shading->space], name);
    put_direction(out, "to_light_", shading->lamps[0].direction);
    put_direction(out, "to_viewer_", shading->view);
    fputs("    glint_lobe_init(&shader_->lobe, ", out);
    put_constant(out, model_names[shading->model]);
    fprintf(out, ", %u, %u);\n    (void)glint_light_init(&shader_->light, to_light_, to_viewer_);\n", shading->n,
            shading->q);
    put_channels(out, "ambient_q16", shader.material.ambient_q16);
    put_channels(out, "diffuse_q16", shader.material.diffuse_q16);
    put_channels(out, "specular_q16", shader.material.specular_q16);
    put_channels(out, "albedo", albedo);
    fputs("    shader_->format = ", out);
    put_constant(out, format_names[shading->format]);
    fputs(";\n    shader_->space = ", out);
    put_constant(out, space_names[shading->space]);
    fprintf(out, ";\n    shader_->dither = %s;\n    shader_->clamp_peak = %s;\n}\n", shading->dither ? "true" : "false",
            shading->clamp_peak ? "true" : "false");
}

/* ---- the command ---- */

/* What suits the scene where the user says nothing; the plain finish without one. */
static struct shading shading_of_request(const struct request *request)
{
    return shading_of_options(&request->look, request->look.shading.format, scene_finish(request->look.scene.scene));
}

int command_material(int argc, char **argv)
{
    static const struct argp_child children[] = {{&shading_options_argp, 0, NULL, 0}, {NULL, 0, NULL, 0}};
    static const struct argp argp = {options, parse_option, NULL, doc, children, NULL, NULL};
    struct request request = {.path = "-"};
    parse_command(&argp, 0, argc, argv, &request);
    const struct shading shading = shading_of_request(&request);
    struct output *output = output_open(request.path);
    if (request.json)
        shading_print_json(&shading, output->stream);
    else
        write_source(output->stream, &shading, request.name ? request.name : "material");
    output_close(output);
    return EXIT_GOOD;
}
