/* SPDX-License-Identifier: MIT */
#include "mesh_cksum.h"
#include "cksum.h"

static uint32_t add(uint32_t sum, unsigned value)
{
    const uint8_t bytes[2] = {(uint8_t)value, (uint8_t)(value >> 8)};
    return cksum_add(sum, bytes, 2);
}

uint32_t mesh_cksum(const struct glint_mesh *mesh)
{
    const size_t places = (size_t)3 * mesh->vertex_count, corners = (size_t)3 * mesh->face_count;
    const size_t even = (places + 1) & ~(size_t)1; /* a byte of 0 after an odd number of normals */
    uint32_t sum = 0;
    for (size_t i = 0; i < places; i++)
        sum = add(sum, (uint16_t)mesh->places[i]);
    sum = cksum_add(sum, mesh->normals8, places);
    sum = cksum_add(sum, "", even - places);
    for (size_t i = 0; i < corners; i++)
        sum = add(sum, mesh->faces[i]);
    return cksum_end(sum, 2 * places + even + 2 * corners);
}
