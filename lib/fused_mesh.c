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
/* What lines by any tables need. */
static void lines_set(const struct glint_mesh_target *target, struct glint_mesh_lines *lines)
{
    const uint32_t y = (uint32_t)target->y, line = (uint32_t)target->depth;
    lines->line_step = 2 * (uint32_t)target->w;
    lines->off_step = (uint32_t)target->surface->stride - lines->line_step;
    lines->line_first = line - y * lines->line_step;
    lines->off_first = (uint32_t)target->surface->pixels - line - y * lines->off_step;
    lines->w = target->w;
    lines->end = target->end;
}

void glint_mesh_colour_set(const struct glint_tables *tables, const struct glint_mesh_target *target,
                           struct glint_mesh_lines *lines)
{
    const struct glint_look look = glint_look_up(tables);
    lines_set(target, lines);
    lines->colours = look.colours;
    lines->dark = look.dark;
    lines->shift = look.shift;
    lines->limit = look.limit;
    lines->columns = look.columns;
    lines->t_max = look.t_max;
}
#endif

/* ---- ALBEDO ---- */

#if GLINT_FUSED
#if !GLINT_CORTEX_M0PLUS_ASM
/* Of all but colours and the nearest texel without a palette: those that are asked at each pixel. */
#define ALBEDO_OTHER GLINT_MESH_SOURCES

static inline __attribute__((always_inline)) uint32_t albedo_fields(const struct glint_mesh_pixels *p, uint32_t u,
                                                                    uint32_t v, uint32_t blue, unsigned source)
{
    if (source == GLINT_MESH_COLOURS)
        return glint_mesh_colour_fields(u, v, blue);
    if (source == ALBEDO_OTHER && p->loop >= 4 * GLINT_MESH_SMOOTH)
        return glint_mesh_smooth_fields(&p->picture, u, v);
    const uint32_t at = glint_mesh_nearest(&p->picture, u, v);
    return glint_mesh_fields(source == ALBEDO_OTHER ? p->picture.palette[p->picture.pixels[at]]
                                                    : ((const uint16_t *)(const void *)p->picture.pixels)[at]);
}

static inline __attribute__((always_inline)) void albedo_side_by_side(const struct glint_mesh_pixels *p, bool is_glossy,
                                                                      bool is_swapped, unsigned source)
{
    const uint32_t dz = p->dz, dnl = p->dnl, du = p->step[0], dv = p->step[1];
    const uint32_t dblue = source == GLINT_MESH_COLOURS ? p->step[2] : 0;
    const uint8_t *const levels = p->levels;
    uint32_t z = p->z, nl = p->nl, back = p->back, dt = p->dt, u = p->now[0], v = p->now[1];
    uint32_t blue = source == GLINT_MESH_COLOURS ? p->now[2] : 0;
    const ptrdiff_t off = p->off;
    uint16_t *depth = p->depth;
    for (const uint16_t *const end = p->end; depth != end; depth++) {
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            uint32_t word = albedo_fields(p, u, v, blue, source);
            if ((int32_t)nl < 0) {
                word = (word * p->dark + GLINT_ALBEDO_HALF) >> 5 & GLINT_ALBEDO_FIELDS;
            } else {
                word = (word * levels[-1 - (int32_t)(nl >> GLINT_ALBEDO_LEVEL_SHIFT)] + GLINT_ALBEDO_HALF) >> 5 &
                       GLINT_ALBEDO_FIELDS;
                if (is_glossy && back <= p->limit)
                    word = glint_albedo_full(word + p->sums[(back <= p->t_max ? back : p->t_max) >> p->shift]);
            }
            *(uint16_t *)(void *)((uint8_t *)depth + off) = glint_packed(word, is_swapped);
        }
        z += dz;
        nl += dnl;
        u += du;
        v += dv;
        if (source == GLINT_MESH_COLOURS)
            blue += dblue;
        if (is_glossy) {
            back -= dt;
            dt += p->ddt;
        }
    }
}

#define ALBEDO_SOURCE(name, source)                                                                                    \
    static void albedo_##name##_matt(const struct glint_mesh_pixels *p)                                                \
    {                                                                                                                  \
        albedo_side_by_side(p, false, false, source);                                                                  \
    }                                                                                                                  \
    static void albedo_##name##_glossy(const struct glint_mesh_pixels *p)                                              \
    {                                                                                                                  \
        albedo_side_by_side(p, true, false, source);                                                                   \
    }                                                                                                                  \
    static void albedo_##name##_matt_swapped(const struct glint_mesh_pixels *p)                                        \
    {                                                                                                                  \
        albedo_side_by_side(p, false, true, source);                                                                   \
    }                                                                                                                  \
    static void albedo_##name##_glossy_swapped(const struct glint_mesh_pixels *p)                                      \
    {                                                                                                                  \
        albedo_side_by_side(p, true, true, source);                                                                    \
    }
