/* SPDX-License-Identifier: MIT */
#include "options/drawing_options.h"

#include "options/mesh_options.h"
#include "options/shading_options.h"

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    (void)text;
    struct shading_options *o = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = o;
        state->child_inputs[1] = &o->scene;
        state->child_inputs[2] = &o->view;
        return 0;
    case ARGP_KEY_END:
        view_options_check(state, &o->view, o->scene.mesh.name);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = {{&shading_options_argp, 0, NULL, 0},
                                             {&mesh_options_argp, 0, NULL, 0},
                                             {&view_options_argp, 0, NULL, 0},
                                             {NULL, 0, NULL, 0}};
const struct argp drawing_options_argp = {NULL, parse_option, NULL, NULL, children, NULL, NULL};
