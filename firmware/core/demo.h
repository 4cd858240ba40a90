/* SPDX-License-Identifier: MIT
 *
 * What a board shows by itself: gold under a light that circles, or that turns under a light. Shared with the tests, which draw it on
 * the host. */
#ifndef DEMO_H
#define DEMO_H

#include "glint_mesh.h"

extern const struct glint_material demo_gold;
extern const struct glint_output demo_output; /* RGB565 in the machine's order */

/* A mesh that turns about its upright axis, tilted towards the viewer; a turn takes ORBIT_FRAMES. It is as large as the panel's shorter
 * side, `size` pixels, up to 1023. */
void demo_pose(struct glint_pose *pose, uint32_t frame, uint16_t size);
extern const int32_t demo_mesh_light[3]; /* towards the light */

#endif
