/* SPDX-License-Identifier: MIT
 * A triangle by COLOUR tables, and by ALBEDO tables with a texture or colours of vertices. Its lines are short, so each pixel is asked for its
 * depth and drawn at once; loops take what dark, matt and glossy pixels need and no more. */
#include "glint_mesh_rows.h"
#include "glint_mesh_strip.h"
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
#if !GLINT_CORTEX_M0PLUS_ASM
void glint_mesh_words_nearest(const struct glint_mesh_over *over, const uint32_t now[3], uint32_t *words,
                              const uint32_t *end)
{
    const uint32_t du = over->step[0], dv = over->step[1], w = over->picture.w, h = over->picture.h;
    const uint8_t *const pixels = over->picture.pixels;
    const uint16_t *const palette = over->picture.palette, *const texels = (const uint16_t *)(const void *)pixels;
    uint32_t u = now[0], v = now[1];
    for (; words != end; u += du, v += dv) {
        const uint32_t at = ((v >> 16) * h >> 16) * w + ((u >> 16) * w >> 16);
        const uint32_t texel = palette ? palette[pixels[at]] : texels[at];
        *words++ = (texel | texel << 16) & GLINT_ALBEDO_FIELDS;
    }
}

void glint_mesh_words_smooth(const struct glint_mesh_over *over, const uint32_t now[3], uint32_t *words,
                             const uint32_t *end)
{
    const uint32_t du = over->step[0], dv = over->step[1];
    uint32_t u = now[0], v = now[1];
    for (; words != end; u += du, v += dv)
        *words++ = glint_mesh_smooth_fields(&over->picture, u, v);
}

void glint_mesh_words_colours(const struct glint_mesh_over *over, const uint32_t now[3], uint32_t *words,
                              const uint32_t *end)
{
    const uint32_t dred = over->step[0], dgreen = over->step[1], dblue = over->step[2];
    uint32_t red = now[0], green = now[1], blue = now[2];
    for (; words != end; red += dred, green += dgreen, blue += dblue)
        *words++ = glint_mesh_colour_fields(red, green, blue);
}

static inline __attribute__((always_inline)) void shade(const struct glint_mesh_shade *s, bool is_glossy,
                                                        bool is_swapped)
{
    const uint32_t dz = s->dz, dnl = s->dnl, *words = s->words;
    const uint8_t *const levels = s->levels;
    uint32_t z = s->z, nl = s->nl, back = s->back, dt = s->dt;
    const ptrdiff_t off = s->off;
    uint16_t *depth = s->depth;
    for (const uint16_t *const end = s->end; depth != end; depth++, words++) {
        if (z >> 16 < *depth) {
            uint32_t word = *words;
            *depth = (uint16_t)(z >> 16);
            if ((int32_t)nl < 0) {
                word = (word * s->dark + GLINT_ALBEDO_HALF) >> 5 & GLINT_ALBEDO_FIELDS;
            } else {
                word = (word * levels[-1 - (int32_t)(nl >> GLINT_ALBEDO_LEVEL_SHIFT)] + GLINT_ALBEDO_HALF) >> 5 &
                       GLINT_ALBEDO_FIELDS;
                if (is_glossy && back <= s->limit)
                    word = glint_albedo_full(word + s->sums[(back <= s->t_max ? back : s->t_max) >> s->shift]);
            }
            *(uint16_t *)(void *)((uint8_t *)depth + off) = glint_packed(word, is_swapped);
        }
        z += dz;
        nl += dnl;
        if (is_glossy) {
            back -= dt;
            dt += s->ddt;
        }
    }
}

void glint_mesh_shade_matt(const struct glint_mesh_shade *s)
{
    shade(s, false, false);
}
void glint_mesh_shade_glossy(const struct glint_mesh_shade *s)
{
    shade(s, true, false);
}
void glint_mesh_shade_matt_swapped(const struct glint_mesh_shade *s)
{
    shade(s, false, true);
}
void glint_mesh_shade_glossy_swapped(const struct glint_mesh_shade *s)
{
    shade(s, true, true);
}
#endif

/* Pixels of a line up to `to`, from where over has these numbers. */
static inline __attribute__((always_inline)) void albedo_row(struct glint_mesh_albedo *a,
                                                             const struct glint_mesh_values *v,
                                                             struct glint_mesh_over *over, uint32_t now[3],
                                                             uint16_t *depth, int32_t from, int32_t to)
{
    for (;;) {
        const int32_t k = from - v->x, most = (int32_t)GLINT_MESH_RUN, count = to - from < most ? to - from : most;
        const uint32_t n = (uint32_t)k;
        a->shade.z = v->z + n * a->shade.dz;
        a->shade.nl = v->nl + n * a->shade.dnl;
        if (a->is_glossy) {
            a->shade.dt = v->tx + n * a->shade.ddt;
            a->shade.back = a->shade.t_max - v->t - n * v->tx - (uint32_t)(k * (k - 1) / 2) * a->shade.ddt;
        }
        a->shade.depth = depth + from;
        a->shade.end = depth + from + count;
        a->words(over, now, a->memory, a->memory + count);
        a->pixels(&a->shade);
        from += count;
        if (from == to)
            return;
        for (unsigned i = 0; i < over->count; i++)
            now[i] += (uint32_t)count * over->step[i];
    }
}

/* Does no colour leave its range on a line? */
static inline bool albedo_is_held(const struct glint_mesh_over *over, const uint32_t now[3], uint32_t n)
{
    const uint32_t red = now[0] | (now[0] + n * over->step[0]), green = now[1] | (now[1] + n * over->step[1]),
                   blue = now[2] | (now[2] + n * over->step[2]);
    return ((red | blue) >> 26 | green >> 27) == 0;
}

