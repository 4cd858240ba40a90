/* SPDX-License-Identifier: MIT
 * A rectangle, a span, a palette: lines of a source, in runs of the pixels that are drawn, given to the paint. */
#include "glint_draw.h"
#include "glint_fused.h"
#include "glint_grain.h"
#include "glint_lights.h"
#include "glint_math.h"
#include "glint_port.h"
#include "glint_sample.h"

void glint_bounds_add(struct glint_bounds *b, uint32_t x, uint32_t y)
{
    b->left = x < b->left ? (uint16_t)x : b->left;
    b->right = x > b->right ? (uint16_t)x : b->right;
    b->top = y < b->top ? (uint16_t)y : b->top;
    b->bottom = (uint16_t)y;
}

void glint_bounds_box(const struct glint_bounds *b, struct glint_box *box)
{
    if (!box)
        return;
    box->x = box->y = box->w = box->h = 0;
    if (b->left <= b->right) {
        box->x = b->left;
        box->y = b->top;
        box->w = (uint16_t)(b->right - b->left + 1);
        box->h = (uint16_t)(b->bottom - b->top + 1);
    }
}

/* ---- Lines as runs ---- */

/* Where the map has line y, or NULL. Inlined in one place only. */
static inline const uint8_t *lines_of(const uint8_t *map, ptrdiff_t stride, uint32_t y)
{
    return map ? map + stride * (ptrdiff_t)y : NULL;
}

void glint_lines_set(struct glint_lines *lines, uint32_t y)
{
    const struct glint_maps *maps = lines->maps;
    const struct glint_surface *target = lines->target;
    lines->run.line = (uint8_t *)target->pixels + target->stride * (ptrdiff_t)y;
    lines->run.x = 0;
    lines->run.y = target->y + y;
    if (!maps)
        return;
    lines->run.coverage = lines_of(maps->coverage, maps->coverage_stride, y);
    lines->albedo = lines_of(maps->albedo, maps->albedo_stride, y);
    lines->gloss = lines_of(maps->gloss, maps->gloss_stride, y);
    lines->normals = lines_of((const uint8_t *)maps->normals, maps->normals_stride, y); /* not read of a span's */
}

/* The next run of pixels of a surface, in normals of INT8. */
static inline void lines_over_gaps(struct glint_lines *lines)
{
    const uint32_t w = lines->w;
    uint32_t x = lines->run.x, count = 0;
    const uint32_t *word = (const uint32_t *)(const void *)lines->normals + x;
    for (; x != w && *word >> 16 == 0; word++)
        x++;
    lines->run.x = x;
    for (; x != w && count != lines->most && *word >> 16; word++, x++)
        count++;
    lines->count = (uint16_t)count;
}

bool glint_lines_next(struct glint_lines *lines)
{
    struct glint_run *const run = &lines->run;
    const uint32_t left = lines->w - run->x;
    if (left == 0)
        return false;
    lines->count = left < lines->most ? (uint16_t)left : lines->most;
    if (run->coverage)
        GLINT_FLASH_POINTER(lines->soft->next)(lines);
    else if (lines->has_gaps)
        lines_over_gaps(lines);
    if (lines->count == 0)
        return false;
    const uint32_t x = run->x;
    if (lines->albedo)
        run->albedo = lines->albedo + (lines->maps->albedo_format == GLINT_RGB888 ? 3 : 2) * x;
    if (lines->gloss)
        run->gloss = lines->gloss + x;
    return true;
}

const struct glint_vec *glint_lines_normals(const struct glint_lines *lines, struct glint_vec *unpacked)
{
    if (lines->maps->normals_format == GLINT_NORMALS_INT16)
        return (const struct glint_vec *)(const void *)lines->normals + lines->run.x;
    const uint32_t *words = (const uint32_t *)(const void *)lines->normals + lines->run.x;
    for (unsigned i = 0; i < lines->count; i++)
        unpacked[i] = glint_int8_normal(words[i]);
    return unpacked;
}

void glint_lines_walk(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at,
                      struct glint_sample *samples)
{
    const uint32_t left = lines->w - lines->run.x;
    (void)paint;
    if (at->w != left)
        glint_span_skip(at, at->w - left);
    glint_samples_walk(at, samples, lines->count);
    at->w = (uint16_t)(left - lines->count);
}

/* ---- The exact paint under one light ---- */

/* The samples that are lit go to the bounds. Not inlined, for the stack of what is called beside it. */
static __attribute__((noinline)) void draw_note(struct glint_bounds *bounds, const struct glint_paint *paint,
                                                const struct glint_run *run, const struct glint_sample *sample,
                                                unsigned count, uint32_t y)
{
    for (unsigned i = 0; i < count; i++)
        if (sample[i].t_q30 < paint->of.exact.t_end && (!run->gloss || run->gloss[i]))
            glint_bounds_add(bounds, run->x + i, y);
}

