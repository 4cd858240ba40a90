/* SPDX-License-Identifier: MIT
 *
 * glint: specular shading with integers only. This header is the manual.
 *
 * ONE ANSWER. Every value is the correctly rounded value of the real function at the argument given: nearest, ties up,
 * in Q16.16, the same on every machine and compiler. (From t, powers and both Gaussians promise 0.501 ulp instead.)
 *
 * Units        Q16.16: 1.0 = 65536.   Q2.30: 1.0 = 2^30.   Q1.15 in an int16_t: 1.0 = 32768, held as 32767.
 * Arguments    c: the cosine, N.H (V.R for Phong), Q16.16.   t = 1 - c, Q2.30. Prefer t: at n = 1000 one step of c moves a
 *              highlight by 6 levels of 255, one step of t by none.
 *              n: shininess, 1..1000.   q: a highlight below 2^-q counts as 0; 0..16.
 * Clamping     Lobes clamp n and q. c < 0 or t > 1 (back-facing) gives 0, c > 1 counts as 1. An unknown model gives 0.
 * Re-entrancy  No global state, no heap, no writable data. Interrupts and threads may call it, and share a struct where it is const.
 * Stack        At most 1,300 bytes for any call, 1,600 with Helium (`make test-targets` checks it).
 * Memory       Constants stay in flash, also on AVR and the ESP8266. COSTS.md has their bytes.
 * Integers     sequence.md has the integers of every path, bit by bit.
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

/* Of functions that name what they link: inlined, or a linker that optimizes would see the name. */
#if defined(__GNUC__)
#define GLINT_USES __attribute__((always_inline))
#else
#define GLINT_USES
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define GLINT_VERSION_MAJOR 0
#define GLINT_VERSION_MINOR 3
#define GLINT_VERSION_PATCH 0
#define GLINT_VERSION_STRING "0.3.0"

#define GLINT_N_MAX 1000u
#define GLINT_Q_MAX 16u
#define GLINT_C_ONE ((int32_t)65536)    /* 1.0 in Q16.16 */
#define GLINT_T_ONE ((uint32_t)1 << 30) /* 1.0 in Q2.30 */

/* What calls that take memory or geometry return: 0 is good, negative an error. */
enum glint_err {
    GLINT_OK = 0,
    GLINT_ERR_ARG = -1,    /* NULL, or a number, size, stride or combination that is not allowed */
    GLINT_ERR_FORMAT = -2, /* no such format, space or dither, or one that this paint does not do */
    GLINT_ERR_VECTOR = -3  /* a direction of 0, a light straight behind, a viewer not in front, a span out of range */
};

/* ---- The lobe: how bright the highlight is ------------------------------------------------------------------- */

/* The models: functions of the cosine c and the shininess n. This list alone names them all. X(number, name, function, use, grain): glint_FUNCTION
 * below does the model's work (lib/lobe_FUNCTION.c); use is own, or shared where the functions are another model's; grain is grained where
 * a material may have n_across, else plain. MSH is the modified Schlick function; Cayley's r = max(0, 4(1+c) - n(1-c)) / (4(1+c) + n(1-c)). */
#define GLINT_MODELS(X)                                                                                                \
    X(GLINT_MSH, msh, msh, own, grained)             /* (5)  2c / (1.25 (n - nc + 1.25c)^2); peak 1.024 */             \
    X(GLINT_SCHLICK, schlick, schlick, own, grained) /* (2)  c / (n - nc + c) */                                       \
    X(GLINT_BLINN, blinn, blinn, own, plain)         /* (1)  c^n, c = N.H */                                           \
    X(GLINT_PHONG, phong, blinn, shared, plain)      /* (1)  c^n, c = V.R: other geometry */                           \
    X(GLINT_GAUSS, gauss, gauss, own, plain)         /* (1)  exp(-n x^2 / 2), x = acos c */                            \
    X(GLINT_CAYLEY, cayley, cayley, own, grained)    /* ours: c^n for n <= 4, else r^4 */                              \
    X(GLINT_LYON, lyon, lyon, own, grained)          /* Lyon 1993, gamma 4: max(0, 1 - n(1-c)/4)^4 */                  \
    X(GLINT_GGX, ggx, ggx, own, grained)             /* 1 / (1 + n (1 - c^2) / 2)^2; at c = 0 a step */                \
    X(GLINT_SG, sg, sg, own, plain)                  /* the spherical Gaussian, exp(-n (1 - c)) */

