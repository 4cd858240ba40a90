/* SPDX-License-Identifier: MIT
 * The exact line of RGB565 under MSH in one loop: in assembly for ARMv6-M (cortex_m0plus_rgb565.S), what a rectangle folds to for it, and
 * rectangles and spans by it or by the DSP extension's (fused_dsp.c). */
#include "glint_fused.h"

#if GLINT_CORTEX_M0PLUS_ASM && GLINT_FUSED
#include "glint_grain.h"
#include "glint_math.h"
#include "glint_offsets.h"

#define LINE_AT(field, offset) (offsetof(struct glint_line_loop, field) == (offset))
typedef char glint_line_layout[LINE_AT(l, GLINT_AT_LINE_L) && LINE_AT(t_end, GLINT_AT_LINE_T_END) &&
                                       LINE_AT(base, GLINT_AT_LINE_BASE) && LINE_AT(r, GLINT_AT_LINE_R) &&
                                       LINE_AT(k, GLINT_AT_LINE_K) && LINE_AT(reciprocals, GLINT_AT_LINE_RECIPROCALS) &&
                                       LINE_AT(f_max, GLINT_AT_LINE_F_MAX) && LINE_AT(dark, GLINT_AT_LINE_DARK) &&
                                       LINE_AT(minus_h, GLINT_AT_LINE_MINUS_H) &&
                                       LINE_AT(limit, GLINT_AT_LINE_MINUS_H + 12) && LINE_AT(out, GLINT_AT_LINE_OUT) &&
                                       LINE_AT(w, GLINT_AT_LINE_OUT + 4) && LINE_AT(mask, GLINT_AT_LINE_OUT + 8) &&
                                       LINE_AT(normals, GLINT_AT_LINE_OUT + 12) &&
                                       LINE_AT(albedo, GLINT_AT_LINE_OUT + 16) && LINE_AT(first, GLINT_AT_LINE_LIT) &&
                                       LINE_AT(last, GLINT_AT_LINE_LIT + 4) && LINE_AT(steps, GLINT_AT_LINE_LIT + 8) &&
                                       LINE_AT(at, GLINT_AT_LINE_LIT + 12) && LINE_AT(turn, GLINT_AT_LINE_LIT + 16) &&
                                       sizeof(struct glint_vec) == 6
                                   ? 1
                                   : -1];
#undef LINE_AT

bool glint_line_begin(struct glint_line_loop *loop, const struct glint_paint *p, bool albedo)
{
    if (GLINT_FLASH_U8(p->model->model) != GLINT_MSH || p->of.exact.shift != GLINT_LINE_SHIFT || p->output.dither)
        return false;
    const struct glint_vec l = p->l, h = p->h;
    loop->l[0] = l.x, loop->l[1] = l.y, loop->l[2] = l.z;
    loop->minus_h[0] = -h.x, loop->minus_h[1] = -h.y, loop->minus_h[2] = -h.z;
    loop->t_end = 2 * p->of.exact.t_end;
    loop->f_max = p->of.exact.f_max;
    for (int k = 0; k < 3; k++) {
        loop->base[k].nl = albedo ? p->of.exact.diffuse[k] : p->of.exact.q[k];
        loop->base[k].one = albedo ? p->of.exact.ambient[k] : p->of.exact.p[k];
        loop->r[k] = p->of.exact.r[k];
        loop->k[k] = p->of.exact.k[k];
    }
    loop->k[2]--;
    loop->reciprocals = glint_reciprocals;
    loop->limit = 0 - ((albedo ? p->of.exact.w_maps : p->of.exact.w) << (32 - GLINT_LINE_SHIFT));
    const bool swapped = p->output.format == GLINT_RGB565_SWAPPED;
    loop->steps = NULL;
    loop->dark = 0;
    loop->turn = swapped ? 8 : 0;
    loop->draw = albedo    ? swapped ? glint_line_rgb565_albedo_swapped : glint_line_rgb565_albedo
                 : swapped ? glint_line_rgb565_swapped
                           : glint_line_rgb565;
    return true;
}
#endif

#if GLINT_LINE && !GLINT_HELIUM

/* The run's pixel, where N.L <= 0. */
static __attribute__((noinline)) void fused_dark(struct glint_line_loop *loop, const struct glint_paint *paint,
                                                 const struct glint_run *run)
{
    loop->sample.t_q30 = UINT32_MAX;
    loop->sample.nl_q16 = loop->sample.f_q16 = 0;
    if (paint->format->levels(paint, run, &loop->sample, 1))
        glint_paint_sums(paint, run, 0, 0, 0);
}

