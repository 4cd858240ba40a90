/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/argp.h"
#include "base/message.h"
#include "base/parse.h"
#include "draw/paths.h"
#include "image/format.h"
#include "models/models.h"
#include "options/light_options.h"
#include "options/shading_options.h"
#include "scene/filter.h"
#include "scene/materials.h"
#include "scene/scenes.h"

/* The commands' own keys begin at 384. */
enum key {
    KEY_COLOR = 256,
    KEY_MODEL,
    KEY_ROUGHNESS,
    KEY_LIGHT,
    KEY_POINT,
    KEY_SPOT,
    KEY_VIEW,
    KEY_AMBIENT,
    KEY_DIFFUSE,
    KEY_SPECULAR,
    KEY_CLAMP_PEAK,
    KEY_FORMAT,
    KEY_SPACE,
    KEY_DITHER,
    KEY_MATERIAL,
    KEY_ACROSS
};
enum { Q_UNSET = 255 };

static const struct shading_options shading_options_default = {
    .roughness = NAN,
    .shading = {.model = GLINT_MSH,
                .q = Q_UNSET,
                .view = {0, 0, 1},
                .ambient = {NAN, NAN, NAN},
                .diffuse = {NAN, NAN, NAN},
                .specular = {NAN, NAN, NAN},
                .color = {200, 200, 200},
                .format = GLINT_RGB888,
                .space = GLINT_GAMMA},
};

/* scene_options.c has the surface's. */
static const struct argp_option argp_options[] = {
    {"color", KEY_COLOR, "R,G,B", 0, "The surface's one colour, 0..255 each (default 200,200,200, or the scene's own)",
     1},

    {NULL, 0, NULL, 0, "The light and the material:", 3},
    {"material", KEY_MATERIAL, "NAME", 0,
     PRESET_WORDS "each with its shininess, colour, --ambient, --diffuse and --specular where no option gives them", 3},
    {"model", KEY_MODEL, "NAME", 0, "The highlight: " MODEL_WORDS "default: msh", 3},
    {NULL, 'n', "N", 0, "Shininess, 1..1000 (default 60, or the scene's own)", 3},
    {"roughness", KEY_ROUGHNESS, "R", 0,
     "In the place of -n: glTF's roughness, 0..1. n = 2 / R^4 - 2, the GGX lobe's; below .211 it counts as .211, n = "
     "1000",
     3},
    {"across", KEY_ACROSS, "N", 0,
     "Shininess across the grain, 1..1000; -n is along it. Metal has a lower one (default: no grain, or the scene's or "
     "the material's)",
     3},
    {NULL, 'q', "Q", 0,
     "A highlight under 2^-Q counts as 0; 1..16 (default, and 0: 12 for --space linear, else 6 for rgb565, grey4, "
     "grey2 and mono undithered, else 8)",
     3},
    {"light", KEY_LIGHT, "X,Y,Z[,R,G,B]", 0,
     "The direction to the light, of any length: x right, y up, z to you (default -1,1,1 if no light is given), and "
     "its colour, 0..16 each (default 1,1,1). Up to four of --light, --point and --spot together",
     3},
    {"point", KEY_POINT, "X,Y,Z,RANGE[,R,G,B]", 0,
     "A light at a place, in pixels to a sixteenth: x right and y down from the upper left corner, z to you. Its light "
     "falls to 0 at RANGE pixels",
     3},
    {"spot", KEY_SPOT, "X,Y,Z,TX,TY,RANGE,INNER,OUTER[,R,G,B]", 0,
     "A --point aimed at TX,TY on the surface, or as deep as a mesh's middle: full within INNER degrees of its "
     "axis, 0 beyond OUTER",
     3},
    {"view", KEY_VIEW, "X,Y,Z", 0, "The direction to the viewer (default 0,0,1)", 3},
    {"ambient", KEY_AMBIENT, "A", 0,
     "Light from everywhere, 0..1: one number or R,G,B (default .2, or the scene's own)", 3},
    {"diffuse", KEY_DIFFUSE, "D", 0,
     "What the surface scatters, 0..1: one number or R,G,B (default .9, or the scene's own)", 3},
    {"specular", KEY_SPECULAR, "S", 0,
     "How strong the highlight is, 0..1: one number or R,G,B (default .5, or the scene's "
     "own)",
     3},
    {"clamp-peak", KEY_CLAMP_PEAK, NULL, 0, "Limit the highlight to 1 (msh reaches 1.024)", 3},

    {NULL, 0, NULL, 0, "The picture:", 4},
    {"format", KEY_FORMAT, "NAME", 0,
     "The display's pixels: " FORMAT_WORDS
     "default: rgb888, or the device's. As LVGL has them bgr888, xrgb8888 and argb8888 have blue first; the alpha of "
     "argb8888 is the mask; PNG, QOI, WebP and raw keep it",
     4},
    {"space", KEY_SPACE, "NAME", 0,
     "The space in which light is summed: gamma (default: as encoded) or linear (sRGB decoded and encoded)", 4},
    {"dither", KEY_DITHER, NULL, 0, "4x4 ordered dither; not with --path albedo-* or palette", 4},
    {NULL, 0, NULL, 0, NULL, 0}};

