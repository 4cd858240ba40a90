/* SPDX-License-Identifier: MIT
 * The exact rectangle and span beside the reference pixel: the same bytes for every shader, map, normal and stride, likely or
 * hostile. GLINT_PIXELS: how many million pixels, 1000 where not set: two minutes on two cores. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "cases.h"
#include "glint_math_srgb.h"
#include "glint_pixel_prepared.h"
#include "reference_pixel.h"

enum { W = 61, H = 8, LINE = 4 * W + 13, SIZE = (H + 2) * LINE, GUARD = 0xa5 };

struct scene {
    struct glint_vec normals[W * H];
    uint8_t albedo[3 * W * H], gloss[W * H], mask[W * H], out[SIZE], expected[SIZE];
};

static bool same(const struct scene *s, const struct glint_box *a, const struct glint_box *b)
{
    return !memcmp(s->out, s->expected, SIZE) && !memcmp(a, b, sizeof *a);
}

/* Returns how many pixels; 0 where one differs. */
static unsigned rect_case(uint64_t *seed, void *memory)
{
    struct scene *s = memory;
    const struct glint_shader sh = case_shader(seed);
    const int spread = 1 + (int)BELOW(UINT32_C(1) << BELOW(16));
    const uint16_t w = (uint16_t)BELOW(W + 1), h = (uint16_t)BELOW(H + 1);
    const int step = (int)BELOW(W + 1); /* of a line's normals; those of two lines may be shared */
    struct glint_source source = {s->normals, (ptrdiff_t)sizeof *s->normals * step, NULL, 3 * W, NULL, W, NULL, W};
    source.albedo = ONE_IN(2) ? s->albedo : NULL;
    source.gloss = ONE_IN(3) ? s->gloss : NULL;
    source.mask = ONE_IN(3) ? s->mask : NULL;
    /* What the rectangle reads, and no more. */
    for (int i = 0; h && i < step * (h - 1) + w; i++)
        s->normals[i] = case_normal(seed, &sh.light, spread);
    for (int y = 0; y < h; y++)
        for (int i = W * y; i < W * y + w; i++) {
            s->gloss[i] = (uint8_t)(!source.gloss || ONE_IN(2) ? 255 : BELOW(256));
            s->mask[i] = !source.mask || BELOW(5) != 0;
            for (int k = 0; k < 3 && source.albedo; k++)
                s->albedo[3 * i + k] = (uint8_t)BELOW(256);
        }
    const bool up = ONE_IN(4);
    const ptrdiff_t start = (up ? H : 1) * LINE + (ptrdiff_t)BELOW(3), stride = up ? -LINE : LINE - (ptrdiff_t)BELOW(3);
    memset(s->out, GUARD, SIZE);
    memset(s->expected, GUARD, SIZE);
    struct glint_surface surface = {s->out + start, stride, (uint16_t)BELOW(65536), (uint16_t)BELOW(65536)};
    struct glint_box box = {0, 0, 0, 0}, expected = {0, 0, 0, 0};
    const bool boxed = ONE_IN(2);
    if (glint_shade_rect(&sh, &source, w, h, &surface, boxed ? &box : NULL))
        return 0;
    surface.pixels = s->expected + start;
    reference_rect(&sh, &source, w, h, &surface, boxed ? &expected : NULL);
    return same(s, &box, &expected) ? (unsigned)w * h + 1 : 0;
}

/* nl_q30 at which a channel's level without highlight changes. */
static int32_t boundary(uint64_t *seed, const struct glint_shader *s)
{
    const unsigned k = BELOW(3),
                   max = s->format == GLINT_RGB565 || s->format == GLINT_RGB565_SWAPPED ? (k == 1 ? 63 : 31) : 255;
    const double a = s->material.albedo[k] / 255.0, d = s->material.diffuse_q16[k] / 65536.0;
    const double threshold = s->dither ? (2 * BELOW(16) + 1) / 32.0 : 0.5,
                 ambient = s->material.ambient_q16[k] / 65536.0;
    const double nl = ((1 + BELOW(max) - threshold) / max / (a > 0 ? a : 1) - ambient) / (d > 0 ? d : 1);
    return nl > 0 && nl < 1.9 ? (int32_t)(nl * 1073741824.0) : 0;
}

