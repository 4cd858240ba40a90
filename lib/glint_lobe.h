/* SPDX-License-Identifier: MIT
 * Internal. What lobes share: their arguments, clamped, and one from another; a cutoff that no formula gives; and a lobe from below,
 * quickly: what the exact pixel takes from each model. */
#ifndef GLINT_LOBE_H
#define GLINT_LOBE_H

/* ---- MSH from below, for its assembly, too, which includes these macros alone ---- */

/* Of a paint's of.exact.k. */
#define GLINT_MSH_FACTOR 0
#define GLINT_MSH_ADDEND 1
#define GLINT_MSH_SHIFT 2

/* The quotient is high by at most 2400, and by 26 for each unit that m is low: < 2^8, as E >= 2^18.3 is doubled 9 times
 * at most, and once before the cut. (n = 1: E >= 2^18 > E / 2: once after.) It is low by at most 2400 + 101 (u): together less than
 * 2^14, the smallest step of F, so F is this or 1 more. */
#define GLINT_MSH_HIGH (2400 + 26 * 256)

/* Of t and m, with x >= E, Q20, by less than 2: doubled up to 5 times, as E > 4 - 2^-20. Of q >= 12 it may be halved first, and low by 1. So
 * the quotient is high by less than this, low by less than 2400 + 101 + 26 * 64: together less than 2^14 again. */
#define GLINT_MSH_GRAIN_HIGH (2400 + 26)

#ifndef __ASSEMBLER__

#include "glint_port.h"
#include "glint_sample.h"

/* ---- arguments ---- */

static inline uint32_t glint_clamp_n(uint32_t n)
{
    return n < 1 ? 1 : n > GLINT_N_MAX ? GLINT_N_MAX : n;
}

static inline unsigned glint_clamp_q(unsigned q)
{
    return q > GLINT_Q_MAX ? GLINT_Q_MAX : q;
}

/* t of a cosine, exactly: Q16 has fewer bits. For c > 1 it is 0, for c < 0 more than 1. */
static inline uint32_t glint_t_of_c(int32_t c_q16)
{
    return c_q16 < 0 ? UINT32_MAX : c_q16 > GLINT_C_ONE ? 0 : (uint32_t)(GLINT_C_ONE - c_q16) << 14;
}

/* The smallest c whose t = 1 - c is no larger: F falls as t grows. */
static inline uint32_t glint_c_of_cutoff_t(uint32_t t_q30)
{
    return (uint32_t)GLINT_C_ONE - (t_q30 >> 14);
}

/* The largest t in 0..2^30 for which reaches() holds; it holds at 0 and stops holding once. n and q are clamped first. */
uint32_t glint_largest_t(bool (*reaches)(uint32_t n, uint32_t t_q30, unsigned q), uint32_t n, unsigned q);

/* ---- from below ----
 * A line is shaded in three stages over runs of samples: the geometry gives t and N.L, the model's loop F, the format's loop
 * levels. So a model is one loop, called once a run, and knows no format. Its F may be low by a few units, by a bound that is
 * stated: a level that this leaves open is drawn from the exact F. */

struct glint_use_model {
    uint8_t model;                           /* enum glint_model */
    uint8_t slack;                           /* f <= F <= f + slack for every t */
    glint_geometry *geometry;                /* NULL: glint_samples_half */
    void (*fold)(struct glint_paint *paint); /* of.exact.k from t_end, f_max and n; NULL: there is none */
    void (*run)(const struct glint_paint *paint, struct glint_sample *samples, unsigned count);
    uint32_t (*exact)(uint32_t n, uint32_t t_q30);
    uint32_t (*cutoff_t)(uint32_t n, unsigned q);
    const struct glint_use_grain *grain; /* NULL: n_across, maps of grain and of shininess are errors */
    const struct glint_use_line *line;   /* its lines by the DSP extension, fused; NULL: there are none */
};

#if GLINT_DSP
extern const struct glint_use_line glint_line_msh, glint_line_schlick, glint_line_ggx, glint_line_cayley;
#define GLINT_LINE_OF(line) &line
#else
#define GLINT_LINE_OF(line) NULL
#endif

/* Blinn's, which Phong shares. */
void glint_blinn_run(const struct glint_paint *paint, struct glint_sample *samples, unsigned count);

/* Every model's loop: f(paint, t) is asked only where F > 0. With f known at compile time no call is left. (Where f shares a quick form
 * with the model's function, it is flattened: that would be a call.) */
static inline __attribute__((always_inline)) void
glint_near_run(const struct glint_paint *paint, struct glint_sample *sample, unsigned count,
               uint32_t (*f)(const struct glint_paint *paint, uint32_t t_q30))
{
    const struct glint_sample *end = sample + count;
    const uint32_t t_end = paint->of.exact.t_end;
    do
        sample->f_q16 = sample->t_q30 < t_end ? f(paint, sample->t_q30) : 0;
    while (++sample != end);
}

#endif

#endif
