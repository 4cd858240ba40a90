/* SPDX-License-Identifier: MIT
 *
 * glint: specular shading with integers only. This header is the manual.
 *
 * ONE ANSWER. Every value is the correctly rounded value of the real function at the argument given: nearest, ties up,
 * in Q16.16, the same on every machine and compiler. (From t, powers and Gauss promise 0.501 ulp instead.)
 *
 * Units        Q16.16: 1.0 = 65536.   Q2.30: 1.0 = 2^30.   Q1.15 in an int16_t: 1.0 = 32768, held as 32767.
 * Arguments    c: the cosine, N.H (V.R for Phong), Q16.16.   t = 1 - c, Q2.30: prefer it; one step of c is already
 *              6 levels of 255 at n = 1000, one step of t is nothing.
 *              n: shininess, 1..1000.   q: the cutoff 2^-q below which a highlight counts as 0, 0..16.
 * Clamping     n and q are clamped. c < 0 or t > 1 (back-facing) gives 0, c > 1 counts as 1. An unknown model gives 0.
 * Re-entrancy  No global state, no heap, no writable data: call it from interrupts and threads, on one struct where that is const.
 * Stack        At most 800 bytes on Cortex-M, 900 on RV32, AVR and Xtensa, for any call (`make test-targets` checks it).
 * Memory       Constants: 2.0 KB, 1.1 of it the sRGB tables, where all is linked. In flash, on AVR and the ESP8266, too.
 * Integers     sequence.md states every path's sequence, bit by bit.
 * Sources      Equation numbers are those of Zavalniuk et al. 2022, DOI 10.31649/1999-9941-2022-55-3-4-12.
 */
#ifndef GLINT_H
#define GLINT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* An AVR with 32 KB of flash holds one model and one format, not all: a call that links all is refused there. */
#if defined(__AVR__)
#include <avr/io.h>
#endif
#if defined(__AVR__) && FLASHEND < 0x8000
#define GLINT_LARGE(instead) __attribute__((noinline, error("glint: this part has too little flash for it; " instead)))
#else
#define GLINT_LARGE(instead)
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define GLINT_VERSION_MAJOR 0
#define GLINT_VERSION_MINOR 2
#define GLINT_VERSION_PATCH 0
#define GLINT_VERSION_STRING "0.2.0"

#define GLINT_N_MAX 1000u
#define GLINT_Q_MAX 16u
#define GLINT_C_ONE ((int32_t)65536)    /* 1.0 in Q16.16 */
#define GLINT_T_ONE ((uint32_t)1 << 30) /* 1.0 in Q2.30 */

/* What can go wrong in a call that takes memory or geometry: 0 is good, negative an error. */
enum glint_err {
    GLINT_OK = 0,
    GLINT_ERR_ARG = -1,    /* a pointer, size or stride that cannot be */
    GLINT_ERR_FORMAT = -2, /* no such pixel format or colour space */
    GLINT_ERR_VECTOR = -3  /* a direction of length 0, a light straight behind, or a span out of range */
};

/* ---- The lobe: how bright the highlight is ------------------------------------------------------------------- */

/* The models: functions of the cosine c and the shininess n. This list is the one place that names them all: X(number, name, function, use)
 * has glint_FUNCTION below do the model's work, in lib/lobe_FUNCTION.c; use is own, or shared where another model's functions are used. */
#define GLINT_MODELS(X)                                                                                                \
    X(GLINT_MSH, msh, msh, own)             /* (5)  2c / (1.25 (n - nc + 1.25c)^2), modified Schlick; peak 1.024 */    \
    X(GLINT_SCHLICK, schlick, schlick, own) /* (2)  c / (n - nc + c) */                                                \
    X(GLINT_BLINN, blinn, blinn, own)       /* (1)  c^n, c = N.H */                                                    \
    X(GLINT_PHONG, phong, blinn, shared)    /* (1)  c^n, c = V.R: the same power, other geometry */                    \
    X(GLINT_GAUSS, gauss, gauss, own)       /* (1)  exp(-n x^2 / 2), x = acos c */                                     \
    X(GLINT_CAYLEY, cayley, cayley, own)    /* ours: c^n for n <= 4, else r^4, r =                                  */ \
                                            /* max(0, 4(1+c) - n(1-c)) / (4(1+c) + n(1-c)) */                          \
    X(GLINT_LYON, lyon, lyon, own)          /* Lyon 1993, gamma 4: max(0, 1 - n(1-c)/4)^4 */