/* Part by part, also in perspective. */
void glint_mesh_albedo_held(struct glint_mesh_albedo *a, const struct glint_mesh_triangle *triangle,
                            const struct glint_mesh_target *target, struct glint_mesh_over *over, uint16_t *depth,
                            int32_t from, int32_t to, int32_t y)
{
    const struct glint_use_mesh *const use = target->drawn->mesh->use;
    const struct glint_mesh_values *const v = &triangle->values;
    GLINT_FLASH_POINTER(use->line)(over, y, from, to, v->z + (uint32_t)(from - v->x) * v->zx, v->zx);
    for (; albedo_row(a, v, over, over->now, depth, over->from, over->to), over->to != to;)
        GLINT_FLASH_POINTER(use->next)(over);
    for (unsigned k = 0; k < over->count && !over->is_far; k++)
        over->step[k] = over->of[k].x;
}

#if !GLINT_CORTEX_M0PLUS_ASM
void glint_mesh_albedo_part(struct glint_mesh_albedo *a, struct glint_mesh_triangle *triangle,
                            const struct glint_mesh_part *part, const struct glint_mesh_target *target,
                            struct glint_mesh_over *over)
{
    const struct glint_surface *surface = target->surface;
    const int32_t line = triangle->y - target->y;
    struct glint_mesh_values *const v = &triangle->values;
    struct glint_mesh_edge left = *part->left, right = *part->right;
    uint16_t *depth = target->depth + target->w * line;
    const bool has_colours = over->count == 3;
    const ptrdiff_t off_step = surface->stride - 2 * (ptrdiff_t)target->w;
    a->shade.off = (ptrdiff_t)((uintptr_t)surface->pixels + (uintptr_t)(surface->stride * line) - (uintptr_t)depth);
    for (; triangle->y < part->end; triangle->y++) {
        int32_t from, to;
        if (glint_mesh_columns(&left, &right, target->w, &from, &to)) {
            uint32_t now[3];
            const uint32_t n = (uint32_t)(from - over->x);
            now[0] = over->line[0] + n * over->step[0];
            now[1] = over->line[1] + n * over->step[1];
            if (has_colours)
                now[2] = over->line[2] + n * over->step[2];
            if (has_colours && !albedo_is_held(over, now, (uint32_t)(to - from - 1)))
                glint_mesh_albedo_held(a, triangle, target, over, depth, from, to, triangle->y);
            else
                albedo_row(a, v, over, now, depth, from, to);
        }
        glint_mesh_edge_next(&left);
        glint_mesh_edge_next(&right);
        depth += target->w;
        a->shade.off += off_step;
        over->line[0] += over->of[0].y;
        over->line[1] += over->of[1].y;
        if (has_colours)
            over->line[2] += over->of[2].y;
        if (a->is_glossy) {
            glint_mesh_values_next(v);
        } else {
            v->nl += v->nly;
            v->z += v->zy;
        }
    }
    *part->left = left;
    *part->right = right;
}
#endif

/* In perspective. */
static __attribute__((noinline)) void albedo_far(struct glint_mesh_albedo *a, struct glint_mesh_triangle *triangle,
                                                 const struct glint_mesh_part *part,
                                                 const struct glint_mesh_target *target, struct glint_mesh_over *over)
{
    for (; triangle->y < part->end; triangle->y++) {
        const int32_t line = triangle->y - target->y;
        uint16_t *const depth = target->depth + target->w * line;
        int32_t from, to;
        a->shade.off = (ptrdiff_t)((uintptr_t)target->surface->pixels + (uintptr_t)(target->surface->stride * line) -
                                   (uintptr_t)depth);
        if (glint_mesh_columns(part->left, part->right, target->w, &from, &to))
            glint_mesh_albedo_held(a, triangle, target, over, depth, from, to, triangle->y);
        glint_mesh_edge_next(part->left);
        glint_mesh_edge_next(part->right);
        glint_mesh_values_next(&triangle->values);
    }
}

void glint_mesh_albedo_lines(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                             const struct glint_mesh_target *target, struct glint_mesh_over *over)
{
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end;
    const bool is_glossy = triangle->shine == GLINT_MESH_GLOSSY;
    struct glint_mesh_albedo a;
    a.is_glossy = is_glossy;
    a.shade.words = a.memory = ((struct glint_mesh_bench *)target->frame->memory)->colours.words;
    a.shade.dz = triangle->values.zx;
    a.shade.dnl = triangle->values.nlx;
    a.shade.ddt = triangle->values.txx;
    a.shade.levels = tables->columns;
    a.shade.sums = tables->colour.sums;
    a.shade.t_max = tables->t_max_q30;
    a.shade.limit = tables->t_max_q30 - GLINT_NEGATIVE_T;
    a.shade.shift = tables->shift;
    a.shade.dark = tables->dark;
    a.words = over->count == 3  ? glint_mesh_words_colours
              : over->is_smooth ? glint_mesh_words_smooth
                                : glint_mesh_words_nearest;
    a.is_swapped = glint_is_swapped(tables);
    if (a.is_swapped)
        a.pixels = is_glossy ? glint_mesh_shade_glossy_swapped : glint_mesh_shade_matt_swapped;
    else
        a.pixels = is_glossy ? glint_mesh_shade_glossy : glint_mesh_shade_matt;
    if (!over->is_far) {
        const uint32_t lines = (uint32_t)(triangle->y - over->y);
        for (unsigned k = 0; k < over->count; k++) {
            over->line[k] = over->of[k].at + lines * over->of[k].y;
            over->step[k] = over->of[k].x;
        }
    }
    while (triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        (over->is_far ? albedo_far : glint_mesh_albedo_part)(&a, triangle, &part, target, over);
    }
}
#endif
