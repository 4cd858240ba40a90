/* SPDX-License-Identifier: MIT
 * Where a mesh stands in a picture. */
#ifndef GLINT_DRAW_VIEW_H
#define GLINT_DRAW_VIEW_H

#include <stdint.h>

#include "glint_mesh.h"

struct view {
    uint32_t width, height;
    double turn
        [3]; /* degrees: about y, the vertical axis, first, then about x, then about z; counterclockwise as seen from its tip */
    double zoom;     /* 1: a ball of 32767 fills the shorter side */
    double distance; /* of the camera from the middle, in such balls' radii; 0: parallel projection */
};
void view_rotation(const struct view *view, double m[3][3]);
double view_radius(const struct view *view); /* of such a ball, in pixels */
/* As the library takes it. */
struct glint_pose view_pose(const struct view *view);
uint16_t view_distance(const struct view *view);
/* Why the library cannot draw so, a sentence; NULL where it can. */
const char *view_refusal(const struct view *view);

#endif
