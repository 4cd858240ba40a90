/* SPDX-License-Identifier: MIT
 * Scenes from height maps and normal maps. */
#ifndef GLINT_SCENE_NORMALS_H
#define GLINT_SCENE_NORMALS_H

#include <stdbool.h>

#include "image/image.h"
#include "scene/scene.h"

/* `scale`: white lies so many pixels above black. Central differences; one-sided at the edges, or across them where the map
 * `wraps`. */
struct scene *scene_from_heights(const struct image *heights, double scale, bool wraps);
struct scene *scene_from_relief(const double *heights, uint32_t width, uint32_t height, double scale, bool wraps);

/* Red x, green y (up), blue z, -1..1 over the samples' range; z is reconstructed where there are two channels or blue is
 * 0 throughout. Renormalised. Pixels that `mask` (NULL: none) leaves out may hold anything. */
struct scene *scene_from_normals(const struct image *map, bool flip_y, const uint8_t *mask);

#endif
