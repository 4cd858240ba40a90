/* SPDX-License-Identifier: MIT
 * A sum over what a picture has: faces, those of them with pixels, their lines, their pixels. The cycles of each are fitted to 27
 * pictures of the teapot (992, 1610 and 2710 triangles, three sides, three sizes in 240x240) on an emulated Cortex-M0+, which
 * they meet within 12 %. */
#include "compare/mesh_cost.h"

#include <stdlib.h>

#include "base/memory.h"
#include "compare/mesh_raster.h"

enum { FACE = 600, VISIBLE = 2830, LINE = 280, PIXEL = 15 };

double mesh_cycles(const struct mesh *mesh, const struct fitted *fitted, const struct view *view)
{
    double(*corners)[3] = allocate(3 * mesh->face_count, sizeof *corners); /* black */
    struct mesh_raster *raster = mesh_raster(mesh, fitted, view, corners);
    const double cycles = FACE * (double)mesh->face_count + VISIBLE * (double)raster->faces +
                          LINE * (double)raster->lines + PIXEL * (double)raster->pixels;
    mesh_raster_free(raster);
    free(corners);
    return cycles;
}