/* GLINT_MSH = 0, ... Stored as uint8_t in structs. (The last name is the first again: C++98 takes no comma at a list's end.) */
#define GLINT_MODEL_NUMBER(number, name, function, use, grain) number,
#define GLINT_MODEL_ONE(number, name, function, use, grain) +1
enum glint_model { GLINT_MODELS(GLINT_MODEL_NUMBER) GLINT_MODEL_FIRST = 0 };
enum { GLINT_MODEL_COUNT = 0 GLINT_MODELS(GLINT_MODEL_ONE) };

/* F in Q16.16, 0..67109. From c correctly rounded; from t correctly rounded, too, but for powers, Gauss and SG, which
 * are within 0.501 ulp. Monotone: F never rises with t. Both agree where t is a multiple of 2^-16. */
uint32_t glint_eval(enum glint_model model, uint32_t n, int32_t c_q16);
uint32_t glint_eval_t(enum glint_model model, uint32_t n, uint32_t t_q30);

/* The cutoff: the smallest c in 0..65536, the largest t in 0..2^30, whose true F is at least 2^-q. (The paper's closed
 * forms (12) and (14) are not used: (12) is singular at n = 1.25 and wrong in single precision.) */
uint32_t glint_cutoff(enum glint_model model, uint32_t n, unsigned q);
uint32_t glint_cutoff_t(enum glint_model model, uint32_t n, unsigned q);

/* The same, one model a file, so that a program links only what it calls: glint_msh, glint_msh_t, glint_msh_cutoff,
 * glint_msh_cutoff_t, and so on for schlick, blinn, gauss, cayley, lyon, ggx and sg. */
#define GLINT_MODEL_FUNCTIONS(number, name, function, use, grain)                                                      \
    uint32_t glint_##function(uint32_t n, int32_t c_q16);                                                              \
    uint32_t glint_##function##_t(uint32_t n, uint32_t t_q30);                                                         \
    uint32_t glint_##function##_cutoff(uint32_t n, unsigned q);                                                        \
    uint32_t glint_##function##_cutoff_t(uint32_t n, unsigned q);
GLINT_MODELS(GLINT_MODEL_FUNCTIONS)

/* A lobe prepared for a loop of your own: beyond the cutoff it is exactly 0, and costs one compare. */
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

/* ---- Directions ---------------------------------------------------------------------------------------------- */

/* A direction in Q1.15: x to the right, y up, z to the viewer. An array of these is a normal map: 6 bytes a pixel. */
struct glint_vec {
    int16_t x, y, z;
};

/* Scales v (any units) to length 1, within .501 of 2^-15; 1.0 is held as 32767. GLINT_ERR_ARG: NULL. GLINT_ERR_VECTOR: v is 0. */
enum glint_err glint_vec_normalize(struct glint_vec *out, const int32_t v[3]);

/* ---- What is drawn with: material, output, lights -------------------------------------------------------------- *
 *
 * N is the normal, L the direction to the light, H the half vector (Phong has V.R in place of N.H), k red, green, blue:
 *
 *   t = |N - H|^2 / 2 = 1 - N.H      nl = max(0, N.L)      F = the lobe at t; 0 where nl = 0 or F < 2^-q
 *   value_k = albedo_k (ambient_k + diffuse_k nl) + specular_k gloss F
 *   out_k   = floor(min(1, value_k) max_k + 1/2), max_k = 255, 63, 31, 15, 3 or 1; dithered: a threshold in place of 1/2
 *
 * Under several lights nl and F are sums over the lights, each times its colour. In gamma space there is one rounding, after the sum; in
 * linear space the sum is encoded to sRGB first. sequence.md has the integers, step by step: the same on every path, target and
 * compiler.
 */

/* A material. Coefficients are Q16.16, 0..65536; more counts as 65536. Red, green, blue. */
struct glint_material {
    uint8_t model; /* enum glint_model */
    /* The highlight ends at 2^-q, 1..16. 0: 6 for RGB565, GREY4, GREY2 and MONO, 8 for others or dithered, 12 in linear space; an exact paint's
     * material tells which. */
    uint8_t q;
    uint16_t n;        /* shininess, 1..1000; 0 is an error, more counts as 1000 */
    uint16_t n_across; /* of grain, 1..1000; more counts as 1000. 0 or n: there is none */
    uint32_t ambient_q16[3];
    uint32_t diffuse_q16[3];
    uint32_t specular_q16[3];
    uint8_t albedo[3]; /* where there is no albedo map; 255 = 1.0 */
    bool clamp_peak;   /* F at most 1.0; else MSH reaches 1.024 */
};

