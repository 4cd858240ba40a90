/* SPDX-License-Identifier: MIT
 * Frame after frame to a sink: the light that moves, what is sent of each frame, what it took. */
#ifndef GLINT_STREAM_H
#define GLINT_STREAM_H

#include "plan/plan.h"
#include "options/shading_options.h"
#include "sinks/sink.h"

enum { USUAL_FPS = 30 }; /* and what --fps 0 counts the light's way by */

struct stream_options {
    struct shading_options look;
    const struct sink_kind *kind;
    const char *output;   /* -o, or NULL */
    double fps;           /* 0: as fast as it goes */
    unsigned long frames; /* 0: until stopped, or until the lights end */
    double orbit;         /* degrees; NAN: the light's own, or the usual */
    double period;        /* seconds; 0: the light stands still */
    const char *lights;   /* file, "-", or NULL */
    bool stats, json;
    bool shade_device; /* the device shades, and gets lights */
};

/* Returns the exit status. */
int stream_run(const struct stream_options *options);

/* ---- devices that shade (stream_shade.c) ---- */

/* Why a device cannot shade so: the end of "--shade device: ...", or NULL where it can. Sets the one colour there is. */
const char *device_refusal(const struct scene *scene, const struct shading *shading, struct glint_shader *shader);
enum sink_result device_send_scene(struct sink *sink, const struct scene *scene, const struct shading *shading);
enum sink_result device_send_light(struct sink *sink, const struct shading *shading, struct plan_result *result);

/* ---- the light (stream_light.c) ---- */

struct light_path;
/* Opens the file of lights, where one is named. */
struct light_path *light_path_new(const struct stream_options *options);
/* The path of the shading's first directional light, else of its first point or spot about the picture's middle. */
void light_path_start(struct light_path *path, const struct stream_options *options, const struct shading *shading,
                      uint32_t width, uint32_t height);
/* Moves the light to where it is `seconds` after the start, or to the next line's; false where there is none. */
bool light_path_next(struct light_path *path, double seconds, struct shading *shading);
void light_path_free(struct light_path *path);

/* ---- figures (stream_stats.c) ---- */

struct stream_stats;
struct stream_stats *stats_new(const struct sink *sink);
void stats_add(struct stream_stats *stats, const struct plan_result *result);
void stats_show(struct stream_stats *stats); /* a line on a terminal, some times a second */
/* The sums at the end, as text or JSON. */
void stats_print(const struct stream_stats *stats, bool json, FILE *stream);
void stats_free(struct stream_stats *stats);

/* ---- the options of sinks (sink_options.c) ---- */

enum { SINK_OPTIONS_MAX = 2 * SINKS_MAX };
/* Those of all sinks compiled in, as children of the stream's argp. */
void sink_options_children(struct argp_child children[SINK_OPTIONS_MAX]);
void sink_options_inputs(void **inputs); /* for argp's child_inputs, in the same order */
/* Refuses what was given for another sink. */
void sink_options_check(const struct argp_state *state, const struct sink_kind *kind);

#endif
