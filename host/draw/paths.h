/* SPDX-License-Identifier: MIT
 * The ways through the library that --path names. */
#ifndef GLINT_DRAW_PATHS_H
#define GLINT_DRAW_PATHS_H

#include <stdbool.h>

#include "draw/shading.h"
#include "scene/scene.h"

extern const char *const path_names[]; /* [0] is the exact rectangle; ends with NULL */
/* Why the path cannot draw with this shading, as the end of "--path NAME ..."; NULL where it can. */
const char *path_refusal(const struct shading *shading);

/* How a mesh is drawn by the shading's path. Returns why it cannot, as above. */
struct mesh_path {
    bool by_tables, normals8;
    enum glint_tables_kind kind;
};
extern const char path_needs_grey[]; /* where ALBEDO tables refuse a material */
const char *path_of_mesh(const struct shading *shading, bool has_colors, struct mesh_path *of_mesh);

/* A path other than [0], made ready for a scene. It draws over what the exact path has drawn; pixels that it cannot draw
 * keep the exact path's values, and a warning says so. Scene and normals must outlive it. */
struct way;
struct way *way_new(const struct scene *scene, const struct shading *shading, const struct glint_shader *shader,
                    const struct glint_vec *normals);
void way_free(struct way *way);
bool way_is_whole(const struct way *way); /* or does it need the exact path below it? */
/* Some lines from y on; the surface starts at the first of them. */
enum glint_err way_draw(const struct way *way, const struct glint_light *light, uint32_t y, uint32_t lines,
                        const struct glint_surface *surface);

#endif
