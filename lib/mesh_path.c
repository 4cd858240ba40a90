/* SPDX-License-Identifier: MIT */
#include "glint_mesh_path.h"

/* The triangle's line; false where it has no pixel. */
static bool row_set(struct glint_mesh_row *row, const struct glint_mesh_triangle *triangle,
                    const struct glint_mesh_part *part, const struct glint_mesh_target *target)
{
    const struct glint_mesh_values *v = &triangle->values;
    const struct glint_surface *surface = target->surface;
    const int32_t line = triangle->y - target->y;
    int32_t left, right;
    if (!glint_mesh_columns(part->left, part->right, target->w, &left, &right))
        return false;
    const int32_t k = left - v->x; /* |k| < 2^12 */
    const uint32_t n = (uint32_t)k, pairs = (uint32_t)(k * (k - 1) / 2);
    row->line = (uint8_t *)surface->pixels + surface->stride * line;
    row->depth = target->depth + (size_t)target->w * (size_t)line;
    row->x = (uint32_t)left;
    row->end = (uint32_t)right;
    row->left = surface->x;
    row->y = (uint32_t)surface->y + (uint32_t)line;
    row->t = v->t + n * v->tx + pairs * v->txx;
    row->dt = v->tx + n * v->txx;
    row->ddt = v->txx;
    row->nl = v->nl + n * v->nlx;
    row->dnl = v->nlx;
    row->z = v->z + n * v->zx;
    row->dz = v->zx;
    return true;
}

bool glint_mesh_row_next(struct glint_mesh_row *row, struct glint_mesh_triangle *triangle,
                         const struct glint_mesh_target *target)
{
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end;
    bool found = false;
    while (!found && triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        found = row_set(row, triangle, &part, target);
        glint_mesh_edge_next(part.left);
        glint_mesh_edge_next(part.right);
        glint_mesh_values_next(&triangle->values);
        triangle->y++;
    }
    return found;
}

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
