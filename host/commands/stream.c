/* SPDX-License-Identifier: MIT
 * glint stream: its options. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/argp.h"
#include "base/memory.h"
#include "base/parse.h"
#include "commands/commands.h"
#include "draw/shading.h"
#include "light_protocol.h"
#include "options/drawing_options.h"
#include "options/map_options.h"
#include "sinks/options.h"
#include "sinks/sinks.h"
#include "stream/iio.h"
#include "stream/stream.h"

enum key { KEY_TO = 384, KEY_FPS, KEY_FRAMES, KEY_ORBIT, KEY_PERIOD, KEY_LIGHTS, KEY_STATS, KEY_JSON, KEY_SHADE };
static const double usual_period = 4, usual_turn_period = 8;
enum { SHADE_HOST, SHADE_DEVICE, SHADE_DEMO };
static const char *const shade_names[] = {"host", "device", "demo", NULL};

static const struct argp_option argp_options[] = {
    {NULL, 0, NULL, 0, "The light that moves, or the mesh:", 5},
    {"orbit", KEY_ORBIT, "DEGREES", 0,
     "The first --light circles around the viewer's direction at this angle (default: its own, or 30 where no light is "
     "given). Where there are only points and spots, the first circles around the picture's middle",
     5},
    {"period", KEY_PERIOD, "SECONDS", 0,
     "Time for one turn of the light (default 4), or of a mesh about its vertical axis (default 8), whose light stands "
     "still without --orbit and --lights; 0: nothing turns",
     5},
    {"lights", KEY_LIGHTS, "FILE", 0,
     "Instead of the orbit: the direction of each frame from a file or standard input (-), one a line: X Y Z or "
     "X,Y,Z. Empty lines and lines that begin with # are skipped. Or iio: this computer's accelerometer, by Linux; the "
     "light is straight above however the display is tilted (iio:FOLDER: one that is elsewhere than in "
     "/sys/bus/iio/devices). Or board: the accelerometer of the board that shades (--to usb --shade device)",
     5},
    {"light-from", 0, NULL, OPTION_ALIAS, NULL, 5},

    {NULL, 0, NULL, 0, "The stream:", 6},
    {"to", KEY_TO, "SINK", 0, "Where the frames go: see below", 6},
    {NULL, 'o', "FILE", 0,
     "For sinks that write files, their name. Where each frame is a file, its number replaces %d or %04d in FILE", 6},
    {"fps", KEY_FPS, "F", 0,
     "Frames a second (default 30), by which the light moves; displays are paced by it. 0: as fast as they take them",
     6},
    {"frames", KEY_FRAMES, "N", 0,
     "End after N frames (default: displays go on until Ctrl-C; files and pipes end after one turn of the light)", 6},
    {"shade", KEY_SHADE, "WHERE", 0,
     "Who shades: host (default), or device: it gets the normals and the material once, then 16 bytes a frame. It "
     "draws as --path colour-int8 does, in one colour, under one white --light, a mesh with --no-outlines, over black "
     "and without soft edges. Or demo: the device shows what it shows by itself (a dial, a coin, its mesh), and gets "
     "the light's direction alone, without SCENE, maps and materials; its own is back 2.5 s after the last. For --to",
     6},
    {"stats", KEY_STATS, NULL, 0,
     "Print at the end what was sent, and what it would take over USB; on a terminal also while it runs", 6},
    {"json", KEY_JSON, NULL, 0,
     "What --stats prints at the end, as JSON; on standard error where frames go to standard output", 6},
    {NULL, 0, NULL, 0, NULL, 0}};

static const char doc[] = "Shades a scene frame after frame as its light moves or the mesh turns, and sends what "
                          "changed to a display, to files or to a pipe."
                          "\v"; /* and then what describe() writes */

static void parse_shader(const struct argp_state *state, const char *text, struct stream_options *o)
{
    const unsigned shader = parse_choice(state, "--shade", "shader", text, shade_names);
    o->shade_device = shader != SHADE_HOST;
    o->shade_demo = shader == SHADE_DEMO;
    o->look.scene.on_device = o->shade_demo;
}

static void parse_sink(const struct argp_state *state, const char *text, struct stream_options *o)
{
    for (const struct sink_left_out *out = sinks_left_out; out->name; out++)
        if (strcmp(text, out->name) == 0)
            refuse(state, "--to %s: this glint was built without it; install %s and build glint again", text,
                   out->packages);
    const char *names[SINKS_MAX + 1] = {NULL};
    for (unsigned i = 0; i < SINKS_MAX && sink_kinds[i]; i++)
        names[i] = sink_kinds[i]->name;
    o->kind = sink_kinds[parse_choice(state, "--to", "sink", text, names)];
}

