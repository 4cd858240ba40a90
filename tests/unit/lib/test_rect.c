/* SPDX-License-Identifier: MIT
 * The exact rectangle and span: the value of every pixel. */
#include "shading.h"

/* What a test says of a pixel: the levels found, those wanted, and the real values. */
typedef void check_pixel(const unsigned found[3], const unsigned wanted[3], const double real[3]);

/* Shades a scene, without its mask, and shows each pixel to `check`. */
static void for_every_pixel_of(struct scene *s, check_pixel *check)
{
    s->source.mask = NULL;
    assert_int_equal(glint_shade_rect(&s->shader, &s->source, W, H, &s->surface, NULL), GLINT_OK);
    for (unsigned p = 0; p < W * H; p++) {
        const unsigned x = p % W, y = p / W;
        unsigned wanted[3], found[3];
        double real[3];
        expected_levels(&s->shader, s->normals[p], &s->albedo[3 * p], s->gloss[p], x + s->surface.x, y + s->surface.y,
                        wanted, real);
        stored_levels((enum glint_format)s->shader.format, s->out + LINE * (1 + y), x, found);
        check(found, wanted, real);
    }
}

/* The same of random scenes. */
static void for_every_pixel(enum glint_space space, check_pixel *check)
{
    static struct scene s;
    for (int i = 0; i < 1500; i++) {
        scene_init(&s, format_number(i), space);
        for_every_pixel_of(&s, check);
    }
}

static void levels_are_equal(const unsigned found[3], const unsigned wanted[3], const double real[3])
{
    (void)real;
    for (int k = 0; k < 3; k++)
        assert_int_equal(found[k], wanted[k]);
}

static void gamma_pixels_are_the_correctly_rounded_sum_in_every_format(void **state)
{
    (void)state;
    for_every_pixel(GLINT_GAMMA, levels_are_equal);
}

/* Their N.L needs more than 32 bits. */
static void a_light_longer_than_1_is_summed_without_overflow(void **state)
{
    (void)state;
    static struct scene s;
    for (int i = 0; i < 200; i++) {
        scene_init(&s, format_number(i), GLINT_GAMMA);
        s.shader.light.l = (struct glint_vec){(int16_t)(32767 - below(9000)), (int16_t)(below(65536) - 32768),
                                              (int16_t)(below(2) ? 32767 : -32768)};
        for (unsigned p = 0; p < W * H; p += 2) /* the longest */
            s.normals[p] = (struct glint_vec){32767, (int16_t)(below(2) ? 32767 : -32768), -32768};
        for_every_pixel_of(&s, levels_are_equal);
    }
}

/* Of grey formats, too, whose maps are read in a loop of their own. */
static void a_map_that_is_not_there_is_the_material_s(void **state)
{
    (void)state;
    static struct scene s;
    for (int i = 0; i < 200; i++) {
        scene_init(&s, format_number(i), GLINT_GAMMA);
        for (unsigned p = 0; p < W * H; p++)
            memcpy(&s.albedo[3 * p], s.shader.material.albedo, 3);
        s.source.albedo = NULL;
        for_every_pixel_of(&s, levels_are_equal);
    }
}

/* Also where F is far from 0 there, as a lobe made by hand may have it. */
static void a_highlight_ends_with_the_lobe_s_last_t(void **state)
{
    (void)state;
    static struct scene s;
    for (int i = 0; i < 200; i++) {
        scene_init(&s, format_number(i), GLINT_GAMMA);
        glint_lobe_init(&s.shader.lobe, GLINT_MSH, 3, 16);
        for (int k = 0; k < 3; k++)
            s.shader.material.specular_q16[k] = 65536;
        const struct glint_vec h = s.shader.light.h, n = s.normals[0];
        const int64_t x = n.x - h.x, y = n.y - h.y, z = n.z - h.z, t = (x * x + y * y + z * z) / 2;
        if (t > 1 && t < 1 << 28)
            s.shader.lobe.t_max_q30 = (uint32_t)t - (i & 8 ? 1 : 0);
        s.gloss[0] = 255;
        for_every_pixel_of(&s, levels_are_equal);
    }
}

