/* SPDX-License-Identifier: MIT
 * What a picture of a mesh should show: each pixel's normal, in double precision. */
#ifndef GLINT_COMPARE_MESH_SCENE_H
#define GLINT_COMPARE_MESH_SCENE_H

#include "draw/shading.h"
#include "draw/view.h"
#include "image/levels.h"
#include "mesh/fit.h"
#include "scene/scene.h"

/* Pixels that the double render or the library draws, and those of them where they draw different triangles, which no shading can
 * bring together. */
struct mesh_coverage {
    size_t drawn, different;
    size_t texels; /* where they draw the same triangle, but of its texture the nearest pixel is another */
};
/* A scene of the picture's size: normals interpolated over the triangle in front, in space, and normalised; its parts are the
 * mesh's, its albedo is the vertices' where they have colours, and textures' where there are such; its mask is where both draw the same triangle, and of a texture that is
 * not blended the same pixel. */
struct scene *mesh_scene(const struct mesh *mesh, const struct fitted *fitted, const struct view *view,
                         const struct shading *shadings, struct mesh_coverage *coverage);

/* The same mesh as Gouraud shading draws it, for comparison: colours in double precision at the corners, and between them interpolated.
 * `behind`: pixels of the format; NULL: black. */
struct levels *mesh_gouraud(const struct mesh *mesh, const struct fitted *fitted, const struct view *view,
                            const struct shading *shadings, const uint8_t *behind);

#endif