void glint_line_dark(struct glint_line_loop *loop, const struct glint_paint *paint)
{
    const uint8_t *none = NULL;
    __asm__("" : "+r"(none)); /* else gcc sets two of them by a register of floating point */
    const struct glint_run dark = {(uint8_t *)&loop->dark, 0, 0, 0, none, none, none, 0, paint->format, NULL};
    fused_dark(loop, paint, &dark);
}

#if GLINT_DSP
static __attribute__((noinline)) void fused_dithered(struct glint_line_loop *loop, const struct glint_paint *paint,
                                                     const struct glint_run *of)
{
    uint16_t dark[4];
    struct glint_run run = {(uint8_t *)dark, 0, of->left, of->y, NULL, NULL, NULL, 0, paint->format, NULL};
    for (; run.x < 4; run.x++)
        fused_dark(loop, paint, &run);
    glint_line_dither(loop, of, dark);
}

/* What is covered in part, which the loop left out. */
static void fused_edges(const struct glint_paint *paint, struct glint_lines *lines, struct glint_bounds *bounds,
                        uint32_t y)
{
    struct glint_run *const run = &lines->run;
    run->x = 0;
    while (lines->most = UINT16_MAX, glint_lines_next(lines))
        run->x = !run->soft ? run->x + lines->count
                            : GLINT_FLASH_POINTER(lines->soft->edge)(paint, lines, NULL, NULL, bounds, y);
    glint_run_soften(run, paint, NULL);
}

#define LINE_DRAW glint_line_dsp
#define LINE_LACKS_DARK(loop) ((loop)->dark_is_open)
#define LINE_BYTES(loop) ((loop)->bytes)
#else
#define LINE_DRAW loop->draw
#if GLINT_RISCV
#define LINE_LACKS_DARK(loop) true
#else
#define LINE_LACKS_DARK(loop) (!(loop)->dark)
#endif
#define LINE_BYTES(loop) 2
#endif

/* A line by the loop; pixels that this leaves open by the 64-bit sequence. */
static void fused_line(struct glint_line_loop *loop, const struct glint_paint *paint, struct glint_lines *lines,
                       struct glint_span *at, struct glint_bounds *bounds, uint32_t y)
{
    struct glint_run *const run = &lines->run;
    const struct glint_vec *normals = (const struct glint_vec *)(const void *)lines->normals;
    loop->out = run->line;
    loop->w = lines->w;
    loop->mask = run->coverage;
    loop->normals = normals;
#if GLINT_DSP
    loop->run_end = loop->covered = 0;
    if (paint->output.dither)
        fused_dithered(loop, paint, run);
#endif
#if !GLINT_RISCV
    loop->albedo = lines->albedo;
#endif
    loop->first = (const uint8_t *)UINTPTR_MAX;
    loop->last = NULL;
    for (uint32_t x = 0; (x = LINE_DRAW(loop, x)) < lines->w; x++) {
        run->x = x;
#if !GLINT_DSP
        if (run->coverage && run->coverage[x] != 255) {
            x = GLINT_FLASH_POINTER(lines->soft->edge)(paint, lines, loop, NULL, bounds, y) - 1;
            continue;
        }
#endif
        run->albedo = lines->albedo ? lines->albedo + 3 * x : NULL;
        lines->count = 1;
        if (at)
            glint_lines_walk(paint, lines, at, &loop->sample);
        else
            glint_samples_half(&paint->l, &paint->v, &paint->h, normals + x, &loop->sample, 1);
        glint_paint_exactly(paint, run, 0, &loop->sample);
    }
#if GLINT_DSP
    if (loop->covered)
        fused_edges(paint, lines, bounds, y);
#endif
    if (loop->last && (uintptr_t)loop->first != UINTPTR_MAX) {
        glint_bounds_add(bounds, (uint32_t)(loop->first - run->line) / LINE_BYTES(loop), y);
        glint_bounds_add(bounds, (uint32_t)(loop->last - run->line) / LINE_BYTES(loop), y);
    }
}

