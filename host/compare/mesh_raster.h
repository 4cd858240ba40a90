/* SPDX-License-Identifier: MIT
 * Meshes drawn in double precision. */
#ifndef GLINT_COMPARE_MESH_RASTER_H
#define GLINT_COMPARE_MESH_RASTER_H

#include "draw/view.h"
#include "mesh/fit.h"

struct mesh_raster {
    double (*values)[3]; /* of each pixel, interpolated in space over the triangle in front */
    uint32_t *numbers;   /* of that triangle, plus 1; 0: none */
    double *areas;       /* of each face on the screen, in pixels */
    size_t faces, lines,
        pixels; /* seen from the front with a pixel at all, their lines, their pixels; hidden ones, too */
};
/* Where each vertex stands before it is projected: in pixels from the picture's middle, x right, y up, z to you. malloc'd. */
double (*mesh_turned_places(const struct mesh *mesh, const struct fitted *fitted, const struct view *view))[3];
/* `corners`: the values of each face's three. Places are those before they were fitted, so that nothing of the library's rounding is in
 * the picture. */
struct mesh_raster *mesh_raster(const struct mesh *mesh, const struct fitted *fitted, const struct view *view,
                                double (*corners)[3]);
void mesh_raster_free(struct mesh_raster *raster);

#endif