/* GLINT_MSH = 0, ... Stored as uint8_t in structs. */
#define GLINT_MODEL_NUMBER(number, name, function, use) number,
#define GLINT_MODEL_ONE(number, name, function, use) +1
enum glint_model { GLINT_MODELS(GLINT_MODEL_NUMBER) };
enum { GLINT_MODEL_COUNT = 0 GLINT_MODELS(GLINT_MODEL_ONE) };

/* F in Q16.16, 0..67109. From c correctly rounded; from t correctly rounded, too, but for powers and Gauss, which
 * are within 0.501 ulp. Monotone: F never rises with t. Both agree where t is a multiple of 2^-16. */
uint32_t glint_eval(enum glint_model model, uint32_t n, int32_t c_q16);
uint32_t glint_eval_t(enum glint_model model, uint32_t n, uint32_t t_q30);

/* The cutoff: the smallest c in 0..65536, the largest t in 0..2^30, whose true F is at least 2^-q. (The paper's closed
 * forms (12) and (14) are not used: (12) is singular at n = 1.25 and wrong in single precision.) */
uint32_t glint_cutoff(enum glint_model model, uint32_t n, unsigned q);
uint32_t glint_cutoff_t(enum glint_model model, uint32_t n, unsigned q);

/* The same, one model a file, so that a program links only what it calls: glint_msh, glint_msh_t, glint_msh_cutoff,
 * glint_msh_cutoff_t, and so on for schlick, blinn, gauss, cayley and lyon. */
#define GLINT_MODEL_FUNCTIONS(number, name, function, use)                                                             \
    uint32_t glint_##function(uint32_t n, int32_t c_q16);                                                              \
    uint32_t glint_##function##_t(uint32_t n, uint32_t t_q30);                                                         \
    uint32_t glint_##function##_cutoff(uint32_t n, unsigned q);                                                        \
    uint32_t glint_##function##_cutoff_t(uint32_t n, unsigned q);
GLINT_MODELS(GLINT_MODEL_FUNCTIONS)

/* A lobe prepared for a loop: everything beyond the cutoff is exactly 0 and costs one compare. Yours to place. */
struct glint_lobe {
    uint8_t model;      /* enum glint_model */
    uint8_t q;          /* 0..16 */
    uint16_t n;         /* 1..1000 */
    uint32_t c_min_q16; /* glint_cutoff(model, n, q) */
    uint32_t t_max_q30; /* glint_cutoff_t(model, n, q) */
};
void glint_lobe_init(struct glint_lobe *lobe, enum glint_model model, uint32_t n, unsigned q);
uint32_t glint_lobe_eval(const struct glint_lobe *lobe, int32_t c_q16);    /* Q16.16; 0 where c < c_min */
uint32_t glint_lobe_eval_t(const struct glint_lobe *lobe, uint32_t t_q30); /* Q16.16; 0 where t > t_max */

/* ---- Geometry: directions and what a pixel knows ------------------------------------------------------------- */

/* A direction in Q1.15: x to the right, y up, z to the viewer. An array of these is a normal map: 6 bytes a pixel. */
struct glint_vec {
    int16_t x, y, z;
};

/* Scales v (any units) to length 1, within .501 of 2^-15; 1.0 is held as 32767. GLINT_ERR_ARG: NULL. GLINT_ERR_VECTOR: v is 0. */
enum glint_err glint_vec_normalize(struct glint_vec *out, const int32_t v[3]);