/* Alone, as tables do not need its samples on the stack. */
static void draw_exactly(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at, uint32_t h,
                         struct glint_box *highlight)
{
    struct glint_bounds bounds;
    struct glint_sample samples[GLINT_RUN];
    glint_bounds_begin(&bounds);
    lines->most = GLINT_RUN;
    for (uint32_t y = 0; y < h; y++)
        for (glint_lines_set(lines, y); glint_lines_next(lines); lines->run.x += lines->count) {
            lines->source(paint, lines, at, samples);
            if (highlight) /* before gloss is drawn over, where it is the output */
                draw_note(&bounds, paint, &lines->run, samples, lines->count, y);
            glint_paint_run(paint, &lines->run, samples, lines->count);
        }
    glint_bounds_box(&bounds, highlight);
}

#if GLINT_LINE_SPANS
/* A span in one loop, where there is one. */
static void draw_walked(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at, uint32_t h,
                        struct glint_box *highlight)
{
    if (!glint_fused_lines(paint, lines, at, h, highlight))
        draw_exactly(paint, lines, at, h, highlight);
}
#else
#define draw_walked draw_exactly
#endif

static void draw_normals(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at,
                         struct glint_sample *samples)
{
    glint_geometry *const own = GLINT_FLASH_POINTER(paint->model->geometry);
    struct glint_vec unpacked[GLINT_RUN];
    (void)at;
    (own ? own : glint_samples_half)(&paint->l, &paint->v, &paint->h, glint_lines_normals(lines, unpacked), samples,
                                     lines->count);
}

/* ---- What can be drawn ---- */

/* No map, or one whose lines fit the stride; a line of so many bytes. Called, for less code. */
static __attribute__((noinline)) bool draw_fits(const void *map, ptrdiff_t stride, uint32_t bytes)
{
    return !map || glint_stride_fits(stride, bytes);
}

/* Checks what a drawing asks of any source, and sets the rest of its lines. */
static enum glint_err draw_begin(struct glint_lines *lines, const struct glint_paint *paint, uint32_t h, bool normals)
{
    const struct glint_maps *const maps = lines->maps;
    const struct glint_surface *const target = lines->target;
    if (!glint_paint_is_lit(paint) || !target || !target->pixels || (maps && maps->coverage && !lines->soft))
        return GLINT_ERR_ARG;
    lines->albedo = lines->gloss = NULL;
    lines->run.left = target->x;
    lines->run.apart = 0;
    lines->run.albedo = lines->run.gloss = lines->run.coverage = NULL;
    lines->paint = paint;
    lines->run.format = paint->format;
    lines->run.soft = NULL;
    if (!glint_paint_is_exact(paint)) {
        const struct glint_use_tables *use = paint->of.tables.filled.use;
        lines->draw = GLINT_FLASH_POINTER(use->draw);
        return GLINT_FLASH_POINTER(use->check)(paint, maps, h, normals);
    }
    const struct glint_use_grain *grain = GLINT_FLASH_POINTER(paint->model->grain);
    if (grain ? (maps || paint->material.n_across) &&
                    GLINT_FLASH_POINTER(grain->check)(paint, lines, h, normals) != GLINT_OK
              : maps && (maps->grain || maps->shininess))
        return GLINT_ERR_ARG;
    if (paint->several)
        lines->draw = GLINT_FLASH_POINTER(paint->several->draw);
    return maps && maps->albedo && maps->albedo_format != GLINT_RGB888 ? GLINT_ERR_FORMAT : GLINT_OK;
}

static enum glint_err draw_check(const struct glint_paint *paint, const struct glint_maps *maps, uint32_t w, uint32_t h,
                                 const struct glint_surface *target)
{
    if (maps->normals_format > GLINT_NORMALS_INT8)
        return GLINT_ERR_FORMAT;
    const bool is_int8 = maps->normals_format == GLINT_NORMALS_INT8;
    const uintptr_t bits = (uintptr_t)maps->normals | (h > 1 ? (uintptr_t)maps->normals_stride : 0);
    if (is_int8 ? GLINT_MISALIGNED(bits, 32) : GLINT_MISALIGNED(bits, 16))
        return GLINT_ERR_ARG;
    if (h > 1 &&
        !(draw_fits(target, target->stride, glint_line_bytes(paint->output.format, w)) &&
          draw_fits(maps, maps->normals_stride, (is_int8 ? 4 : (uint32_t)sizeof(struct glint_vec)) * w) &&
          draw_fits(maps->gloss, maps->gloss_stride, w) && draw_fits(maps->coverage, maps->coverage_stride, w) &&
          draw_fits(maps->shininess, maps->shininess_stride, w) &&
          draw_fits(maps->albedo, maps->albedo_stride, (maps->albedo_format == GLINT_RGB888 ? 3u : 2u) * w)))
        return GLINT_ERR_ARG;
    return GLINT_OK;
}