static bool shades(const struct sink_kind *kind)
{
    return kind->shader != NULL;
}

static bool writes_standard_output(const struct sink_kind *kind)
{
    return kind->output && (kind->output->piped || kind->output->dash);
}

/* -o as the sink takes it; its usual name where none is given. */
static void check_output(const struct argp_state *state, struct stream_options *o)
{
    static const struct sink_output nowhere;
    const struct sink_kind *kind = o->kind;
    const struct sink_output *to = kind->output ? kind->output : &nowhere;
    if (o->output && !to->written)
        refuse(state, "-o: --to %s writes no files; leave it out", kind->name);
    if (!o->output)
        o->output = kind->usual_output;
    if (!o->output && to->written) {
        const size_t length = strlen(to->example);
        refuse(state, "-o: --to %s writes %s; name it: -o %s%s", kind->name, to->written, to->example,
               length && to->example[length - 1] == '.' ? kind->name : "");
    }
    if (!to->shown && sink_takes_standard_output(kind, o->output) && isatty(STDOUT_FILENO))
        refuse(state, "--to %s: standard output is a terminal; pipe or redirect it", kind->name);
    if (o->output && !to->dash && strcmp(o->output, "-") == 0)
        refuse(state, "-o -: --to %s writes %s; for standard output choose --to %s", kind->name, to->written,
               sink_names(writes_standard_output));
    if (to->check)
        to->check(state, kind, o->output, o->frames);
}

/* Nothing but the light's direction reaches the device. This comes before options are checked against each other, which would
 * ask for more of what is refused here. */
static void check_only_light(const struct argp_state *state, const struct stream_options *o)
{
    const struct scene_options *scene = &o->look.scene;
    char option[OPTION_NAME_MAX];
    if (!o->shade_demo)
        return;
    if (scene->heights || scene->normals || scene->scene || scene->mesh.name)
        refuse(state, "--shade demo: the device shows what is its own; leave the scene out");
    if (option_given(state, &drawing_options_argp, "light", option))
        refuse(state, "--shade demo: the device shows what is its own; leave %s out", option);
    if (o->board_lights)
        refuse(state, "--shade demo: a board's light is for --shade device; leave --lights board out");
}

static void check_demo(const struct argp_state *state, const struct stream_options *o, bool directional)
{
    const struct shading *shading = &o->look.shading;
    if (!directional || shading->lamp_count > 1)
        refuse(state, "--shade demo: the device takes one --light");
    for (int k = 0; k < 3; k++)
        if (shading->lamps[0].color[k] != 1)
            refuse(state, "--shade demo: the light is white; leave the colour of --light out");
    if (o->fps > 0 && o->fps < 1)
        refuse(state,
               "--shade demo: the device's own light is back %g s after the last, and frames may come late; "
               "give --fps 1 or more",
               LIGHT_HELD_MS / 1000.);
}

static void check(const struct argp_state *state, struct stream_options *o)
{
    const struct shading *shading = &o->look.shading;
    bool directional = false;
    for (unsigned i = 0; i < shading->lamp_count; i++)
        directional |= shading->lamps[i].kind == LAMP_DIRECTIONAL;
    const bool is_given = o->lights || o->board_lights;
    const bool is_mesh = o->look.scene.mesh.name; /* whose own turns --period is of, whatever the light does */
    if (is_given && (!isnan(o->orbit) || (!isnan(o->period) && !is_mesh)))
        refuse(state, "--lights: gives each direction of the light; leave out %s",
               isnan(o->orbit) ? "--period" : "--orbit");
    if (is_given && !directional)
        refuse(state, "--lights: moves a --light, and there are only --point and --spot; add a --light");
    if (o->lights && iio_is_named(o->lights) && !o->frames && !o->kind->paced)
        refuse(state, "--lights %s: goes on for ever; give --frames N for --to %s", o->lights, o->kind->name);
    if (o->shade_demo)
        check_demo(state, o, directional);
    if (o->board_lights && !o->shade_device)
        refuse(state, "--lights board: is the light of a board that shades; add --to usb --shade device");
    if (!isnan(o->orbit) && !directional)
        refuse(state, "--orbit: is for a --light; points and spots keep their distance from the picture's middle");
    if (o->lights && strcmp(o->lights, "-") == 0 && map_options_standard_input(&o->look.scene))
        refuse(state, "--lights: only one of --lights, the maps and the mesh can come from standard input");
    const bool light_moves = !is_mesh || is_given || !isnan(o->orbit);
    if (isnan(o->period))
        o->period = is_mesh ? usual_turn_period : usual_period;
    if (!o->frames && !o->lights && !o->kind->paced) {
        const double fps = o->fps > 0 ? o->fps : USUAL_FPS;
        o->frames = o->period > 0 ? (unsigned long)fmax(1, round(fps * o->period)) : 1;
    }
    o->turn_period = is_mesh ? o->period : 0;
    if (!light_moves) {
        o->period = 0;
        o->look.has_light = true; /* which stays where it is, also the one that nobody gave */
    }
    check_output(state, o);
    if (o->kind->wants_fps && !(o->fps > 0))
        refuse(state, "--fps: --to %s states the frame rate in what it writes; give one above 0", o->kind->name);
    sink_options_check(state, o->kind);
    if (o->shade_device && !o->kind->shader)
        refuse(state, "--shade %s: no device of --to %s shades; choose --to %s", o->shade_demo ? "demo" : "device",
               o->kind->name, sink_names(shades));
    if (o->look.has_format)
        shading_options_check(state, &o->look, shading);
}

