/* SPDX-License-Identifier: MIT
 * Loops over tables that are source and paint in one: lines of INT8 normals, the viewer at (0, 0, 1), and spans. */
#include "glint_tables.h"

#if GLINT_DSP && GLINT_THUMB2
#define INT8_AT(field, offset) (offsetof(struct glint_paint, of.tables.field) == (offset))
typedef char int8_layout[INT8_AT(filled.columns, 0) && INT8_AT(filled.colour, 4) && INT8_AT(filled.dark, 12) &&
                                 INT8_AT(x, 24) && INT8_AT(y, 28) && INT8_AT(z, 32) && INT8_AT(cut, 36) &&
                                 INT8_AT(r, 44) && INT8_AT(a, 48) && GLINT_COLOUR_ROW_SHIFT == 24 &&
                                 GLINT_COLOUR_ROW_BYTES_LOG == 7 && GLINT_COLOUR_COLUMNS_LOG == 12
                             ? 1
                             : -1];
#undef INT8_AT

/* What glint_colour_int8 below says, two pixels at a time where both have a surface, are lit, and are both in the highlight or both outside; else
 * one. y and z are halves of a word, 2^14 is another factor of z: products of halves have d and e.
 *
 * r0: words, r1: out, r2: the last place for two, r3: colours, r4: x, r5: z and y, r6: cut, lr: 2^14; on the stack a, r, columns, dark, out's end. */
#define INT8_COLUMNS                                                                                                   \
    "ldrd r7, r12, [sp]\n\t"                                                                                           \
    "lsr r8, r8, r7\n\t"                                                                                               \
    "mul r8, r12, r8\n\t"

