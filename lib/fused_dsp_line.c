/* SPDX-License-Identifier: MIT
 * Lines by the DSP extension's loops (fused_dsp.c): runs over a mask, the first pixel that is lit, and pixels that W leaves open. */
#include "glint_fused.h"

#if GLINT_DSP

static inline uint32_t dsp_word(const uint8_t *m)
{
    uint32_t word;
    __builtin_memcpy(&word, __builtin_assume_aligned(m, 4), 4);
    return word;
}

static inline uint64_t dsp_two(const uint8_t *m)
{
    uint64_t words;
    __builtin_memcpy(&words, __builtin_assume_aligned(m, 4), 8);
    return words;
}

/* From m on, before end, the first pixel that is covered in full, or, is_full, that is not. Of those before it *all has all bits. */
static inline __attribute__((always_inline)) const uint8_t *dsp_find(const uint8_t *m, const uint8_t *end,
                                                                     uint32_t *all, bool is_full)
{
    const uint32_t whole = is_full ? UINT32_MAX : 0;
    for (;;) {
        if (!((uintptr_t)m & 3)) {
            for (; end - m >= 16; m += 16) {
                const uint64_t a = dsp_two(m), b = dsp_two(m + 8), both = is_full ? a & b : a | b;
                if ((is_full ? (uint32_t)both & (uint32_t)(both >> 32) : (uint32_t)both | (uint32_t)(both >> 32)) !=
                    whole)
                    break;
            }
            while (end - m >= 4 && dsp_word(m) == whole)
                m += 4;
        }
        do {
            if (m == end || (*m == 255) != is_full)
                return m;
            *all |= *m++;
        } while ((uintptr_t)m & 3);
    }
}

/* Until a pixel is lit, where it is asked which one is the first: W so large that what is lit is open. V is 1 then. */
static const uint32_t dsp_stops[7] = {0, 0, 0, 1, 1, 1, UINT32_MAX};

static inline void dsp_copy(uint32_t *to, const uint32_t *from)
{
    for (unsigned i = 0; i < 7; i++)
        to[i] = from[i];
}

/* A pixel that W leaves open, from its exact N.L and F, but for what the coefficients are off: less than DSP_NEAR. false: it is as open as before. */
enum { DSP_NEAR = 8 };
static inline __attribute__((always_inline)) uint32_t dsp_level(const struct glint_line_loop *loop,
                                                                const struct glint_sample *sample, unsigned k,
                                                                unsigned shift, uint32_t more, uint32_t *undecided)
{
    const uint32_t most = (UINT32_C(1) << (shift == 25 ? 5 : 30 - shift)) - 1;
    const uint64_t lit = (uint64_t)loop->q_q16[k] * sample->nl_q16 + (uint64_t)loop->r_q16[k] * sample->f_q16;
    const uint32_t v = loop->base[k] + (uint32_t)(lit >> 16) + more - DSP_NEAR, level = v >> shift;
    *undecided |= (v ^ (v + 2 * DSP_NEAR)) >> shift;
    return level < most ? level : most;
}

static bool dsp_decide(const struct glint_line_loop *loop, const struct glint_sample *sample, uint8_t *out)
{
    if (loop->albedo)
        return false;
    uint32_t undecided = loop->paint->of.exact.high; /* a coloured light's nl and F are rounded once more */
    if (loop->bytes == 3) {
        const uint32_t first = dsp_level(loop, sample, 0, 22, 0, &undecided),
                       second = dsp_level(loop, sample, 1, 22, 0, &undecided),
                       third = dsp_level(loop, sample, 2, 22, 0, &undecided);
        if (undecided)
            return false;
        out[0] = (uint8_t)first;
        out[1] = (uint8_t)second;
        out[2] = (uint8_t)third;
        return true;
    }
    const uint32_t more = loop->paint->output.dither ? loop->thresholds[(uintptr_t)out >> 1 & 3] : 0;
    const uint32_t pixel = dsp_level(loop, sample, 0, 25, more, &undecided) << 11 |
                           dsp_level(loop, sample, 1, 24, more >> 1, &undecided) << 5 |
                           dsp_level(loop, sample, 2, 25, more, &undecided);
    if (undecided)
        return false;
    const bool swapped = loop->format == GLINT_RGB565_SWAPPED;
    out[swapped] = (uint8_t)pixel;
    out[!swapped] = (uint8_t)(pixel >> 8);
    return true;
}

void glint_line_dither(struct glint_line_loop *loop, const struct glint_run *run, const uint16_t dark[4])
{
    uint32_t row = glint_bayer_row(run->left, run->y);
    for (unsigned x = 0; x < 4; x++, row >>= 4) {
        const unsigned at = (unsigned)((uintptr_t)loop->out >> 1) + x;
        loop->thresholds[at & 3] = (2 * (row & 15) + 1) << 20; /* of 2^25 */
        loop->dark_of[at & 3] = dark[x];
    }
}

uint32_t glint_line_dsp(struct glint_line_loop *loop, uint32_t x)
{
    const struct glint_paint *const paint = loop->paint;
    uint32_t shine[7] = {0}; /* once a line: else gcc warns where it cannot tell that stops stays */
    for (;;) {
        if (x >= loop->run_end) {
            if (x >= loop->w)
                return loop->w;
            loop->run_end = loop->w;
            if (loop->mask) {
                const uint8_t *const end = loop->mask + loop->w;
                uint32_t all = 0;
                const uint8_t *const first = dsp_find(loop->mask + x, end, &loop->covered, false);
                x = (uint32_t)(first - loop->mask);
                if (first == end)
                    return x;
                loop->run_end = (uint32_t)(dsp_find(first, end, &all, true) - loop->mask);
            }
        }
        const bool stops = loop->seeks && loop->first == (const uint8_t *)UINTPTR_MAX;
        if (stops) {
            dsp_copy(shine, loop->shine);
            dsp_copy(loop->shine, dsp_stops);
        }
        loop->albedo_at = loop->albedo + (loop->albedo ? 3 * x : 0);
        uint8_t *stopped =
            loop->run(loop->normals + x, loop->out + loop->bytes * x, loop->shine, loop->normals + loop->run_end);
        if (stops)
            dsp_copy(loop->shine, shine);
        const uint32_t at = (uint32_t)(stopped - loop->out);
        x = loop->bytes == 2 ? at / 2 : at / 3;
        if (stops && loop->last == stopped) {
            loop->first = stopped; /* it is to be drawn as yet */
        } else if (x < loop->run_end) {
            struct glint_sample *const sample = &loop->sample;
            glint_samples_half(&paint->l, &paint->v, &paint->h, loop->normals + x, sample, 1);
            sample->f_q16 = 0;
            if (sample->t_q30 < paint->of.exact.t_end) { /* the loop has not noted it where N.L is above 1.0 */
                loop->last = stopped;
                loop->first = loop->first < stopped ? loop->first : stopped;
                sample->f_q16 = paint->model->exact(paint->of.exact.n, sample->t_q30);
            }
            if (!dsp_decide(loop, sample, stopped))
                return x;
            x++;
        }
    }
}
#endif