/* A directional light seen by a distant viewer. */
struct glint_light {
    struct glint_vec l; /* towards the light */
    struct glint_vec v; /* towards the viewer */
    struct glint_vec h; /* the half vector (L + V) / |L + V| */
};
/* From directions of any length. GLINT_ERR_ARG: NULL. GLINT_ERR_VECTOR where one is 0, or the light straight behind: L within 2^-27 of -V. */
enum glint_err glint_light_init(struct glint_light *light, const int32_t to_light[3], const int32_t to_viewer[3]);

/* ---- The pixel ------------------------------------------------------------------------------------------------ *
 *
 * With N a normal, L the light, H the half vector (V.R for Phong in the place of N.H), k red, green, blue:
 *
 *   t = |N - H|^2 / 2 = 1 - N.H      nl = max(0, N.L)      F = the lobe at t; 0 where nl = 0
 *   value_k = albedo_k (ambient_k + diffuse_k nl) + specular_k gloss F
 *   out_k   = floor(min(1, value_k) max_k + 1/2), max_k = 255, 63, 31 or 1; dithered: a threshold in the place of 1/2
 *
 * In gamma space that is the one rounding, after the sum; in linear space the sum is encoded to sRGB before it. sequence.md has the
 * integers, step by step, the same on every path, target and compiler. Q1.15 vectors are the input as given: what rounding them costs
 * is the picture's affair, see the README.
 */

/* The coefficients, Q16.16, 0..65536 each (more counts as 65536), times the light's colour: red, green, blue. */
struct glint_material {
    uint32_t ambient_q16[3];
    uint32_t diffuse_q16[3];
    uint32_t specular_q16[3];
    uint8_t albedo[3]; /* where there is no albedo map; 255 = 1.0 */
};

/* Pixel formats. This list is the one place that names them all: X(number, name, bytes, channels, red, green, blue) has a pixel's bytes
 * (0: one bit), its channels and the largest level of each. GLINT_RGB565 = 0, ... Stored as uint8_t. */
#define GLINT_FORMATS(X)                                                                                               \
    X(GLINT_RGB565, "rgb565", 2, 3, 31, 63, 31)                 /* red in the top 5 bits, low byte first */            \
    X(GLINT_RGB565_SWAPPED, "rgb565-swapped", 2, 3, 31, 63, 31) /* high byte first: the wire's to most panels */       \
    X(GLINT_RGB888, "rgb888", 3, 3, 255, 255, 255)              /* red, green, blue */                                 \
    X(GLINT_GREY8, "grey8", 1, 1, 255, 255, 255)                                                                       \
    X(GLINT_MONO, "mono", 0, 1, 1, 1, 1)               /* most significant bit first; each line starts on a byte */    \
    X(GLINT_BGR888, "bgr888", 3, 3, 255, 255, 255)     /* blue, green, red, as LVGL has all of these */                \
    X(GLINT_XRGB8888, "xrgb8888", 4, 3, 255, 255, 255) /* blue, green, red, 255 */                                     \
    X(GLINT_ARGB8888, "argb8888", 4, 3, 255, 255, 255) /* blue, green, red, the mask: 255 where there is none */

#define GLINT_FORMAT_NUMBER(number, name, bytes, channels, red, green, blue) number,
#define GLINT_FORMAT_ONE(number, name, bytes, channels, red, green, blue) +1
enum glint_format { GLINT_FORMATS(GLINT_FORMAT_NUMBER) };
enum { GLINT_FORMAT_COUNT = 0 GLINT_FORMATS(GLINT_FORMAT_ONE) };

/* Where the sum is formed. Stored as uint8_t. */
enum glint_space {
    GLINT_GAMMA, /* on encoded values, as the paper and small displays do */
    GLINT_LINEAR /* albedo decoded from sRGB, the sum encoded to sRGB */
};