__attribute__((naked, noinline)) void glint_colour_int8(__attribute__((unused)) const struct glint_paint *paint,
                                                        __attribute__((unused)) const uint32_t *words,
                                                        __attribute__((unused)) uint32_t w,
                                                        __attribute__((unused)) uint16_t *out)
{
    __asm__("push {r4, r5, r6, r7, r8, r9, r10, r11, lr}\n\t"
            "sub sp, #20\n\t"
            "ldrd r10, r7, [r0]\n\t"
            "ldrh r11, [r0, #12]\n\t"
            "ldrb r8, [r0, #48]\n\t"
            "ldr r9, [r0, #44]\n\t"
            "add r12, r3, r2, lsl #1\n\t"
            "stmia sp, {r8, r9, r10, r11, r12}\n\t"
            "ldrd r4, r5, [r0, #24]\n\t"
            "ldrd r8, r6, [r0, #32]\n\t"
            "pkhbt r5, r5, r8, lsl #16\n\t"
            "mov r0, r1\n\t"
            "mov r1, r3\n\t"
            "mov r3, r7\n\t"
            "sub r2, r12, #4\n\t"
            "mov lr, #0x4000\n\t"
            "b 2f\n"
            "1:\n\t"
            "ldrd r8, r9, [r0], #8\n\t"
            "smultt r7, r8, r9\n\t"
            "cbz r7, 3f\n\t"
            "sxtb r7, r8\n\t"
            "sxtb r12, r9\n\t"
            "mul r7, r4, r7\n\t"
            "mul r12, r4, r12\n\t"
            "smlad r10, r8, r5, r7\n\t"
            "smlad r11, r9, r5, r12\n\t"
            "orrs r7, r10, r11\n\t"
            "bmi 8f\n\t"
            "smlatb r8, r8, lr, r10\n\t"
            "smlatb r9, r9, lr, r11\n\t"
            "sub r8, r6\n\t"
            "sub r9, r6\n\t"
            "ands r7, r8, r9\n\t"
            "bpl 5f\n\t"
            "lsr r10, r10, #23\n\t"
            "lsr r11, r11, #23\n\t"
            "lsl r10, r10, #7\n\t"
            "lsl r11, r11, #7\n\t"
            "ldrh r10, [r3, r10]\n\t"
            "ldrh r11, [r3, r11]\n\t"
            "strh r10, [r1], #2\n\t"
            "strh r11, [r1], #2\n"
            "2:\n\t"
            "cmp r1, r2\n\t"
            "bls 1b\n\t"
            "ldr r7, [sp, #16]\n\t"
            "cmp r1, r7\n\t"
            "blo 4f\n\t"
            "add sp, #20\n\t"
            "pop {r4, r5, r6, r7, r8, r9, r10, r11, pc}\n"
            "3:\n\t" /* one of the two */
            "sub r0, #8\n\t"
            "b 4f\n"
            "8:\n\t"
            "ands r7, r10, r11\n\t"
            "bpl 3b\n\t"
            "ldr r10, [sp, #12]\n\t"
            "strh r10, [r1], #2\n\t"
            "strh r10, [r1], #2\n\t"
            "b 2b\n"
            "5:\n\t"
            "orrs r7, r8, r9\n\t"
            "bmi 3b\n\t" INT8_COLUMNS "lsr r9, r9, r7\n\t"
            "mul r9, r12, r9\n\t"
            "ldr r7, [sp, #8]\n\t"
            "lsr r10, r10, #23\n\t"
            "lsr r11, r11, #23\n\t"
            "lsr r8, r8, #20\n\t"
            "lsr r9, r9, #20\n\t"
            "ldrb r8, [r7, r8]\n\t"
            "ldrb r9, [r7, r9]\n\t"
            "add r10, r3, r10, lsl #7\n\t"
            "add r11, r3, r11, lsl #7\n\t"
            "ldrh r10, [r10, r8]\n\t"
            "ldrh r11, [r11, r9]\n\t"
            "strh r10, [r1], #2\n\t"
            "strh r11, [r1], #2\n\t"
            "cmp r1, r2\n\t"
            "bls 1b\n\t"
            "b 2b\n"
            "4:\n\t"
            "ldr r8, [r0], #4\n\t"
            "cmp r8, #0x10000\n\t"
            "blo 7f\n\t"
            "sxtb r7, r8\n\t"
            "mul r7, r4, r7\n\t"
            "smlad r10, r8, r5, r7\n\t"
            "cmp r10, #0\n\t"
            "blt 6f\n\t"
            "smlatb r8, r8, lr, r10\n\t"
            "lsr r10, r10, #23\n\t"
            "lsl r10, r10, #7\n\t"
            "subs r8, r6\n\t"
            "bmi 5f\n\t" INT8_COLUMNS "ldr r7, [sp, #8]\n\t"
            "lsr r8, r8, #20\n\t"
            "ldrb r8, [r7, r8]\n\t"
            "add r10, r8\n"
            "5:\n\t"
            "ldrh r10, [r3, r10]\n\t"
            "strh r10, [r1], #2\n\t"
            "b 2b\n"
            "6:\n\t"
            "ldr r10, [sp, #12]\n\t"
            "strh r10, [r1], #2\n\t"
            "b 2b\n"
            "7:\n\t" /* no surface: r8 pixels of what is left, at least one */
            "ldr r7, [sp, #16]\n\t"
            "sub r7, r1\n\t"
            "lsr r7, r7, #1\n\t"
            "cmp r8, r7\n\t"
            "it lo\n\t"
            "movlo r7, r8\n\t"
            "cmp r7, #0\n\t"
            "it eq\n\t"
            "moveq r7, #1\n\t"
            "add r1, r1, r7, lsl #1\n\t"
            "sub r0, #4\n\t"
            "add r0, r0, r7, lsl #2\n\t"
            "b 2b\n");
}
#undef INT8_COLUMNS
#elif GLINT_FUSED && !GLINT_CORTEX_M0PLUS_ASM && !GLINT_HELIUM
/* 8 bits, the viewer at (0, 0, 1). H lies between L and the viewer, so N.H |L + V| = N.L + z: one product d (Q29) gives the
 * row, and with z the place e (Q29) from the last column on, to which r brings a column's number. Three multiplications
 * for the vectors, and one inside the highlight. */
