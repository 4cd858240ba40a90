/* SPDX-License-Identifier: MIT
 * How a scene is lit and shaded, the picture the library makes of it, and the double-precision picture it should be. */
#ifndef GLINT_SHADE_H
#define GLINT_SHADE_H

#include "glint.h"
#include "image/levels.h"
#include "scene/scene.h"

/* A light of the scene. */
struct lamp {
    enum glint_lamp_kind kind;
    double direction[3]; /* directional: towards it, any length, y up */
    double position[3]; /* point and spot, in pixels: x right, y down, from the picture's upper left corner; z to you */
    double target[2];   /* spot: the pixel on the surface it is aimed at */
    double range;       /* point and spot: in pixels */
    double cone[2];     /* spot: degrees from its axis, full within the first, nothing beyond the second */
    double color[3];    /* 1 is white */
};

/* As the user gave it: in doubles, so that the reference has nothing of the library's rounding. */
struct shading {
    enum glint_model model;
    unsigned n, q;
    struct lamp lamps[GLINT_LAMPS_MAX];
    unsigned lamp_count;
    double view[3]; /* towards the viewer, any length */
    double ambient[3], diffuse[3], specular[3];
    uint8_t color[3]; /* where the scene has no albedo */
    enum glint_format format;
    enum glint_space space;
    bool dither, clamp_peak;
    unsigned path; /* index in path_names */
};

/* ---- by the library (shade.c) ---- */

/* A lamp as the library takes it, or what the library has against it. */
enum glint_err shading_lamp(const struct shading *shading, unsigned i, struct glint_lamp *lamp);
/* A direction in whole numbers, as the library is given it: the longest part becomes 2^30. */
void direction_integers(const double direction[3], int32_t out[3]);
/* As the library takes it, lit by the first light where shading_is_plain. */
struct glint_shader shading_shader(const struct shading *shading);
/* Is it lit by one white directional light, which every path can draw? */
bool shading_is_plain(const struct shading *shading);
struct levels *shade_scene(const struct scene *scene, const struct shading *shading);

/* A scene made ready for a material and a format, to be drawn again and again as the light moves. */
struct canvas;
struct canvas *canvas_new(const struct scene *scene, const struct shading *shading); /* the scene must outlive it */
void canvas_free(struct canvas *canvas);
/* With other lamps than it was made with, perhaps, of the same kinds. On all cores. Lines are packed; what the scene's
 * mask leaves out is left as it is. */
void canvas_draw(const struct canvas *canvas, const struct shading *shading, uint8_t *pixels);
/* ---- ways through the library (paths.c) ---- */

extern const char *const path_names[]; /* by the names --path takes, [0] the exact rectangle; ends with NULL */
/* Why the path cannot draw so, as the end of "--path NAME ...", or NULL where it can. */
const char *path_refusal(const struct shading *shading);
/* Any path but [0], over what the exact one has drawn, which keeps what this path cannot draw; says so. Scene and
 * normals must outlive it. */
struct way;
struct way *way_new(const struct scene *scene, const struct shading *shading, const struct glint_shader *shader,
                    const struct glint_vec *normals);
void way_free(struct way *way);
bool way_is_whole(const struct way *way); /* or does it need the exact path below it? */
/* Some lines from y on; the surface starts at the first of them. */
enum glint_err way_draw(const struct way *way, const struct glint_light *light, uint32_t y, uint32_t lines,
                        const struct glint_surface *surface);

/* ---- in doubles (reference.c) ---- */

/* Line y of the scene by the formula of glint.h's steps 1 to 7, for any model, each channel 0..1 before the rounding.
 * A highlight whose true value is under 2^-q counts as 0, as does one on a side that the light does not reach. */
void reference_line(const struct scene *scene, const struct shading *shading, enum glint_model model, uint32_t y,
                    double *values);
/* The one rounding: step 8. */
unsigned reference_level(double value, unsigned max, bool dither, uint32_t x, uint32_t y);

#endif
