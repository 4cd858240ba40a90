/* SPDX-License-Identifier: MIT
 * How a scene is lit and shaded. */
#ifndef GLINT_DRAW_SHADING_H
#define GLINT_DRAW_SHADING_H

#include <stdbool.h>

#include "glint.h"

enum lamp_kind { LAMP_DIRECTIONAL, LAMP_POINT, LAMP_SPOT };

/* A light of the scene. */
struct lamp {
    enum lamp_kind kind;
    double direction[3]; /* directional: towards it, any length, y up */
    double position[3];  /* point and spot, in pixels from the picture's upper left corner: x right, y down, z to you */
    double target[2];    /* spot: the pixel on the surface it is aimed at */
    double range;        /* point and spot: in pixels */
    double cone[2];      /* spot: degrees from its axis, full within the first, nothing beyond the second */
    double color[3];     /* 1 is white */
};

/* As the user gave it: in doubles, so that the reference has nothing of the library's rounding. */
struct shading {
    enum glint_model model;
    unsigned n, q;     /* q: 1..16 once shading_of_options has filled it in */
    unsigned n_across; /* across the grain; 0: there is none */
    struct lamp lamps[GLINT_LIGHTS_MAX];
    unsigned lamp_count;
    double view[3]; /* towards the viewer, any length */
    double ambient[3], diffuse[3], specular[3];
    uint8_t color[3]; /* where the scene has no albedo */
    enum glint_format format;
    enum glint_space space;
    bool dither, clamp_peak;
    unsigned path; /* index in path_names */
};

/* A direction in whole numbers, as the library is given it: the longest part becomes 2^30. */
void direction_integers(const double direction[3], int32_t out[3]);
/* A place in 1/16 pixel. */
void place_integers(const double pixels[3], int32_t out[3]);

/* As the library takes them. */
struct glint_material shading_material(const struct shading *shading);
struct glint_output shading_output(const struct shading *shading);
/* Its q, or where that is 0 the library's for this output. */
unsigned shading_q(const struct shading *shading);
/* Light i, or the error with which the library refuses it alone: GLINT_ERR_VECTOR where it is straight behind. */
enum glint_err shading_light(const struct shading *shading, unsigned i, struct glint_light *light);
/* All of them; ends the program where the library refuses one. */
void shading_lights(const struct shading *shading, struct glint_light lights[GLINT_LIGHTS_MAX]);

/* Lights a paint, which may keep a pointer to the lights. Ends the program where the library refuses. */
void shading_light_paint(const struct shading *shading, struct glint_paint *paint,
                         struct glint_light lights[GLINT_LIGHTS_MAX]);
/* An exact paint, lit so. */
struct glint_paint shading_paint(const struct shading *shading, struct glint_light lights[GLINT_LIGHTS_MAX]);

/* Is it lit by one white directional light, which every path can draw? */
bool shading_is_plain(const struct shading *shading);

#endif
