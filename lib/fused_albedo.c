/* SPDX-License-Identifier: MIT
 * A triangle by ALBEDO tables with a texture or colours of vertices, as fused_mesh.c draws one by COLOUR tables. */
#include "glint_mesh_rows.h"
#include "glint_mesh_strip.h"
#include "glint_mesh_texture.h"
#include "glint_tables.h"

#if GLINT_FUSED
#if !GLINT_CORTEX_M0PLUS_ASM
/* 1: small code: the order of bytes is asked at each pixel, and of lines of a texture there is one function. */
#ifdef __OPTIMIZE_SIZE__
#define ALBEDO_SMALL 1
#else
#define ALBEDO_SMALL 0
#endif

/* 1: a function for glossy triangles and one for others, as each then has its registers for one loop. Left to itself gcc has a loop's steps on the
 * stack and takes the registers that can do little but add for what it fetches. So steps are held in these, and what goes on from line to line
 * stays in memory. */
#if GLINT_THUMB1
#define ALBEDO_APART (!ALBEDO_SMALL)
#define ALBEDO_STEP(x) __asm__("" : "+h"(x))
#define ALBEDO_STAY(x) __asm__("" : "+m"(x) : : "memory")
#else
#define ALBEDO_APART 0
#define ALBEDO_STEP(x) (void)0
#define ALBEDO_STAY(x) (void)0
#endif

/* Of all but colours and the nearest texel without a palette: those that are asked at each pixel. */
#define ALBEDO_OTHER GLINT_MESH_SOURCES

/* Alone, as it would leave the loop no register. */
static __attribute__((noinline)) uint32_t albedo_smooth(const struct glint_mesh_picture *picture, uint32_t u,
                                                        uint32_t v)
{
    return glint_mesh_smooth_fields(picture, u, v);
}

static inline __attribute__((always_inline)) uint32_t albedo_fields(const struct glint_mesh_pixels *p, uint32_t u,
                                                                    uint32_t v, uint32_t blue, unsigned source)
{
    if (source == GLINT_MESH_COLOURS)
        return glint_mesh_colour_fields(u, v, blue);
    if (source == ALBEDO_OTHER && p->loop >= 4 * GLINT_MESH_SMOOTH)
        return albedo_smooth(&p->picture, u, v);
    const uint32_t at = glint_mesh_nearest(&p->picture, u, v);
    return glint_mesh_fields(source == ALBEDO_OTHER ? p->picture.palette[p->picture.pixels[at]]
                                                    : ((const uint16_t *)(const void *)p->picture.pixels)[at]);
}

/* A line's pixels: values at the first one, and steps. */
struct albedo_run {
    uint32_t z, nl, back, dt, now[3];
    uint32_t dz, dnl, ddt, step[3];
    uint16_t *depth;
    const uint16_t *end; /* of depth; there is one */
    ptrdiff_t off;       /* bytes from a depth to its pixel */
};

static inline __attribute__((always_inline)) void albedo_side_by_side(const struct glint_mesh_pixels *p,
                                                                      const struct albedo_run *run, bool is_glossy,
                                                                      bool is_swapped, unsigned source)
{
    const uint8_t *const levels = p->levels;
    const uint16_t *const end = run->end;
    const ptrdiff_t off = run->off;
    const bool has_blue = source == GLINT_MESH_COLOURS;
    uint32_t dz = run->dz, dlack = 0 - run->dnl, du = run->step[0], dv = run->step[1], half = GLINT_ALBEDO_HALF;
    const uint32_t ddt = is_glossy ? run->ddt : 0, dblue = has_blue ? run->step[2] : 0;
    uint32_t z = run->z, lack = ~run->nl; /* -1 - nl, as levels go down */
    uint32_t back = is_glossy ? run->back : 0, dback = is_glossy ? 0 - run->dt : 0;
    uint32_t u = run->now[0], v = run->now[1], blue = has_blue ? run->now[2] : 0;
    uint16_t *depth = run->depth;
    do {
        if (source != ALBEDO_OTHER) {
            ALBEDO_STEP(dz);
            ALBEDO_STEP(dlack);
            ALBEDO_STEP(du);
            ALBEDO_STEP(dv);
        }
        if (source == GLINT_MESH_NEAREST && !is_glossy)
            ALBEDO_STEP(half);
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            uint32_t word = albedo_fields(p, u, v, blue, source);
            const int32_t number = (int32_t)lack >> GLINT_ALBEDO_LEVEL_SHIFT;
            word = (word * (number < 0 ? levels[number] : p->dark) + half) >> 5 & GLINT_ALBEDO_FIELDS;
            if (is_glossy && (int32_t)back >= 0 && number < 0) { /* t_max and limit are below 2^31 */
                if (__builtin_expect(back <= p->t_max, 1))
                    word = glint_albedo_full(word + p->sums[back >> p->shift]);
                else if (back <= p->limit)
                    word = glint_albedo_full(word + p->sums[p->t_max >> p->shift]);
            }
            *(uint16_t *)(void *)((uint8_t *)depth + off) = glint_packed(word, is_swapped);
        }
        z += dz;
        lack += dlack;
        u += du;
        v += dv;
        if (has_blue)
            blue += dblue;
        if (is_glossy) {
            back += dback;
            dback -= ddt;
        }
    } while (++depth != end);
}

