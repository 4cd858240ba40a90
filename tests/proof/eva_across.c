/* SPDX-License-Identifier: MIT
 * For Eva: what a triangle's corners have, at any pixel: any three numbers of each of any three corners, clipped or not.
 * eva: -eva-precision 1 -eva-min-loop-unroll 8 -eva-slevel 60 -split-zeros -eva-use-spec of_reciprocal,of_area */
#include "eva_meshes.h"
#include "glint_math.h"
#include "glint_mesh_rows.h"
#include "glint_mesh_strip.h"
#define glint_mesh_corners_of of_corners_of
#define glint_mesh_corners_weigh of_corners_weigh
#define glint_mesh_across_set of_across_set
#define glint_reciprocal of_reciprocal
#define glint_mesh_area of_area
/* A face that shows: mesh_lists.c and mesh_strip.c leave out the others. */
/*@ assigns \result \from *a, *b, *c; ensures \result < 0; */
int32_t of_area(const struct glint_mesh_vertex *a, const struct glint_mesh_vertex *b,
                const struct glint_mesh_vertex *c);
/* All m, by eva_finite. */
/*@ requires 0x8000000 <= m <= 0xfffffff; assigns \result \from m; ensures 0x40000000 <= \result <= 0x8000000f; */
uint32_t of_reciprocal(uint32_t m);
#include "mesh_across.c"

static int16_t of[3][3];

void eva_mesh_across(void)
{
    struct glint_mesh_corner corner[3];
    struct glint_mesh_across across;
    uint32_t now[3];
    any_triangle(corner);
    const struct glint_mesh_corners corners = {{corner[0].v, corner[1].v, corner[2].v}, {NULL, NULL, NULL}};
    for (unsigned i = 0; i < 3; i++)
        for (unsigned k = 0; k < 3; k++) {
            const int16_t number = (int16_t)any;
            of[i][k] = number < -32767 ? -32767 : number;
        }
    glint_mesh_across_set(&across, &corners, of);
    glint_mesh_across_at(&across, any_signed % 2048, any_signed % 2048, now);
    for (unsigned k = 0; k < 3; k++)
        (void)glint_mesh_across_next(&across.of[k], &now[k]);
}

void eva_mesh_corners_weigh(void)
{
    struct glint_mesh_clipped at[3];
    ANY_BYTES(of);
    for (unsigned i = 0; i < 3; i++)
        at[i].weight[0] = (uint16_t)(any % 32769), at[i].weight[1] = (uint16_t)(any % 32769);
    const struct glint_mesh_corners corners = {{NULL, NULL, NULL}, {&at[0], &at[1], &at[2]}};
    glint_mesh_corners_weigh(&corners, of);
}
