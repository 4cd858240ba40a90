/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "base/argp.h"
#include "base/parse.h"
#include "scene/scenes.h"
#include "options/scene_options.h"

/* Beyond those of the commands, whose keys begin at 256. */
enum key { KEY_SCENE = 512 };

static const struct argp_option argp_options[] = {
    {NULL, 0, NULL, 0, "The surface:", 1},
    {"scene", KEY_SCENE, "NAME", 0,
     "A built-in scene, also without --scene: sphere, watchface, coin, dial (the watch without "
     "numerals), knob (metal with spun grain) or sunray "
     "(a dial with sunray grain), or the mesh teapot",
     1},
    {NULL, 0, NULL, 0, NULL, 0}};

void scene_options_choose(const struct argp_state *state, const char *option, const char *text,
                          struct scene_options *options)
{
    const char *names[16] = {NULL};
    unsigned scenes = 0, all;
    for (; scene_names[scenes]; scenes++)
        names[scenes] = scene_names[scenes];
    for (all = scenes; mesh_names[all - scenes]; all++)
        names[all] = mesh_names[all - scenes];
    const unsigned chosen = parse_choice(state, option, "scene", text, names);
    if (options->mesh.built_in) { /* chosen before */
        options->mesh.name = NULL;
        options->mesh.built_in = false;
    }
    options->scene = names[chosen];
    if (options->mesh.name && !options->mesh.built_in)
        refuse(state, "give only one of --height, --normals, --scene and --mesh");
    if (chosen >= scenes) {
        options->mesh.name = names[chosen];
        options->mesh.built_in = true;
    }
}

void scene_options_argument(const struct argp_state *state, const char *text, struct scene_options *options)
{
    if (options->scene)
        refuse(state, "unexpected argument '%s'; one scene is enough", text);
    if (strpbrk(text, "./"))
        refuse(state, "unexpected argument '%s'; name files by --height, --normals, --mesh and -o", text);
    scene_options_choose(state, NULL, text, options);
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct scene_options *o = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        *o = (struct scene_options){.scale = NAN, .mesh = {.crease = -1, .axes = AXES_USUAL}};
        return 0;
    case KEY_SCENE:
        scene_options_choose(state, "--scene", text, o);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp scene_options_argp = {argp_options, parse_option, NULL, NULL, NULL, NULL, NULL};