static inline __attribute__((always_inline)) void
albedo_run_by(const struct glint_mesh_pixels *p, const struct albedo_run *run, bool is_glossy, unsigned source)
{
    if (ALBEDO_SMALL)
        albedo_side_by_side(p, run, is_glossy, p->loop & 2, source);
    else if (p->loop & 2)
        albedo_side_by_side(p, run, is_glossy, true, source);
    else
        albedo_side_by_side(p, run, is_glossy, false, source);
}

static inline __attribute__((always_inline)) void
albedo_numbers(const struct glint_mesh_pixels *p, const struct albedo_run *run, bool is_glossy, unsigned source)
{
    if (GLINT_THUMB1 || source == ALBEDO_OTHER)
        albedo_side_by_side(p, run, is_glossy, p->loop & 2, source);
    else
        albedo_run_by(p, run, is_glossy, source);
}

/* The same from numbers in memory. */
#define ALBEDO_PIXELS(name, is_glossy, source)                                                                         \
    static __attribute__((noinline)) void albedo_pixels_##name(const struct glint_mesh_pixels *p)                      \
    {                                                                                                                  \
        const struct albedo_run run = {p->z,                                                                           \
                                       p->nl,                                                                          \
                                       (is_glossy) ? p->back : 0,                                                      \
                                       (is_glossy) ? p->dt : 0,                                                        \
                                       {p->now[0], p->now[1], 0},                                                      \
                                       p->dz,                                                                          \
                                       p->dnl,                                                                         \
                                       p->ddt,                                                                         \
                                       {p->step[0], p->step[1], 0},                                                    \
                                       p->depth,                                                                       \
                                       p->end,                                                                         \
                                       p->off};                                                                        \
        albedo_numbers(p, &run, is_glossy, source);                                                                    \
    }
ALBEDO_PIXELS(nearest_matt, false, GLINT_MESH_NEAREST)
ALBEDO_PIXELS(nearest_glossy, true, GLINT_MESH_NEAREST)
ALBEDO_PIXELS(other_matt, false, ALBEDO_OTHER)
ALBEDO_PIXELS(other_glossy, true, ALBEDO_OTHER)

void glint_mesh_albedo_pixels(const struct glint_mesh_pixels *p)
{
    const bool is_glossy = p->loop & 1;
    if (p->loop >= 4 * GLINT_MESH_PALETTE && is_glossy)
        albedo_pixels_other_glossy(p);
    else if (p->loop >= 4 * GLINT_MESH_PALETTE)
        albedo_pixels_other_matt(p);
    else if (is_glossy)
        albedo_pixels_nearest_glossy(p);
    else
        albedo_pixels_nearest_matt(p);
}
#endif