static double worst;

static void worst_is_noted(const unsigned found[3], const unsigned wanted[3], const double real[3])
{
    (void)wanted;
    for (int k = 0; k < 3; k++) /* found <= real < found + 1, up to the error of the tables */
        worst = fmax(worst, fmax(found[k] - real[k], real[k] - found[k] - 1));
}

static void linear_pixels_are_within_a_twentieth_of_a_level_of_the_real_sum(void **state)
{
    (void)state;
    worst = 0;
    for_every_pixel(GLINT_LINEAR, worst_is_noted);
    printf("# at most %.4f of a level beyond the rounding\n", worst);
    assert_true(worst <= 0.05);
}

static void masked_pixels_keep_what_was_there(void **state)
{
    (void)state;
    static struct scene s, all;
    for (int i = 0; i < 200; i++) {
        const enum glint_format format = format_number(i);
        scene_init(&s, format, GLINT_GAMMA);
        all = s;
        s.surface.pixels = s.out + LINE;
        all.surface.pixels = all.out + LINE;
        all.source =
            (struct glint_source){all.normals, W * sizeof *all.normals, all.albedo, 3 * W, all.gloss, W, NULL, 0};
        assert_int_equal(glint_shade_rect(&s.shader, &s.source, W, H, &s.surface, NULL), GLINT_OK);
        assert_int_equal(glint_shade_rect(&all.shader, &all.source, W, H, &all.surface, NULL), GLINT_OK);
        static uint8_t untouched[LINE];
        memset(untouched, GUARD, sizeof untouched);
        for (unsigned p = 0; p < W * H; p++) {
            unsigned found[3], wanted[3];
            stored_levels(format, s.out + LINE * (1 + p / W), p % W, found);
            stored_levels(format, s.mask[p] ? all.out + LINE * (1 + p / W) : untouched, p % W, wanted);
            assert_memory_equal(found, wanted, sizeof found);
        }
    }
}

static void a_span_is_the_rectangle_sequence_at_its_own_t(void **state)
{
    (void)state;
    for (int i = 0; i < 500; i++) {
        const enum glint_format format = format_number(i);
        struct glint_shader shader = random_shader(format, (enum glint_space)below(2));
        if (shader.lobe.model == GLINT_PHONG)
            shader.lobe.model = GLINT_BLINN;
        /* Along a constant normal the span has the rectangle's t and nl in every pixel. */
        struct glint_vec n;
        struct glint_vec normals[W];
        struct glint_span span;
        do
            n = random_normal(&shader.light);
        while (glint_span_init(&span, &shader.light, &n, &n, W) != GLINT_OK); /* garbage may be out of its range */
        for (int x = 0; x < W; x++)
            normals[x] = n;
        uint8_t rect[LINE], span_out[LINE];
        memset(rect, GUARD, sizeof rect);
        memset(span_out, GUARD, sizeof span_out);
        const struct glint_surface to_rect = {rect + 1, LINE, 2, 3}, to_span = {span_out + 1, LINE, 2, 3};
        const struct glint_source source = {.normals = normals};
        struct glint_box a, b;
        assert_int_equal(glint_shade_rect(&shader, &source, W, 1, &to_rect, &a), GLINT_OK);
        assert_int_equal(glint_shade_span(&shader, &span, &to_span, &b), GLINT_OK);
        assert_memory_equal(rect, span_out, sizeof rect);
        assert_memory_equal(&a, &b, sizeof a);
    }
}

