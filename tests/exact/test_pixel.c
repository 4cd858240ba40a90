/* SPDX-License-Identifier: MIT
 * The exact paint under one directional light, or none, beside the reference pixel: the same bytes for every material, output, colour, map, source
 * and stride, likely or hostile. GLINT_PIXELS: how many million pixels, 100 where not set: a quarter of a minute on two cores. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "cases.h"
#include "glint_lobe.h"
#include "glint_math.h"
#include "glint_pixel.h"

/* Normals of a line, as vectors or words; some runs of words without surface say how long they are. */
static void line_of_normals(uint64_t *seed, struct case_scene *s, unsigned from, unsigned w, bool is_8,
                            struct glint_vec h, int spread)
{
    for (unsigned i = from, none = 0; i < from + w; i++) {
        const struct glint_vec n = case_normal(seed, h, spread);
        s->normals[i] = n;
        if (!is_8)
            continue;
        s->words[i] = ONE_IN(9) ? BELOW(UINT32_MAX) | 1 << 16 : glint_normals_pack(GLINT_NORMALS_INT8, &n);
        if (none == 0 && ONE_IN(20))
            none = 1 + BELOW(30);
        if (none) {
            s->words[i] = ONE_IN(2) ? none : BELOW(none);
            none--;
        }
    }
}

/* Returns how many pixels; 0 where one differs. */
static unsigned rect_case(uint64_t *seed, void *memory)
{
    struct case_scene *s = memory;
    struct glint_vec lvh[3];
    struct reference look = case_look(seed, lvh);
    look.count = !ONE_IN(20);
    const int spread = 1 + (int)BELOW(UINT32_C(1) << BELOW(16));
    const uint16_t w = (uint16_t)BELOW(CASE_W + 1), h = (uint16_t)BELOW(CASE_H + 1);
    const bool is_8 = ONE_IN(4);
    const unsigned step = w + BELOW(CASE_W - w + 1u), size = is_8 ? 4 : 6; /* of a line's normals */
    struct glint_maps maps = case_maps(seed, s, w, h);
    maps.normals = is_8 ? (const void *)s->words : s->normals;
    maps.normals_format = is_8 ? GLINT_NORMALS_INT8 : GLINT_NORMALS_INT16;
    maps.normals_stride = (ptrdiff_t)(size * step);
    case_grain(seed, s, &look.material, true, &maps);
    for (unsigned y = 0; y < h; y++)
        line_of_normals(seed, s, step * y, w, is_8, lvh[2], spread);
    const struct glint_surface target = case_target(seed, s), wanted = case_expected(s, &target);
    struct glint_box box = {0, 0, 0, 0}, expected = {0, 0, 0, 0};
    const bool boxed = ONE_IN(2);
    struct glint_paint paint;
    if (case_paint(&paint, &look) || glint_draw_rect(&paint, &maps, w, h, &target, boxed ? &box : NULL))
        return 0;
    reference_rect(&look, &maps, w, h, &wanted, boxed ? &expected : NULL);
    return case_same(s, &box, &expected) ? (unsigned)w * h + 1 : 0;
}

/* nl_q30 at which a channel's level without highlight changes. */
static int32_t boundary(uint64_t *seed, const struct reference *s)
{
    const unsigned k = BELOW(3), max = s->output.format <= GLINT_RGB565_SWAPPED ? (k == 1 ? 63 : 31) : 255;
    const double a = s->material.albedo[k] / 255.0, d = s->material.diffuse_q16[k] / 65536.0;
    const double threshold = s->output.dither ? (2 * BELOW(16) + 1) / 32.0 : 0.5,
                 ambient = s->material.ambient_q16[k] / 65536.0;
    const double nl = ((1 + BELOW(max) - threshold) / max / (a > 0 ? a : 1) - ambient) / (d > 0 ? d : 1);
    return nl > 0 && nl < 1.9 ? (int32_t)(nl * 1073741824.0) : 0;
}

static unsigned span_case(uint64_t *seed, void *memory)
{
    struct case_scene *s = memory;
    struct glint_vec lvh[3];
    struct reference look = case_look(seed, lvh);
    look.count = !ONE_IN(20);
    struct glint_span span = {
        BELOW(UINT32_MAX),       BELOW(1 << 20), BELOW(1 << 16),  (int32_t)BELOW(UINT32_C(1) << 31),
        (int32_t)BELOW(1 << 26), CASE_W,         {{0, 0}, {0, 0}}};
    const uint32_t t_last = reference_t_last(&look);
    switch (BELOW(4)) {
    case 0: /* slowly over a level's boundary */
        span.nl_q30 = boundary(seed, &look) - (CASE_W / 2 << 14) * (int32_t)BELOW(2);
        span.dnl_q30 = (int32_t)BELOW(1 << 15);
        break;
    case 1: /* about the cutoff */
        span.t_q30 = t_last - BELOW(CASE_W);
        span.dt_q30 = 1;
        span.ddt_q30 = 0;
        break;
    case 2: /* from the peak, where t may be a little below 0 */
        span.t_q30 = 0 - BELOW(1000);
        span.dt_q30 = BELOW(UINT32_C(1) << BELOW(26));
        span.ddt_q30 = BELOW(UINT32_C(1) << BELOW(20));
        break;
    default: /* N.L about 0 and 1 */
        span.nl_q30 = (int32_t)(ONE_IN(2) ? 0u : UINT32_C(1) << 30) - (int32_t)BELOW(1 << 16);
        span.dnl_q30 = (int32_t)BELOW(1 << 12);
        span.t_q30 = BELOW(t_last + 1);
    }
    span.w = (uint16_t)(ONE_IN(4) ? BELOW(CASE_W + 1) : CASE_W);
    struct glint_maps maps = case_maps(seed, s, span.w, 1), *const some = ONE_IN(2) ? &maps : NULL;
    for (int i = 0; i < 4; i++)
        span.ends[i / 2][i % 2] = (int16_t)(BELOW(65536) - 32768);
    case_grain(seed, s, &look.material, false, &maps);
    struct glint_surface target = case_target(seed, s);
    target.stride = 0; /* it is not looked at */
    const struct glint_surface wanted = case_expected(s, &target);
    struct glint_box box, expected;
    struct glint_paint paint;
    if (case_paint(&paint, &look) || glint_draw_span(&paint, &span, some, &target, &box))
        return 0;
    reference_span(&look, &span, some, &wanted, &expected);
    return case_same(s, &box, &expected) ? CASE_W : 0;
}