bool glint_fused_lines(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at, uint32_t h,
                       struct glint_box *highlight)
{
    const struct glint_use_format *format = paint->format;
    const struct glint_surface *target = lines->target;
    struct glint_line_loop loop;
    const struct glint_maps *const maps = lines->maps;
    const bool albedo = maps && maps->albedo;
    if (!format->begin || (at ? maps != NULL : maps->gloss || maps->normals_format != GLINT_NORMALS_INT16) ||
        (paint->of.exact.high && albedo) ||
        (glint_format_is_565(paint->output.format) &&
         (GLINT_MISALIGNED(target->pixels, 16) || (h > 1 && GLINT_MISALIGNED(target->stride, 16)))) ||
        !format->begin(&loop, paint, albedo))
        return false;
    struct glint_bounds bounds;
    glint_bounds_begin(&bounds);
    if (LINE_LACKS_DARK(&loop) && !at)
        glint_line_dark(&loop, paint);
#if GLINT_LINE_SPANS
    if (at)
        loop.draw = glint_line_rgb565_span;
    loop.at = at;
#endif
#if GLINT_DSP
    loop.seeks = highlight != NULL;
#endif
    for (uint32_t y = 0; y < h; y++) {
        glint_lines_set(lines, y);
        fused_line(&loop, paint, lines, at, &bounds, y);
    }
    glint_bounds_box(&bounds, highlight);
    return true;
}
#elif GLINT_HELIUM
/* A line as runs of what is covered in full, side by side. */
static void fused_line(struct glint_line_loop *loop, const struct glint_paint *paint, struct glint_lines *lines,
                       struct glint_bounds *bounds, uint32_t y)
{
    struct glint_run *const run = &lines->run;
    loop->first = UINT16_MAX;
    loop->last = 0;
    glint_lines_set(lines, y);
    const uint8_t *const coverage = run->coverage;
    const struct glint_vec *normals = (const struct glint_vec *)(const void *)lines->normals;
    for (uint32_t x = 0, end = lines->w; x < lines->w; x = end) {
        if (coverage) {
            end = glint_helium_find(coverage, x, lines->w, true);
            while (x < end) { /* what is covered in part */
                run->x = x++;
                if (coverage[run->x])
                    x = GLINT_FLASH_POINTER(lines->soft->edge)(paint, lines, NULL, NULL, bounds, y);
            }
            end = glint_helium_find(coverage, x, lines->w, false);
        }
        run->x = x;
        if (x < end)
            loop->draw(loop, paint, run, normals + x, end - x);
    }
    if (loop->first <= loop->last) {
        glint_bounds_add(bounds, loop->first, y);
        glint_bounds_add(bounds, loop->last, y);
    }
}

bool glint_fused_lines(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at, uint32_t h,
                       struct glint_box *highlight)
{
    const struct glint_use_format *format = paint->format;
    const struct glint_surface *target = lines->target;
    struct glint_line_loop loop;
    struct glint_bounds bounds;
    if (at)
        return glint_helium_span(paint, lines, at, highlight);
    if (!format->begin || lines->maps->gloss || (lines->maps->coverage && !lines->soft) ||
        lines->maps->normals_format != GLINT_NORMALS_INT16 || GLINT_MISALIGNED(target->pixels, 16) ||
        (h > 1 && GLINT_MISALIGNED(target->stride, 16)) || !format->begin(&loop, paint, lines->maps->albedo != NULL))
        return false;
    glint_bounds_begin(&bounds);
    for (uint32_t y = 0; y < h; y++)
        fused_line(&loop, paint, lines, &bounds, y);
    glint_bounds_box(&bounds, highlight);
    return true;
}
#endif

/* ---- With grain, or a map of shininess, in assembly (cortex_m0plus_grain.S) ---- */

#if GLINT_CORTEX_M0PLUS_ASM && GLINT_FUSED
#define GRAIN_AT(field, word) (offsetof(struct glint_grain_loop, field) == GLINT_AT_GRAIN + 4 * (word))
typedef char glint_grain_layout[GRAIN_AT(u, 0) && GRAIN_AT(h, 2) && GRAIN_AT(kind, 3) && GRAIN_AT(across, 4) &&
                                        GRAIN_AT(more, 5) && GRAIN_AT(turn, 6) && GRAIN_AT(map, 7) &&
                                        GRAIN_AT(sines, 8) && GRAIN_AT(x, 9) && GRAIN_AT(y, 10) &&
                                        GRAIN_AT(y_size, 11) && GRAIN_AT(log, 12) && GRAIN_AT(is_spun, 13)
                                    ? 1
                                    : -1];
#undef GRAIN_AT

enum { GRAIN_Q_MOST = 11 }; /* beyond it MSH's E may have to be halved */