/* Pixel formats. This list alone names them all. X(number, name, bits, channels, red, green, blue): a pixel's bits (below 8: the most
 * significant first, each line starts on a byte), its channels, and the largest level of each. GLINT_RGB565 = 0, ... Stored as uint8_t. */
#define GLINT_FORMATS(X)                                                                                               \
    X(GLINT_RGB565, "rgb565", 16, 3, 31, 63, 31)                 /* red in the top 5 bits, low byte first */           \
    X(GLINT_RGB565_SWAPPED, "rgb565-swapped", 16, 3, 31, 63, 31) /* high byte first: the order of most panels */       \
    X(GLINT_RGB888, "rgb888", 24, 3, 255, 255, 255)              /* red, green, blue */                                \
    X(GLINT_GREY8, "grey8", 8, 1, 255, 255, 255)                                                                       \
    X(GLINT_MONO, "mono", 1, 1, 1, 1, 1)                                                                               \
    X(GLINT_BGR888, "bgr888", 24, 3, 255, 255, 255)     /* blue, green, red, as LVGL has all of these */               \
    X(GLINT_XRGB8888, "xrgb8888", 32, 3, 255, 255, 255) /* blue, green, red, 255 */                                    \
    X(GLINT_ARGB8888, "argb8888", 32, 3, 255, 255, 255) /* blue, green, red, the coverage: 255 where there is none */  \
    X(GLINT_GREY4, "grey4", 4, 1, 15, 15, 15)           /* e-paper, OLED */                                            \
    X(GLINT_GREY2, "grey2", 2, 1, 3, 3, 3)

#define GLINT_FORMAT_NUMBER(number, name, bits, channels, red, green, blue) number,
#define GLINT_FORMAT_ONE(number, name, bits, channels, red, green, blue) +1
enum glint_format { GLINT_FORMATS(GLINT_FORMAT_NUMBER) GLINT_FORMAT_FIRST = 0 };
enum { GLINT_FORMAT_COUNT = 0 GLINT_FORMATS(GLINT_FORMAT_ONE) };

/* Where the sum is formed. Stored as uint8_t. */
enum glint_space {
    GLINT_GAMMA, /* on encoded values, as the paper and small displays do */
    GLINT_LINEAR /* albedo decoded from sRGB, the sum encoded to sRGB */
};

/* What pixels are. */
struct glint_output {
    uint8_t format; /* enum glint_format */
    uint8_t space;  /* enum glint_space */
    bool dither;    /* 4x4 ordered, by a pixel's place on the screen */
};

/* Lights: directional, points and spots. A point costs some 1,400 cycles a pixel on a Cortex-M0+.
 *
 * Places are on the screen, in 1/16 pixel from its upper left corner: x right, y down (as lines go), z to the viewer. A rectangle lies at
 * z = 0, the middle of its pixel x, y at 16 (target.x + x) + 8, 16 (target.y + y) + 8: parts of a picture that are drawn one by one fit
 * together. Directions have y up.
 *
 * A point's light falls off by (1 - (distance / range)^2)^2, a spot's also by a smooth step from its outer cone to its inner one. */
#define GLINT_LIGHTS_MAX 4u
#define GLINT_LIGHT_COLOR_MAX ((uint32_t)1 << 20) /* 16.0 */
#define GLINT_LIGHT_FAR ((int32_t)1 << 23) /* the largest coordinate of a place, and the longest range; 1/16 pixel */

struct glint_light_kind; /* one for each kind, const: what is linked for it */
/* Filled by one of the functions below, white; then the colour is yours to set. */
struct glint_light {
    const struct glint_light_kind *kind;
    uint32_t color_q16[3];    /* scales diffuse and specular: red, green, blue; more than 16.0 counts as 16.0 */
    int32_t direction_q30[3]; /* directional: towards the light; spot: where it looks. Length 1, y up */
    int32_t position[3];      /* point and spot */
    uint32_t range;           /* where the light has fallen to 0, 1..GLINT_LIGHT_FAR; half of it is at .54 range */
    int32_t cos_inner_q30;    /* spot: full within this angle to its direction, ... */
    int32_t cos_outer_q30;    /* ... 0 from this one on; between them a smooth step, where they are equal an edge */
};