void glint_colour_int8(const struct glint_paint *paint, const uint32_t *words, uint32_t w, uint16_t *out)
{
    const struct glint_look look = glint_look_up(&paint->of.tables.filled);
    const int32_t lx = paint->of.tables.x, ly = paint->of.tables.y, lz = paint->of.tables.z;
    const uint32_t cut = (uint32_t)paint->of.tables.cut, r = paint->of.tables.r;
    const unsigned a = paint->of.tables.a;
    for (const uint16_t *end = out + w; out < end; words++, out++) {
        const uint32_t word = *words;
        const int32_t z = (int32_t)word >> 16;
        if (z == 0) {
            const uint32_t skip = glint_gap(word, (uint32_t)(end - out)) - 1;
            words += skip;
            out += skip;
            continue;
        }
        const int32_t d =
            (int32_t)((uint32_t)((int8_t)word * lx) + (uint32_t)((int16_t)word * ly) + (uint32_t)(z * lz));
        if (d < 0) {
            *out = look.dark;
            continue;
        }
        uint32_t at = (uint32_t)d >> (GLINT_COLOUR_ROW_SHIFT - 1) << GLINT_COLOUR_ROW_BYTES_LOG;
        const uint32_t e = (uint32_t)d + ((uint32_t)z << 14) - cut;
        if ((int32_t)e >= 0)
            at += look.columns[((e >> a) * r) >> (32 - GLINT_COLOUR_COLUMNS_LOG)];
        *out = glint_look_colour(&look, at);
    }
}

#endif

#if GLINT_FUSED && !GLINT_CORTEX_M0PLUS_ASM
/* COLOUR, dithered. The viewer at (0, 0, 1): rows and columns as above. */
static inline void fused_dither(const struct glint_paint *paint, const uint32_t *words, uint32_t w, uint16_t *out,
                                uint32_t phase, uint32_t y, bool swapped)
{
    const struct glint_dither_look look = glint_dither_look_up(&paint->of.tables.filled, y);
    const int32_t lx = paint->of.tables.x, ly = paint->of.tables.y, lz = paint->of.tables.z;
    const uint32_t cut = (uint32_t)paint->of.tables.cut, r = paint->of.tables.r;
    const uint32_t nudge = look.nudge >> 1;
    const unsigned a = paint->of.tables.a;
    for (const uint16_t *end = out + w; out < end; words++, out++, phase = glint_dither_next(phase)) {
        const uint32_t word = *words;
        const int32_t z = (int32_t)word >> 16;
        if (z == 0) {
            const uint32_t skip = glint_gap(word, (uint32_t)(end - out)) - 1;
            words += skip;
            out += skip;
            phase += 2 * skip;
            continue;
        }
        const int32_t d =
            (int32_t)((uint32_t)((int8_t)word * lx) + (uint32_t)((int16_t)word * ly) + (uint32_t)(z * lz));
        if (d < 0) {
            *out = glint_dither_past(&look, -1, phase);
            continue;
        }
        const int32_t row = (int32_t)(((uint32_t)d + nudge) >> (GLINT_DITHER_ROW_SHIFT - 1));
        const uint32_t e = (uint32_t)d + ((uint32_t)z << 14) - cut;
        *out = (int32_t)e < 0
                   ? glint_dither_past(&look, row, phase)
                   : glint_dither_within(&look, (uint32_t)row, phase, ((e >> a) * r) >> (32 - GLINT_DITHER_COLUMNS_LOG),
                                         GLINT_NO_GLOSS, swapped);
    }
}

void glint_dither_int8_plain(const struct glint_paint *paint, const uint32_t *words, uint32_t w, uint16_t *out,
                             uint32_t phase, uint32_t y)
{
    fused_dither(paint, words, w, out, phase, y, false);
}

void glint_dither_int8_swapped(const struct glint_paint *paint, const uint32_t *words, uint32_t w, uint16_t *out,
                               uint32_t phase, uint32_t y)
{
    fused_dither(paint, words, w, out, phase, y, true);
}