static void a_span_by_c_is_the_span_at_the_nearest_multiple_of_two_to_the_minus_16(void **state)
{
    (void)state;
    unsigned lit = 0, other = 0;
    for (int i = 0; i < 500; i++) {
        struct glint_shader shader =
            random_shader(format_number(i % (GLINT_FORMAT_COUNT - 1)), (enum glint_space)below(2));
        shader.dither = false; /* each pixel is drawn by itself below */
        const uint32_t scale = below(2) ? 1 << 22 : 1 << 30;
        const struct glint_span span = {below(scale),
                                        below(scale) / W - scale / W / 2,
                                        below(scale) / (W * W),
                                        (int32_t)(below(1u << 31) - (1u << 29)),
                                        (int32_t)below(1 << 26) - (1 << 25),
                                        W};
        uint8_t out[LINE], by_t[LINE], wanted[LINE];
        memset(out, GUARD, sizeof out);
        memset(by_t, GUARD, sizeof by_t);
        memset(wanted, GUARD, sizeof wanted);
        const struct glint_surface surface = {out, LINE, 0, 0}, exact = {by_t, LINE, 0, 0};
        struct glint_box box, expected = {0, 0, 0, 0};
        assert_int_equal(glint_shade_span_c16(&shader, &span, &surface, &box), GLINT_OK);
        assert_int_equal(glint_shade_span(&shader, &span, &exact, NULL), GLINT_OK);
        const unsigned bytes = bytes_of((enum glint_format)shader.format, 1);
        for (int64_t k = 0; k < W; k++) {
            int64_t t = (span.t_q30 + k * span.dt_q30 + k * (k - 1) / 2 * span.ddt_q30) % (INT64_C(1) << 32);
            t = t >= INT64_C(0xf8000000) ? 0 : (t + 8192) / 16384 * 16384;
            const struct glint_span pixel = {(uint32_t)t, 0, 0, (int32_t)(span.nl_q30 + k * span.dnl_q30), 0, 1};
            const struct glint_surface at = {wanted + k * bytes, LINE, 0, 0};
            struct glint_box here;
            assert_int_equal(glint_shade_span(&shader, &pixel, &at, &here), GLINT_OK);
            if (here.w) {
                expected.x = expected.w ? expected.x : (uint16_t)k;
                expected.w = (uint16_t)(k + 1 - expected.x);
                expected.h = 1;
            }
        }
        assert_memory_equal(out, wanted, sizeof out);
        assert_memory_equal(&box, &expected, sizeof box);
        lit += box.w > 0;
        other += memcmp(out, by_t, sizeof out) != 0;
    }
    assert_in_range(lit, 100, 500);  /* the spans do meet highlights, ... */
    assert_in_range(other, 20, 500); /* ... and it is not the path by t */
}

static void a_span_whose_t_dips_below_zero_shows_the_peak_there(void **state)
{
    (void)state;
    struct glint_shader shader = random_shader(GLINT_GREY8, GLINT_GAMMA);
    glint_lobe_init(&shader.lobe, GLINT_BLINN, 60, 8);
    shader.dither = false;
    for (int k = 0; k < 3; k++) {
        shader.material.ambient_q16[k] = shader.material.diffuse_q16[k] = 0;
        shader.material.specular_q16[k] = 65536;
    }
    const struct glint_span span = {1u << 24, 0u - (1u << 25), 0, 1 << 30, 0, 3}; /* t = 2^24, -2^24, -3 * 2^24 */
    uint8_t out[3];
    const struct glint_surface surface = {out, 3, 0, 0};
    struct glint_box box;
    assert_int_equal(glint_shade_span(&shader, &span, &surface, &box), GLINT_OK);
    assert_in_range(out[0], 90, 110); /* exp(-60 / 64) */
    assert_int_equal(out[1], 255);
    assert_int_equal(out[2], 255);
    assert_true(box.x == 0 && box.w == 3 && box.h == 1);
}

static const struct glint_shade_model *model_of(const struct glint_shader *shader)
{
#define MODEL_BY_NAME(number, name, function, use) [number] = &glint_shade_##name,
    static const struct glint_shade_model *const models[] = {GLINT_MODELS(MODEL_BY_NAME)};
#undef MODEL_BY_NAME
    return models[shader->lobe.model];
}

static const struct glint_shade_format *format_of(const struct glint_shader *shader)
{
    static const struct glint_shade_format *const kinds[] = {
        [GLINT_RGB565] = &glint_shade_rgb565,   [GLINT_RGB565_SWAPPED] = &glint_shade_rgb565,
        [GLINT_RGB888] = &glint_shade_rgb888,   [GLINT_GREY8] = &glint_shade_grey,
        [GLINT_MONO] = &glint_shade_grey,       [GLINT_BGR888] = &glint_shade_bgr888,
        [GLINT_XRGB8888] = &glint_shade_bgr888, [GLINT_ARGB8888] = &glint_shade_bgr888,
    };
    return shader->space == GLINT_LINEAR ? &glint_shade_linear : kinds[shader->format];
}