/* What is the same for all of a part's triangles. */
static inline void albedo_set(struct glint_mesh_pixels *p, const struct glint_tables *tables,
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

/* What a triangle has of the texture. */
static inline void albedo_picture(struct glint_mesh_pixels *p, const struct glint_mesh_laid *laid)
{
    p->picture.pixels += laid->of[GLINT_MESH_LAID_BLUE];
    p->picture.w = laid->of[GLINT_MESH_LAID_BLUE + 1] & 0xffff;
    p->picture.h = laid->of[GLINT_MESH_LAID_BLUE + 1] >> 16;
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

/* Of a part: in perspective over, by which a line's parts follow each other, or laid. */
static __attribute__((noinline)) void albedo_part(struct glint_mesh_pixels *p, struct glint_mesh_triangle *triangle,
                                                  const struct glint_mesh_part *part,
                                                  const struct glint_mesh_target *target, struct glint_mesh_over *over,
                                                  struct glint_mesh_laid *laid)
{
    const struct glint_use_mesh *const use = target->drawn->mesh->use;
    struct glint_mesh_values *const v = &triangle->values;
    for (; triangle->y < part->end; triangle->y++) {
        const int32_t line = triangle->y - target->y;
        uint16_t *const depth = target->depth + target->w * line;
        int32_t from, to;
        p->off = (ptrdiff_t)((uintptr_t)target->surface->pixels + (uintptr_t)(target->surface->stride * line) -
                             (uintptr_t)depth);
        if (!glint_mesh_columns(part->left, part->right, target->w, &from, &to)) {
        } else if (laid) {
            p->now[0] = laid->of[0] + (uint32_t)(from - v->x) * p->step[0];
            p->now[1] = laid->of[1] + (uint32_t)(from - v->x) * p->step[1];
            albedo_row(p, v, depth, from, to);
        } else {
            GLINT_FLASH_POINTER(use->line)(over, triangle->y, from, to, v->z + (uint32_t)(from - v->x) * v->zx, v->zx);
            for (;;) {
                p->now[0] = over->now[0];
                p->step[0] = over->step[0];
                p->now[1] = over->now[1];
                p->step[1] = over->step[1];
                albedo_row(p, v, depth, over->from, over->to);
                if (over->to == to)
                    break;
                GLINT_FLASH_POINTER(use->next)(over);
            }
        }
        for (unsigned i = 0; i < 2 && laid; i++)
            laid->of[i] += laid->of[GLINT_MESH_LAID_DOWN + i];
        glint_mesh_edge_next(part->left);
        glint_mesh_edge_next(part->right);
        glint_mesh_values_next(v);
    }
}

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

/* laid: NULL in perspective. */
static __attribute__((noinline)) void albedo_lines_of(const struct glint_tables *tables,
                                                      struct glint_mesh_triangle *triangle,
                                                      const struct glint_mesh_target *target,
                                                      const struct glint_texture *texture, struct glint_mesh_laid *laid)
{
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end;
    struct glint_mesh_over *const over = &((struct glint_mesh_bench *)target->frame->memory)->of.over;
    struct glint_mesh_pixels p;
    albedo_set(&p, tables, texture);
    albedo_triangle(&p, triangle);
    if (laid) {
        albedo_picture(&p, laid);
        p.step[0] = laid->of[GLINT_MESH_LAID_RIGHT];
        p.step[1] = laid->of[GLINT_MESH_LAID_RIGHT + 1];
    } else {
        GLINT_FLASH_POINTER(target->drawn->mesh->use->set)(over, target, glint_mesh_face_of(triangle), texture);
        p.picture = over->picture;
        p.picture.h = glint_mesh_height_of(texture, &p.picture);
    }
    while (triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        albedo_part(&p, triangle, &part, target, over, laid);
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
    glint_mesh_lines_set(target, lines);
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
/* Does no colour leave its range on a line of n + 1 pixels? */
static inline bool albedo_is_held(const struct albedo_run *run, uint32_t n)
{
    const uint32_t red = run->now[0] | (run->now[0] + n * run->step[0]),
                   green = run->now[1] | (run->now[1] + n * run->step[1]),
                   blue = run->now[2] | (run->now[2] + n * run->step[2]);
    return ((red | blue) >> 26 | green >> 27) == 0;
}

/* A line where one would. */
static __attribute__((noinline)) void albedo_hold(uint32_t now[3], uint32_t step[3], uint32_t n)
{
    for (unsigned k = 0; k < 3; k++)
        glint_mesh_hold(&now[k], &step[k], k, n);
}

static inline __attribute__((always_inline)) void albedo_colours_begin(struct albedo_run *run,
                                                                       const struct glint_mesh_laid *laid, uint32_t n)
{
    const uint32_t last = (uint32_t)(run->end - run->depth - 1);
    run->step[2] = laid->of[GLINT_MESH_LAID_BLUE + 2];
    run->now[2] = laid->of[GLINT_MESH_LAID_BLUE] + n * run->step[2];
    if (albedo_is_held(run, last))
        return;
    uint32_t now[3] = {run->now[0], run->now[1], run->now[2]}, step[3] = {run->step[0], run->step[1], run->step[2]};
    albedo_hold(now, step, last);
    for (unsigned k = 0; k < 3; k++) {
        run->now[k] = now[k];
        run->step[k] = step[k];
    }
}

/* Pixels of the triangle's line from column `from` on, which run has. */
static inline __attribute__((always_inline)) void
albedo_line(const struct glint_mesh_pixels *p, const struct glint_mesh_triangle *triangle,
            const struct glint_mesh_laid *laid, struct albedo_run *run, int32_t from, bool is_glossy, unsigned source)
{
    const struct glint_mesh_values *const v = &triangle->values;
    const int32_t k = from - v->x;
    const uint32_t n = (uint32_t)k;
    run->dz = v->zx;
    run->z = v->z + n * run->dz;
    run->dnl = v->nlx;
    run->nl = v->nl + n * run->dnl;
    run->step[0] = laid->of[GLINT_MESH_LAID_RIGHT];
    run->now[0] = laid->of[0] + n * run->step[0];
    run->step[1] = laid->of[GLINT_MESH_LAID_RIGHT + 1];
    run->now[1] = laid->of[1] + n * run->step[1];
    if (is_glossy) {
        run->ddt = v->txx;
        run->dt = v->tx + n * run->ddt;
        run->back = p->t_max - v->t - n * v->tx - ((uint32_t)(k * (k - 1)) >> 1) * run->ddt;
    }
    if (source == GLINT_MESH_COLOURS)
        albedo_colours_begin(run, laid, n);
    if (is_glossy)
        albedo_run_by(p, run, true, source);
    else
        albedo_run_by(p, run, false, source);
}

/* To the next line. */
static inline void albedo_next(struct glint_mesh_values *v, struct glint_mesh_laid *laid, bool is_glossy,
                               unsigned source)
{
    laid->of[0] += laid->of[GLINT_MESH_LAID_DOWN];
    laid->of[1] += laid->of[GLINT_MESH_LAID_DOWN + 1];
    if (source == GLINT_MESH_COLOURS)
        laid->of[GLINT_MESH_LAID_BLUE] += laid->of[GLINT_MESH_LAID_BLUE + 1];
    if (is_glossy) {
        glint_mesh_values_next(v);
    } else {
        v->nl += v->nly;
        v->z += v->zy;
    }
}

/* A triangle, laid, up to line end - 1. */
static inline __attribute__((always_inline)) void albedo_lines(const struct glint_tables *tables,
                                                               struct glint_mesh_triangle *triangle,
                                                               const struct glint_mesh_target *target,
                                                               const struct glint_texture *texture, bool is_glossy,
                                                               unsigned source)
{
    const struct glint_surface *const surface = target->surface;
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end, w = target->w,
                  line = triangle->y - target->y;
    struct glint_mesh_laid *const laid =
        (struct glint_mesh_laid *)(void *)((struct glint_mesh_kept *)(void *)triangle + 1);
    ptrdiff_t depth_step = 2 * (ptrdiff_t)w, off_step = surface->stride - depth_step;
    uint8_t *depth = (uint8_t *)(target->depth + w * line);
    ptrdiff_t off = (ptrdiff_t)((uintptr_t)surface->pixels + (uintptr_t)(surface->stride * line) - (uintptr_t)depth);
    struct glint_mesh_pixels p;
    albedo_set(&p, tables, texture);
    albedo_triangle(&p, triangle);
    if (source != GLINT_MESH_COLOURS)
        albedo_picture(&p, laid);
    while (triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        uint32_t left = (uint32_t)part.left->x, right = (uint32_t)part.right->x;
        uint32_t left_step = (uint32_t)part.left->step, right_step = (uint32_t)part.right->step;
        int32_t lines = part.end - triangle->y;
        triangle->y = (int16_t)part.end;
        do {
            int32_t from = (int32_t)left >> 16, to = (int32_t)right >> 16;
            from = from < 0 ? 0 : from;
            to = to > w ? w : to;
            if (from < to) {
                struct albedo_run run;
                run.depth = (uint16_t *)(void *)depth + from;
                run.end = (uint16_t *)(void *)depth + to;
                run.off = off;
                albedo_line(&p, triangle, laid, &run, from, is_glossy, source);
            }
            ALBEDO_STAY(left);
            ALBEDO_STAY(right);
            ALBEDO_STAY(left_step);
            ALBEDO_STAY(right_step);
            ALBEDO_STAY(depth);
            ALBEDO_STAY(depth_step);
            ALBEDO_STAY(off);
            ALBEDO_STAY(off_step);
            ALBEDO_STAY(lines);
            left += left_step;
            right += right_step;
            depth += depth_step;
            off += off_step;
            albedo_next(&triangle->values, laid, is_glossy, source);
        } while (--lines);
        part.left->x = (int32_t)left;
        part.right->x = (int32_t)right;
    }
}

#define ALBEDO_LINES(name, is_glossy, source)                                                                          \
    static __attribute__((noinline)) void albedo_##name(                                                               \
        const struct glint_tables *tables, struct glint_mesh_triangle *triangle,                                       \
        const struct glint_mesh_target *target, const struct glint_texture *texture)                                   \
    {                                                                                                                  \
        albedo_lines(tables, triangle, target, texture, is_glossy, source);                                            \
    }
#if ALBEDO_APART
ALBEDO_LINES(colours_matt, false, GLINT_MESH_COLOURS)
ALBEDO_LINES(colours_glossy, true, GLINT_MESH_COLOURS)
ALBEDO_LINES(nearest_matt, false, GLINT_MESH_NEAREST)
ALBEDO_LINES(nearest_glossy, true, GLINT_MESH_NEAREST)
#define ALBEDO_BY(name)                                                                                                \
    if (triangle->shine & GLINT_MESH_GLOSSY)                                                                           \
        albedo_##name##_glossy(tables, triangle, target, texture);                                                     \
    else                                                                                                               \
        albedo_##name##_matt(tables, triangle, target, texture)
#else
ALBEDO_LINES(colours, (triangle->shine & GLINT_MESH_GLOSSY) != 0, GLINT_MESH_COLOURS)
#if !ALBEDO_SMALL
ALBEDO_LINES(nearest, (triangle->shine & GLINT_MESH_GLOSSY) != 0, GLINT_MESH_NEAREST)
#endif
#define ALBEDO_BY(name) albedo_##name(tables, triangle, target, texture)
#endif

static void albedo_draw(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                        const struct glint_mesh_target *target, const struct glint_texture *texture)
{
    struct glint_mesh_laid *const laid = glint_mesh_albedo_laid(target, triangle, texture);
    if (!texture) {
        ALBEDO_BY(colours);
        return;
    }
#if !ALBEDO_SMALL
    if (!texture->palette && !texture->is_smooth) {
        ALBEDO_BY(nearest);
        return;
    }
#endif
    albedo_lines_of(tables, triangle, target, texture, laid);
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

/* One that has none is copied; below the strip it goes on from where it was. Alone, for the stack. */
static __attribute__((noinline)) void albedo_copied(const struct glint_tables *tables,
                                                    const struct glint_mesh_triangle *triangle,
                                                    const struct glint_mesh_target *target,
                                                    const struct glint_texture *texture)
{
    struct glint_mesh_bench *const bench = (struct glint_mesh_bench *)target->frame->memory;
    struct glint_mesh_triangle *const copy = &bench->copy.triangle;
    *copy = *triangle;
    copy->shine &= GLINT_MESH_LAID - 1;
    bench->copy.face = (uint16_t)glint_mesh_face_of(triangle);
    albedo_draw(tables, copy, target, texture);
}

void glint_mesh_albedo_lines(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                             const struct glint_mesh_target *target, const struct glint_texture *texture)
{
    if (texture && target->frame->distance)
        albedo_lines_of(tables, triangle, target, texture, NULL);
    else if (albedo_has_room(target->frame, triangle))
        albedo_draw(tables, triangle, target, texture);
    else
        albedo_copied(tables, triangle, target, texture);
}
#endif