/* GLINT_ERR_ARG: NULL, a place or range out of bounds, cosines beyond +-2^30, the outer one above the inner.
 * GLINT_ERR_VECTOR: a direction of length 0; a spot whose target is its position. *light is not written then. */
enum glint_err glint_light_directional(struct glint_light *light, const int32_t to_light[3]);
enum glint_err glint_light_point(struct glint_light *light, const int32_t position[3], uint32_t range);
enum glint_err glint_light_spot(struct glint_light *light, const int32_t position[3], const int32_t target[3],
                                uint32_t range, int32_t cos_inner_q30, int32_t cos_outer_q30);

/* ---- A paint: what material, output and lights fold to ---------------------------------------------------------- *
 *
 * Make a paint once a material, light it once a frame, then draw with it as often as you like. It is the same for every source of pixels.
 * A function that names neither model nor format links them all; with `_for` a program links what it names: &glint_use_msh,
 * &glint_use_rgb565.
 */
struct glint_use_model;    /* one for each model, const */
struct glint_use_format;   /* one for each group of formats, const */
struct glint_use_tables;   /* one for each kind of tables, const */
struct glint_use_lights;   /* what sums several lights, const */
struct glint_use_coverage; /* what blends soft edges, const */
/* Models that may have grain have two: glint_use_msh_grain links what n_across and maps of grain and shininess take, with glint_use_msh these
 * are an error. */
#define GLINT_IF_grained(x) x
#define GLINT_IF_plain(x)
#define GLINT_MODEL_USE(number, name, function, use, grain)                                                            \
    extern const struct glint_use_model glint_use_##name;                                                              \
    GLINT_IF_##grain(extern const struct glint_use_model glint_use_##name##_grain;)
GLINT_MODELS(GLINT_MODEL_USE)                          /* glint_use_msh, glint_use_msh_grain and so on */
extern const struct glint_use_format glint_use_rgb565, /* gamma, both orders */
    glint_use_rgb888,                                  /* gamma: RGB888, BGR888, XRGB8888, ARGB8888 */
    glint_use_grey,                                    /* gamma: GREY8, GREY4, GREY2, MONO */
    glint_use_linear,                                  /* every format in linear space */
    glint_use_rgb565_steps, glint_use_linear_steps;    /* RGB565 undithered: glint_paint_steps_for */
extern const struct glint_use_tables glint_use_colour, glint_use_colour_dithered, glint_use_albedo,
    glint_use_colour_maps, glint_use_colour_dithered_maps, glint_use_albedo_maps; /* with maps of gloss and shininess */
extern const struct glint_use_lights glint_use_lights;
extern const struct glint_use_coverage glint_use_coverage;

/* Tables: what the exact paint draws, at a fraction of its cycles. They are filled from exact values, on the device or before; only their
 * arguments are quantised (sequence.md). They take one white directional light or none, and every model but Phong. Maps of gloss and shininess need
 * a kind named _maps; F of a pixel's n is that of the tables at the same n t then, for every model.
 *
 * COLOUR  RGB565 in either order, gamma or linear, of one albedo. 20,480 bytes: 4096 columns over t, which hold F in 64 steps, and
 *         128 rows over nl of 64 finished pixels. Dithered: gamma only, 20,608 bytes, and no rings around the highlight: means over 4x4
 *         pixels are as near to the true picture as those of the exact dithered paint.
 * ALBEDO  RGB565 in either order, undithered, gamma, over an albedo map in RGB565; ambient and diffuse grey, together at most 1, any specular
 *         colour. 8,584 bytes. It differs from the exact paint (the map as RGB888, the same normals) by at most 2 steps of a channel,
 *         by less than .5 in the mean; by more only where |N.L| < 2^-10, since there a last bit decides whether F is 0. */
enum glint_tables_kind { GLINT_TABLES_COLOUR, GLINT_TABLES_ALBEDO };
#define GLINT_TABLES_COLOUR_BYTES 20480u
#define GLINT_TABLES_DITHER_BYTES 20608u /* COLOUR, dithered */
#define GLINT_TABLES_ALBEDO_BYTES 8584u
size_t glint_tables_bytes(enum glint_tables_kind kind, bool dither); /* 0: no such tables */

