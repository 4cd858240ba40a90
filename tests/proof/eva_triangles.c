/* SPDX-License-Identifier: MIT
 * For Eva: a triangle of any three corners, dark, matt or glossy: its edges, what they are on any line, and the slopes of u and v. The
 * steps of its values: eva_gradients.c.
 * eva: -eva-precision 1 -eva-min-loop-unroll 4 -eva-slevel 200 -split-zeros -eva-use-spec glint_mesh_inverse,glint_mesh_values_set,of_inverse */
#include "eva_meshes.h"

/*@ assigns *values, \result \from *corner[0 .. 2], area, shine, t_end; ensures 0 <= \result <= 2; */
enum glint_mesh_shine glint_mesh_values_set(struct glint_mesh_values *values,
                                            const struct glint_mesh_corner *const corner[3], int32_t area,
                                            enum glint_mesh_shine shine, uint32_t t_end);

static struct glint_mesh_triangle triangle;

void eva_mesh_triangle(void)
{
    struct glint_mesh_corner corner[3];
    const uint32_t t_end = any;
    any_triangle(corner);
    (void)glint_mesh_triangle_set(&triangle, corner, glint_mesh_shine(corner, t_end), t_end);
}

#define glint_mesh_shine(corner, t_end) of_shine(corner, t_end)
#define glint_mesh_values_set of_values_set
#define glint_mesh_inverse of_inverse
#define glint_mesh_triangle_set of_triangle_set
#define glint_mesh_triangle_skip of_triangle_skip
#define glint_mesh_slopes_set of_slopes_set
#define glint_mesh_places of_places
#include "mesh_triangle.c"
/*@ requires 0x8000000 <= m <= 0xfffffff; assigns \result \from m; ensures 32768 <= \result <= 65536; */
uint32_t glint_mesh_inverse(uint32_t m);

void eva_mesh_slopes(void)
{
    struct glint_mesh_corner corner[3];
    any_triangle(corner);
    const int32_t area = any_signed;
    if (area > 0)
        (void)gradient_slopes(corner[0].v, corner[1].v, corner[2].v, area);
    if (area < 0)
        (void)gradient_slopes(corner[0].v, corner[1].v, corner[2].v, area);
}
