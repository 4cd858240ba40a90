/* SPDX-License-Identifier: MIT
 * Internal. Fast loops that fuse a source and a paint: what they draw is what the general way draws, bit for bit, and GLINT_FUSED=0 leaves
 * them out. The exact line of RGB565 under MSH is there by core: glint_fused_lines, and GLINT_LINE_BEGIN for the format's begin. */
#ifndef GLINT_FUSED_H
#define GLINT_FUSED_H

#include "glint_tables.h"

#if GLINT_CORTEX_M0PLUS_ASM && GLINT_FUSED
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
    uint32_t dark;      /* without a map: the pixel where N.L <= 0, in memory order; 0: the caller's to set */
    int32_t minus_h[3]; /* added to a normal */
    uint32_t limit;     /* 2^32 - 2^7 W: from here on a fraction of a level, times 2^32, leaves it open */
    /* of the line: the caller */
    uint8_t *out; /* of pixel 0; aligned to 2 */
    uint32_t w;
    const uint8_t *mask; /* NULL: every pixel is drawn; else those of 255 */
    const struct glint_vec *normals;
    const uint8_t *albedo;
    const uint8_t *first,
        *last;             /* where in out pixels are lit: the caller sets first to the end of memory, last to 0 */
    const uint16_t *steps; /* of the rectangle: paint.c's, or NULL */
    const struct glint_span *at; /* of a span: from pixel x on */
    uint32_t turn;               /* of a span: 8 where bytes are swapped, or 0 */
    struct glint_sample sample;  /* of one that is left open: the caller's */
    /* Draws from pixel x on, up to one that the bound leaves open: its number, or w. */
    uint32_t (*draw)(struct glint_line_loop *loop, uint32_t x);
};

/* With grain or a map of shininess: t_end is m's end, and k what GLINT_GRAIN_UP and so on say. */
struct glint_grain_loop {
    struct glint_line_loop line;
    int32_t u[2], h; /* U and H.U, where all pixels have the same */
    uint32_t kind;   /* 0, or GLINT_GRAIN_LINE_PLACE and so on */
    uint32_t across, more;
    uint32_t turn;                 /* bits by which a pixel, twice side by side, is turned to the right */
    uintptr_t map;                 /* of pixel 0, less half of out */
    const uint16_t *sines;         /* of a quarter */
    uint32_t x;                    /* of the place, from the centre: with 8 times the pixel's address */
    int32_t y;                     /* of U from the centre: its y, or where it is spun -y for x */
    uint32_t y_size, log, is_spun; /* |y|; near the log2 of a pixel's |x| + |y|: any to begin with */
};

/* Draws as glint_grain_draw, by it where it can. */
void glint_fused_grain(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at, uint32_t h,
                       struct glint_box *highlight);

/* cortex_m0plus_grain.S: glint_line_rgb565's twin. */
uint32_t glint_line_grain(struct glint_grain_loop *loop, uint32_t x);

/* cortex_m0plus_rgb565.S */
uint32_t glint_line_rgb565(struct glint_line_loop *loop, uint32_t x);
uint32_t glint_line_rgb565_swapped(struct glint_line_loop *loop, uint32_t x);
uint32_t glint_line_rgb565_albedo(struct glint_line_loop *loop, uint32_t x);
uint32_t glint_line_rgb565_albedo_swapped(struct glint_line_loop *loop, uint32_t x);
uint32_t glint_line_rgb565_soft(struct glint_line_loop *loop, uint32_t x);
uint32_t glint_line_rgb565_soft_swapped(struct glint_line_loop *loop, uint32_t x);
uint32_t glint_line_rgb565_steps(struct glint_line_loop *loop, uint32_t x);
uint32_t glint_line_rgb565_steps_swapped(struct glint_line_loop *loop, uint32_t x);
uint32_t glint_line_rgb565_span(struct glint_line_loop *loop, uint32_t x);
#define GLINT_LINE 1
#elif GLINT_HELIUM
/* Eight pixels at a time. V of a channel: 2^30 is 1.0. helium.c has the numbers' meaning and bounds. */
struct glint_line_loop {
    int32_t l[3], h[3];
    int32_t t_end;        /* u is below it where F > 0 */
    int32_t up, d, k;     /* D = d + (k (u << up) >> 31) */
    int32_t f_max;        /* -2^30 F is held to it */
    int32_t q[3], r[3];   /* of N.L, and -r of F */
    uint32_t p[2][3];     /* of 1: where F = 0 in all eight, and elsewhere */
    uint16_t width[2][3]; /* by how much of 2^-16 V may be low then */
    bool swapped;
    uint16_t first, last; /* of the line: lit pixels; first > last: none */
    void (*draw)(struct glint_line_loop *loop, const struct glint_paint *paint, const struct glint_run *run,
                 const struct glint_vec *normals, uint32_t count);
};
/* The first pixel from x on that is covered in full, or is not; or end. */
uint32_t glint_helium_find(const uint8_t *coverage, uint32_t x, uint32_t end, bool full);
/* glint_fused_lines of a span. */
bool glint_helium_span(const struct glint_paint *paint, struct glint_lines *lines, const struct glint_span *at,
                       struct glint_box *highlight);