/* Nearer to 0 a frame would take for ever, or a turn no time. */
static double parse_time(const struct argp_state *state, const char *option, const char *text, double most)
{
    const double least = 1e-6, value = parse_real(state, option, text, 0, most);
    if (value > 0 && value < least)
        refuse(state, "%s: '%s' is too small; give 0, or %g or more", option, text, least);
    return value;
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct stream_options *o = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &o->look;
        sink_options_inputs(&state->child_inputs[1]);
        return 0;
    case KEY_TO:
        parse_sink(state, text, o);
        return 0;
    case 'o':
        o->output = parse_output(state, "-o", text);
        return 0;
    case KEY_FPS:
        o->fps = parse_time(state, "--fps", text, 1000);
        return 0;
    case KEY_FRAMES:
        o->frames = (unsigned long)parse_integer(state, "--frames", text, 1, 1000000000);
        return 0;
    case KEY_ORBIT:
        o->orbit = parse_real(state, "--orbit", text, 0, 179);
        return 0;
    case KEY_PERIOD:
        o->period = parse_time(state, "--period", text, 1e6);
        return 0;
    case KEY_LIGHTS:
        o->board_lights = strcmp(text, "board") == 0;
        o->lights = o->board_lights ? NULL : parse_output(state, "--lights", text);
        return 0;
    case KEY_SHADE:
        parse_shader(state, text, o);
        return 0;
    case KEY_STATS:
        o->stats = true;
        return 0;
    case KEY_JSON:
        o->json = true;
        return 0;
    case ARGP_KEY_ARG:
        scene_options_argument(state, text, &o->look.scene);
        check_only_light(state, o);
        return 0;
    case ARGP_KEY_NO_ARGS: /* before the end, which other parsers see first */
        check_only_light(state, o);
        return 0;
    case ARGP_KEY_END:
        check(state, o);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* All sinks with one line each, their own help, and their examples. */
static void print_help(FILE *stream)
{
    fputs("SCENE is a built-in scene, as --scene takes it; its size is the display's, else 320x240.\n\nSinks:\n",
          stream);
    for (unsigned i = 0; sink_kinds[i]; i++)
        fprintf(stream, "  %-9s %s%s\n", sink_kinds[i]->name, sink_kinds[i]->summary, i ? "" : " (the default)");
    for (const struct sink_left_out *left = sinks_left_out; left->name; left++)
        fprintf(stream, "  %-9s (not in this build: it needs %s)\n", left->name, left->packages);
    for (unsigned i = 0; sink_kinds[i]; i++)
        if (sink_kinds[i]->help)
            fprintf(stream, "\n%s", sink_kinds[i]->help);
    fputs("\nCtrl-C ends the stream after a whole frame. The display is left in a defined state, and the exit status "
          "is 130.\n"
          "\nExamples:\n",
          stream);
    for (unsigned i = 0; sink_kinds[i]; i++)
        if (sink_kinds[i]->examples)
            fputs(sink_kinds[i]->examples, stream);
}

static char *describe(int key, const char *text, void *input)
{
    (void)input;
    if (key == KEY_SHADE)
        return formatted("%s %s", text, sink_names(shades));
    return key == ARGP_KEY_HELP_POST_DOC ? help_text(text, print_help) : (char *)text;
}

int command_stream(int argc, char **argv)
{
    static struct argp_child children[SINK_OPTIONS_MAX + 2] = {{&drawing_options_argp, 0, NULL, 0}};
    sink_options_children(children + 1);
    const struct argp argp = {argp_options, parse_option, SCENE_ARGUMENT, doc, children, describe, NULL};
    struct stream_options options = {.kind = sink_kinds[0], .fps = USUAL_FPS, .orbit = NAN, .period = NAN};
    parse_command(&argp, 0, argc, argv, &options);
    return stream_run(&options);
}
