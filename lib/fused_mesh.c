/* SPDX-License-Identifier: MIT
 * A triangle by COLOUR tables, and by ALBEDO tables with a texture or colours of vertices. Its lines are short, so each pixel is asked for its
 * depth and drawn at once; loops take what dark, matt and glossy pixels need and no more. */
#include "glint_mesh_rows.h"
#include "glint_mesh_texture.h"
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

/* ---- ALBEDO ---- */

#if GLINT_FUSED
#define FUSED_INLINE static inline __attribute__((always_inline))

/* A line's part: values at its first pixel, and where its pixels are. */
struct albedo_line {
    uint32_t z, nl, back, dt, now[3];
    uint16_t *depth, *out;
    const uint16_t *end; /* of depth */
};

enum albedo_of { ALBEDO_NEAREST, ALBEDO_SMOOTH, ALBEDO_COLOURS };

/* The pixels of a part. Dark ones are matt with nl below 0. */
FUSED_INLINE void albedo_pixels_of(const struct glint_tables *tables, const struct glint_mesh_values *values,
                                   const struct glint_mesh_over *over, const struct albedo_line *line,
                                   enum albedo_of of, bool is_glossy)
{
    const uint32_t dz = values->zx, dnl = values->nlx, ddt = values->txx, limit = tables->t_max_q30 - GLINT_NEGATIVE_T;
    const uint8_t *const levels = tables->columns;
    const bool swapped = glint_is_swapped(tables);
    const struct glint_mesh_picture *const picture = &over->picture;
    const uint32_t step0 = over->step[0], step1 = over->step[1], step2 = over->step[2];
    uint32_t z = line->z, nl = line->nl, back = line->back, dt = line->dt;
    uint32_t first = line->now[0], second = line->now[1], third = line->now[2];
    uint16_t *depth = line->depth, *out = line->out;
    for (const uint16_t *const end = line->end; depth != end; depth++, out++) {
        if (z >> 16 < *depth) {
            uint32_t word;
            *depth = (uint16_t)(z >> 16);
            if (of == ALBEDO_COLOURS) {
                word = glint_mesh_colour_fields(first, second, third);
            } else if (of == ALBEDO_SMOOTH) {
                word = glint_mesh_smooth_fields(picture, first, second);
            } else {
                word = glint_mesh_texel(picture, glint_mesh_nearest(picture, first, second));
                word = (word | word << 16) & GLINT_ALBEDO_FIELDS;
            }
            if ((int32_t)nl < 0) {
                word = (word * tables->dark + GLINT_ALBEDO_HALF) >> 5 & GLINT_ALBEDO_FIELDS;
            } else {
                word = (word * levels[-1 - (int32_t)(nl >> GLINT_ALBEDO_LEVEL_SHIFT)] + GLINT_ALBEDO_HALF) >> 5 &
                       GLINT_ALBEDO_FIELDS;
                if (is_glossy && back <= limit)
                    word = glint_albedo_full(
                        word +
                        tables->colour.sums[(back <= tables->t_max_q30 ? back : tables->t_max_q30) >> tables->shift]);
            }
            *out = glint_packed(word, swapped);
        }
        z += dz;
        nl += dnl;
        first += step0;
        second += step1;
        if (of == ALBEDO_COLOURS)
            third += step2;
        if (is_glossy) {
            back -= dt;
            dt += ddt;
        }
    }
}

/* Each alone, for the registers. */
#define ALBEDO_PIXELS(name, of, is_glossy)                                                                             \
    static __attribute__((noinline)) void name(const struct glint_tables *tables,                                      \
                                               const struct glint_mesh_values *values,                                 \
                                               const struct glint_mesh_over *over, const struct albedo_line *line)     \
    {                                                                                                                  \
        albedo_pixels_of(tables, values, over, line, of, is_glossy);                                                   \
    }
ALBEDO_PIXELS(albedo_nearest_matt, ALBEDO_NEAREST, false)
ALBEDO_PIXELS(albedo_nearest_glossy, ALBEDO_NEAREST, true)
ALBEDO_PIXELS(albedo_smooth_matt, ALBEDO_SMOOTH, false)
ALBEDO_PIXELS(albedo_smooth_glossy, ALBEDO_SMOOTH, true)
ALBEDO_PIXELS(albedo_colours_matt, ALBEDO_COLOURS, false)
ALBEDO_PIXELS(albedo_colours_glossy, ALBEDO_COLOURS, true)
typedef void albedo_pixels(const struct glint_tables *tables, const struct glint_mesh_values *values,
                           const struct glint_mesh_over *over, const struct albedo_line *line);

/* Pixels from..to - 1 of the triangle's line, part by part: in perspective u and v bend between these. */
static void albedo_row(const struct glint_tables *tables, const struct glint_mesh_values *v,
                       const struct glint_mesh_target *target, struct glint_mesh_over *over, int32_t line, int32_t from,
                       int32_t to, albedo_pixels *pixels)
{
    const struct glint_use_mesh *const use = target->drawn->mesh->use;
    const uint32_t n = (uint32_t)(from - v->x); /* |k| < 2^12 */
    struct albedo_line at;
    uint16_t *const depth = target->depth + target->w * line;
    uint16_t *const out = (uint16_t *)(void *)((uint8_t *)target->surface->pixels + target->surface->stride * line);
    GLINT_FLASH_POINTER(use->line)(over, line + target->y, from, to, v->z + n * v->zx, v->zx);
    for (;;) {
        const int32_t k = over->from - v->x, end = over->to;
        at.z = v->z + (uint32_t)k * v->zx;
        at.nl = v->nl + (uint32_t)k * v->nlx;
        at.back = tables->t_max_q30 - v->t - (uint32_t)k * v->tx - (uint32_t)(k * (k - 1) / 2) * v->txx;
        at.dt = v->tx + (uint32_t)k * v->txx;
        at.now[0] = over->now[0];
        at.now[1] = over->now[1];
        at.now[2] = over->now[2];
        at.depth = depth + over->from;
        at.out = out + over->from;
        at.end = depth + end;
        pixels(tables, v, over, &at);
        if (end == to)
            return;
        GLINT_FLASH_POINTER(use->next)(over);
    }
}

void glint_mesh_albedo(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                       const struct glint_mesh_target *target, struct glint_mesh_over *over)
{
    static albedo_pixels *const all[3][2] = {{albedo_nearest_matt, albedo_nearest_glossy},
                                             {albedo_smooth_matt, albedo_smooth_glossy},
                                             {albedo_colours_matt, albedo_colours_glossy}};
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end;
    albedo_pixels *const pixels = all[over->count == 3 ? 2 : over->is_smooth][triangle->shine == GLINT_MESH_GLOSSY];
    while (triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        for (; triangle->y < part.end; triangle->y++) {
            int32_t from, to;
            if (glint_mesh_columns(part.left, part.right, target->w, &from, &to))
                albedo_row(tables, &triangle->values, target, over, triangle->y - target->y, from, to, pixels);
            glint_mesh_edge_next(part.left);
            glint_mesh_edge_next(part.right);
            glint_mesh_values_next(&triangle->values);
        }
    }
}
#endif
