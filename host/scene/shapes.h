/* SPDX-License-Identifier: MIT
 * Drawing reliefs with signed distances. */
#ifndef GLINT_SCENE_SHAPES_H
#define GLINT_SCENE_SHAPES_H

/* A point of a relief. Lengths are in units of half the picture's shorter side. */
struct relief {
    double height;
    double albedo[3]; /* 0..1 */
    double gloss;     /* 0..1 */
    double solid;     /* 0..1: how much of the pixel there is the thing, not the wall behind it */
};
/* The relief of a thing at x, y from the picture's middle, y up, and a little beyond its edge; `pixel` is the length of a pixel, for
 * smooth edges that do not blur. `body`: the colour of what it is made of; NULL: its own. */
typedef struct relief relief_function(double x, double y, double pixel, const double body[3]);

double smooth_step(double from, double to, double at); /* 0..1, level at both ends */
double mix(double a, double b, double part);
/* How much of a pixel lies inside, from the signed distance to the edge (negative inside). */
double coverage(double distance, double pixel);
/* Lays `top` over `bottom` by `part` 0..1. */
void relief_cover(struct relief *bottom, const struct relief *top, double part);
double distance_to_segment(double x, double y, double ax, double ay, double bx, double by);
/* The distance to the strokes of a whole number's digits, each `size` high, centred on 0, 0. */
double distance_to_number(double x, double y, unsigned number, double size);

#endif