/* Filled tables. State, ours; `glint table` on a computer writes one for flash. */
struct glint_tables {
    const uint8_t *columns;
    union {
        const uint16_t *colours;
        const uint32_t *sums;
    } colour;
    uint32_t t_max_q30;
    uint16_t dark; /* where nl < 0: the pixel, in memory order (COLOUR); its level (ALBEDO) */
    uint8_t kind, format, shift;
    bool dither;
    uint16_t n; /* the material's */
    const struct glint_use_tables *use;
};

/* State, ours: read it if you like. Drawing leaves it as it is, so threads and interrupts may draw with one paint. */
struct glint_paint {
    union {
        struct {
            uint32_t t_end, f_max, n; /* F > 0 exactly where t < t_end; F is held to f_max */
            int32_t k[3];             /* the model's own */
            /* The format's own: with the material's albedo, ... */
            uint32_t p[3], q[3], r[3], w;
            uint32_t ambient[3], diffuse[3], w_maps, shift; /* ... and with maps */
            uint32_t most;  /* of several lights: the largest sum of nl that the format takes; of F 33/32 of it */
            uint16_t slack; /* by how much F may be low */
            uint16_t high;  /* V may be high by 2^(shift - 15) times this */
            uint8_t nl_down, f_down;    /* of several lights: their sums are shifted down by these */
            struct glint_vec halves[4]; /* and H of each directional one */
            const uint16_t *steps;      /* glint_paint_steps' */
        } exact;
        struct {
            struct glint_tables filled;
            int32_t x, y, z, cut, peak; /* for INT8 with the viewer at (0, 0, 1) */
            uint32_t r;
            uint8_t a;
            bool is_frontal; /* is the viewer there? */
        } tables;
    } of;
    const struct glint_use_model *model;    /* NULL: a paint of zeros, or of tables */
    const struct glint_use_format *format;  /* NULL: the same */
    const struct glint_use_lights *several; /* NULL: no light, or one directional one */
    const struct glint_light *lights;       /* of several */
    struct glint_vec l, v, h;               /* of one; v also of several */
    uint8_t light_count;                    /* 0..4; 255: never lit */
    struct glint_output output;
    uint32_t color_q16[3]; /* of one light */
    struct glint_material material;
};

/* Makes an exact paint. GLINT_ERR_ARG: NULL, no such model, n = 0, n_across of a model or by a
 * `glint_use_` that has no grain; `_for`: the material names another model.
 * GLINT_ERR_FORMAT: no such format or space; `_for`: the output names another. *paint is not written then. */
GLINT_LARGE("name the model and the format: glint_paint_exact_for")
enum glint_err glint_paint_exact(struct glint_paint *paint, const struct glint_material *material,
                                 const struct glint_output *output);
enum glint_err glint_paint_exact_for(struct glint_paint *paint, const struct glint_material *material,
                                     const struct glint_output *output, const struct glint_use_model *model,
                                     const struct glint_use_format *format);

/* Gives an exact paint of RGB565, undithered, a table of what it draws without highlight, a pixel for each of 1024 steps of N.L: the same pixels
 * in fewer cycles, where most have no highlight. Call it once a material (its cycles: COSTS.md), after glint_paint_light where the light is
 * coloured. A light of another colour, several lights, points and spots leave it out from there on. memory: aligned to 2; leave it alone while you
 * draw. `_for`: with &glint_use_rgb565_steps or, of linear space, &glint_use_linear_steps. GLINT_ERR_ARG: NULL, too few bytes, misaligned, no
 * exact paint, lights of these kinds. GLINT_ERR_FORMAT: another format or space, or dither. Nothing is written then. */
#define GLINT_STEPS_BYTES 2050u
GLINT_LARGE("name the format: glint_paint_steps_for")
enum glint_err glint_paint_steps(struct glint_paint *paint, void *memory, size_t bytes);
enum glint_err glint_paint_steps_for(struct glint_paint *paint, const struct glint_use_format *format, void *memory,
                                     size_t bytes);