/* ---- A rectangle ---- */

enum glint_err glint_draw_rect_by(const struct glint_paint *paint, const struct glint_maps *maps, uint16_t w,
                                  uint16_t h, const struct glint_surface *target, struct glint_box *highlight,
                                  const struct glint_use_coverage *soft)
{
    struct glint_lines lines;
    if (!maps || !maps->normals)
        return GLINT_ERR_ARG;
    lines.maps = maps;
    lines.target = target;
    lines.soft = soft;
    lines.draw = draw_exactly;
    lines.source = draw_normals;
    lines.w = w;
    lines.has_gaps = maps->normals_format == GLINT_NORMALS_INT8;
    enum glint_err err = draw_begin(&lines, paint, h, true);
    if (!err)
        err = draw_check(paint, maps, w, h, target);
    if (!err && (lines.draw != draw_exactly || !glint_fused_lines(paint, &lines, NULL, h, highlight)))
        lines.draw(paint, &lines, NULL, h, highlight);
    return err;
}

/* ---- A span ---- */

static __attribute__((noinline)) enum glint_err
draw_span(const struct glint_paint *paint, const struct glint_span *span, const struct glint_maps *maps,
          const struct glint_surface *target, struct glint_box *highlight, const struct glint_use_coverage *soft)
{
    struct glint_lines lines;
    lines.maps = maps;
    lines.target = target;
    lines.soft = soft;
    lines.draw = draw_walked;
    lines.source = glint_lines_walk;
    lines.w = span->w;
    lines.has_gaps = false;
    const enum glint_err err = draw_begin(&lines, paint, 1, false);
    if (err || paint->several)
        return err ? err : GLINT_ERR_ARG;
    struct glint_span at = *span;
    if (paint->light_count == 0) { /* dark, whatever the span was made for */
        at.nl_q30 = -1;
        at.dnl_q30 = 0;
    }
    lines.draw(paint, &lines, &at, 1, highlight);
    return GLINT_OK;
}

/* ---- A palette ---- */

/* A picture of few normals: they are shaded once, as a palette; each pixel then holds 2 x its place there, as an offset in
 * bytes, so that a pixel costs one load of the offset and one of the colour. */

/* A line; with a twin in assembly. */
void glint_palette_line(const uint16_t *colours, const uint16_t *offsets, uint16_t w, uint16_t *out);

#if !(GLINT_CORTEX_M0PLUS_ASM && GLINT_FUSED)
void glint_palette_line(const uint16_t *colours, const uint16_t *offsets, uint16_t w, uint16_t *out)
{
    for (const uint16_t *end = offsets + w; offsets != end; offsets++, out++)
        *out = *(const uint16_t *)(const void *)((const uint8_t *)colours + *offsets);
}
#endif

enum glint_err glint_draw_palette(const uint16_t *colours, const uint16_t *offsets, ptrdiff_t stride, uint16_t w,
                                  uint16_t h, const struct glint_surface *target)
{
    if (!colours || !offsets || !target || !target->pixels || GLINT_MISALIGNED(colours, 16) ||
        GLINT_MISALIGNED(offsets, 16) || GLINT_MISALIGNED(target->pixels, 16) ||
        (h > 1 && (GLINT_MISALIGNED(stride, 16) || GLINT_MISALIGNED(target->stride, 16) ||
                   !glint_stride_fits(stride, UINT32_C(2) * w) || !glint_stride_fits(target->stride, UINT32_C(2) * w))))
        return GLINT_ERR_ARG;
    for (uint16_t y = 0; y < h; y++) {
        const uint16_t *in = (const uint16_t *)(const void *)((const uint8_t *)offsets + stride * (ptrdiff_t)y);
        uint16_t *out = (uint16_t *)(void *)((uint8_t *)target->pixels + target->stride * (ptrdiff_t)y);
        glint_palette_line(colours, in, w, out);
    }
    return GLINT_OK;
}

enum glint_err glint_draw_span_by(const struct glint_paint *paint, const struct glint_span *span,
                                  const struct glint_maps *maps, const struct glint_surface *target,
                                  struct glint_box *highlight, const struct glint_use_coverage *soft)
{
    if (!span)
        return GLINT_ERR_ARG;
    if (!maps && !highlight && glint_fused_span(paint, span, target))
        return GLINT_OK;
    return draw_span(paint, span, maps, target, highlight, soft);
}