/* All that does not change within a rectangle. Config, set by you: fill it, then shade with it. */
struct glint_shader {
    struct glint_lobe lobe; /* glint_lobe_init; the model GLINT_PHONG also chooses Phong's geometry */
    struct glint_light light;
    struct glint_material material;
    uint8_t format; /* enum glint_format */
    uint8_t space;  /* enum glint_space */
    bool dither;
    bool clamp_peak; /* F at most 1.0; else MSH reaches 1.024 */
};

/* Where the pixels go. The stride is in bytes and may be negative (bottom-up) or odd. */
struct glint_surface {
    void *pixels;     /* the rectangle's first pixel; any alignment */
    ptrdiff_t stride; /* from a line to the next */
    uint16_t x, y;    /* where on the screen the rectangle starts: the phase of the dither */
};

struct glint_box { /* a rectangle in pixels; w = 0 where empty */
    uint16_t x, y, w, h;
};

/* ---- A rectangle of normals ---------------------------------------------------------------------------------- */

/* What each pixel knows. Maps that are NULL count as all 255 (albedo: the material's). Strides in bytes. A map may be
 * the output itself where sizes match (albedo in RGB888, a byte map in GREY8). */
struct glint_source {
    const struct glint_vec *normals; /* of about unit length; aligned as int16_t, so is the stride */
    ptrdiff_t normals_stride;
    const uint8_t *albedo; /* RGB888 */
    ptrdiff_t albedo_stride;
    const uint8_t *gloss; /* scales the highlight */
    ptrdiff_t gloss_stride;
    const uint8_t *mask; /* 0: the pixel is left as it is, its alpha, too */
    ptrdiff_t mask_stride;
};

/* Shades w x h pixels; w or h = 0 does nothing. In GLINT_MONO the bits past w in a line's last byte are kept. *highlight, unless it
 * is NULL, becomes the smallest box, relative to the rectangle, that holds every drawn pixel with F > 0 and gloss > 0: beyond it the
 * picture does not depend on it. GLINT_ERR_ARG: NULL, normals or stride misaligned. GLINT_ERR_FORMAT: no such format or space. */
GLINT_LARGE("name the model and the format: glint_shade_prepare_for, then glint_shade_prepared_rect")
enum glint_err glint_shade_rect(const struct glint_shader *shader, const struct glint_source *source, uint16_t w,
                                uint16_t h, const struct glint_surface *surface, struct glint_box *highlight);

/* ---- Several lights ------------------------------------------------------------------------------------------- *
 *
 * Up to four, each directional, a point or a spot. A point costs some 1,400 cycles a pixel on a Cortex-M0+.
 * Places are on the screen, in 1/16 pixel: x right, y down (as lines go), z to the viewer from the surface, which is at z = 0; pixel
 * x, y of a rectangle lies at 16 (surface.x + x) + 8, 16 (surface.y + y) + 8: parts of a picture join. Directions stay as above, y up.
 *
 * A point's light falls off by (1 - (distance / range)^2)^2; a spot's also by a smooth step from its outer cone to its inner one.
 * The lights' nl and F, scaled by their colours, are summed before the one rounding. The order of the lamps does not matter; one white
 * directional lamp gives the pixels of glint_shade_rect. With clamp_peak each F is held to 1, not their sum. The integers: sequence.md.
 */

#define GLINT_LAMPS_MAX 4u
#define GLINT_LAMP_COLOR_MAX ((uint32_t)1 << 20) /* 16.0 */
#define GLINT_LAMP_FAR ((int32_t)1 << 23)        /* how far a place may be from 0, and the longest range; 1/16 pixel */

enum glint_lamp_kind { GLINT_DIRECTIONAL, GLINT_POINT, GLINT_SPOT }; /* stored as uint8_t */