/* Makes a paint of tables and fills them, in a few million cycles. memory: glint_tables_bytes, aligned to 4; leave it alone
 * while you draw. Errors as above, and GLINT_ERR_ARG: too few bytes, misaligned, no such kind, Phong (its t is not |N - H|^2 / 2), a material that
 * ALBEDO does not do. GLINT_ERR_FORMAT: a format, space or dither that this kind does not do; `_for`: glint_use_colour with dither,
 * glint_use_colour_dithered without. Nothing is written then. */
GLINT_LARGE("no table has room beside all models")
enum glint_err glint_paint_tables(struct glint_paint *paint, enum glint_tables_kind kind,
                                  const struct glint_material *material, const struct glint_output *output,
                                  void *memory, size_t bytes);
enum glint_err glint_paint_tables_for(struct glint_paint *paint, const struct glint_use_tables *kind,
                                      const struct glint_material *material, const struct glint_output *output,
                                      void *memory, size_t bytes, const struct glint_use_model *model,
                                      const struct glint_use_format *format);
/* Makes a paint of tables that were filled before, in flash: no fill, no RAM. It links what the tables name. GLINT_ERR_ARG: NULL, tables of
 * zeros. GLINT_ERR_FORMAT: the output has another format or dither than they were filled for. */
enum glint_err glint_paint_tables_filled(struct glint_paint *paint, const struct glint_tables *filled,
                                         const struct glint_output *output);

/* What glint_paint_light calls. It names what sums several lights only where count may be above 1, so that others do not link that. */
enum glint_err glint_paint_light_by(struct glint_paint *paint, const struct glint_light *lights, unsigned count,
                                    const int32_t to_viewer[3], const struct glint_use_lights *several);
/* Lights the paint, in a few thousand cycles. An exact paint takes 0..4 lights of any kind, tables one white directional light or none. A
 * single directional light is copied; points, spots and several lights are not: leave the array as it is until the drawing is done.
 * to_viewer: a direction of any length. After an error the paint keeps the light that it had.
 * GLINT_ERR_ARG: NULL, a paint of zeros, more than four lights, a light of zeros or out of bounds, lights that tables do not take.
 * GLINT_ERR_VECTOR: to_viewer is 0; a directional light straight behind (L within 2^-27 of -V). */
GLINT_USES
static inline enum glint_err glint_paint_light(struct glint_paint *paint, const struct glint_light *lights,
                                               unsigned count, const int32_t to_viewer[3])
{
    return glint_paint_light_by(paint, lights, count, to_viewer, count > 1 ? &glint_use_lights : NULL);
}

/* ---- Sources of pixels: each takes any paint -------------------------------------------------------------------- */

/* Where the pixels go. The stride is in bytes and may be negative (bottom-up) or odd. */
struct glint_surface {
    void *pixels;     /* the first pixel; any alignment */
    ptrdiff_t stride; /* from a line to the next; ignored where there is one line */
    uint16_t x, y;    /* where on the screen the first pixel is: for dither, points and spots */
};

struct glint_box { /* a rectangle in pixels; w = 0 where empty */
    uint16_t x, y, w, h;
};

/* How a normal is held. Stored as uint8_t. */
enum glint_normals {
    GLINT_NORMALS_INT16, /* struct glint_vec, 6 bytes */
    GLINT_NORMALS_INT8 /* uint32_t: 256 y + x in the low half (x, y Q7: -127..127), z in the high one (Q15), such that the
                            length is 1. z = 0: no surface. The low half may then say how many pixels from this one on have none,
                            all with z = 0, so that loops skip them; 0 counts as 1. */
};
/* Packs a normal: x and y to nearest, and the z that makes the length 1. 0 for NULL, a normal of length 0, and INT16. */
uint32_t glint_normals_pack(enum glint_normals format, const struct glint_vec *normal);
/* Unpacks it, as it is drawn. 0, 0, 0 where there is no surface. */
struct glint_vec glint_normals_unpack(enum glint_normals format, uint32_t word);
/* Where a window of a map begins: at column x of line y. Its stride is the map's. */
const void *glint_normals_window(enum glint_normals format, const void *map, ptrdiff_t stride, uint32_t x, uint32_t y);

/* A map of shininess, a byte a pixel, is logarithmic: 25.6 codes an octave, n = 1 at 0, 997 at 255. And the code whose n is nearest. */
uint32_t glint_shininess_n(uint8_t code);
uint8_t glint_shininess_code(uint32_t n);