static unsigned span_case(uint64_t *seed, void *memory)
{
    struct scene *s = memory;
    struct glint_shader sh = case_shader(seed);
    struct glint_span span = {BELOW(UINT32_MAX),       BELOW(1 << 20),
                              BELOW(1 << 16),          (int32_t)BELOW(UINT32_C(1) << 31),
                              (int32_t)BELOW(1 << 26), W};
    const uint32_t t_end = sh.lobe.t_max_q30;
    switch (BELOW(4)) {
    case 0: /* slowly over a level's boundary */
        span.nl_q30 = boundary(seed, &sh) - (W / 2 << 14) * (int32_t)BELOW(2);
        span.dnl_q30 = (int32_t)BELOW(1 << 15);
        break;
    case 1: /* about the cutoff */
        span.t_q30 = t_end - BELOW(W);
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
        span.t_q30 = BELOW(t_end + 1);
    }
    memset(s->out, GUARD, SIZE);
    memset(s->expected, GUARD, SIZE);
    struct glint_surface surface = {s->out + BELOW(3), 0, (uint16_t)BELOW(65536), (uint16_t)BELOW(65536)};
    struct glint_box box, expected;
    const ptrdiff_t start = (uint8_t *)surface.pixels - s->out;
    if (glint_shade_span(&sh, &span, &surface, &box))
        return 0;
    surface.pixels = s->expected + start;
    reference_span(&sh, &span, &surface, &expected);
    return same(s, &box, &expected) ? W : 0;
}

static void rectangles_have_the_reference_pixels(void **state)
{
    (void)state;
    assert_true(cases_pass(rect_case, sizeof(struct scene), 500));
}

static void spans_have_the_reference_pixels_at_boundaries_cutoffs_and_ends(void **state)
{
    (void)state;
    assert_true(cases_pass(span_case, sizeof(struct scene), 500));
}

/* For t of any size, 4 million a model. */
static void quick_models_are_below_the_exact_ones_by_at_most_their_slack(void **state)
{
    (void)state;
    for (int model = 0; model < GLINT_MODEL_COUNT; model++) {
        uint64_t random = (uint64_t)model + 1, *seed = &random;
        for (int i = 0; i < 4000000 / (int)GLINT_RUN / 100; i++) {
            struct glint_shader s = case_shader(seed);
            struct glint_prepared p;
            glint_lobe_init(&s.lobe, (enum glint_model)model, 1 + BELOW(ONE_IN(2) ? 1000 : 8), BELOW(17));
            s.clamp_peak = false;
            assert_int_equal(glint_shade_prepare(&p, &s), GLINT_OK);
            for (int run = 0; run < 100; run++) {
                struct glint_sample samples[GLINT_RUN];
                for (unsigned k = 0; k < GLINT_RUN; k++)
                    samples[k].t_q30 = BELOW(p.near.t_end) >> BELOW(ONE_IN(2) ? 20 : 1);
                p.model->run(&p.near, samples, GLINT_RUN);
                for (unsigned k = 0; k < GLINT_RUN; k++)
                    assert_in_range(p.model->exact(p.near.n, samples[k].t_q30), samples[k].f_q16,
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(encoding_rises_by_no_more_than_its_octaves_first_chord_says),
        cmocka_unit_test(quick_models_are_below_the_exact_ones_by_at_most_their_slack),
        cmocka_unit_test(rectangles_have_the_reference_pixels),
        cmocka_unit_test(spans_have_the_reference_pixels_at_boundaries_cutoffs_and_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
