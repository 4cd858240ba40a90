/* SPDX-License-Identifier: MIT
 * Internal. Samples become pixels, exactly: steps 3 to 9 of sequence.md.
 *
 * Once material, albedo, light's colour and the format's largest level fold to P, Q and R a channel, scaled such that a level is the
 * upper bits of V = P + Q nl + R F in 32 bits. All are rounded down and F may be low, so V is low, by at most W, which is known
 * then. Where V and V + W have the same upper bits the level is decided; elsewhere, for one pixel in 200 of RGB565, the
 * 64-bit sequence draws it. */
#ifndef GLINT_PIXEL_H
#define GLINT_PIXEL_H

#include "glint_lobe.h"
#include "glint_offsets.h"

/* ---- Up to GLINT_RUN pixels side by side ---- */

struct glint_run {
    uint8_t *line;           /* the surface's line */
    uint32_t x;              /* in it, of the first sample */
    uint32_t left, y;        /* on the screen, of the line's first pixel */
    const uint8_t *albedo;   /* of the first sample, RGB888; NULL: the material's */
    const uint8_t *gloss;    /* of the first sample; NULL: 255 */
    const uint8_t *coverage; /* of the line's first pixel; NULL: 255 */
    uint8_t apart;           /* from a channel's samples to the next's; 0: they are the same */
    /* Draws the samples: the paint's, or what blends them in gamma space. Tables have none. */
    const struct glint_use_format *format;
    /* Of samples that blend by their coverage, else NULL. ARGB8888 has coverage as alpha, in full. */
    const struct glint_use_coverage *soft;
};

/* ---- A group of formats ---- */

struct glint_line_loop;
struct glint_lines;
struct glint_bounds;

/* Draws h lines of a rectangle, or of the span *at. */
typedef void glint_draw_lines(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at,
                              uint32_t h, struct glint_box *highlight);

/* Diffuse and specular, with the light's colour, <= 65536. */
struct glint_coefficients {
    uint32_t d[3], s[3];
};

/* Stores the samples' pixels; not those that stay open: their bits, the first sample's the lowest. */
typedef uint32_t glint_levels(const struct glint_paint *paint, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count);

struct glint_use_format {
    bool (*draws)(const struct glint_output *output);
    /* The format's own from the material's ambient and albedo and these coefficients, times 2^up: glint_paint_fold. */
    void (*fold)(struct glint_paint *paint, const struct glint_coefficients *c, unsigned up);
    glint_levels *levels; /* in full; in linear space, blended where the run is */
    /* Stores pixel i of the run by the 64-bit sequence, from three samples with exact nl and F, one a channel, apart after one another. */
    void (*exact)(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                  const struct glint_sample *sums, unsigned apart);
    /* Prepares lines in one loop, over an albedo map or not; false where the paint has none. NULL: there is none. */
    bool (*begin)(struct glint_line_loop *loop, const struct glint_paint *paint, bool albedo);
};

/* ---- Coverage ----
 *
 * Whoever has a run with coverage that blends has it drawn by this format: levels and exact blend those of the paint's. */
typedef void glint_draw_edge(const struct glint_paint *paint, struct glint_lines *lines, struct glint_bounds *bounds,
                             unsigned count, uint32_t y);

struct glint_use_coverage {
    struct glint_use_format format; /* levels, exact */
    /* Step 8 for channel k of pixel i: what the formats in linear space do not do themselves. */
    uint8_t (*level)(const struct glint_paint *paint, const struct glint_run *run, unsigned i, unsigned k, uint64_t x);
    /* Of tables: draws raws, count <= GLINT_RUN; draws the run of a line of normals, all of it covered in part, by the kind's fused loop. */
    void (*blend_pixels)(const struct glint_run *run, const struct glint_paint *paint, const struct glint_raw *raws,
                         unsigned count);
    void (*line)(const struct glint_paint *paint, const struct glint_lines *lines);
    /* glint_lines_next where there is a coverage map: run.x, the run's count, and whether it is soft. */
    void (*next)(struct glint_lines *lines);
    /* Of a line of normals that a core's loop draws: draws what is covered in part from run.x on, and notes what of it shines. Returns where
     * it ends, or before. draw: draws count <= GLINT_RUN pixels of it; NULL: without grain. loop: NULL, or what may draw it, too. */
    uint32_t (*edge)(const struct glint_paint *paint, struct glint_lines *lines, struct glint_line_loop *loop,
                     glint_draw_edge *draw, struct glint_bounds *bounds, uint32_t y);
};