/* ALBEDO. */
static inline void fused_albedo(const struct glint_paint *paint, const uint32_t *words, const uint16_t *albedo,
                                uint32_t w, uint16_t *out, bool swapped)
{
    const struct glint_tables *tables = &paint->of.tables.filled;
    const uint32_t *const shine = tables->colour.sums;
    const uint8_t *const levels = tables->columns;
    const int32_t lx = paint->of.tables.x, ly = paint->of.tables.y, lz = paint->of.tables.z;
    const uint32_t cut = (uint32_t)paint->of.tables.cut, dark = tables->dark, r = paint->of.tables.r;
    for (uint32_t i = 0; i < w; i++) {
        const uint32_t word = words[i];
        const int32_t z = (int32_t)word >> 16;
        if (z == 0) {
            i += glint_gap(word, w - i) - 1;
            continue;
        }
        /* Q25, negative where lit: the level is behind its table's end, and e needs no other address */
        const int32_t d = (int8_t)word * lx + (int16_t)word * ly + z * lz;
        if (d >= 0) {
            out[i] = glint_packed(glint_albedo_lit(albedo[i], dark), swapped);
            continue;
        }
        uint32_t sum = glint_albedo_lit(albedo[i], levels[d >> (GLINT_ALBEDO_LEVEL_SHIFT - 5)]);
        const uint32_t e = ((uint32_t)z << 10) - cut - (uint32_t)d;
        if ((int32_t)e >= 0)
            sum = glint_albedo_full(sum + shine[(e * r) >> (32 - GLINT_ALBEDO_COLUMNS_LOG)]);
        out[i] = glint_packed(sum, swapped);
    }
}

void glint_albedo_int8(const struct glint_paint *paint, const uint32_t *words, const uint16_t *albedo, uint32_t w,
                       uint16_t *out)
{
    fused_albedo(paint, words, albedo, w, out, false);
}

void glint_albedo_int8_swapped(const struct glint_paint *paint, const uint32_t *words, const uint16_t *albedo,
                               uint32_t w, uint16_t *out)
{
    fused_albedo(paint, words, albedo, w, out, true);
}
#endif

#if GLINT_FUSED
/* ---- Lines: INT8, and INT16 with t and nl by a product of vectors each ---- */

static const uint32_t *fused_words(const struct glint_lines *lines)
{
    return lines->maps->normals_format == GLINT_NORMALS_INT8 ? (const uint32_t *)(const void *)lines->normals : NULL;
}

void glint_colour_line(const struct glint_paint *paint, const struct glint_lines *lines, uint32_t x, uint32_t end)
{
    const uint32_t *words = fused_words(lines);
    uint16_t *out = (uint16_t *)(void *)lines->run.line + x;
    if (words) {
        glint_colour_int8(paint, words + x, end - x, out);
        return;
    }
    const struct glint_look look = glint_look_up(&paint->of.tables.filled);
    const struct glint_vec l = paint->l, h = paint->h, *n = (const struct glint_vec *)(const void *)lines->normals + x;
    for (const uint16_t *stop = out + (end - x); out != stop; n++, out++) {
        const struct glint_raw raw = glint_raw_of(n, &l, &h, look.t_max);
        if (raw.nl_q30 != GLINT_RAW_NOTHING)
            *out = glint_look_pixel(&look, &raw, GLINT_NO_GLOSS);
    }
}

void glint_dither_line(const struct glint_paint *paint, const struct glint_lines *lines, uint32_t x, uint32_t end)
{
    const struct glint_tables *tables = &paint->of.tables.filled;
    const uint32_t *words = fused_words(lines), y = lines->run.y;
    const bool swapped = glint_is_swapped(tables);
    uint16_t *out = (uint16_t *)(void *)lines->run.line + x;
    uint32_t phase = 2 * ((lines->run.left + x) & 3);
    if (words) {
        (swapped ? glint_dither_int8_swapped : glint_dither_int8_plain)(paint, words + x, end - x, out, phase, y);
        return;
    }
    const struct glint_dither_look look = glint_dither_look_up(tables, y);
    const struct glint_vec l = paint->l, h = paint->h, *n = (const struct glint_vec *)(const void *)lines->normals + x;
    for (const uint16_t *stop = out + (end - x); out != stop; n++, out++, phase = glint_dither_next(phase)) {
        const struct glint_raw raw = glint_raw_of(n, &l, &h, tables->t_max_q30);
        if (raw.nl_q30 != GLINT_RAW_NOTHING)
            *out = glint_dither_pixel(&look, &raw, phase, GLINT_NO_GLOSS, swapped);
    }
}

