/* SPDX-License-Identifier: MIT
 * Shading by a device that shades by itself: from a map of 8-bit normals, by COLOUR tables, RGB565. */
#ifndef GLINT_DRAW_SHADING_DEVICE_H
#define GLINT_DRAW_SHADING_DEVICE_H

#include "draw/shading.h"
#include "light_protocol.h"
#include "scene/scene.h"

/* Why a device cannot shade so: the end of "--shade device: ...", or NULL where it can. Sets the material, with the one
 * colour there is, as it goes over the wire. */
const char *device_refusal(const struct scene *scene, const struct shading *shading, struct light_material *material);
extern const char device_needs_black[]; /* why it draws over no background */

#endif
