/* SPDX-License-Identifier: MIT
 * The ways through the library that --path names: a source of pixels and a paint. */
#ifndef GLINT_DRAW_PATHS_H
#define GLINT_DRAW_PATHS_H

#include <stdbool.h>

#include "draw/shading.h"
#include "scene/scene.h"

extern const char *const path_names[]; /* [0] is the exact paint over 16-bit normals; ends with NULL */
/* Why the path cannot draw with this shading, as the end of "--path NAME ..."; NULL where it can. */
const char *path_refusal(const struct shading *shading);
/* Of one whose coefficients are all known: what the tables of colours would refuse. */
const char *path_material_refusal(const struct shading *shading);

/* Does it draw every map as it is, so that a picture can be drawn in parts? Others choose for all of it what they draw. */
bool path_draws_all(unsigned path);

/* How a mesh is drawn by the shading's path. Returns why it cannot, as above. */
struct mesh_path {
    bool by_tables, normals8;
    enum glint_tables_kind kind;
};
extern const char path_needs_grey[]; /* where ALBEDO tables refuse a material */
const char *path_of_mesh(const struct shading *shading, bool has_colors, struct mesh_path *of_mesh);

/* The grain of the scene from pixel `first` on, where the shading has one. */
void scene_add_grain(const struct scene *scene, const struct shading *shading, size_t first, struct glint_maps *maps);

/* A path made ready for a scene. Some leave pixels of the scene undrawn, and a warning says so: the exact paint is to
 * draw these. Scene and normals must outlive it. */
struct way;
struct way *way_new(const struct scene *scene, const struct shading *shading, const struct glint_vec *normals);
void way_free(struct way *way);
bool way_is_whole(const struct way *way); /* does it draw the whole scene? */
/* The scene's mask without what it draws, which another is to draw: each pixel once, as edges are blended. malloc'd. */
uint8_t *way_rest(const struct way *way, const struct scene *scene);
/* Before lines are drawn: the lights and the viewer as the shading has them now. */
void way_light(struct way *way, const struct shading *shading);
/* Some lines from y on; the surface starts at the first of them. */
enum glint_err way_draw(const struct way *way, uint32_t y, uint32_t lines, const struct glint_surface *surface);

#endif
