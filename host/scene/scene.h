/* SPDX-License-Identifier: MIT
 * What is shaded, apart from how: a normal for each pixel and what the maps say of it, from files or drawn. */
#ifndef GLINT_SCENE_H
#define GLINT_SCENE_H

#include <stdbool.h>
#include <stdint.h>

#include "glint.h"
#include "image/image.h"

/* What suits a scene where the user says nothing. */
struct finish {
    unsigned n;
    double ambient[3], diffuse[3], specular[3];
};

struct scene {
    uint32_t width, height;
    double (*normals)[3]; /* length 1; x right, y up, z towards the viewer; lines from the top */
    uint8_t *albedo;      /* RGB888, or NULL */
    uint8_t *gloss;       /* or NULL */
    uint8_t *mask;        /* 0: not drawn; or NULL */
    struct finish finish;
};

struct scene *scene_new(uint32_t width, uint32_t height); /* normals towards the viewer, no maps, the plain finish */
void scene_free(struct scene *scene);
/* The scene cut to the size, or repeated to fill it. */
void scene_repeat(struct scene *scene, uint32_t width, uint32_t height);
/* What the library takes: nearest Q1.15, 1.0 held as 32767; malloc'd. */
struct glint_vec *scene_normals_q15(const struct scene *scene);

/* ---- normals from files (normals.c) ---- */

/* `scale`: how many pixels white lies above black. Central differences; at the edges one-sided, or around them where
 * the map `wraps`. */
struct scene *scene_from_heights(const struct image *heights, double scale, bool wraps);

/* Red x, green y (up), blue z, -1..1 over the samples' range; z is reconstructed where there are two channels or blue is
 * 0 throughout. Renormalised. Pixels that `mask` (NULL: none) leaves out may hold anything. */
struct scene *scene_from_normals(const struct image *map, bool flip_y, const uint8_t *mask);

/* ---- built-in scenes (scenes.c and one file each) ---- */

extern const char *const scene_names[];                                      /* ends with NULL */
struct scene *scene_draw(const char *name, uint32_t width, uint32_t height); /* NULL: no such scene */

/* A point of a relief. Lengths are in units of half the picture's shorter side. */
struct relief {
    double height;
    double albedo[3]; /* 0..1 */
    double gloss;     /* 0..1 */
};
/* The relief at x, y from the picture's middle, y up; `pixel` is the length of a pixel, for edges that neither step nor
 * blur. */
typedef struct relief relief_function(double x, double y, double pixel);

struct relief relief_watchface(double x, double y, double pixel);
struct relief relief_dial(double x, double y, double pixel); /* the same without numerals and minutes */
struct relief relief_coin(double x, double y, double pixel);

/* ---- drawing with signed distances (shapes.c) ---- */

double smooth_step(double from, double to, double at); /* 0..1, level at both ends */
double mix(double a, double b, double part);
/* How much of a pixel lies inside, from the signed distance to the edge (negative inside). */
double coverage(double distance, double pixel);
/* Lays `top` over `bottom` by `part` 0..1. */
void relief_cover(struct relief *bottom, const struct relief *top, double part);
double distance_to_segment(double x, double y, double ax, double ay, double bx, double by);
/* To the strokes of a whole number's digits, each `size` high, centred on 0, 0. */
double distance_to_number(double x, double y, unsigned number, double size);

#endif
