/* SPDX-License-Identifier: MIT
 * How good the quick forms are, counted: the values of models, what the encoding of linear space may rise by, cones of spots, a paint's
 * steps. Where they were worse, no pixel would be another, but more of them would be left to slow forms. */
#include "grained.h"
#include "lamps.h"
#include "mesh_colours.h"

#include "glint_grain.h"
#include "glint_lights.h"
#include "glint_lobe.h"
#include "glint_math.h"
#include "glint_pixel.h"

/* In 1/1000, how often the loop of the model has not the value but 1 less, at t before the end of the highlight. */
static uint32_t low_of(enum glint_model model)
{
    enum { COUNT = 200 };
    unsigned low = 0, all = 0;
    for (uint16_t n = 1; n <= 1000; n = (uint16_t)(n + n / 8 + 1)) {
        struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
        struct glint_sample samples[COUNT];
        struct glint_paint paint;
        set_model(&look, model, n, 16);
        look.material.clamp_peak = false;
        paint_of(&paint, &look);
        for (unsigned i = 0; i < COUNT; i++)
            samples[i] = (struct glint_sample){.t_q30 = below(paint.of.exact.t_end)};
        paint.model->run(&paint, samples, COUNT);
        for (unsigned i = 0; i < COUNT; i++) {
            const uint32_t f = glint_eval_t(model, n, samples[i].t_q30);
            assert_in_range(samples[i].f_q16, f - (f > 0 && paint.model->slack > 0), f);
            low += samples[i].f_q16 != f;
            all++;
        }
    }
    return 1000 * low / all;
}

/* The same of m, where there is grain. */
static uint32_t low_of_m(enum glint_model model)
{
    enum { COUNT = 20000, Q = 12 };
    static struct glint_sample samples[COUNT];
    static uint32_t m[COUNT], t[COUNT];
    const struct look look = metal(model, 60, 20);
    struct glint_paint paint;
    uint32_t low = 0, all = 0;
    paint_of(&paint, &look);
    paint.material.q = Q;
    const struct glint_use_grain *const grain = paint.model->grain;
    for (unsigned i = 0; i < COUNT; i++) {
        samples[i].f_q16 = m[i] = below(grain->m_end(Q)) >> below(8);
        samples[i].t_q30 = t[i] = below((m[i] < 1 << 22 ? m[i] : 1 << 22) + 1) << 8; /* t <= m */
    }
    grain->run(&paint, samples, COUNT);
    for (unsigned i = 0; i < COUNT; i++) {
        const uint32_t f = grain->exact(m[i], t[i]);
        if (!grain->reaches(m[i], t[i], Q))
            continue;
        assert_in_range(samples[i].f_q16, f - (paint.model->slack > 0), f);
        low += samples[i].f_q16 != f;
        all++;
    }
    return 1000 * low / all;
}

static void quick_values_of_models_are_mostly_the_values(void **state)
{
    (void)state;
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
        assert_in_range(low_of((enum glint_model)model), 0, 100);
    for (unsigned i = 0; i < GRAINED; i++)
        assert_in_range(low_of_m((enum glint_model)grained[i]), 0, 100);
}

/* What has no highlight is not asked for it. (At q = 1 F rises with c only from beyond there on.) */
static void grain_of_msh_ends_where_f_of_its_peak_falls_to_two_to_minus_q(void **state)
{
    (void)state;
    const struct glint_use_grain *const grain = glint_use_msh_grain.grain;
    for (unsigned q = 2; q <= 16; q++) {
        assert_false(grain->reaches(grain->m_end(q), 0, q));
        assert_true(grain->reaches(grain->m_end(q) - 2 - (1u << q / 2), 0, q)); /* what its root is rounded up by */
    }
}

/* Where (n + 4) t / 2, in which its quick form overflows, reaches 2^32. */
static void cayley_is_0_from_its_end_on(void **state)
{
    (void)state;
    for (uint32_t n = 4; n <= 1000; n++) {
        const uint32_t end = (uint32_t)(((UINT64_C(1) << 33) + n + 3) / (n + 4));
        for (uint32_t t = end; t <= UINT32_C(1) << 30; t += t == end ? 0x3fff - (end & 0x3fff) + 1 : t >> 1) {
            assert_int_equal(glint_cayley_t(n, t), 0);
            assert_int_equal(glint_cayley_t(n, t | (t < UINT32_C(1) << 30 ? 0x3fff : 0)), 0);
        }
    }
}