void glint_albedo_line(const struct glint_paint *paint, const struct glint_lines *lines, uint32_t x, uint32_t end)
{
    const struct glint_tables *tables = &paint->of.tables.filled;
    const uint32_t *words = fused_words(lines);
    const uint16_t *albedo = (const uint16_t *)(const void *)lines->albedo + x;
    const bool swapped = glint_is_swapped(tables);
    uint16_t *out = (uint16_t *)(void *)lines->run.line + x;
    if (words) {
        (swapped ? glint_albedo_int8_swapped : glint_albedo_int8)(paint, words + x, albedo, end - x, out);
        return;
    }
    const struct glint_vec l = paint->l, h = paint->h, *n = (const struct glint_vec *)(const void *)lines->normals + x;
    for (const uint16_t *stop = out + (end - x); out != stop; n++, out++, albedo++) {
        const struct glint_raw raw = glint_raw_of(n, &l, &h, tables->t_max_q30);
        if (raw.nl_q30 != GLINT_RAW_NOTHING)
            *out = glint_albedo_pixel(tables, &raw, *albedo, GLINT_NO_GLOSS, swapped);
    }
}

/* ---- Spans ---- */

void glint_colour_fused(const struct glint_paint *paint, const struct glint_span *span,
                        const struct glint_surface *target)
{
    glint_colour_span(&paint->of.tables.filled, span, (uint16_t *)target->pixels);
}

void glint_dither_fused(const struct glint_paint *paint, const struct glint_span *span,
                        const struct glint_surface *target)
{
    const struct glint_tables *tables = &paint->of.tables.filled;
    const struct glint_dither_look look = glint_dither_look_up(tables, target->y);
    const bool swapped = glint_is_swapped(tables);
    uint32_t t = span->t_q30, dt = span->dt_q30, nl = (uint32_t)span->nl_q30, phase = 2 * (target->x & 3u);
    uint16_t *out = (uint16_t *)target->pixels;
    for (const uint16_t *stop = out + span->w; out != stop; out++, phase = glint_dither_next(phase)) {
        const struct glint_raw raw = glint_raw_at(t, (int32_t)nl, tables->t_max_q30);
        *out = glint_dither_pixel(&look, &raw, phase, GLINT_NO_GLOSS, swapped);
        t += dt;
        dt += span->ddt_q30;
        nl += (uint32_t)span->dnl_q30;
    }
}
#endif

/* Spans over COLOUR tables, GLINT_SPAN_RUN pixels at a time: a run. Of a run it is cheap to know that all its pixels are alike,
 * as t is convex and nl linear: three loops for three kinds take only the additions that their kind needs, and a fourth
 * takes any run. */

#if GLINT_FUSED && !GLINT_CORTEX_M0PLUS_ASM
/* nl < 0 throughout; lit, and past t_max throughout; lit, and t = 0..t_max throughout; any. */
enum span_kind { SPAN_DARK, SPAN_OUTSIDE, SPAN_INSIDE, SPAN_MIXED };

/* Modulo 2^32 t is convex and nl linear only where no sum wraps: with steps below 2^25 and ddt below 2^20, 31 steps
 * change nl by less than 2^30, and t by -2^30 .. 3 * 2^29. */
#define SPAN_BIG ((uint32_t)1 << 25)

static inline bool span_is_big(uint32_t step)
{
    return (step + SPAN_BIG) >> 26 != 0;
}

/* w = 1..GLINT_SPAN_RUN. */
static inline enum span_kind span_kind(const struct glint_span *at, uint32_t w, uint32_t t_max_q30)
{
    const uint32_t m = w - 1u;
    const uint32_t last_nl = (uint32_t)at->nl_q30 + m * (uint32_t)at->dnl_q30;
    if (span_is_big((uint32_t)at->dnl_q30) || span_is_big(at->dt_q30) || at->ddt_q30 >> 20)
        return SPAN_MIXED;
    if ((int32_t)((uint32_t)at->nl_q30 | last_nl | at->t_q30) < 0)
        return (at->nl_q30 & (int32_t)last_nl) < 0 ? SPAN_DARK : SPAN_MIXED;
    const int32_t t_max = (int32_t)t_max_q30, back = t_max - (int32_t)at->t_q30;
    const int32_t fall = (int32_t)(m * at->dt_q30);
    const int32_t highest = fall < 0 ? back - fall : back; /* t is not below the tangent at the start */
    if (highest < 0)
        return SPAN_OUTSIDE;
    return back >= 0 && highest <= t_max && back - fall - (int32_t)((m * (m - 1) >> 1) * at->ddt_q30) >= 0 ? SPAN_INSIDE
                                                                                                           : SPAN_MIXED;
}

