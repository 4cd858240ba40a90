/* SPDX-License-Identifier: MIT
 * What drivers of meshes share: corners of triangles, and what stands for some of the library's functions. */
#ifndef PROOF_EVA_MESHES_H
#define PROOF_EVA_MESHES_H

#include "eva.h"
#include "glint_mesh_triangle.h"

/* All m, by eva_finite. */
/*@ requires 0x8000000 <= m <= 0xfffffff; assigns \result \from m; ensures 32768 <= \result <= 65536; */
uint32_t glint_mesh_inverse(uint32_t m);

/* The compiler's. */
int __builtin_clz(unsigned x)
{
    /*@ assert x != 0; */
    int zeros = 0;
    for (unsigned bit = (unsigned)1 << 31; x < bit; bit >>= 1)
        zeros++;
    return zeros;
}

static struct glint_mesh_vertex any_corners[3];

/* As vertices that are not out have it, in a picture of any size: at most 16383 from its middle. */
static int16_t any_place(void)
{
    const uint32_t size = 1 + any % GLINT_MESH_SIZE_MAX;
    return (int16_t)(any % 32767 - 16383 + 8 * size);
}

static void any_triangle(struct glint_mesh_corner corner[3])
{
    for (unsigned i = 0; i < 3; i++) {
        const struct glint_mesh_vertex v = {any_place(), any_place(), (uint16_t)any, 0, any, any_signed};
        any_corners[i] = v;
        corner[i].v = &any_corners[i];
        corner[i].side = any;
    }
}

#endif