/* Filled by one of the functions below, white; then the colour is yours to set. */
struct glint_lamp {
    uint8_t kind;             /* enum glint_lamp_kind */
    uint32_t color_q16[3];    /* scales diffuse and specular: red, green, blue; more than 16.0 counts as 16.0 */
    struct glint_light light; /* directional */
    int32_t position[3];      /* point and spot */
    uint32_t range;           /* where the light has fallen to 0, 1..GLINT_LAMP_FAR; half of it is at .54 range */
    int32_t axis_q30[3];      /* spot: where it looks, length 1, y up */
    int32_t cos_inner_q30;    /* spot: within this angle to the axis full, ... */
    int32_t cos_outer_q30;    /* ... from this one on 0; a smooth step between, an edge where equal */
};

/* GLINT_ERR_ARG: NULL, a place or range out of bounds, cosines beyond +-2^30, the outer one above the inner.
 * GLINT_ERR_VECTOR: as glint_light_init; a spot whose target is its position. *lamp is not written then. */
enum glint_err glint_lamp_directional(struct glint_lamp *lamp, const int32_t to_light[3], const int32_t to_viewer[3]);
enum glint_err glint_lamp_point(struct glint_lamp *lamp, const int32_t position[3], uint32_t range);
enum glint_err glint_lamp_spot(struct glint_lamp *lamp, const int32_t position[3], const int32_t target[3],
                               uint32_t range, int32_t cos_inner_q30, int32_t cos_outer_q30);

/* As glint_shade_rect, lit by count lamps, 0..4, in place of shader->light, of which only v is used: the distant viewer
 * of points and spots. *highlight holds every drawn pixel with a shine_k > 0 and gloss > 0. Errors also:
 * GLINT_ERR_ARG: count > 4, NULL, an unknown kind, a lamp out of bounds. GLINT_ERR_VECTOR: a point or spot, and v is 0. */
enum glint_err glint_shade_lights(const struct glint_shader *shader, const struct glint_lamp *lamps, unsigned count,
                                  const struct glint_source *source, uint16_t w, uint16_t h,
                                  const struct glint_surface *surface, struct glint_box *highlight);

/* ---- A prepared shader: what a material, light, format and space fold to ---------------------------------------- *
 *
 * The functions that take a shader prepare it in every call: some 2,000 cycles on a Cortex-M0+. Short spans and small rectangles
 * prepare once and draw often, with the same pixels. A model and a format named at preparation link nothing else. */
struct glint_shade_model;  /* const, one a model */
struct glint_shade_format; /* const, one a kind of pixel */
#define GLINT_MODEL_SHADE(number, name, function, use) extern const struct glint_shade_model glint_shade_##name;
GLINT_MODELS(GLINT_MODEL_SHADE)                            /* glint_shade_msh and so on */
extern const struct glint_shade_format glint_shade_rgb565, /* gamma, both orders */
    glint_shade_rgb888, glint_shade_bgr888,                /* gamma; BGR888, XRGB8888 and ARGB8888 by the second */
    glint_shade_grey,                                      /* GREY8 and MONO, gamma */
    glint_shade_linear;                                    /* every format in linear space */

struct glint_near { /* what a lobe folds to */
    uint32_t t_end; /* F > 0 exactly where t < t_end, <= 2^30 + 1 */
    uint32_t f_max; /* F is held to this */
    uint32_t n;     /* 1..1000 */
    int32_t k[3];   /* the model's own */
};

/* State, ours; const once filled: shared by threads and interrupts. */
struct glint_prepared {
    struct glint_near near;
    uint32_t p[3], q[3], r[3], w;                   /* the format's own: with the material's albedo, */
    uint32_t ambient[3], diffuse[3], w_maps, shift; /* and with maps */
    const struct glint_shade_model *model;
    const struct glint_shade_format *format;
    struct glint_shader shader; /* as given */
    uint16_t slack;             /* F may be low by so much; V high by 2^(shift - 15) high */
    uint8_t high, apart;        /* apart: from a channel's samples to the next's; 0: they are the same */
};