ALBEDO_SOURCE(colours, GLINT_MESH_COLOURS)
ALBEDO_SOURCE(nearest, GLINT_MESH_NEAREST)
static void albedo_other_matt(const struct glint_mesh_pixels *p)
{
    albedo_side_by_side(p, false, p->loop & 2, ALBEDO_OTHER);
}
static void albedo_other_glossy(const struct glint_mesh_pixels *p)
{
    albedo_side_by_side(p, true, p->loop & 2, ALBEDO_OTHER);
}
#define ALBEDO_LOOPS(name)                                                                                             \
    albedo_##name##_matt, albedo_##name##_glossy, albedo_##name##_matt_swapped, albedo_##name##_glossy_swapped
#define ALBEDO_OTHERS albedo_other_matt, albedo_other_glossy, albedo_other_matt, albedo_other_glossy
typedef void albedo_loop(const struct glint_mesh_pixels *p);

void glint_mesh_albedo_pixels(const struct glint_mesh_pixels *p)
{
    static albedo_loop *const loops[GLINT_MESH_SOURCES * 4] GLINT_FLASH = {
        ALBEDO_LOOPS(colours), ALBEDO_LOOPS(nearest), ALBEDO_LOOPS(nearest), ALBEDO_OTHERS, ALBEDO_OTHERS};
    GLINT_FLASH_POINTER(loops[p->loop])(p);
}
#endif

/* What is the same for all of a part's triangles. */
static void albedo_set(struct glint_mesh_pixels *p, const struct glint_tables *tables,
                       const struct glint_texture *texture)
{
    const unsigned source = !texture                        ? GLINT_MESH_COLOURS
                            : texture->is_smooth            ? GLINT_MESH_SMOOTH
                            : texture->palette              ? GLINT_MESH_PALETTE
                            : glint_mesh_is_square(texture) ? GLINT_MESH_SQUARE
                                                            : GLINT_MESH_NEAREST;
    p->levels = tables->columns;
    p->sums = tables->colour.sums;
    p->t_max = tables->t_max_q30;
    p->limit = tables->t_max_q30 - GLINT_NEGATIVE_T;
    p->shift = tables->shift;
    p->dark = tables->dark;
    p->picture.pixels = texture ? (const uint8_t *)texture->pixels : NULL;
    p->picture.palette = texture ? texture->palette : NULL;
    p->loop = (uint8_t)(4u * source + 2u * glint_is_swapped(tables));
}

/* And of its lines. */
static void albedo_triangle(struct glint_mesh_pixels *p, const struct glint_mesh_triangle *triangle)
{
    p->dz = triangle->values.zx;
    p->dnl = triangle->values.nlx;
    p->ddt = triangle->values.txx;
    p->loop = (uint8_t)(p->loop | (triangle->shine >> 1 & 1)); /* glossy */
}

/* Pixels of a line up to `to`, from where p has its numbers. */
static inline __attribute__((always_inline)) void
albedo_row(struct glint_mesh_pixels *p, const struct glint_mesh_values *v, uint16_t *depth, int32_t from, int32_t to)
{
    const int32_t k = from - v->x;
    const uint32_t n = (uint32_t)k;
    p->z = v->z + n * p->dz;
    p->nl = v->nl + n * p->dnl;
    if (p->loop & 1) {
        p->dt = v->tx + n * p->ddt;
        p->back = p->t_max - v->t - n * v->tx - ((uint32_t)(k * (k - 1)) >> 1) * p->ddt;
    }
    p->depth = depth + from;
    p->end = depth + to;
    glint_mesh_albedo_pixels(p);
}

/* In perspective: a line's parts one after the other. */
static __attribute__((noinline)) void albedo_far(struct glint_mesh_pixels *p, struct glint_mesh_triangle *triangle,
                                                 const struct glint_mesh_part *part,
                                                 const struct glint_mesh_target *target, struct glint_mesh_over *over)
{
    const struct glint_use_mesh *const use = target->drawn->mesh->use;
    struct glint_mesh_values *const v = &triangle->values;
    for (; triangle->y < part->end; triangle->y++) {
        const int32_t line = triangle->y - target->y;
        uint16_t *const depth = target->depth + target->w * line;
        int32_t from, to;
        p->off = (ptrdiff_t)((uintptr_t)target->surface->pixels + (uintptr_t)(target->surface->stride * line) -
                             (uintptr_t)depth);
        if (glint_mesh_columns(part->left, part->right, target->w, &from, &to)) {
            GLINT_FLASH_POINTER(use->line)(over, triangle->y, from, to, v->z + (uint32_t)(from - v->x) * v->zx, v->zx);
            for (;;) {
                for (unsigned i = 0; i < 2; i++) {
                    p->now[i] = over->now[i];
                    p->step[i] = over->step[i];
                }
                albedo_row(p, v, depth, over->from, over->to);
                if (over->to == to)
                    break;
                GLINT_FLASH_POINTER(use->next)(over);
            }
        }
        glint_mesh_edge_next(part->left);
        glint_mesh_edge_next(part->right);
        glint_mesh_values_next(v);
    }
}