/* Grain: brushed, spun, turned metal. Across it a material's shininess is n_across, along it n. With T, the direction of the grain in the
 * surface, m takes the place of n t, of n t (2 - t) / 2 in GGX, in MSH, Schlick, Cayley (as r^4 for every n), Lyon and GGX:
 *
 *   m = n_across t + (n - n_across) (H.T)^2 / 2      (H.T)^2 = (H.U - c N.U)^2 / (|U|^2 - (N.U)^2)
 *
 * U: the direction in the picture's plane, of any length. Where it is 0, in the middle of what is spun, and where N is along it,
 * m = (n + n_across) t / 2, the mean of all directions. F is the correctly rounded value at the t and m of sequence.md, and 0 where that
 * true F is below 2^-q. Pictures are within .6 level of 255, the rounding's .5 included, of double precision.
 *
 * Which way the grain runs. Stored as uint8_t. */
enum glint_grain {
    GLINT_GRAIN_BRUSHED, /* one way over the whole surface */
    GLINT_GRAIN_SPUN,    /* round a point */
    GLINT_GRAIN_SUNRAY   /* away from it */
};

/* What each pixel has. A map that is NULL counts as 255 everywhere, albedo as the material's. Strides are in bytes, and ignored where there is
 * one line. A map, but not the normals, may be the output itself where pixels have one size (albedo in RGB888, a byte map in GREY8): a pixel is
 * read before it is written, and what coverage blends is blended over the map's own value. Which paint takes which:
 *
 *            normals                                       albedo                      gloss   coverage   grain   shininess
 *   exact    INT16, INT8                                   RGB888                      yes     yes        yes     without n_across
 *   COLOUR   INT16, INT8 with the viewer at (0, 0, 1)      no                          _maps   yes        no      _maps
 *   ALBEDO   the same                                      RGB565, machine's order     _maps   yes        no      _maps
 *
 * Normals have about unit length; others give some colour. INT16 is aligned to 2 bytes, INT8 to 4, RGB565 to 2, and so are strides.
 * A pixel without a surface (INT8: z = 0; by tables also INT16: 0, 0, 0) is left as it is. */
struct glint_maps {
    const void *normals;
    ptrdiff_t normals_stride;
    const uint8_t *albedo;
    ptrdiff_t albedo_stride;
    const uint8_t *gloss; /* scales the highlight */
    ptrdiff_t gloss_stride;
    /* 0..255: how much of the pixel is drawn over what the buffer holds; 0 leaves it as it is, 255 draws it. ARGB8888 is not blended: where it
     * is not 0, the pixel is drawn, with the coverage as alpha. */
    const uint8_t *coverage;
    ptrdiff_t coverage_stride;
    /* Its direction, 256 a half turn, counterclockwise from the right. Without n_across it changes nothing; not with shininess. */
    const uint8_t *grain;
    ptrdiff_t grain_stride;
    uint8_t normals_format; /* enum glint_normals */
    uint8_t albedo_format;  /* GLINT_RGB888 or GLINT_RGB565 */
    uint8_t grain_kind;     /* enum glint_grain; not used where there is a map of grain */
    /* Brushed: the direction, x right, y up, of any length; 0, 0 is 1, 0. Spun, sunray: the centre, on the screen as places of lights are. */
    int32_t grain_at[2];
    const uint8_t *shininess; /* n of each pixel in the place of the material's, as glint_shininess_code gives it */
    ptrdiff_t shininess_stride;
};

/* What glint_draw_rect calls. It names what blends only where there may be coverage, so that others do not link that: soft is
 * &glint_use_coverage, or NULL, and then a map of coverage is an error. */
enum glint_err glint_draw_rect_by(const struct glint_paint *paint, const struct glint_maps *maps, uint16_t w,
                                  uint16_t h, const struct glint_surface *target, struct glint_box *highlight,
                                  const struct glint_use_coverage *soft);