/* GLINT_ERR_ARG: NULL. GLINT_ERR_FORMAT: no such format or space. Nothing is written then. */
enum glint_err glint_shade_prepare(struct glint_prepared *prepared, const struct glint_shader *shader);
/* For a model and format by name. GLINT_ERR_ARG, too: the shader has another model; GLINT_ERR_FORMAT: another format, space. */
enum glint_err glint_shade_prepare_for(struct glint_prepared *prepared, const struct glint_shader *shader,
                                       const struct glint_shade_model *model, const struct glint_shade_format *format);
/* Another light, without delay. GLINT_ERR_ARG: NULL. */
enum glint_err glint_shade_relight(struct glint_prepared *prepared, const struct glint_light *light);

/* As glint_shade_rect. */
enum glint_err glint_shade_prepared_rect(const struct glint_prepared *prepared, const struct glint_source *source,
                                         uint16_t w, uint16_t h, const struct glint_surface *surface,
                                         struct glint_box *highlight);

/* ---- A span: normals interpolated linearly, and no normal memory ---------------------------------------------- */

#define GLINT_SPAN_MAX 4096u
/* |N - H|^2 / 2 is exactly quadratic along a span: t takes two additions a pixel and nl one, Q2.30 modulo 2^32:
 *   t and nl are used (t >= 0xf8000000 is a little below 0 and counts as 0), then t += dt, dt += ddt, nl += dnl.
 * The rest of the pixel follows, with the material's albedo and gloss 255. */
struct glint_span {
    uint32_t t_q30, dt_q30, ddt_q30;
    int32_t nl_q30, dnl_q30;
    uint16_t w;
};

/* From the normals of the first and last pixel, for Blinn geometry. The ends are exact to (w + 2) 2^-31, the middle to
 * (w^2 / 16 + w + 1) 2^-30. Normals more than 20 degrees apart want subdividing: between them N is not renormalised.
 * GLINT_ERR_ARG: w > GLINT_SPAN_MAX. GLINT_ERR_VECTOR: t > 3.75 or |nl| > 2 - 2^-17 (normals far from unit length). */
enum glint_err glint_span_init(struct glint_span *span, const struct glint_light *light, const struct glint_vec *first,
                               const struct glint_vec *last, uint16_t w);

/* Shades the span's w pixels as one line. Errors and highlight as glint_shade_rect; Phong's power takes t as it is. */
GLINT_LARGE("name the model and the format: glint_shade_prepare_for, then glint_shade_prepared_span")
enum glint_err glint_shade_span(const struct glint_shader *shader, const struct glint_span *span,
                                const struct glint_surface *surface, struct glint_box *highlight);

enum glint_err glint_shade_prepared_span(const struct glint_prepared *prepared, const struct glint_span *span,
                                         const struct glint_surface *surface, struct glint_box *highlight);

/* The same as gateware draws it, whose core takes c: F at the nearest c_q16 to 1 - t. Off the exact span by half a step
 * of c: F by at most .03, .19, .63, 3.2 levels of 255 at n = 10, 60, 200, 1000 (MSH; Schlick 0.6 of that): one step of
 * RGB565, in 8 to 9 of 230,400 samples of the sphere in the README. */
enum glint_err glint_shade_span_c16(const struct glint_shader *shader, const struct glint_span *span,
                                    const struct glint_surface *surface, struct glint_box *highlight);