#define GLINT_LINE 1
#elif GLINT_DSP
/* Draws the pixels of normals from N up to end, at least one, and returns where in out it stopped: at the first one that W leaves open, which
 * has a value all the same, or behind the last one. shine: the loop's. */
typedef uint8_t *glint_dsp_run(const struct glint_vec *normals, uint8_t *out, uint32_t *shine,
                               const struct glint_vec *end);

/* The offsets of these fields are the assembly's, too (fused_dsp.c). */
struct glint_line_loop {
    /* of the rectangle: glint_line_begin */
    uint32_t turn[7];  /* halves of L, -2^13, halves of H: x y, z x, y z, the first one the lower */
    uint32_t plain[7]; /* outside the highlight V = P2 + Q (nl - 1): Q, P2, W */
    uint32_t shine[7]; /* in it V = P + Q (nl - 1 - 2^15) + R (F - 2^15): R and Q, P, W. W: of a level, times 2^32 */
    int32_t v[2];      /* the root of F's divisor is v[1] + v[0] (T << up) 2^-32 */
    uint32_t up;
    uint32_t hh, nh;     /* where the lobe is wide: what is added to N.N and N.H */
    uint32_t t_end;      /* of T: 2t, or |N - H|^2; where the lobe is wide, t */
    uint32_t dark;       /* the pixel where N.L <= 0, in memory order; where it is open, the caller's to set */
    const uint8_t *last; /* where in out the last pixel is lit; the caller sets it to 0 for each line */
    uint32_t w_green;    /* W of green in the highlight */
    /* Dithered, by an address in out / 2 mod 4: thresholds, of red and blue, and dark pixels; a line's. */
    uint32_t thresholds[4], dark_of[4];
    uint32_t lit[6]; /* with an albedo map: for each channel what N.L, with half of 2^-15, adds, and what is there */
    const uint8_t *albedo_at; /* of the next pixel; albedo: of pixel 0, the caller's, or NULL */
    uint32_t base[3], q_q16[3],
        r_q16[3]; /* V = base + (q_q16 nl + r_q16 F) 2^-16, within DSP_NEAR, where the light is white */
    const struct glint_paint *paint;
    const uint8_t *first; /* the first one; the caller sets it to the end of memory */
    /* of the line: the caller */
    bool is_wide, dark_is_open;
    uint8_t format;
    unsigned bytes; /* of a pixel */
    glint_dsp_run *run;
    bool seeks;   /* is first wanted? */
    uint8_t *out; /* of pixel 0; aligned to 2 */
    uint32_t w;
    const uint8_t *mask; /* NULL: every pixel is drawn; else those of 255 */
    const struct glint_vec *normals;
    const uint8_t *albedo;
    uint32_t run_end;           /* up to where mask is 255; the caller sets it to 0 */
    uint32_t covered;           /* all bits of mask where it is not 255; the caller sets it to 0 */
    struct glint_sample sample; /* of one that is left open: the caller's */
};
/* Sets thresholds and dark_of for the line at out, from the pixels where N.L <= 0. */
void glint_line_dither(struct glint_line_loop *loop, const struct glint_run *run, const uint16_t dark[4]);
uint32_t glint_line_dsp(struct glint_line_loop *loop, uint32_t x);
glint_dsp_run glint_dsp_msh_dither, glint_dsp_msh_dither_swapped, glint_dsp_msh_dither_wide,
    glint_dsp_msh_dither_wide_swapped;
glint_dsp_run glint_dsp_msh_albedo, glint_dsp_msh_albedo_swapped;
glint_dsp_run glint_dsp_msh, glint_dsp_msh_swapped, glint_dsp_msh_wide, glint_dsp_msh_wide_swapped, glint_dsp_888,
    glint_dsp_888_wide;
