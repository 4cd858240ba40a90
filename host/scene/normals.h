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
/* Of these lines alone; of a map that wraps they may lie beyond its last, too. */
struct scene *scene_from_heights_lines(const struct image *heights, double scale, bool wraps, uint32_t top,
                                       uint32_t lines);
struct scene *scene_from_relief(const double *heights, uint32_t width, uint32_t height, double scale, bool wraps);

/* Red x, green y (up), blue z, -1..1 over the samples' range; z is reconstructed where there are two channels or blue is
 * 0 throughout. Renormalised. Pixels that `mask` (NULL: none) leaves out may hold anything. */
struct scene *scene_from_normals(const struct image *map, bool flip_y, const uint8_t *mask);
/* The same in parts: first the whole map is looked at, to see whether z is to be reconstructed; then some lines, which may lie beyond its
 * last: it repeats. The mask is that of these lines. */
bool normal_map_is_xy(const struct image *map);
struct scene *scene_from_normals_lines(const struct image *map, bool is_xy, bool flip_y, const uint8_t *mask,
                                       uint32_t top, uint32_t lines);

#endif
