/* SPDX-License-Identifier: MIT
 * The scene that is measured: a sphere on 60 % of 320x240 pixels, lit from (1, 1, 1), seen from far in front. */
#ifndef GLINT_BENCH_SPHERE_H
#define GLINT_BENCH_SPHERE_H

#include "glint.h"

enum {
    SPHERE_W = 320,
    SPHERE_H = 240,
    SPHERE_Q = 8,
    SPHERE_N_COUNT = 5,
    SPHERE_STEP = 16, /* simulated machines that are slow or small take one line in so many */
    SPHERE_LINES = SPHERE_H / SPHERE_STEP,
    SPHERE_PALETTE = 4096 /* entries at most, the one for no surface included */
};
extern const uint16_t sphere_n[SPHERE_N_COUNT];

enum sphere_lamps { LAMPS_NONE, LAMPS_DIRECTIONAL, LAMPS_POINT, LAMPS_COLOURED, LAMPS_SPOT, LAMPS_NARROW, LAMPS_FOUR };

/* How it looks, but for n: what a loop draws, and the exact picture to which that is compared. */
struct sphere_look {
    uint8_t model;  /* enum glint_model */
    uint8_t format; /* enum glint_format */
    uint8_t space;  /* enum glint_space */
    bool dither, albedo, gloss;
    uint8_t lamps; /* enum sphere_lamps: in the place of the light */
};

/* Its light and material. Under an albedo map the light is white: the diffuse part is grey. */
void sphere_shader(struct glint_shader *shader, const struct sphere_look *look, uint32_t n);
/* Fills the lamps; how many there are, negative: enum glint_err. */
int sphere_lamps(struct glint_lamp lamps[GLINT_LAMPS_MAX], enum sphere_lamps which);

/* Maps over it: a smooth pattern in RGB565, and that in RGB888; and of gloss. */
uint16_t sphere_albedo(uint16_t x, uint16_t y);
void sphere_expand(uint8_t rgb[3], uint16_t rgb565);
uint8_t sphere_gloss(uint16_t x, uint16_t y);

#endif
