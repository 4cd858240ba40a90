/* SPDX-License-Identifier: MIT
 * The loop of glint stream: light, shade, plan, send; and how it ends. */
#ifndef GLINT_STREAM_H
#define GLINT_STREAM_H

#include "options/shading_options.h"
#include "sinks/sink.h"

enum { USUAL_FPS = 30 }; /* and what the light moves by where fps is 0 */

struct stream_options {
    struct shading_options look;
    const struct sink_kind *kind;
    const char *output;   /* -o, or NULL */
    double fps;           /* 0: as fast as the sink takes them */
    unsigned long frames; /* 0: until stopped, or until the lights end */
    double orbit;         /* degrees; NAN: the light's own, or the usual */
    double period;        /* seconds; 0: the light stands still */
    double turn_period;   /* of a mesh about the vertical axis, seconds; 0: it stands still */
    const char *lights;   /* file, "-", a sensor (iio.h), or NULL */
    bool board_lights;    /* the device that shades tells where the light is; lights is NULL */
    bool stats, json;
    bool shade_device; /* the device shades, and gets lights */
    bool shade_demo;   /* what is its own; there is no scene */
};

/* Returns the exit status. */
int stream_run(const struct stream_options *options);

#endif