/* Sets what draws a run: soft where it blends, else NULL. In linear space the paint's format does either. */
static inline void glint_run_soften(struct glint_run *run, const struct glint_paint *paint,
                                    const struct glint_use_coverage *soft)
{
    run->soft = soft;
    run->format = soft && paint->output.space == GLINT_GAMMA && paint->output.format != GLINT_ARGB8888 ? &soft->format
                                                                                                       : paint->format;
}

/* Draws a run's levels, and one pixel by the 64-bit sequence. */
static inline uint32_t glint_run_levels(const struct glint_paint *paint, const struct glint_run *run,
                                        const struct glint_sample *samples, unsigned count)
{
    return GLINT_FLASH_POINTER(run->format->levels)(paint, run, samples, count);
}
static inline void glint_run_exact(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                                   const struct glint_sample *sums, unsigned apart)
{
    GLINT_FLASH_POINTER(run->format->exact)(paint, run, i, sums, apart);
}

/* ---- The sequence itself, in 64 bits ---- */

/* What GLINT_FORMATS says of a format. */
struct glint_format_traits {
    uint8_t bits, max[3];
};
extern const struct glint_format_traits glint_formats[GLINT_FORMAT_COUNT]; /* GLINT_FLASH */

/* Bytes of a line. */
static inline uint32_t glint_line_bytes(uint8_t format, uint32_t w)
{
    return (GLINT_FLASH_U8(glint_formats[format].bits) * w + 7) / 8;
}
/* The same where the loops ask for it, without a load. */
static inline bool glint_format_is_565(uint8_t format)
{
    return format == GLINT_RGB565 || format == GLINT_RGB565_SWAPPED;
}
static inline bool glint_format_is_grey(uint8_t format)
{
    const unsigned greys = 1u << GLINT_GREY8 | 1u << GLINT_MONO | 1u << GLINT_GREY4 | 1u << GLINT_GREY2;
    return greys >> format & 1;
}
static inline bool glint_format_is_blue_first(uint8_t format)
{
    return format >= GLINT_BGR888 && format <= GLINT_ARGB8888;
}

/* Step 6, of 256: Rec. 709. */
enum { GLINT_LUMA_RED = 54, GLINT_LUMA_GREEN = 183, GLINT_LUMA_BLUE = 19 };
static inline uint32_t glint_luma(unsigned k)
{
    return k == 0 ? GLINT_LUMA_RED : k == 1 ? GLINT_LUMA_GREEN : GLINT_LUMA_BLUE;
}

static inline uint32_t glint_coefficient(uint32_t q16)
{
    return q16 > 65536 ? 65536 : q16;
}

/* Step 5: albedo of step 4, 65535 = 1.0; nl < 2^23, shine = g F < 2^39: what several lights may sum to. */
uint64_t glint_exact_value(const struct glint_material *material, unsigned k, uint32_t albedo, uint32_t nl_q16,
                           uint64_t shine);
/* Step 8. weight / 32 is the threshold: 2b + 1, or 16. */
uint32_t glint_exact_level(uint64_t x, uint32_t max, uint32_t weight);
/* Steps 4 and 5 of a channel in gamma space, and with 8 of all three. */
uint64_t glint_exact_channel(const struct glint_paint *paint, const struct glint_run *run, unsigned i, unsigned k,
                             const struct glint_sample *sum);
void glint_exact_levels(uint8_t levels[4], const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                        const struct glint_sample *sums, unsigned apart);

/* Stores the levels of pixels x..: 4 bytes a pixel, in grey 1; not of those whose bits are set in open, the first pixel's the lowest. Not
 * alpha. */
void glint_store_run(uint8_t format, uint8_t *line, uint32_t x, const uint8_t *levels, unsigned count, uint32_t open);
/* Alpha or X of pixels x.. of a line, where the format has one; coverage: the line's, or NULL. */
void glint_store_alpha(uint8_t format, uint8_t *line, uint32_t x, unsigned count, const uint8_t *coverage);