/* ---- Table loops: what the exact paths draw, at a fraction of their cycles -------------------------------------- *
 *
 * Tables are filled from exact values on the device; only their arguments are quantised. Filled once a material; a light that moves
 * needs only glint_tables_light_init. Uniform material, gloss 255, one directional light, Blinn geometry. In full: sequence.md.
 *
 * Compile with -DGLINT_CORTEX_M0PLUS_ASM=1, and lib/cortex_m0plus_*.S too, and 8- and 10-bit lines (10-bit ones not over an albedo map),
 * spans without one and palettes run in Thumb assembly, with the same pixels; so do exact rectangles of undithered RGB565 in gamma
 * space under MSH, without gloss.
 *
 * COLOUR  for RGB565 in either order, gamma or linear. 20,480 bytes: 4096 columns over t, which hold F in 64 steps, and
 *         128 rows over nl of 64 finished pixels. With shader->dither: gamma only, and 20,608 bytes; surface.x and y are the
 *         dither's phase. No rings: means over 4x4 pixels are as near to the true picture as the exact dithered path's.
 * SMALL   for every format, dithered or not, gamma only. 904 bytes; with its structs below 1 KB. A pixel is a sum of two
 *         words, one by nl and one by t.
 * ALBEDO  for RGB565 in either order, undithered, gamma, from an albedo map in RGB565; ambient and diffuse grey, together at most 1 (a
 *         coloured light goes into the map), any specular colour. 8,584 bytes. From the exact path with the map as RGB888 and the normals
 *         as stored: at most 2 steps of each channel, less than .5 in the mean, but where |N.L| < 2^-10: a last bit decides whether F is 0.
 */

/* How a normal is held. Stored as uint8_t. */
enum glint_normals {
    GLINT_NORMALS_INT16, /* struct glint_vec, 6 bytes */
    GLINT_NORMALS_INT10, /* uint32_t: x in the top 10 bits (Q9), y in 10 (Q9), z in the low 12 (Q11). z = 0: no surface */
    GLINT_NORMALS_INT8 /* uint32_t: 256 y + x in the low half (x, y Q7: -127..127), z in the high one (Q15), such that the
                            length is 1. z = 0: no surface */
    /* Where z = 0, the other bits may hold how many pixels from this one on have no surface, and z = 0, too: loops may step
     * over them. 0 counts as 1. */
};
/* A normal, packed: to the nearest x and y, and the z that makes its length 1. One of length 0, and INT16: 0. */
uint32_t glint_normals_pack(enum glint_normals format, const struct glint_vec *normal);
/* And as the loops read it. 0, 0, 0 where there is no surface. */
struct glint_vec glint_normals_unpack(enum glint_normals format, uint32_t word);

enum glint_tables_kind { GLINT_TABLES_COLOUR, GLINT_TABLES_SMALL, GLINT_TABLES_ALBEDO };
#define GLINT_TABLES_COLOUR_BYTES 20480u
#define GLINT_TABLES_DITHER_BYTES 20608u /* COLOUR, dithered */
#define GLINT_TABLES_SMALL_BYTES 904u
#define GLINT_TABLES_ALBEDO_BYTES 8584u
size_t glint_tables_bytes(enum glint_tables_kind kind); /* the same, undithered; 0 for no such kind */

/* State, ours; the memory stays yours and must outlive it. Const once filled: shared by threads and interrupts. */
struct glint_tables {
    const uint8_t *columns;
    union {
        const uint16_t *colours;
        const uint32_t *sums;
    } colour;
    uint32_t t_max_q30; /* u above (COLOUR, ALBEDO); the lobe's (SMALL) */
    uint16_t dark;      /* where nl < 0: the pixel, in memory order (COLOUR); p (ALBEDO) */
    uint8_t kind, format, shift;
    bool dither;
};
/* Fills. shader->light is not looked at. GLINT_ERR_ARG: NULL, too few bytes, memory not aligned to 4, no such kind or
 * model, Phong (its geometry is not |N - H|^2), ALBEDO and a material that it does not do. GLINT_ERR_FORMAT: a format,
 * space or dither that this kind does not do. Nothing is written then. */
enum glint_err glint_tables_fill(struct glint_tables *tables, enum glint_tables_kind kind,
                                 const struct glint_shader *shader, void *memory, size_t bytes);