/* Its denominator at the end of the highlight has 28 bits, but where its factor is too large for that. */
static void msh_s_quick_form_loses_no_bit_that_it_has_room_for(void **state)
{
    (void)state;
    for (uint16_t n = 2; n <= 1000; n++)
        for (uint8_t q = 1; q <= 16; q++) {
            struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
            struct glint_paint paint;
            set_model(&look, GLINT_MSH, n, q);
            paint_of(&paint, &look);
            const int32_t *const k = paint.of.exact.k;
            const double m = k[GLINT_MSH_FACTOR] * (double)(paint.of.exact.t_end - 1) / 16384 + k[GLINT_MSH_ADDEND];
            assert_true(m < 1 << 28 && (m >= 1 << 27 || k[GLINT_MSH_FACTOR] >= 1 << 16));
        }
}

/* No chord is steeper than the first one of its octave, and what is rounded is not added to that. */
static void srgb_rises_by_no_more_than_the_first_chord_s_steps(void **state)
{
    (void)state;
    for (uint32_t x = 0; x < 65536; x++) {
        struct glint_chords chords;
        glint_srgb_chords(&chords, x);
        const uint32_t step = ((uint32_t)(chords.entry[1] - chords.entry[0]) >> chords.bits) + 1;
        for (uint32_t steps = 1; steps <= 64; steps++) {
            const uint32_t end = x + steps < 65535 ? x + steps : 65535;
            assert_true(glint_srgb_encode((uint16_t)end) <= glint_srgb_encode((uint16_t)x) + steps * step);
        }
    }
}

static unsigned slow;
static const struct glint_light_kind *counted_kind;

static uint32_t count_place(const struct glint_light *light, const struct glint_sight *sight, struct glint_view *view)
{
    slow++;
    return counted_kind->exact(light, sight, view);
}

/* A spot whose cone's edge is so narrow that what its cosine is off by is 2^-19 of it, over 100 by 100 pixels of that edge. */
static void cones_of_spots_are_mostly_decided_in_32_bits(void **state)
{
    (void)state;
    enum { SIDE = 100 };
    static struct glint_vec normals[SIDE];
    static uint8_t out[3 * SIDE];
    static const int32_t position[3] = {8 * SIDE, 8 * SIDE, 8000}, target[3] = {8 * SIDE, 8 * SIDE, 0};
    const struct look look = bare(GLINT_RGB888);
    struct glint_light spot;
    struct glint_paint paint;
    assert_int_equal(glint_light_spot(&spot, position, target, GLINT_LIGHT_FAR, cosine(1), cosine(8)), GLINT_OK);
    counted_kind = spot.kind;
    struct glint_light_kind counted = *spot.kind;
    counted.exact = count_place;
    spot.kind = &counted;
    assert_int_equal(glint_paint_exact(&paint, &look.material, &look.output), GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, &spot, 1, in_front), GLINT_OK);
    for (unsigned i = 0; i < SIDE; i++)
        normals[i] = (struct glint_vec){0, 0, 32767};
    slow = 0;
    for (uint16_t y = 0; y < SIDE; y++) {
        const struct glint_maps maps = {.normals = normals};
        const struct glint_surface surface = {.pixels = out, .stride = sizeof out, .y = y};
        assert_int_equal(glint_draw_rect(&paint, &maps, SIDE, 1, &surface, NULL), GLINT_OK);
    }
    assert_in_range(slow, 500, 1500);
}