static bool grain_line_begin(struct glint_grain_loop *loop, const struct glint_paint *p, struct glint_lines *lines,
                             uint32_t h)
{
    const struct glint_maps *const maps = lines->maps;
    const struct glint_surface *const target = lines->target;
    const uint32_t q = glint_clamp_q(p->material.q);
    if (!p->format->begin || maps->albedo || maps->gloss || maps->normals_format != GLINT_NORMALS_INT16 ||
        q > GRAIN_Q_MOST || GLINT_MISALIGNED(target->pixels, 16) || (h > 1 && GLINT_MISALIGNED(target->stride, 16)) ||
        !p->format->begin(&loop->line, p, false))
        return false;
    glint_line_dark(&loop->line, p);
    glint_grain_begin(lines);
    const uint32_t end = GLINT_FLASH_POINTER(GLINT_FLASH_POINTER(p->model->grain)->m_end)(q);
    const uint32_t up = glint_msh_grain_up(end);
    loop->line.t_end = end;
    loop->line.k[GLINT_GRAIN_UP] = (int32_t)up;
    loop->line.k[GLINT_GRAIN_LEAST] = (int32_t)((uint32_t)65536 >> q);
    loop->line.k[GLINT_GRAIN_SHIFT] = 23 - 2 * (int32_t)up;
    loop->u[0] = lines->grain[0];
    loop->u[1] = lines->grain[1];
    loop->h = p->h.x * loop->u[0] + p->h.y * loop->u[1];
    loop->kind = maps->shininess                           ? GLINT_GRAIN_LINE_SHININESS
                 : maps->grain                             ? GLINT_GRAIN_LINE_MAP
                 : maps->grain_kind == GLINT_GRAIN_BRUSHED ? 0
                                                           : GLINT_GRAIN_LINE_PLACE;
    loop->is_spun = maps->grain_kind == GLINT_GRAIN_SPUN;
    loop->across = glint_material_across(&p->material);
    loop->more = p->of.exact.n - loop->across;
    loop->turn = p->output.format == GLINT_RGB565_SWAPPED ? 8 : 0;
    loop->sines = glint_grain_sines;
    loop->log = 14;
    return true;
}

/* A line by the loop; pixels that this leaves open by the general way. */
static void grain_line(struct glint_grain_loop *loop, const struct glint_paint *paint, struct glint_lines *lines,
                       struct glint_bounds *bounds, uint32_t line)
{
    const struct glint_maps *const maps = lines->maps;
    struct glint_run *const run = &lines->run;
    const uint8_t *map = maps->shininess ? maps->shininess + maps->shininess_stride * (ptrdiff_t)line
                         : maps->grain   ? maps->grain + maps->grain_stride * (ptrdiff_t)line
                                         : NULL;
    const int32_t y = maps->grain_at[1] - 16 * (int32_t)run->y - 8;
    loop->line.out = run->line;
    loop->line.w = lines->w;
    loop->line.mask = run->coverage;
    loop->line.normals = (const struct glint_vec *)(const void *)lines->normals;
    loop->line.first = (const uint8_t *)UINTPTR_MAX;
    loop->line.last = NULL;
    loop->map = (uintptr_t)map - ((uintptr_t)run->line >> 1);
    loop->x = 16 * run->left + 8 - (uint32_t)maps->grain_at[0] - 8 * (uint32_t)(uintptr_t)run->line;
    loop->y = loop->is_spun ? -y : y;
    loop->y_size = (uint32_t)(y < 0 ? -y : y);
    lines->count = 1;
    for (uint32_t x = 0; (x = glint_line_grain(loop, x)) < lines->w; x++) {
        run->x = x;
        if (run->coverage && run->coverage[x] != 255) {
            x = GLINT_FLASH_POINTER(lines->soft->edge)(paint, lines, NULL, glint_grain_edge, bounds, line) - 1;
            lines->count = 1;
            continue;
        }
        loop->line.sample.f_q16 = 1; /* it is open */
        if (glint_grain_exactly(paint, lines, NULL, &loop->line.sample, 0))
            glint_bounds_add(bounds, x, line);
    }
    if (loop->line.last) {
        glint_bounds_add(bounds, (uint32_t)(loop->line.first - run->line) / 2, line);
        glint_bounds_add(bounds, (uint32_t)(loop->line.last - run->line) / 2, line);
    }
}

void glint_fused_grain(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at, uint32_t h,
                       struct glint_box *highlight)
{
    struct glint_grain_loop loop;
    struct glint_bounds bounds;
    if (at || !grain_line_begin(&loop, paint, lines, h)) {
        glint_grain_draw(paint, lines, at, h, highlight);
        return;
    }
    glint_bounds_begin(&bounds);
    for (uint32_t y = 0; y < h; y++) {
        glint_lines_set(lines, y);
        grain_line(&loop, paint, lines, &bounds, y);
    }
    glint_bounds_box(&bounds, highlight);
}
#endif