static void rectangles_have_the_reference_pixels(void **state)
{
    (void)state;
    assert_true(cases_pass(rect_case, sizeof(struct case_scene), 500));
}

static void spans_have_the_reference_pixels_at_boundaries_cutoffs_and_ends(void **state)
{
    (void)state;
    assert_true(cases_pass(span_case, sizeof(struct case_scene), 500));
}

/* For t of any size, 4 million a model. */
static void quick_models_are_below_the_exact_ones_by_at_most_their_slack(void **state)
{
    (void)state;
    for (int model = 0; model < GLINT_MODEL_COUNT; model++) {
        uint64_t random = (uint64_t)model + 1, *seed = &random;
        for (int i = 0; i < 4000000 / (int)GLINT_RUN / 100; i++) {
            struct glint_vec lvh[3];
            struct reference look = case_look(seed, lvh);
            struct glint_paint p;
            look.material.model = (uint8_t)model;
            look.material.n = (uint16_t)(1 + BELOW(ONE_IN(2) ? 1000 : 8));
            look.material.n_across = 0;
            look.material.q = (uint8_t)BELOW(17);
            look.material.clamp_peak = false;
            assert_int_equal(case_paint(&p, &look), GLINT_OK);
            for (int run = 0; run < 100; run++) {
                struct glint_sample samples[GLINT_RUN];
                for (unsigned k = 0; k < GLINT_RUN; k++)
                    samples[k].t_q30 = BELOW(p.of.exact.t_end) >> BELOW(ONE_IN(2) ? 20 : 1);
                p.model->run(&p, samples, GLINT_RUN);
                for (unsigned k = 0; k < GLINT_RUN; k++)
                    assert_in_range(p.model->exact(p.of.exact.n, samples[k].t_q30), samples[k].f_q16,
                                    samples[k].f_q16 + p.model->slack);
            }
        }
    }
}

/* For every argument, and as many steps as W may be. */
static void encoding_rises_by_no_more_than_its_octaves_first_chord_says(void **state)
{
    (void)state;
    for (uint32_t x = 0; x < 65536; x++) {
        struct glint_chords chords;
        glint_srgb_chords(&chords, x);
        const uint32_t steep = ((uint32_t)(chords.entry[1] - chords.entry[0]) >> chords.bits) + 1;
        for (uint32_t steps = 1; steps <= 9; steps++) {
            const uint32_t most = x + steps < 65535 ? x + steps : 65535;
            assert_in_range(glint_srgb_encode((uint16_t)most) - glint_srgb_encode((uint16_t)x), 0, steps * steep + 1);
        }
    }
}

/* For every coverage, shift and largest level of a format: any V, W and level below. */
static void a_blend_by_32_bits_is_low_by_no_more_than_its_bound_and_never_high(void **state)
{
    (void)state;
    static const uint32_t largest[] = {1, 3, 15, 31, 63, 255};
    uint64_t any = 1;
    unsigned wrong = 0;
    for (unsigned kind = 0; kind < 6; kind++)
        for (unsigned shift = 18; shift <= 28; shift++) {
            const uint64_t max = largest[kind], most = max << shift;
            const bool deep = max != 31 && max != 63;
            if ((max + 1) << shift > UINT64_C(0xfff00000))
                continue;
            for (uint64_t m = 0; m < 256; m++)
                for (unsigned i = 0; i < 2000; i++) {
                    any = any * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
                    const uint64_t v = i < 4 ? most - i % 2 : (any >> 32) % (most + 1), w = any >> 20 & 4095;
                    const uint64_t q = i % 3 ? (any >> 8) % (max + 1) : max;
                    const uint64_t y =
                        glint_covered_blend((uint32_t)v, (uint32_t)m, (uint32_t)((255 - m) * q) << (shift - 8), deep);
                    const uint64_t sum = m * v + ((255 - m) * q << shift);
                    wrong += 255 * y > sum || sum + m * w > 255 * (y + glint_covered_w((uint32_t)w, shift, deep));
                }
        }
    assert_int_equal(wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_blend_by_32_bits_is_low_by_no_more_than_its_bound_and_never_high),
        cmocka_unit_test(encoding_rises_by_no_more_than_its_octaves_first_chord_says),
        cmocka_unit_test(quick_models_are_below_the_exact_ones_by_at_most_their_slack),
        cmocka_unit_test(rectangles_have_the_reference_pixels),
        cmocka_unit_test(spans_have_the_reference_pixels_at_boundaries_cutoffs_and_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