/* Of MSH, whose quick form may be 1 low, at a coefficient that makes that as much as W has room for. */
static void what_32_bits_decide_of_linear_grey_is_what_64_bits_find(void **state)
{
    (void)state;
    unsigned decided = 0;
    for (int i = 0; i < 20000; i++) {
        struct look look = bare(GLINT_GREY8);
        struct glint_sample samples[GLINT_RUN], sums[GLINT_RUN];
        struct glint_paint paint;
        uint8_t found[GLINT_RUN], exact[GLINT_RUN];
        set_model(&look, GLINT_MSH, (uint16_t)(1 + below(200)), 12);
        look.output.space = GLINT_LINEAR;
        for (int k = 0; k < 3; k++) {
            look.material.ambient_q16[k] = below(2000);
            look.material.diffuse_q16[k] = below(4000);
            look.material.specular_q16[k] = 32768 + below(32768);
        }
        paint_of(&paint, &look);
        const struct glint_run run = {.line = found, .format = paint.format},
                               to = {.line = exact, .format = paint.format};
        for (unsigned p = 0; p < GLINT_RUN; p++) {
            samples[p] = (struct glint_sample){.t_q30 = below(paint.of.exact.t_end), .nl_q16 = below(65537)};
            const uint32_t f = glint_eval_t(GLINT_MSH, look.material.n, samples[p].t_q30);
            sums[p] = (struct glint_sample){samples[p].t_q30, samples[p].nl_q16,
                                            f < paint.of.exact.f_max ? f : paint.of.exact.f_max};
        }
        paint.model->run(&paint, samples, GLINT_RUN);
        const uint32_t open = paint.format->levels(&paint, &run, samples, GLINT_RUN);
        for (unsigned p = 0; p < GLINT_RUN; p++) {
            paint.format->exact(&paint, &to, p, &sums[p], 0);
            if (!(open >> p & 1))
                assert_int_equal(found[p], exact[p]);
            decided += !(open >> p & 1);
        }
    }
    assert_in_range(decided, 10000 * GLINT_RUN, 20000 * GLINT_RUN);
}

/* A line in the dark, of which every pixel is a step's. */
static void what_steps_decide_is_not_decided_again(void **state)
{
    (void)state;
    enum { COUNT = 8 };
    static uint16_t steps[GLINT_STEPS_BYTES / 2], out[COUNT];
    const struct glint_sample samples[COUNT] = {{.t_q30 = UINT32_MAX}};
    const struct glint_run run = {.line = (uint8_t *)out};
    const struct look look = bare(GLINT_RGB565);
    struct glint_paint paint;
    paint_of(&paint, &look);
    assert_int_equal(glint_paint_steps(&paint, steps, sizeof steps), GLINT_OK);
    assert_int_equal(paint.format->levels(&paint, &run, samples, COUNT), 0);
}

static const struct glint_use_format *plain_format;

static uint32_t levels_of_two(const struct glint_paint *paint, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count)
{
    assert_int_equal(count, 2); /* there is room for no more */
    return plain_format->levels(paint, run, samples, count);
}

static void a_step_is_found_by_the_two_pixels_at_its_ends(void **state)
{
    (void)state;
    static uint16_t steps[GLINT_STEPS_BYTES / 2];
    const struct look look = bare(GLINT_RGB565);
    struct glint_paint paint;
    paint_of(&paint, &look);
    plain_format = paint.format;
    struct glint_use_format asked = *paint.format;
    asked.levels = levels_of_two;
    paint.format = &asked;
    assert_int_equal(glint_paint_steps(&paint, steps, sizeof steps), GLINT_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cayley_is_0_from_its_end_on),
        cmocka_unit_test(grain_of_msh_ends_where_f_of_its_peak_falls_to_two_to_minus_q),
        cmocka_unit_test(quick_values_of_models_are_mostly_the_values),
        cmocka_unit_test(msh_s_quick_form_loses_no_bit_that_it_has_room_for),
        cmocka_unit_test(srgb_rises_by_no_more_than_the_first_chord_s_steps),
        cmocka_unit_test(cones_of_spots_are_mostly_decided_in_32_bits),
        cmocka_unit_test(what_32_bits_decide_of_linear_grey_is_what_64_bits_find),
        cmocka_unit_test(a_step_is_found_by_the_two_pixels_at_its_ends),
        cmocka_unit_test(what_steps_decide_is_not_decided_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
