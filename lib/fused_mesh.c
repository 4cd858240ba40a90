/* SPDX-License-Identifier: MIT
 * A triangle by COLOUR tables. Its lines are short, so each pixel is asked for its depth and drawn at once; three loops take what
 * dark, matt and glossy pixels need and no more. */
#include "glint_mesh_rows.h"
#include "glint_tables.h"

#if !GLINT_CORTEX_M0PLUS_ASM
/* Pixels with their depths; end: of these. */
static void colour_dark(const struct glint_look *look, uint32_t z, uint32_t dz, uint16_t *depth, const uint16_t *end,
                        uint16_t *out)
{
    const uint16_t dark = look->dark;
    for (; depth != end; depth++, out++, z += dz)
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            *out = dark;
        }
}

static void colour_matt(const struct glint_look *look, uint32_t z, uint32_t dz, uint32_t nl, uint32_t dnl,
                        uint16_t *depth, const uint16_t *end, uint16_t *out)
{
    for (; depth != end; depth++, out++, z += dz, nl += dnl)
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            *out = (int32_t)nl < 0 ? look->dark : glint_look_colour(look, glint_look_row(nl));
        }
}

static void colour_glossy(const struct glint_look *look, const struct glint_mesh_values *v, uint32_t n, uint32_t pairs,
                          uint16_t *depth, const uint16_t *end, uint16_t *out)
{
    const uint32_t dz = v->zx, dnl = v->nlx, ddt = v->txx;
    uint32_t z = v->z + n * dz, nl = v->nl + n * dnl, dt = v->tx + n * ddt;
    uint32_t back = look->t_max - v->t - n * v->tx - pairs * ddt;
    for (; depth != end; depth++, out++) {
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            glint_look_store(look, back, nl, out);
        }
        z += dz;
        nl += dnl;
        back -= dt;
        dt += ddt;
    }
}

/* Lines of a part, with the edges and steps at hand. */
static void colour_part(const struct glint_look *look, struct glint_mesh_triangle *triangle,
                        const struct glint_mesh_part *part, const struct glint_mesh_target *target)
{
    const struct glint_surface *surface = target->surface;
    const int32_t line = triangle->y - target->y;
    struct glint_mesh_values *v = &triangle->values;
    struct glint_mesh_edge left = *part->left, right = *part->right;
    uint16_t *depth_line = target->depth + target->w * line;
    uint8_t *out_line = (uint8_t *)surface->pixels + surface->stride * line;
    for (int32_t lines = part->end - triangle->y; lines; lines--) {
        int32_t from, to;
        if (glint_mesh_columns(&left, &right, target->w, &from, &to)) {
            uint16_t *depth = depth_line + from, *out = (uint16_t *)(void *)out_line + from;
            const uint16_t *const end = depth_line + to;
            const int32_t k = from - v->x; /* |k| < 2^12 */
            const uint32_t n = (uint32_t)k;
            if (triangle->shine == GLINT_MESH_GLOSSY)
                colour_glossy(look, v, n, (uint32_t)(k * (k - 1) / 2), depth, end, out);
            else if (triangle->shine == GLINT_MESH_MATT)
                colour_matt(look, v->z + n * v->zx, v->zx, v->nl + n * v->nlx, v->nlx, depth, end, out);
            else
                colour_dark(look, v->z + n * v->zx, v->zx, depth, end, out);
        }
        glint_mesh_edge_next(&left);
        glint_mesh_edge_next(&right);
        depth_line += target->w;
        out_line += surface->stride;
        if (triangle->shine == GLINT_MESH_GLOSSY) {
            glint_mesh_values_next(v);
        } else {
            v->nl += v->nly;
            v->z += v->zy;
        }
    }
    *part->left = left;
    *part->right = right;
    triangle->y = (int16_t)part->end;
}

void glint_mesh_colour(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                       const struct glint_mesh_target *target)
{
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end;
    const struct glint_look look = glint_look_up(tables);
    while (triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        colour_part(&look, triangle, &part, target);
    }
}
#else
void glint_mesh_colour_set(const struct glint_tables *tables, const struct glint_mesh_target *target,
                           struct glint_mesh_lines *lines)
{
    const struct glint_look look = glint_look_up(tables);
    const uint32_t y = (uint32_t)target->y, line = (uint32_t)target->depth;
    lines->line_step = 2 * (uint32_t)target->w;
    lines->off_step = (uint32_t)target->surface->stride - lines->line_step;
    lines->line_first = line - y * lines->line_step;
    lines->off_first = (uint32_t)target->surface->pixels - line - y * lines->off_step;
    lines->colours = look.colours;
    lines->dark = look.dark;
    lines->shift = look.shift;
    lines->limit = look.limit;
    lines->w = target->w;
    lines->end = target->end;
    lines->columns = look.columns;
    lines->t_max = look.t_max;
}
#endif
