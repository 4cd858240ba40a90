/* SPDX-License-Identifier: MIT
 * What a rectangle with grain, or a map of shininess, folds to for the line in assembly (cortex_m0plus_grain.S). */
#include "glint_fused.h"

#if GLINT_CORTEX_M0PLUS_ASM && GLINT_FUSED
#include "glint_grain.h"
#include "glint_offsets.h"

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