glint_dsp_run glint_dsp_schlick, glint_dsp_schlick_swapped, glint_dsp_schlick_wide, glint_dsp_schlick_wide_swapped;
glint_dsp_run glint_dsp_ggx, glint_dsp_ggx_swapped, glint_dsp_ggx_wide, glint_dsp_ggx_wide_swapped;
glint_dsp_run glint_dsp_cayley, glint_dsp_cayley_swapped, glint_dsp_cayley_wide, glint_dsp_cayley_wide_swapped;

/* A model's lines. */
struct glint_use_line {
    /* F 2^16 = S F' + e: (S - 1) 2^32; is F' below 2^16 also where F is held to 1.0? */
    uint32_t scale;
    uint8_t below, width; /* -e < below / 16, and how far apart both its bounds are, of 16ths */
    bool holds;
    bool (*fold)(struct glint_line_loop *loop, const struct glint_paint *paint);
    glint_dsp_run
        *run[10]; /* narrow, then wide; each in both orders; then these dithered, or NULL; narrow with an albedo map */
};
bool glint_line_begin_888(struct glint_line_loop *loop, const struct glint_paint *paint, bool albedo);
#define GLINT_LINE_BEGIN_888 glint_line_begin_888
#define GLINT_LINE 1
#elif GLINT_RISCV
struct glint_line_loop {
    /* of the rectangle: glint_line_begin */
    int32_t l[3], h[3];
    uint32_t p[3], q[3], r[3]; /* V = P + Q nl + R F, as glint_levels_sum has it */
    uint32_t limit;            /* 2^32 - 2^7 W: from here on a fraction of a level, times 2^32, leaves it open */
    uint32_t two_t_end;
    uint32_t up, factor, addend, below, two_fifths, high, f_max; /* MSH's: riscv_msh */
    const uint8_t *reciprocals;
    bool swapped;
    uint16_t dark; /* the pixel where N.L <= 0, in memory order; the caller's to set */
    /* of the line: the caller */
    uint8_t *out; /* of pixel 0; aligned to 2 */
    uint32_t w;
    const uint8_t *mask; /* NULL: every pixel is drawn; else those of 255 */
    const struct glint_vec *normals;
    const uint8_t *first,
        *last;                  /* where in out pixels are lit: the caller sets first to the end of memory, last to 0 */
    struct glint_sample sample; /* of one that is left open: the caller's */
    /* Draws from pixel x on, up to one that the bound leaves open, or that is covered in part: its number, or w. */
    uint32_t (*draw)(struct glint_line_loop *loop, uint32_t x);
};
#define GLINT_LINE 1
#else
#define GLINT_LINE 0
#endif

#ifndef GLINT_LINE_BEGIN_888
#define GLINT_LINE_BEGIN_888 NULL
#endif
#if GLINT_LINE
/* The rectangle's fields but dark; false where this loop does not draw it. */
bool glint_line_begin(struct glint_line_loop *loop, const struct glint_paint *paint, bool albedo);
/* Sets dark, the pixel where N.L <= 0; not for Helium. */
void glint_line_dark(struct glint_line_loop *loop, const struct glint_paint *paint);

/* Draws a rectangle by it, or a span; false where it cannot, and nothing is drawn. */
bool glint_fused_lines(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at, uint32_t h,
                       struct glint_box *highlight);
#define GLINT_LINE_BEGIN glint_line_begin
#define GLINT_LINE_SPANS (GLINT_CORTEX_M0PLUS_ASM || GLINT_HELIUM) /* does glint_fused_lines take spans? */
#else
#define GLINT_LINE_BEGIN NULL
#define GLINT_LINE_SPANS 0
static inline bool glint_fused_lines(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at,
                                     uint32_t h, struct glint_box *highlight)
{
    (void)paint, (void)lines, (void)at, (void)h, (void)highlight;
    return false;
}
#endif

/* Draws a span without maps by tables; false where it cannot, and nothing is drawn. This comes before all checks, as a short span costs
 * little more than they do. */
static inline bool glint_fused_span(const struct glint_paint *paint, const struct glint_span *span,
                                    const struct glint_surface *target)
{
#if GLINT_FUSED
    if (!paint || paint->format || !paint->of.tables.filled.use || paint->light_count - 1u >= GLINT_LIGHTS_MAX ||
        !target || !target->pixels || GLINT_MISALIGNED(target->pixels, 16))
        return false;
    const struct glint_use_tables *use = paint->of.tables.filled.use;
    if (!GLINT_FLASH_POINTER(use->span))
        return false;
    GLINT_FLASH_POINTER(use->span)(paint, span, target);
    return true;
#else
    (void)paint, (void)span, (void)target;
    return false;
#endif
}

#endif
