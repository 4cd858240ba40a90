/* SPDX-License-Identifier: MIT
 * The mesh of DEMO=teapot, baked by `glint bake`. The linker puts it into RAM, where it is faster than in flash. */
#ifndef DEMO_TEAPOT_H
#define DEMO_TEAPOT_H

#include "light_protocol.h"

extern const struct glint_mesh demo_teapot;
extern const struct light_mesh demo_teapot_identity;
bool demo_teapot_is_intact(void);

#endif