/* The Bayer matrix's rows, 4 bits an entry, the first one the lowest. */
extern const uint16_t glint_bayer_rows[4];
/* The ordered dither's weights b, 0..15, of four or more places on the screen from x to the right, 4 bits each, the first the lowest. */
static inline uint32_t glint_bayer_row(uint32_t x, uint32_t y)
{
    const uint32_t row = GLINT_FLASH_U16(glint_bayer_rows[y & 3]);
    return (row | row << 16) >> 4 * (x & 3);
}
/* Step 8's weight of a pixel of a run: 2b + 1, or 16. */
static inline uint32_t glint_weight(const struct glint_paint *paint, const struct glint_run *run, unsigned i)
{
    return paint->output.dither ? 2 * (glint_bayer_row(run->left + run->x + i, run->y) & 15) + 1 : 16;
}

/* ---- Paints ---- */

/* Is it an exact one, and lit? */
static inline bool glint_paint_is_exact(const struct glint_paint *paint)
{
    return paint->format != NULL;
}

/* The model's own and the format's own from the material, from the colour of the one light, and from slack, nl_down and f_down, which are set: of
 * several lights by lights_light. rounds: of one light nl and F are rounded before its colour scales them. */
void glint_paint_fold(struct glint_paint *paint, bool rounds);

/* F of a t by its definition; held to the peak, and 0 from t_end on. */
static inline uint32_t glint_paint_f(const struct glint_paint *paint, uint32_t t_q30)
{
    const uint32_t f =
        t_q30 < paint->of.exact.t_end ? GLINT_FLASH_POINTER(paint->model->exact)(paint->of.exact.n, t_q30) : 0;
    return f < paint->of.exact.f_max ? f : paint->of.exact.f_max;
}

/* Steps 3 to 9 for samples whose t and nl are there, count 1..GLINT_RUN, under one light. */
void glint_paint_run(const struct glint_paint *paint, const struct glint_run *run, struct glint_sample *samples,
                     unsigned count);
/* The same for sample i of the run, whose t and nl are those of *sample, by the 64-bit sequence. */
void glint_paint_exactly(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                         const struct glint_sample *sample);
/* The same from exact nl and F. */
void glint_paint_sums(const struct glint_paint *paint, const struct glint_run *run, unsigned i, uint32_t nl,
                      uint32_t f);

/* The brightest channel of the one light. */
static inline uint32_t glint_paint_peak(const struct glint_paint *paint)
{
    const uint32_t *c = paint->color_q16;
    const uint32_t most = c[0] > c[1] ? c[0] : c[1];
    return most > c[2] ? most : c[2];
}

/* n_across where a material has grain, <= GLINT_N_MAX, else 0. */
static inline __attribute__((always_inline)) uint32_t glint_material_across(const struct glint_material *material)
{
    const uint32_t across = material->n_across, least = across < material->n ? across : material->n;
    return across == material->n || least >= GLINT_N_MAX ? 0 : across < GLINT_N_MAX ? across : GLINT_N_MAX;
}

/* Checks a material and an output. grain: may the material have it? */
enum glint_err glint_paint_check(const struct glint_material *material, const struct glint_output *output, bool grain);
/* What paints have that are not lit yet. */
void glint_paint_unlit(struct glint_paint *paint, const struct glint_output *output);

/* Gamma space: one description of the formats' fold and of their loop.
 *
 * Channel k's part of a level is V 2^-shift; without maps V = P + Q nl + R F, with them
 * V = (albedo (ambient + diffuse nl) >> 7) + R (F gloss / 255), held to MOST. In RGB a part is a level, and in grey their sum is. */

/* P, Q, R and W: glint_use_format's fold. In RGB P has the threshold of an undithered level, as the loop without maps adds none. */
void glint_levels_fold(struct glint_paint *paint, const struct glint_coefficients *c, unsigned up);

/* The thresholds of four pixels side by side, times 2^shift, 2^(shift - 5) or more, less what V may be high by, < 2^(shift - 7). */
void glint_levels_bias(uint32_t bias[4], const struct glint_paint *paint, const struct glint_run *run);

/* P of the channels of four pixels side by side, each with its pixel's threshold. */
void glint_levels_base(uint32_t base[12], const struct glint_paint *paint, const struct glint_run *run);

/* Levels of every format in gamma space where each channel has samples of its own, run->apart after those of the channel before. */
glint_levels glint_levels_apart;

#define GLINT_INLINE static inline __attribute__((always_inline))

/* x / 255 for x <= 33/16 2^16 255, as lights sum to: low by < 1 + 2^-6, never high (tests/proof). 1 / 255 = 2^-8 + 2^-16 + 2^-24 + .. */
GLINT_INLINE uint32_t glint_by_255(uint32_t x)
{
    return (x + (x >> 8) + (x >> 16)) >> 8;
}

