/* SPDX-License-Identifier: MIT */
#include "glint_mesh_path.h"

unsigned glint_mesh_in_front(struct glint_mesh_row *row, unsigned most)
{
    uint16_t *depth = row->depth + row->x;
    uint32_t z = row->z;
    for (; row->x < row->end && z >> 16 >= *depth; row->x++, depth++, z += row->dz)
        glint_mesh_step(row);
    const uint32_t left = row->end - row->x;
    unsigned count = 0;
    for (most = left < most ? (unsigned)left : most; count < most && z >> 16 < *depth; count++, depth++, z += row->dz)
        *depth = (uint16_t)(z >> 16);
    row->z = z;
    return count;
}
