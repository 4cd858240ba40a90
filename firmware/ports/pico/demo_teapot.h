/* SPDX-License-Identifier: MIT
 * The mesh of DEMO=teapot, baked by `glint bake`. The linker puts it into RAM, where it is faster than in flash. */
#ifndef DEMO_TEAPOT_H
#define DEMO_TEAPOT_H

#include "glint.h"

extern const struct glint_mesh demo_teapot;
bool demo_teapot_is_intact(void);

#endif