#if !GLINT_CORTEX_M0PLUS_ASM
static inline void albedo_steps(struct glint_mesh_pixels *p, const struct glint_mesh_laid *laid)
{
    p->step[0] = laid->right[0];
    p->step[1] = laid->right[1];
    p->step[2] = laid->blue[2];
}

/* A line of colours, where one would leave its range. */
static __attribute__((noinline)) void albedo_hold(struct glint_mesh_pixels *p, uint32_t n)
{
    for (unsigned k = 0; k < 3; k++)
        glint_mesh_hold(&p->now[k], &p->step[k], k, n);
}

/* Does no colour leave its range on a line? */
static inline bool albedo_is_held(const struct glint_mesh_pixels *p, uint32_t n)
{
    const uint32_t red = p->now[0] | (p->now[0] + n * p->step[0]), green = p->now[1] | (p->now[1] + n * p->step[1]),
                   blue = p->now[2] | (p->now[2] + n * p->step[2]);
    return ((red | blue) >> 26 | green >> 27) == 0;
}

static void albedo_part(struct glint_mesh_pixels *p, struct glint_mesh_triangle *triangle,
                        const struct glint_mesh_part *part, const struct glint_mesh_target *target,
                        struct glint_mesh_laid *laid)
{
    const struct glint_surface *surface = target->surface;
    const int32_t line = triangle->y - target->y;
    struct glint_mesh_values *const v = &triangle->values;
    struct glint_mesh_edge left = *part->left, right = *part->right;
    uint16_t *depth = target->depth + target->w * line;
    const bool has_colours = p->loop < 4, is_glossy = p->loop & 1;
    const ptrdiff_t off_step = surface->stride - 2 * (ptrdiff_t)target->w;
    p->off = (ptrdiff_t)((uintptr_t)surface->pixels + (uintptr_t)(surface->stride * line) - (uintptr_t)depth);
    for (int32_t lines = part->end - triangle->y; lines; lines--) {
        int32_t from, to;
        if (glint_mesh_columns(&left, &right, target->w, &from, &to)) {
            const uint32_t n = (uint32_t)(from - v->x);
            p->now[0] = laid->at[0] + n * p->step[0];
            p->now[1] = laid->at[1] + n * p->step[1];
            if (has_colours)
                p->now[2] = laid->blue[0] + n * p->step[2];
            if (has_colours && !albedo_is_held(p, (uint32_t)(to - from - 1))) {
                albedo_hold(p, (uint32_t)(to - from - 1));
                albedo_row(p, v, depth, from, to);
                albedo_steps(p, laid);
            } else {
                albedo_row(p, v, depth, from, to);
            }
        }
        glint_mesh_edge_next(&left);
        glint_mesh_edge_next(&right);
        depth += target->w;
        p->off += off_step;
        laid->at[0] += laid->down[0];
        laid->at[1] += laid->down[1];
        if (has_colours)
            laid->blue[0] += laid->blue[1];
        if (is_glossy) {
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
#endif

struct glint_mesh_laid *glint_mesh_albedo_laid(const struct glint_mesh_target *target,
                                               struct glint_mesh_triangle *triangle,
                                               const struct glint_texture *texture)
{
    struct glint_mesh_laid *const laid =
        (struct glint_mesh_laid *)(void *)((struct glint_mesh_kept *)(void *)triangle + 1);
    if (!(triangle->shine & GLINT_MESH_LAID)) {
        GLINT_FLASH_POINTER(target->drawn->mesh->use->lay)(laid, target, triangle, texture);
        triangle->shine |= GLINT_MESH_LAID;
    }
    return laid;
}

static void albedo_lines_far(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                             const struct glint_mesh_target *target, const struct glint_texture *texture)
{
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end;
    struct glint_mesh_over *const over = &((struct glint_mesh_bench *)target->frame->memory)->of.over;
    struct glint_mesh_pixels p;
    albedo_set(&p, tables, texture);
    albedo_triangle(&p, triangle);
    GLINT_FLASH_POINTER(target->drawn->mesh->use->set)(over, target, glint_mesh_face_of(triangle), texture);
    p.picture = over->picture;
    p.picture.h = glint_mesh_height_of(texture, &p.picture);
    while (triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        albedo_far(&p, triangle, &part, target, over);
    }
}

#if GLINT_CORTEX_M0PLUS_ASM
/* The assembly has them where they need not stay. */
typedef char
    albedo_pixels_fit[sizeof(struct glint_mesh_pixels) <= GLINT_MESH_RUN * sizeof(struct glint_sample) ? 1 : -1];

void glint_mesh_albedo_lines_set(const struct glint_mesh_target *target, const struct glint_tables *tables,
                                 const struct glint_texture *texture, struct glint_mesh_lines *lines)
{
    struct glint_mesh_pixels *const p = (struct glint_mesh_pixels *)(void *)target->samples;
    albedo_set(p, tables, texture);
    lines_set(target, lines);
    glint_mesh_albedo_draws(lines);
    lines->colours = p;
    lines->dark = (uint32_t)target;
    lines->shift = (uint32_t)texture;
    if (!texture)
        return;
    p->picture.w = texture->w;
    p->picture.h = texture->h;
    p->now[2] = texture->w | glint_mesh_height_of(texture, &p->picture) << 16;
    for (unsigned k = 0; k < 2; k++) /* what bilinear ones begin before the corner */
        p->now[k] = texture->is_smooth ? UINT32_C(0x80000000) / (k ? texture->h : texture->w) : 0;
}

uint32_t glint_mesh_albedo_begin(const struct glint_mesh_target *target, const struct glint_paint *paint,
                                 struct glint_mesh_lines *lines)
{
    const struct glint_texture *const texture = glint_mesh_texture_of(target->drawn, paint);
    if (target->frame->kept_bytes != GLINT_MESH_LAID_SIZE || (texture && target->frame->distance) ||
        !glint_mesh_is_albedo(paint, target))
        return 0;
    if (lines)
        glint_mesh_albedo_lines_set(target, &paint->of.tables.filled, texture, lines);
    return (uint32_t)1 << 31;
}

static void albedo_draw(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                        const struct glint_mesh_target *target, const struct glint_texture *texture)
{
    (void)glint_mesh_albedo_laid(target, triangle, texture);
    glint_mesh_albedo_triangle(target, triangle, tables, texture);
}
#else
static void albedo_draw(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                        const struct glint_mesh_target *target, const struct glint_texture *texture)
{
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end;
    struct glint_mesh_laid *const laid = glint_mesh_albedo_laid(target, triangle, texture);
    struct glint_mesh_pixels p;
    albedo_set(&p, tables, texture);
    albedo_triangle(&p, triangle);
    albedo_steps(&p, laid);
    if (texture) {
        p.picture.pixels += laid->blue[0];
        p.picture.w = laid->blue[1] & 0xffff;
        p.picture.h = laid->blue[1] >> 16;
    }
    while (triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        albedo_part(&p, triangle, &part, target, laid);
    }
}
#endif

/* Has the triangle room for what it has of the texture? */
static bool albedo_has_room(const struct glint_mesh_frame *frame, const struct glint_mesh_triangle *triangle)
{
    const uintptr_t at = (uintptr_t)triangle - (uintptr_t)frame->kept;
    return triangle == &((struct glint_mesh_bench *)frame->memory)->face.triangle ||
           (frame->kept_bytes == GLINT_MESH_LAID_SIZE &&
            at < (uintptr_t)frame->places * (uintptr_t)GLINT_MESH_KEPT_BYTES);
}

/* One that has none is copied. Alone, for the stack. */
static __attribute__((noinline)) void albedo_copied(const struct glint_tables *tables,
                                                    struct glint_mesh_triangle *triangle,
                                                    const struct glint_mesh_target *target,
                                                    const struct glint_texture *texture)
{
    struct glint_mesh_bench *const bench = (struct glint_mesh_bench *)target->frame->memory;
    struct glint_mesh_triangle *const copy = &bench->copy.triangle;
    *copy = *triangle;
    copy->shine &= GLINT_MESH_LAID - 1;
    bench->copy.face = (uint16_t)glint_mesh_face_of(triangle);
    albedo_draw(tables, copy, target, texture);
    copy->shine &= GLINT_MESH_LAID - 1;
    *triangle = *copy;
}

void glint_mesh_albedo_lines(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                             const struct glint_mesh_target *target, const struct glint_texture *texture)
{
    if (texture && target->frame->distance)
        albedo_lines_far(tables, triangle, target, texture);
    else if (albedo_has_room(target->frame, triangle))
        albedo_draw(tables, triangle, target, texture);
    else
        albedo_copied(tables, triangle, target, texture);
}
#endif