/* V of a sample's channels, without maps from `base`. What the compiler is told of maps decides what is left of it. */
GLINT_INLINE void glint_levels_sum(uint32_t v[3], const struct glint_paint *paint, const uint32_t base[3],
                                   const struct glint_sample *sample, const uint8_t *albedo, const uint8_t *gloss,
                                   bool maps)
{
    const uint32_t nl = sample->nl_q16;
    uint32_t f = sample->f_q16;
    if (maps) {
        if (gloss)
            f = glint_by_255(f * *gloss);
        v[0] = (albedo[0] * ((paint->of.exact.ambient[0] + paint->of.exact.diffuse[0] * nl) >> 7)) +
               paint->of.exact.r[0] * f;
        v[1] = (albedo[1] * ((paint->of.exact.ambient[1] + paint->of.exact.diffuse[1] * nl) >> 7)) +
               paint->of.exact.r[1] * f;
        v[2] = (albedo[2] * ((paint->of.exact.ambient[2] + paint->of.exact.diffuse[2] * nl) >> 7)) +
               paint->of.exact.r[2] * f;
    } else {
        v[0] = base[0] + paint->of.exact.q[0] * nl + paint->of.exact.r[0] * f;
        v[1] = base[1] + paint->of.exact.q[1] * nl + paint->of.exact.r[1] * f;
        v[2] = base[2] + paint->of.exact.q[2] * nl + paint->of.exact.r[2] * f;
    }
}

/* V held to the largest level: W < 2^shift then changes no bit of it. */
GLINT_INLINE uint32_t glint_levels_hold(uint32_t v, uint32_t most)
{
    if (__builtin_expect(v > most, 0))
        v = most;
    return v;
}

