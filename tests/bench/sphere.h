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

/* Its light and material: the same for every loop, and for the exact picture to which they are compared. */
void sphere_shader(struct glint_shader *shader, enum glint_model model, uint32_t n, enum glint_format format,
                   bool dither);

/* A map over it: a smooth pattern in RGB565, and that in RGB888. With it goes white light: the diffuse part grey. */
uint16_t sphere_albedo(uint16_t x, uint16_t y);
void sphere_expand(uint8_t rgb[3], uint16_t rgb565);
void sphere_grey(struct glint_shader *shader);

#endif
