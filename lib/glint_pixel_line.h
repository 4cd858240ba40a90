/* SPDX-License-Identifier: MIT
 * Internal, and only where GLINT_CORTEX_M0PLUS_ASM is 1: a line of RGB565 under MSH in one loop, in assembly. What it draws is
 * what the stages of glint_prepared_run draw. */
#ifndef GLINT_PIXEL_LINE_H
#define GLINT_PIXEL_LINE_H

#include "glint_math_assembly.h"
#include "glint_pixel_prepared.h"

#if GLINT_CORTEX_M0PLUS_ASM
struct glint_line_base {
    uint32_t nl, one; /* V = nl N.L + one, or with a map (albedo (nl N.L + one) >> 7) + 2^24 */
};

struct glint_line_loop {
    /* of the rectangle: glint_line_begin */
    int32_t l[3];
    uint32_t t_end; /* twice the prepared one */
    struct glint_line_base base[3];
    uint32_t r[3];
    int32_t k[3]; /* MSH's; the shift less 1 */
    const uint8_t *reciprocals;
    uint32_t f_max;
    uint32_t dark;      /* without a map: the pixel where N.L <= 0, in memory order; the caller's to set */
    int32_t minus_h[3]; /* added to a normal */
    uint32_t limit;     /* 2^32 - 2^7 W: from here on a fraction of a level, times 2^32, leaves it open */
    /* of the line: the caller */
    uint8_t *out; /* of pixel 0; aligned to 2 */
    uint32_t w;
    const uint8_t *mask; /* NULL: every pixel is drawn */
    const struct glint_vec *normals;
    const uint8_t *albedo;
    const uint8_t *first,
        *last;                  /* where in out pixels are lit: the caller sets first to the end of memory, last to 0 */
    struct glint_sample sample; /* of one that is left open: the caller's */
    /* Draws from pixel x on, up to one that the bound leaves open: its number, or w. */
    uint32_t (*draw)(struct glint_line_loop *loop, uint32_t x);
};

/* The rectangle's fields but dark; false where this loop does not draw it. */
bool glint_line_begin(struct glint_line_loop *loop, const struct glint_prepared *prepared, bool albedo);

/* cortex_m0plus_rgb565.S */
uint32_t glint_line_rgb565(struct glint_line_loop *loop, uint32_t x);
uint32_t glint_line_rgb565_swapped(struct glint_line_loop *loop, uint32_t x);
uint32_t glint_line_rgb565_albedo(struct glint_line_loop *loop, uint32_t x);
uint32_t glint_line_rgb565_albedo_swapped(struct glint_line_loop *loop, uint32_t x);
#define GLINT_LINE_BEGIN glint_line_begin
#else
#define GLINT_LINE_BEGIN NULL
#endif

#endif