static void a_shader_prepared_for_its_model_and_format_by_name_draws_the_same_pixels(void **state)
{
    (void)state;
    static struct scene s;
    static uint8_t before[sizeof s.out], wanted[sizeof s.out];
    static struct glint_prepared prepared;
    for (int i = 0; i < 300; i++) {
        scene_init(&s, format_number(i), i / GLINT_FORMAT_COUNT % 2 ? GLINT_LINEAR : GLINT_GAMMA);
        memcpy(before, s.out, sizeof before);
        assert_int_equal(glint_shade_rect(&s.shader, &s.source, W, H, &s.surface, NULL), GLINT_OK);
        memcpy(wanted, s.out, sizeof wanted);
        memcpy(s.out, before, sizeof before);
        const struct glint_light light = s.shader.light;
        memset(&s.shader.light, 0, sizeof s.shader.light); /* as long as the light is not known */
        assert_int_equal(glint_shade_prepare_for(&prepared, &s.shader, model_of(&s.shader), format_of(&s.shader)),
                         GLINT_OK);
        assert_int_equal(glint_shade_relight(&prepared, &light), GLINT_OK);
        assert_int_equal(glint_shade_prepared_rect(&prepared, &s.source, W, H, &s.surface, NULL), GLINT_OK);
        assert_memory_equal(s.out, wanted, sizeof wanted);
    }
}

static void a_shader_is_not_prepared_for_another_model_or_format(void **state)
{
    (void)state;
    static struct glint_prepared prepared;
    struct glint_shader shader = random_shader(GLINT_RGB565, GLINT_GAMMA);
    const struct glint_shade_model *own = model_of(&shader);
    const struct glint_shade_model *other = own == &glint_shade_msh ? &glint_shade_lyon : &glint_shade_msh;
    assert_int_equal(glint_shade_prepare_for(&prepared, &shader, other, &glint_shade_rgb565), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_prepare_for(&prepared, &shader, own, &glint_shade_rgb888), GLINT_ERR_FORMAT);
    assert_int_equal(glint_shade_prepare_for(&prepared, &shader, own, &glint_shade_linear), GLINT_ERR_FORMAT);
    assert_int_equal(glint_shade_prepare_for(&prepared, &shader, own, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_prepare_for(&prepared, &shader, NULL, &glint_shade_rgb565), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_prepare_for(&prepared, NULL, own, &glint_shade_rgb565), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_prepare_for(NULL, &shader, own, &glint_shade_rgb565), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_relight(&prepared, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_relight(NULL, &shader.light), GLINT_ERR_ARG);
    assert_int_equal(glint_eval((enum glint_model)GLINT_MODEL_COUNT, 10, 65536), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gamma_pixels_are_the_correctly_rounded_sum_in_every_format),
        cmocka_unit_test(a_light_longer_than_1_is_summed_without_overflow),
        cmocka_unit_test(a_map_that_is_not_there_is_the_material_s),
        cmocka_unit_test(a_highlight_ends_with_the_lobe_s_last_t),
        cmocka_unit_test(linear_pixels_are_within_a_twentieth_of_a_level_of_the_real_sum),
        cmocka_unit_test(masked_pixels_keep_what_was_there),
        cmocka_unit_test(a_span_is_the_rectangle_sequence_at_its_own_t),
        cmocka_unit_test(a_span_by_c_is_the_span_at_the_nearest_multiple_of_two_to_the_minus_16),
        cmocka_unit_test(a_span_whose_t_dips_below_zero_shows_the_peak_there),
        cmocka_unit_test(a_shader_prepared_for_its_model_and_format_by_name_draws_the_same_pixels),
        cmocka_unit_test(a_shader_is_not_prepared_for_another_model_or_format),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