/* The same after the shift, where that is one instruction. */
#if GLINT_THUMB2
#define GLINT_LEVELS_HOLD(v, most) (v)
#define GLINT_LEVELS_CUT(level, bits)                                                                                  \
    __extension__({                                                                                                    \
        uint32_t cut;                                                                                                  \
        __asm__("usat %0, #" #bits ", %1" : "=r"(cut) : "r"(level) : "cc");                                            \
        cut;                                                                                                           \
    })
#else
#define GLINT_LEVELS_HOLD(v, most) glint_levels_hold(v, most)
#define GLINT_LEVELS_CUT(level, bits) (level)
#endif

/* A blend by 32 bits, in gamma space. With a = m / 255 a blended level is the upper bits of a V + (1 - a) q 2^shift + threshold, where V, held to its largest, has no threshold.
 * X = (V >> 8) m + (255 - m) q 2^(shift - 8) is 255 / 256 of their sum, and X + (X >> 8) + (X >> 16) all of it but for its 2^-24. X is low by W m / 2^8,
 * and by less than 255; so the sum is low by less than W + 256 of these, 2 of its shifts, and 2^-24 of the largest level. Where V was high by what
 * thresholds lack for it (paint->of.exact.high), it is high by less than that. */
GLINT_INLINE uint32_t glint_covered_w(uint32_t w, unsigned shift, bool deep)
{
    return w + 256 + 3 + (deep ? 256 : (uint32_t)63 << (shift - 16));
}

/* under: (255 - m) q 2^(shift - 8). Without the last term, 2^-16 of the level is missing: for RGB565, as that costs less than what stays open for it. */
GLINT_INLINE uint32_t glint_covered_blend(uint32_t v, uint32_t m, uint32_t under, bool deep)
{
    const uint32_t x = (v >> 8) * m + under;
    return x + (x >> 8) + (deep ? x >> 16 : 0);
}

/* Alpha of samples i.., where the format has one. */
GLINT_INLINE void glint_levels_alpha(uint8_t format, const struct glint_run *run, unsigned i, unsigned count)
{
    if (format >= GLINT_XRGB8888)
        glint_store_alpha(format, run->line, run->x + i, count, run->coverage);
}

enum glint_levels_kind { GLINT_LEVELS_565, GLINT_LEVELS_888 };

/* The loop of RGB. */
GLINT_INLINE uint32_t glint_levels_rgb(const struct glint_paint *paint, const struct glint_run *run,
                                       const struct glint_sample *sample, unsigned count, enum glint_levels_kind kind,
                                       bool maps, bool dither)
{
    const bool deep = kind == GLINT_LEVELS_888;
    const unsigned shift = (unsigned)paint->of.exact.shift;
    const uint32_t w = maps ? paint->of.exact.w_maps : paint->of.exact.w;
    const uint32_t most = (uint32_t)(deep ? 255 : 31) << shift, most_green = (uint32_t)(deep ? 255 : 63) << shift;
    (void)most, (void)most_green; /* where V is held after the shift */
    const uint8_t *albedo = maps && run->albedo ? run->albedo : paint->material.albedo, *gloss = run->gloss;
    const unsigned step = maps && run->albedo ? 3 : 0;
    const bool swapped = paint->output.format == GLINT_RGB565_SWAPPED;
    const unsigned red_at = glint_format_is_blue_first(paint->output.format) ? 2 : 0, blue_at = 2 - red_at;
    const unsigned bytes = !deep ? 2 : red_at && paint->output.format != GLINT_BGR888 ? 4 : 3;
    uint8_t *out = run->line + bytes * run->x + (swapped ? 1 : 0);
    const ptrdiff_t other = swapped ? -1 : 1;
    uint32_t bias[4], bases[12], open = 0;
    const uint32_t *base = paint->of.exact.p;
    const bool turns = !maps && dither && paint->output.dither; /* from a pixel's base to the next's */
    if (maps) {
        glint_levels_bias(bias, paint, run);
    } else if (turns) {
        glint_levels_base(bases, paint, run);
        base = bases;
    }
    const struct glint_sample *const first = sample, *const end = sample + count;
    for (unsigned next = 0; sample != end; sample++, out += bytes) {
        const unsigned i = maps ? next++ : 0; /* else it is found where a pixel stays open */
        uint32_t v[3];
        glint_levels_sum(v, paint, base, sample, albedo, gloss ? gloss + i : gloss, maps);
        const uint32_t threshold = maps ? bias[i & 3] : 0;
        /* Where V is held after the shift, what is beyond the largest level may be left open, too. */
        const uint32_t red = GLINT_LEVELS_HOLD(v[0] + threshold, most);
        const uint32_t green = GLINT_LEVELS_HOLD(v[1] + threshold, most_green);
        const uint32_t blue = GLINT_LEVELS_HOLD(v[2] + threshold, most);
        albedo += maps ? step : 0;
        if (((red ^ (red + w)) | (green ^ (green + w)) | (blue ^ (blue + w))) >> shift) {
            open |= (uint32_t)1 << (sample - first);
        } else if (deep) {
            out[red_at] = (uint8_t)GLINT_LEVELS_CUT(red >> shift, 8);
            out[1] = (uint8_t)GLINT_LEVELS_CUT(green >> shift, 8);
            out[blue_at] = (uint8_t)GLINT_LEVELS_CUT(blue >> shift, 8);
        } else {
            const uint32_t pixel = GLINT_LEVELS_CUT(red >> shift, 5) << 11 | GLINT_LEVELS_CUT(green >> shift, 6) << 5 |
                                   GLINT_LEVELS_CUT(blue >> shift, 5);
            out[0] = (uint8_t)pixel;
            out[other] = (uint8_t)(pixel >> 8);
        }
        if (turns) {
            base += 3;
            if (base == bases + 12)
                base = bases;
        }
    }
    return open;
}

/* ---- A paint's steps: glint_paint_steps ----
 *
 * Formats of their own draw by them. One folds, which is where another colour or several lights come, to the format without. Levels of
 * a run without maps, where there is no highlight and the table has a pixel, are this one; plain: the others. */
GLINT_INLINE uint32_t glint_levels_steps(glint_levels *plain, const struct glint_paint *paint,
                                         const struct glint_run *run, const struct glint_sample *samples,
                                         unsigned count)
{
    const uint16_t *const steps = paint->of.exact.steps;
    uint32_t open = 0;
    for (unsigned i = 0, first = 0;; first = ++i) {
        uint32_t pixel = 0;
        while (i < count && (samples[i].f_q16 || !(pixel = steps[samples[i].nl_q16 >> GLINT_STEPS_LOG])))
            i++;
        if (i != first) {
            struct glint_run part = *run;
            part.x += first;
            open |= plain(paint, &part, samples + first, i - first) << first;
        }
        if (i == count)
            return open;
        uint8_t *const out = run->line + 2 * (run->x + i);
        out[0] = (uint8_t)pixel;
        out[1] = (uint8_t)(pixel >> 8);
    }
}

#endif
