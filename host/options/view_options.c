/* SPDX-License-Identifier: MIT */
#include "options/view_options.h"

#include "base/argp.h"
#include "base/message.h"
#include "base/parse.h"

/* Beyond those of scene_options.c. */
enum key { KEY_TURN = 640, KEY_ZOOM, KEY_PERSPECTIVE };
static const double usual_distance = 4;

static const struct argp_option argp_options[] = {
    {NULL, 0, NULL, 0, NULL, 7},
    {"turn", KEY_TURN, "X,Y,Z", 0,
     "Turn the mesh by so many degrees: about the vertical axis by Y, then about the horizontal one by X, then about "
     "the line of sight by Z (default 0,0,0; teapot 25,-30,0)",
     7},
    {"zoom", KEY_ZOOM, "Z", 0, "How large the mesh is drawn (default 1: whatever its turn, it fills the picture)", 7},
    {"perspective", KEY_PERSPECTIVE, "DISTANCE", OPTION_ARG_OPTIONAL,
     "Draw in perspective. DISTANCE is from the camera to the mesh's middle, in radii of a ball around the mesh, "
     "1.5..100 (default 4; without --perspective: parallel)",
     7},
    {NULL, 0, NULL, 0, NULL, 0}};

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct view_options *o = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        *o = (struct view_options){.view = {.zoom = 1}};
        return 0;
    case KEY_TURN:
        parse_reals(state, "--turn", text, o->view.turn, 3, -3600, 3600);
        o->given = o->turned = true;
        return 0;
    case KEY_ZOOM:
        o->view.zoom = parse_real(state, "--zoom", text, .01, 1000);
        o->given = true;
        return 0;
    case KEY_PERSPECTIVE:
        o->view.distance = text ? parse_real(state, "--perspective", text, 1.5, 100) : usual_distance;
        o->given = true;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp view_options_argp = {argp_options, parse_option, NULL, NULL, NULL, NULL, NULL};

void view_options_check(const struct argp_state *state, const struct view_options *options, bool has_mesh)
{
    if (options->given && !has_mesh)
        refuse(state, "--turn, --zoom and --perspective need a mesh; give --mesh FILE or --scene teapot");
}

struct view view_of_options(const struct view_options *options, uint32_t width, uint32_t height, bool built_in)
{
    struct view view = options->view;
    view.width = width;
    view.height = height;
    if (built_in && !options->turned) {
        view.turn[0] = 25;
        view.turn[1] = -30;
    }
    if (view_refusal(&view))
        fail("%s", view_refusal(&view));
    return view;
}