/* A light, prepared for these tables as they are filled: a few thousand cycles, no table touched. GLINT_ERR_ARG: NULL. */
struct glint_tables_light {
    struct glint_vec l, h;
    int32_t x, y, z, cut, peak; /* for INT8 and INT10 with the viewer at (0, 0, 1) */
    uint32_t r;
    uint8_t a, kind; /* kind: of the tables */
    bool frontal;    /* is the viewer there, and with COLOUR l of length 1 and h theirs? */
};
enum glint_err glint_tables_light_init(struct glint_tables_light *light, const struct glint_tables *tables,
                                       const struct glint_light *from);

/* Shades w x h normals; pixels without a surface are left as they are. Normals are aligned (INT16 to 2 bytes, else to 4) and of about unit
 * length: others give some colour. GLINT_ERR_ARG: NULL, misaligned, ALBEDO tables, a light for another kind of tables. GLINT_ERR_FORMAT: no
 * such normals. GLINT_ERR_VECTOR: INT8 and a viewer not at (0, 0, 1), unless the tables are SMALL; INT8, COLOUR and a light made by hand
 * that is longer than 1.03 or has an h that is not its own. Nothing is written then. */
enum glint_err glint_tables_rect(const struct glint_tables *tables, const struct glint_tables_light *light,
                                 enum glint_normals format, const void *normals, ptrdiff_t stride, uint16_t w,
                                 uint16_t h, const struct glint_surface *surface);
/* The normals of a window, from column x and line y of a map on, for the functions above and below; the stride stays the map's. */
const void *glint_normals_window(enum glint_normals format, const void *map, ptrdiff_t stride, uint32_t x, uint32_t y);
/* The highlight's box of a rectangle over tables of any kind, as glint_shade_rect returns it: the smallest that holds every pixel to which
 * their loop for these normals adds a highlight. Looks again at each normal outside the box, at few inside. Errors as glint_tables_rect's. */
enum glint_err glint_tables_box(const struct glint_tables *tables, const struct glint_tables_light *light,
                                enum glint_normals format, const void *normals, ptrdiff_t stride, uint16_t w,
                                uint16_t h, struct glint_box *highlight);
/* Shades a span as one line. GLINT_ERR_ARG: NULL, ALBEDO tables. */
enum glint_err glint_tables_span(const struct glint_tables *tables, const struct glint_span *span,
                                 const struct glint_surface *surface);

/* The same with ALBEDO tables and a map of RGB565 values in the machine's order, whatever the output's; it and its stride are
 * aligned to 2. It may be the output itself. Errors as above; GLINT_ERR_ARG for other tables. */
enum glint_err glint_tables_albedo_rect(const struct glint_tables *tables, const struct glint_tables_light *light,
                                        enum glint_normals format, const void *normals, ptrdiff_t stride,
                                        const uint16_t *albedo, ptrdiff_t albedo_stride, uint16_t w, uint16_t h,
                                        const struct glint_surface *surface);
enum glint_err glint_tables_albedo_span(const struct glint_tables *tables, const struct glint_span *span,
                                        const uint16_t *albedo, const struct glint_surface *surface);

/* A palette of normals, shaded once a frame by any path as w = its size, h = 1, into 2-byte pixels; then one load a pixel.
 * offsets: 2 x index, to be even and inside (they are not checked). GLINT_ERR_ARG: NULL, misaligned pixels or strides. */
enum glint_err glint_palette_rect(const uint16_t *colours, const uint16_t *offsets, ptrdiff_t stride, uint16_t w,
                                  uint16_t h, const struct glint_surface *surface);

/* ---- sRGB, integers only ------------------------------------------------------------------------------------- */

uint16_t glint_srgb_decode(uint8_t encoded); /* 65535 = 1.0; nearest */
/* 65535 = 1.0, both; monotone, within 3 units (.01 of a level of 255) of the true encoding. */
uint16_t glint_srgb_encode(uint16_t linear);

#ifdef __cplusplus
}
#endif

/* ---- Meshes ---- */
#include "glint_mesh.h"

#endif
