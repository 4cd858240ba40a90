/* SPDX-License-Identifier: MIT
 * For Eva: the loop for RISC-V of INT8 normals over COLOUR tables, which any computer compiles with GLINT_RISCV: lines of 1 to 10 of any
 * words, so with gaps anywhere. States are kept apart by the pixel that is next, which each `while` and each pixel of four notes, and by what a gap skips.
 * eva: -cpp-extra-args=-DGLINT_RISCV=1 -eva-precision 1 -eva-min-loop-unroll 24 -eva-slevel 20 -eva-slevel-function glint_colour_int8:0,riscv_pixel:8 -eva-ilevel 64 -eva-split-return-function riscv_pixel:0:1 -eva-partition-value place,skip -eva-interprocedural-splits */
#include "eva.h"
#include "glint_fused.h"
#include "glint_math.h"
#include "glint_offsets.h"
#include "glint_pixel.h"
#include "glint_tables.h"

enum { LINE = 10 };
static uint32_t colours[GLINT_COLOUR_ROWS * GLINT_COLOUR_STEPS / 2], words[LINE], place, skip;
static uint8_t columns[1 << GLINT_COLOUR_COLUMNS_LOG];
static uint16_t line[LINE], *const out = line; /* where there is no other of this name */
static struct glint_paint paint;

/* What tells a compiler alone. */
#define volatile
#define __asm__(...) (void)0
#define __builtin_expect(condition, usual) (place = (uint32_t)(out - line), (condition))
/* A blank after its name would make it another macro. */
/* clang-format off */
#define while(condition) while (place = (uint32_t)(out - line), skip = 0, (condition))
/* clang-format on */
#define glint_gap(word, left) (skip = glint_gap(word, left), skip)
#include "fused_riscv.c" /* in its place */
#undef while

void eva_riscv_int8(void)
{
    struct glint_tables *const tables = &paint.of.tables.filled;
    ANY_BYTES(colours);
    ANY_BYTES(line);
    for (unsigned i = 0; i < sizeof columns; i++)
        columns[i] = (uint8_t)(2 * (any % GLINT_COLOUR_STEPS));
    tables->colour.sums = colours;
    tables->columns = columns;
    tables->dark = (uint16_t)any;
    paint.of.tables.x = any_signed % 4210689; /* as eva_tables.c shows of eva_light_colour */
    paint.of.tables.y = any_signed % 16385;
    paint.of.tables.z = any_signed % 16385;
    paint.of.tables.cut = any_signed;
    paint.of.tables.r = any;
    paint.of.tables.a = any % 32;
    for (uint32_t w = 1; w <= LINE; w++) {
        ANY_BYTES(words);
        place = skip = 0;
        glint_colour_int8(&paint, words, w, line);
    }
}
