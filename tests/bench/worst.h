/* SPDX-License-Identifier: MIT
 * The exact rectangle's worst line: one whose every pixel the bound leaves open, at normals where the lobe takes longest. The
 * harness (worst.mjs) searches for its normals and its ambient light, and asks these about them. */
#ifndef GLINT_BENCH_WORST_H
#define GLINT_BENCH_WORST_H

#include "loops.h"

extern uint8_t worst_open[SPHERE_W];

/* Maps of one value; every pixel is drawn. */
void worst_begin(void);
/* Ambient light, red, green and blue; prepares. */
void worst_material(uint32_t red, uint32_t green, uint32_t blue);
/* Draws the line: how many pixels, and in worst_open which, the 64-bit sequence draws. */
uint32_t worst_count(void);
/* t of a pixel; F there. */
uint32_t worst_t(uint32_t x);
uint32_t worst_lobe(uint32_t t_q30);

#endif
