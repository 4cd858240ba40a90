/* SPDX-License-Identifier: MIT
 * For Eva: the steps of a triangle's values. What is cut to 15 bits is what test_mesh_words shows of it.
 * eva: -eva-precision 1 -eva-min-loop-unroll 4 -eva-slevel 200 -split-zeros -eva-use-spec of_slopes,of_pair */
#define glint_mesh_pair_of header_pair_of
#include "eva_meshes.h"
#undef glint_mesh_pair_of
#define glint_mesh_shine(corner, t_end) of_shine(corner, t_end)
#define glint_mesh_values_set of_values_set
#define glint_mesh_inverse of_inverse
#define glint_mesh_triangle_set of_triangle_set
#define glint_mesh_triangle_skip of_triangle_skip
#define glint_mesh_slopes_set of_slopes_set
#define glint_mesh_places of_places
#define gradient_slopes of_slopes
#define glint_mesh_pair_of of_pair

/*@ assigns \result \from p, q; ensures -32768 <= \result.p <= 32767 && -32768 <= \result.q <= 32767 && \result.shift <= 16; */
static struct glint_mesh_pair of_pair(int32_t p, int32_t q);

/*@ assigns \result \from *a, *b, *c, area;
    ensures -32767 <= \result.ux <= 32767 && -32767 <= \result.uy <= 32767 && -32767 <= \result.vx <= 32767 && -32767 <= \result.vy <= 32767;
    ensures -23552 <= \result.u <= 23552 && -23552 <= \result.v <= 23552;
    ensures -5 <= \result.e < 12 || 12 <= \result.e <= 41; */
static struct glint_mesh_slopes of_slopes(const struct glint_mesh_vertex *a, const struct glint_mesh_vertex *b,
                                          const struct glint_mesh_vertex *c, int32_t area);
#include "mesh_triangle.c"

static struct glint_mesh_values values;
void eva_mesh_values(void)
{
    struct glint_mesh_corner corner[3];
    const struct glint_mesh_corner *const at[3] = {&corner[0], &corner[1], &corner[2]};
    const uint32_t t_end = any;
    any_triangle(corner);
    for (unsigned shine = GLINT_MESH_DARK; shine <= GLINT_MESH_GLOSSY; shine++)
        (void)glint_mesh_values_set(&values, at, any_signed, (enum glint_mesh_shine)shine, t_end);
}
