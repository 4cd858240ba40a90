/* SPDX-License-Identifier: MIT
 * The scene that is measured: a sphere on 60 % of 320x240 pixels, lit from (1, 1, 1), seen from far in front. */
#ifndef GLINT_BENCH_SCENE_H
#define GLINT_BENCH_SCENE_H

#include "glint.h"

enum {
    SCENE_W = 320,
    SCENE_H = 240,
    SCENE_Q = 8,
    SCENE_N_COUNT = 5,
    SCENE_STEP = 16, /* simulated machines that are slow or small take one line in so many */
    SCENE_LINES = SCENE_H / SCENE_STEP
};
extern const uint16_t scene_n[SCENE_N_COUNT];

/* Its light and material: the same for every loop, and for the exact picture to which they are compared. */
void scene_shader(struct glint_shader *shader, enum glint_model model, uint32_t n, enum glint_format format,
                  bool dither);

#endif
