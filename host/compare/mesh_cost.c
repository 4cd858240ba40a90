/* SPDX-License-Identifier: MIT
 * A sum over what a picture has: faces, those of them with pixels, their lines, their pixels. The cycles of each are fitted to 27
 * pictures of the teapot (992, 1610 and 2710 triangles, three sides, three sizes in 240x240) on an emulated Cortex-M0+, which
 * they met within 13 %; then lowered by what three meshes of tests/bench take less since faces, triangles and lines are faster. */
#include "compare/mesh_cost.h"

#include <stdlib.h>

#include "base/memory.h"
#include "compare/mesh_raster.h"

static const struct cost {
    double face, visible, line, pixel;
} in_c = {495, 2555, 280, 14}, in_assembly = {420, 1690, 193, 6};

static double sum(const struct cost *cost, const struct mesh *mesh, const struct mesh_raster *raster)
{
    return cost->face * (double)mesh->face_count + cost->visible * (double)raster->faces +
           cost->line * (double)raster->lines + cost->pixel * (double)raster->pixels;
}

struct mesh_cycles mesh_cycles(const struct mesh *mesh, const struct fitted *fitted, const struct view *view)
{
    double(*corners)[3] = allocate(3 * mesh->face_count, sizeof *corners); /* black */
    struct mesh_raster *raster = mesh_raster(mesh, fitted, view, corners);
    const struct mesh_cycles cycles = {sum(&in_c, mesh, raster), sum(&in_assembly, mesh, raster)};
    mesh_raster_free(raster);
    free(corners);
    return cycles;
}
