/* SPDX-License-Identifier: MIT
 * A frame of the teapot as an object of LVGL's, a strip at a time, and the same with glint's own calls. Steps return an error, 0 for none. */
#ifndef GLINT_LVGL_BENCH_H
#define GLINT_LVGL_BENCH_H

#include "glint_mesh.h"

extern uint32_t lvgl_out[240 * GLINT_MESH_BAND / 2]; /* a strip */

int lvgl_begin(unsigned is_exact);
int lvgl_frame(void);
int lvgl_strip(unsigned y, unsigned lines); /* at most GLINT_MESH_BAND */
int lvgl_bare_frame(void);
int lvgl_bare_strip(unsigned y, unsigned lines);

#endif
