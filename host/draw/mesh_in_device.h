/* SPDX-License-Identifier: MIT
 * Meshes that lie in a device which shades by itself: is it this one, and where it stands, as the device is told. */
#ifndef GLINT_DRAW_MESH_IN_DEVICE_H
#define GLINT_DRAW_MESH_IN_DEVICE_H

#include "draw/shading.h"
#include "draw/view.h"
#include "light_protocol.h"
#include "mesh/fit.h"

bool mesh_in_device(const struct light_mesh *there, const struct fitted *fitted);
/* Why a device cannot draw a mesh so, as device_refusal; outlines are stepped. behind: pixels that it is drawn over; NULL: black. */
const char *mesh_in_device_refusal(const struct view *view, const struct shading *shading, const uint8_t *behind,
                                   struct light_material *material);
/* The shading's first light, which is directional, and the view. */
struct light_pose mesh_in_device_pose(const struct view *view, const struct shading *shading);

#endif