/* The span from the next run on: t is quadratic in the pixel's number. */
static inline void span_next(struct glint_span *at)
{
    const uint32_t n = GLINT_SPAN_RUN;
    at->t_q30 += n * at->dt_q30 + n * (n - 1) / 2 * at->ddt_q30;
    at->dt_q30 += n * at->ddt_q30;
    at->nl_q30 = (int32_t)((uint32_t)at->nl_q30 + n * (uint32_t)at->dnl_q30);
}

/* nl < 0 throughout. */
static void span_dark(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out,
                      const uint16_t *end)
{
    (void)at;
    const uint16_t pixel = tables->dark;
    while (out != end)
        *out++ = pixel;
}

/* Lit, and past the last column: nl alone. Unrolled by hand, as compilers do not at -O2. */
static void span_outside(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out,
                         const uint16_t *end)
{
    const struct glint_look look = glint_look_up(tables);
    const uint32_t dnl = (uint32_t)at->dnl_q30;
    uint32_t nl = (uint32_t)at->nl_q30;
    for (; end - out >= 4; out += 4) {
        out[0] = glint_look_colour(&look, glint_look_row(nl));
        nl += dnl;
        out[1] = glint_look_colour(&look, glint_look_row(nl));
        nl += dnl;
        out[2] = glint_look_colour(&look, glint_look_row(nl));
        nl += dnl;
        out[3] = glint_look_colour(&look, glint_look_row(nl));
        nl += dnl;
    }
    for (; out != end; out++) {
        *out = glint_look_colour(&look, glint_look_row(nl));
        nl += dnl;
    }
}

/* Lit, and all columns: back = t_max - t, so that a column is back >> shift; here scaled, so that the shift is a constant. */
static void span_inside(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out,
                        const uint16_t *end)
{
    const struct glint_look look = glint_look_up(tables);
    const unsigned top = 32 - GLINT_COLOUR_COLUMNS_LOG, scale = top - tables->shift; /* a column takes the rest */
    uint32_t back = (tables->t_max_q30 - at->t_q30) << scale, dback = (0 - at->dt_q30) << scale;
    uint32_t nl = (uint32_t)at->nl_q30;
    const uint32_t ddback = (0 - at->ddt_q30) << scale, dnl = (uint32_t)at->dnl_q30;
    for (; out != end; out++) {
        *out = glint_look_colour(&look, glint_look_row(nl) + look.columns[back >> top]);
        back += dback;
        dback += ddback;
        nl += dnl;
    }
}

/* Anything: each pixel is asked. */
static void span_mixed(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out,
                       const uint16_t *end)
{
    const struct glint_look look = glint_look_up(tables);
    uint32_t back = look.t_max - at->t_q30, dt = at->dt_q30, nl = (uint32_t)at->nl_q30;
    const uint32_t ddt = at->ddt_q30, dnl = (uint32_t)at->dnl_q30;
    for (; out != end; out++) {
        glint_look_store(&look, back, nl, out);
        back -= dt;
        dt += ddt;
        nl += dnl;
    }
}

static void span_run(const struct glint_tables *tables, const struct glint_span *at, uint32_t w, uint16_t *out)
{
    switch (span_kind(at, w, tables->t_max_q30)) {
    case SPAN_DARK:
        span_dark(tables, at, out, out + w);
        break;
    case SPAN_OUTSIDE:
        span_outside(tables, at, out, out + w);
        break;
    case SPAN_INSIDE:
        span_inside(tables, at, out, out + w);
        break;
    default: /* SPAN_MIXED */
        span_mixed(tables, at, out, out + w);
    }
}

void glint_colour_span(const struct glint_tables *tables, const struct glint_span *span, uint16_t *out)
{
    struct glint_span at = *span;
    uint32_t left = at.w;
    for (; left > GLINT_SPAN_RUN; left -= GLINT_SPAN_RUN, out += GLINT_SPAN_RUN) {
        span_run(tables, &at, GLINT_SPAN_RUN, out);
        span_next(&at);
    }
    if (left)
        span_run(tables, &at, left, out);
}
#endif