/* Draws w x h pixels; w or h = 0 draws nothing. Of pixels below a byte the bits past w in a line's last byte are kept. *highlight, unless it is NULL,
 * becomes the smallest box, relative to the rectangle, of the drawn pixels with a highlight (F > 0 and gloss > 0; by tables: t within their
 * columns, whatever the gloss). Outside of it the picture is the same without the highlight. Paints of tables look at the normals outside of it twice then.
 * GLINT_ERR_ARG: NULL, a paint of zeros or never lit, a map that the paint does not take, or one that it needs (ALBEDO without albedo), a
 * stride smaller than its line, misaligned. GLINT_ERR_FORMAT: no such format of normals, or of albedo for this paint. GLINT_ERR_VECTOR: a paint
 * of tables, INT8, and a viewer not at (0, 0, 1). Nothing is drawn then. */
GLINT_USES
static inline enum glint_err glint_draw_rect(const struct glint_paint *paint, const struct glint_maps *maps, uint16_t w,
                                             uint16_t h, const struct glint_surface *target,
                                             struct glint_box *highlight)
{
    return glint_draw_rect_by(paint, maps, w, h, target, highlight,
                              maps && maps->coverage ? &glint_use_coverage : NULL);
}

/* A span: normals interpolated linearly, and no normal memory. |N - H|^2 / 2 is exactly quadratic along it: t takes two additions a pixel and
 * nl one, Q2.30 modulo 2^32: t and nl are used (t >= 0xf8000000 is a little below 0 and counts as 0), then t += dt, dt += ddt, nl += dnl. */
#define GLINT_SPAN_MAX 4096u
struct glint_span {
    uint32_t t_q30, dt_q30, ddt_q30;
    int32_t nl_q30, dnl_q30;
    uint16_t w;
    int16_t ends[2][2]; /* x and y of the first and the last normal: for grain */
};
/* From the normals of the first and last pixel, under the paint's light. The ends are exact to (w + 2) 2^-31, the middle to
 * (w^2 / 16 + w + 1) 2^-30. Subdivide where the normals are more than 20 degrees apart: between them N is not renormalised.
 * GLINT_ERR_ARG: NULL, w > GLINT_SPAN_MAX, a paint of zeros, never lit, or lit by a point, a spot or several lights.
 * GLINT_ERR_VECTOR: |nl| > 2 - 2^-17 (normals far from unit length). */
enum glint_err glint_span_init(struct glint_span *span, const struct glint_paint *paint, const struct glint_vec *first,
                               const struct glint_vec *last, uint16_t w);
enum glint_err glint_draw_span_by(const struct glint_paint *paint, const struct glint_span *span,
                                  const struct glint_maps *maps, const struct glint_surface *target,
                                  struct glint_box *highlight, const struct glint_use_coverage *soft);
/* Draws the span's pixels as one line. maps: NULL, or albedo, gloss, coverage and shininess of these pixels. Grain is brushed: N.U is linear
 * along a span, within (w + 1) 2^-29. As N is not renormalised, levels of 255 differ by up to 4 where its ends are 15 degrees apart and n_across is
 * 60 over n = 8, by up to 1 where n is 60 over n_across = 8. A span takes one directional light or none;
 * with GLINT_PHONG, too, its t is |N - H|^2 / 2. Errors as glint_draw_rect, and GLINT_ERR_ARG: a paint lit by a point, a spot or several lights. */
GLINT_USES
static inline enum glint_err glint_draw_span(const struct glint_paint *paint, const struct glint_span *span,
                                             const struct glint_maps *maps, const struct glint_surface *target,
                                             struct glint_box *highlight)
{
    return glint_draw_span_by(paint, span, maps, target, highlight,
                              maps && maps->coverage ? &glint_use_coverage : NULL);
}

/* Draws from a palette, with one load a pixel. Once a frame draw the normals of the palette, by any paint, as a rectangle of h = 1 into
 * pixels of 2 bytes: these are the colours. offsets: of each pixel 2 x the index of its normal; they are not checked.
 * GLINT_ERR_ARG: NULL, misaligned pixels or strides, a stride smaller than its line. */
enum glint_err glint_draw_palette(const uint16_t *colours, const uint16_t *offsets, ptrdiff_t stride, uint16_t w,
                                  uint16_t h, const struct glint_surface *target);

/* ---- sRGB, integers only ------------------------------------------------------------------------------------- */

uint16_t glint_srgb_decode(uint8_t encoded); /* 65535 = 1.0; nearest */
/* 65535 = 1.0, both; monotone, within 3 units (.01 of a level of 255) of the true encoding. */
uint16_t glint_srgb_encode(uint16_t linear);

#ifdef __cplusplus
}
#endif

#endif