static void parse_coefficients(const struct argp_state *state, const char *option, const char *text, double out[3])
{
    const bool one = !strchr(text, ',');
    parse_reals(state, option, text, out, one ? 1 : 3, 0, 1);
    if (one)
        out[1] = out[2] = out[0];
}

static void parse_color(const struct argp_state *state, const char *text, struct shading_options *options)
{
    double values[3];
    parse_reals(state, "--color", text, values, 3, 0, 255);
    for (unsigned k = 0; k < 3; k++)
        options->shading.color[k] = (uint8_t)lround(values[k]);
    options->has_color = true;
}

/* Once all options are read and good: an error stands alone, and -n may have come after it. */
static void say_roughness(const struct shading_options *options)
{
    const double n = shininess_of_roughness(options->roughness);
    if (fabs(options->shading.n - n) > 0.5) /* of NaN false */
        warn("--roughness %g: n = %.0f is beyond 1..%u; drawn with %u", options->roughness, n, GLINT_N_MAX,
             options->shading.n);
}

static void say_texture(const struct shading_options *options)
{
    if (options->scene.mesh.texture && shading_options_one_color(options))
        warn("--texture is left out: %s draws a mesh in one colour", options->has_color ? "--color" : "--material");
}

static void parse_view(const struct argp_state *state, const char *text, double view[3])
{
    parse_reals(state, "--view", text, view, 3, -1e6, 1e6);
    check_direction(state, "--view", view);
}

