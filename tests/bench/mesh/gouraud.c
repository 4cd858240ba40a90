/* SPDX-License-Identifier: MIT
 * A vertex's brightness takes the place of its N.L, which the rasterizer interpolates; t is past every highlight. */
#include "gouraud.h"
#include "glint_mesh_strip.h"

const struct glint_paint *gouraud_paint;

void gouraud_vertices(struct glint_mesh_drawn *drawn, uint32_t n, unsigned q)
{
    const uint32_t t_max = glint_msh_cutoff_t(n, q);
    for (unsigned i = 0; i < drawn->mesh->vertex_count; i++) {
        struct glint_mesh_vertex *v = &drawn->vertices[i];
        const uint32_t one = (uint32_t)1 << 30, nl = v->nl_q30 < 0 ? 0 : (uint32_t)v->nl_q30;
        uint32_t f = nl && v->t_q30 <= t_max ? glint_msh_t(n, v->t_q30) : 0;
        f = f > 65536 ? 65536 : f;
        const uint32_t light = one / 5 + (nl < one ? nl : one) / 2 + f * (one / 65536 / 10 * 3);
        v->nl_q30 = (int32_t)(light < one ? light : one - 1);
        v->t_q30 = GLINT_MESH_FAR_T;
    }
}

/* Lines of a part of a triangle: as the library's COLOUR tables draw what has no highlight, but for the colour. */
static void gouraud_part(struct glint_mesh_triangle *triangle, const struct glint_mesh_part *part,
                         const struct glint_mesh_target *target)
{
    struct glint_mesh_values *v = &triangle->values;
    struct glint_mesh_edge left = *part->left, right = *part->right;
    const uint32_t dz = v->zx, dlight = v->nlx;
    for (; triangle->y < part->end; triangle->y++) {
        const int32_t line = triangle->y - target->y;
        int32_t from, to;
        if (glint_mesh_columns(&left, &right, target->w, &from, &to)) {
            const uint32_t n = (uint32_t)(from - v->x);
            uint32_t z = v->z + n * dz, light = v->nl + n * dlight;
            uint16_t *depth = target->depth + target->w * line + from;
            const uint16_t *const end = depth + (to - from);
            uint16_t *out =
                (uint16_t *)(void *)((uint8_t *)target->surface->pixels + target->surface->stride * line) + from;
            for (; depth != end; depth++, out++, z += dz, light += dlight)
                if (z >> 16 < *depth) {
                    const uint32_t level = light >> 24 & 63; /* of 63 */
                    *depth = (uint16_t)(z >> 16);
                    *out = (uint16_t)((level >> 1) << 11 | level << 5 | level >> 1);
                }
        }
        glint_mesh_edge_next(&left);
        glint_mesh_edge_next(&right);
        v->nl += v->nly;
        v->z += v->zy;
    }
    *part->left = left;
    *part->right = right;
}

static void gouraud_draw(struct glint_mesh_triangle *triangle, const struct glint_mesh_target *target)
{
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end;
    if (triangle->y < target->y)
        glint_mesh_triangle_skip(triangle, target->y);
    while (triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        gouraud_part(triangle, &part, target);
    }
}

/* In the place of the library's, by the linker's --wrap. */
void __real_glint_mesh_rows(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                            const struct glint_mesh_target *target);
void __wrap_glint_mesh_rows(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                            const struct glint_mesh_target *target);
void __wrap_glint_mesh_rows(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                            const struct glint_mesh_target *target)
{
    if (paint == gouraud_paint)
        gouraud_draw(triangle, target);
    else
        __real_glint_mesh_rows(paint, triangle, target);
}
