/* SPDX-License-Identifier: MIT
 * For Eva: the exact line of RGB565 under MSH in one loop of C, which any computer compiles with GLINT_RISCV, and what is around it
 * (fused_line.c): rectangles of any normals and coverage. F is what riscv_msh holds it to; eva_finite.c runs that.
 * eva: -cpp-extra-args=-DGLINT_RISCV=1 -eva-precision 1 -eva-min-loop-unroll 24 -eva-slevel 20 -eva-slevel-function fused_line:500,riscv_draw:2000 -eva-ilevel 64 -eva-split-return-function glint_line_begin:0:1,riscv_draw:0:1:2:3 -eva-use-spec VALUES,riscv_msh */
#include "eva.h"
#include "glint_fused.h"
#include "glint_math.h"
#include "glint_offsets.h"
#include "glint_pixel.h"
#include "glint_tables.h"
/*@ assigns \result \from *loop, t; ensures \result <= loop->f_max; */
static inline uint32_t riscv_msh(const struct glint_line_loop *loop, uint32_t t);
/* What tells a compiler alone. */
#define volatile
#define __asm__(...) (void)0
#include "fused_line.c" /* in its place */

#include "fused_riscv.c" /* in its place */

enum { WIDE = 3, HIGH = 2 };
static uint8_t pixels[2 * WIDE * HIGH], coverage[WIDE * HIGH];
static struct glint_vec normals[WIDE * HIGH];
static struct glint_paint paint;

static void make(void)
{
    const struct glint_output output = {any & 1 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED, GLINT_GAMMA, false};
    const struct glint_material material = any_material(GLINT_MSH);
    (void)glint_paint_exact_for(&paint, &material, &output, &glint_use_msh, &glint_use_rgb565);
    paint.l = any_vector();
    paint.v = any_vector();
    paint.h = any_vector();
    paint.light_count = 1;
    ANY_BYTES(normals);
}

static void draw(uint16_t w, const uint8_t *covered)
{
    const struct glint_maps maps = {.normals = normals,
                                    .normals_stride = w * (ptrdiff_t)sizeof *normals,
                                    .coverage = covered,
                                    .coverage_stride = w,
                                    .normals_format = GLINT_NORMALS_INT16};
    const struct glint_surface surface = {pixels, 2 * w, (uint16_t)any, (uint16_t)any};
    struct glint_box box;
    (void)glint_draw_rect(&paint, &maps, w, HIGH, &surface, &box);
    (void)glint_draw_rect(&paint, &maps, w, HIGH, &surface, NULL);
}
void eva_riscv_rect(void)
{
    make();
    draw(WIDE, NULL);
}
/* Every coverage of two lines of two pixels, in full or not. */
void eva_riscv_covered(void)
{
    make();
    for (unsigned bits = 0; bits < 16; bits++) {
        for (unsigned i = 0; i < 4; i++)
            coverage[i] = bits >> i & 1 ? 255 : 0;
        draw(2, coverage);
    }
}