static error_t parse_shading(int key, char *text, const struct argp_state *state, struct shading *shading)
{
    switch (key) {
    case KEY_ACROSS:
        shading->n_across = (unsigned)parse_integer(state, "--across", text, 1, GLINT_N_MAX);
        return 0;
    case 'q':
        shading->q = (unsigned)parse_integer(state, "-q", text, 0, GLINT_Q_MAX);
        return 0;
    case KEY_MODEL:
        shading->model = parse_model(state, "--model", text);
        return 0;
    case KEY_LIGHT:
        parse_light(state, text, shading);
        return 0;
    case KEY_POINT:
        parse_point(state, text, shading);
        return 0;
    case KEY_SPOT:
        parse_spot(state, text, shading);
        return 0;
    case KEY_VIEW:
        parse_view(state, text, shading->view);
        return 0;
    case KEY_AMBIENT:
        parse_coefficients(state, "--ambient", text, shading->ambient);
        return 0;
    case KEY_DIFFUSE:
        parse_coefficients(state, "--diffuse", text, shading->diffuse);
        return 0;
    case KEY_SPECULAR:
        parse_coefficients(state, "--specular", text, shading->specular);
        return 0;
    case KEY_CLAMP_PEAK:
        shading->clamp_peak = true;
        return 0;
    case KEY_SPACE:
        shading->space = (enum glint_space)parse_choice(state, "--space", "colour space", text, space_names);
        return 0;
    case KEY_DITHER:
        shading->dither = true;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void default_to(double values[3], const double defaults[3])
{
    for (unsigned k = 0; k < 3; k++)
        if (isnan(values[k]))
            values[k] = defaults[k];
}

static void check_grain(const struct argp_state *state, const struct shading_options *options)
{
    const struct shading *shading = &options->shading;
    const unsigned n = shading->n ? shading->n : scene_finish(options->scene.scene)->n;
    const bool is_grained = shading->n_across && shading->n_across != n;
    char names[200] = "";
    if ((!is_grained && !options->scene.filter) || model_has_grain(shading->model))
        return;
    for (unsigned i = 0; model_names[i]; i++)
        if (model_has_grain((enum glint_model)i)) {
            strcat(names, *names ? ", " : "");
            strcat(names, model_names[i]);
        }
    refuse(state, "%s: %s %s; choose one of %s", is_grained ? "--across" : "--filter", model_names[shading->model],
           is_grained ? "has no grain" : "takes no map of shininess", names);
}

/* The material's values where no option gave one. A metal keeps the grain of a scene that has one. */
static void take_material(struct shading_options *o, const struct preset *preset)
{
    struct shading *shading = &o->shading;
    if (!shading->n)
        shading->n = preset->finish.n;
    if (!shading->n_across && model_has_grain(shading->model))
        shading->n_across = preset->finish.n_across ? preset->finish.n_across : preset->is_metal ? 0 : shading->n;
    default_to(shading->ambient, preset->finish.ambient);
    default_to(shading->diffuse, preset->finish.diffuse);
    default_to(shading->specular, preset->finish.specular);
    if (o->has_color)
        return;
    memcpy(shading->color, preset->color, sizeof shading->color);
    memcpy(o->scene.body, preset->color, sizeof o->scene.body);
    o->scene.has_body = true;
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct shading_options *o = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        *o = shading_options_default;
        state->child_inputs[0] = &o->scene;
        return 0;
    case 'n':
        o->shading.n = (unsigned)parse_integer(state, "-n", text, 1, GLINT_N_MAX);
        o->roughness = NAN;
        return 0;
    case KEY_ROUGHNESS:
        o->roughness = parse_real(state, "--roughness", text, 0, 1);
        o->shading.n = shininess_held(shininess_of_roughness(o->roughness));
        return 0;
    case KEY_MATERIAL:
        o->material = parse_choice(state, "--material", "material", text, preset_names);
        o->has_material = true;
        return 0;
    case KEY_COLOR:
        parse_color(state, text, o);
        return 0;
    case KEY_FORMAT:
        o->shading.format = (enum glint_format)parse_choice(state, "--format", "format", text, format_names);
        o->has_format = true;
        return 0;
    case KEY_ACROSS:
        o->has_across = true;
        return parse_shading(key, text, state, &o->shading);
    case KEY_VIEW:
        o->has_view = true;
        return parse_shading(key, text, state, &o->shading);
    case ARGP_KEY_END:
        o->has_light = o->shading.lamp_count > 0;
        check_grain(state, o);
        if (o->has_material) {
            const struct preset preset = preset_of(o->material);
            take_material(o, &preset);
        }
        check_lamps(state, &o->shading);
        return 0;
    case ARGP_KEY_SUCCESS:
        say_roughness(o);
        say_texture(o);
        return 0;
    default:
        return parse_shading(key, text, state, &o->shading);
    }
}

static const struct argp_child children[] = {{&scene_options_argp, 0, NULL, 0}, {NULL, 0, NULL, 0}};
const struct argp shading_options_argp = {argp_options, parse_option, NULL, NULL, children, NULL, NULL};

void shading_options_check(const struct argp_state *state, const struct shading_options *options,
                           const struct shading *shading)
{
    const struct mesh_source *mesh = &options->scene.mesh;
    struct mesh_path of_mesh;
    if (!mesh->name && options->scene.has_backdrop && format_has_alpha(shading->format))
        refuse(
            state,
            "--background: in --format %s a scene's soft edges are alpha, not blended with it; leave one of them out",
            format_names[shading->format]);
    const char *refusal = mesh->name ? path_of_mesh(shading, false, &of_mesh) : path_refusal(shading);
    if (refusal && mesh->name && (!mesh->built_in || mesh->texture) && !shading_options_one_color(options) &&
        !path_of_mesh(shading, true, &of_mesh))
        return; /* the file tells */
    if (refusal)
        refuse(state, "--path %s: %s", path_names[shading->path], refusal);
}

bool shading_options_one_color(const struct shading_options *options)
{
    return options->has_color || options->has_material;
}

static struct scene *as_wished(const struct shading_options *options, struct scene *scene)
{
    if (options->has_color) {
        free(scene->albedo);
        scene->albedo = NULL;
    }
    scene_soften(scene, options->shading.n ? options->shading.n : scene->finish.n, options->shading.color);
    return scene;
}

struct scene *scene_of_shading_options(const struct shading_options *options, const struct scene_maps *maps,
                                       uint32_t width, uint32_t height)
{
    return as_wished(options, scene_of_maps(maps, width, height));
}

struct scene *scene_lines_of_shading_options(const struct shading_options *options, struct scene_lines *lines,
                                             uint32_t top, uint32_t count)
{
    return as_wished(options, scene_lines_make(lines, top, count));
}

struct shading shading_of_options(const struct shading_options *options, enum glint_format format,
                                  const struct finish *finish)
{
    struct shading shading = options->shading;
    shading.format = format;
    if (!shading.n)
        shading.n = finish->n;
    if (!shading.n_across && model_has_grain(shading.model))
        shading.n_across = finish->n_across;
    /* a mesh has that of its material where --grain says which way */
    if (shading.n_across == shading.n ||
        (options->scene.mesh.name && !options->scene.has_grain && !options->has_across))
        shading.n_across = 0;
    default_to(shading.ambient, finish->ambient);
    default_to(shading.diffuse, finish->diffuse);
    default_to(shading.specular, finish->specular);
    if (shading.q == Q_UNSET)
        shading.q = 0;
    shading.q = shading_q(&shading);
    return shading;
}

void shading_options_grain(const struct shading_options *options, struct fitted *fitted)
{
    static const double right[3] = {1, 0, 0};
    const double *axis = options->scene.has_grain ? options->scene.grain.at : right;
    fitted->mesh.use_grain = &glint_use_mesh_grain;
    for (int k = 0; k < 3; k++)
        fitted->mesh.grain[k] = (int16_t)lround(32767 * axis[k]);
}

struct mesh_own shading_options_own(const struct shading_options *options)
{
    const struct shading *shading = &options->shading;
    return (struct mesh_own){!shading_options_one_color(options), !shading->n,
                             !options->has_material && isnan(shading->ambient[0]) && isnan(shading->diffuse[0]) &&
                                 isnan(shading->specular[0])};
}
