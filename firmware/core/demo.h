/* SPDX-License-Identifier: MIT
 *
 * What a board shows by itself: gold under a light that circles. Shared with the tests, which draw it on the host. */
#ifndef DEMO_H
#define DEMO_H

#include "glint.h"

/* The material, into RGB565 in the machine's order; the light is not set. */
void demo_shader(struct glint_shader *shader);

#endif
