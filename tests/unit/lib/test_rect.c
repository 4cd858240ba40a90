/* SPDX-License-Identifier: MIT
 * Rectangles and spans by the exact paint: the value of every pixel. */
#include "shading.h"

/* What a test says of a pixel: the levels found, those wanted, and the real values. */
typedef void check_pixel(const unsigned found[3], const unsigned wanted[3], const double real[3]);

/* Draws a scene, without its coverage, and shows each pixel to `check`. */
static void for_every_pixel_of(struct scene *s, check_pixel *check)
{
    s->maps.coverage = NULL;
    assert_int_equal(draw_scene(s, NULL), GLINT_OK);
    for (unsigned p = 0; p < W * H; p++) {
        const unsigned x = p % W, y = p / W;
        unsigned wanted[3], found[3];
        double real[3];
        expected_levels(&s->look, s->normals[p], &s->albedo[3 * p], s->gloss[p], x + s->surface.x, y + s->surface.y,
                        wanted, real);
        stored_levels((enum glint_format)s->look.output.format, s->out + LINE * (1 + y), x, found);
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

/* Their N.L and t are the largest that there are. */
static void the_longest_normals_are_summed_without_overflow(void **state)
{
    (void)state;
    static struct scene s;
    static const int32_t corners[][3] = {{1, 1, 1}, {-1, 1, 1}, {1, -1, -1}, {1, 0, 0}, {0, -1, 0}, {-2, -2, 1}};
    for (int i = 0; i < 200; i++) {
        scene_init(&s, format_number(i), GLINT_GAMMA);
        assert_int_equal(look_light(&s.look, corners[below(6)], i & 1 ? corners[0] : in_front), GLINT_OK);
        for (unsigned p = 0; p < W * H; p += 2)
            s.normals[p] =
                (struct glint_vec){(int16_t)(below(2) ? 32767 : -32768), (int16_t)(below(2) ? 32767 : -32768),
                                   (int16_t)(below(2) ? 32767 : -32768)};
        for_every_pixel_of(&s, levels_are_equal);
    }
}

static void a_light_has_its_colour_in_every_format(void **state)
{
    (void)state;
    static struct scene s;
    for (int i = 0; i < 1500; i++) {
        scene_init(&s, format_number(i), GLINT_GAMMA);
        for (int k = 0; k < 3; k++)
            s.look.light.color_q16[k] = below(9) ? below(UINT32_C(1) << (12 + below(11))) : UINT32_MAX;
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
            memcpy(&s.albedo[3 * p], s.look.material.albedo, 3);
        s.maps.albedo = NULL;
        for_every_pixel_of(&s, levels_are_equal);
    }
}

/* A normal whose |N - H|^2 / 2 is t; false where none was found. */
static bool normal_at(struct glint_vec *n, struct glint_vec h, uint32_t t)
{
    const uint32_t size = (uint32_t)root_of(2 * (uint64_t)t);
    for (int tries = 0; tries < 100000; tries++) {
        const int64_t x = (int64_t)below(2 * size) - size, y = (int64_t)below(2 * size) - size;
        const int64_t rest = 2 * (int64_t)t + below(2) - x * x - y * y;
        const int64_t z = rest < 0 ? 0 : (int64_t)root_of((uint64_t)rest);
        if (rest != z * z || llabs(h.x + x) > INT16_MAX || llabs(h.y + y) > INT16_MAX || h.z - z < INT16_MIN)
            continue;
        *n = (struct glint_vec){(int16_t)(h.x + x), (int16_t)(h.y + y), (int16_t)(h.z - z)};
        return true;
    }
    return false;
}

/* Also where F is far from 0 there. */
static void a_highlight_ends_with_the_last_t_of_the_cutoff(void **state)
{
    (void)state;
    static struct scene s;
    unsigned last = 0, beyond = 0;
    for (int i = 0; i < 400; i++) {
        scene_init(&s, format_number(i), GLINT_GAMMA);
        set_model(&s.look, GLINT_MSH, 3, (uint8_t)(1 + below(3)));
        for (int k = 0; k < 3; k++)
            s.look.material.specular_q16[k] = 65536;
        for (unsigned p = 0; p < 8; p++) {
            uint32_t nl;
            s.gloss[p] = 255;
            if (!normal_at(&s.normals[p], s.look.h, last_t_of(&s.look) + p % 2))
                continue;
            const uint32_t f = lobe_at(&s.look, s.normals[p], &nl);
            last += nl && f;
            beyond += nl && !f;
        }
        for_every_pixel_of(&s, levels_are_equal);
    }
    assert_true(last > 50 && beyond > 50);
}

/* 6 for RGB565 and MONO, 8 for others or dithered, 12 in linear space; more than 16 counts as 16. */
static void a_cutoff_of_0_is_what_the_output_needs(void **state)
{
    (void)state;
    static struct scene s;
    unsigned last = 0;
    for (int i = 0; i < 400; i++) {
        scene_init(&s, format_number(i), (enum glint_space)(i / GLINT_FORMAT_COUNT & 1));
        set_model(&s.look, GLINT_MSH, (uint16_t)(20 + below(100)), 0);
        const uint8_t meant = i % 3 ? (uint8_t)q_of(&s.look) : 16;
        const uint8_t qs[3] = {i % 3 ? 0 : (uint8_t)(17 + below(239)), meant, (uint8_t)(meant - 1)};
        struct glint_box box;
        s.look.material.q = meant;
        if (!normal_at(&s.normals[0], s.look.h, last_t_of(&s.look)))
            continue;
        uint32_t nl;
        const bool shines = lobe_at(&s.look, s.normals[0], &nl) > 0;
        for (int k = 0; k < 3; k++) {
            s.look.material.q = qs[k];
            assert_int_equal(draw_rect(&s.look, &(struct glint_maps){.normals = s.normals}, 1, 1, &s.surface, &box),
                             GLINT_OK);
            assert_int_equal(box.w, shines && k < 2);
        }
        last += shines;
    }
    assert_true(last > 100);
}

static void a_paint_tells_by_which_cutoff_it_draws(void **state)
{
    (void)state;
    static struct scene s;
    for (int i = 0; i < 8 * GLINT_FORMAT_COUNT; i++) {
        scene_init(&s, format_number(i), (enum glint_space)(i / GLINT_FORMAT_COUNT & 1));
        s.look.output.dither = i / GLINT_FORMAT_COUNT & 2;
        s.look.material.q = i / GLINT_FORMAT_COUNT & 4 ? 9 : 0;
        struct glint_paint paint;
        assert_int_equal(glint_paint_exact(&paint, &s.look.material, &s.look.output), GLINT_OK);
        assert_int_equal(paint.material.q, q_of(&s.look));
    }
}

static void a_shininess_beyond_1000_counts_as_1000(void **state)
{
    (void)state;
    static struct scene a, b;
    for (int i = 0; i < 40; i++) {
        scene_init(&a, format_number(i), GLINT_GAMMA);
        a.look.material.n = (uint16_t)(i & 1 ? UINT16_MAX : 1001);
        a.look.material.n_across = (uint16_t)(i & 2 ? a.look.material.n : 0);
        scene_copy(&b, &a);
        b.look.material.n = 1000;
        b.look.material.n_across = 0;
        assert_int_equal(draw_scene(&a, NULL), GLINT_OK);
        assert_int_equal(draw_scene(&b, NULL), GLINT_OK);
        assert_memory_equal(a.out, b.out, sizeof a.out);
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

static void pixels_without_coverage_keep_what_was_there_and_full_ones_are_drawn(void **state)
{
    (void)state;
    static struct scene s, all;
    for (int i = 0; i < 200; i++) {
        const enum glint_format format = format_number(i);
        scene_init(&s, format, GLINT_GAMMA);
        scene_copy(&all, &s);
        all.maps.coverage = NULL;
        assert_int_equal(draw_scene(&s, NULL), GLINT_OK);
        assert_int_equal(draw_scene(&all, NULL), GLINT_OK);
        static uint8_t untouched[LINE];
        memset(untouched, GUARD, sizeof untouched);
        for (unsigned p = 0; p < W * H; p++) {
            unsigned found[3], wanted[3];
            if (s.coverage[p] && s.coverage[p] < 255)
                continue;
            stored_levels(format, s.out + LINE * (1 + p / W), p % W, found);
            stored_levels(format, s.coverage[p] ? all.out + LINE * (1 + p / W) : untouched, p % W, wanted);
            assert_memory_equal(found, wanted, sizeof found);
        }
    }
}

/* Albedo in RGB888 and in BGR888; in GREY8 gloss, coverage, the direction of grain and shininess, by themselves or together. Under one light or two. */
static void a_map_may_be_the_output_itself(void **state)
{
    (void)state;
    enum { WIDE = 61, HIGH = 5 };
    static struct glint_vec normals[WIDE * HIGH];
    static uint8_t apart[3 * WIDE * HIGH], before[3 * WIDE * HIGH], same[3 * WIDE * HIGH];
    for (int round = 0; round < 4000; round++) {
        const bool bytewise = below(2);
        struct look look = random_look(bytewise   ? GLINT_GREY8
                                       : below(2) ? GLINT_RGB888
                                                  : GLINT_BGR888,
                                       below(2) ? GLINT_GAMMA : GLINT_LINEAR);
        const unsigned bytes = bytewise ? 1 : 3, which = 1 + below(15);
        const bool is_shiny = which & 8;
        look.material.model = bytewise ? GLINT_CAYLEY : look.material.model;
        look.material.n_across = (uint16_t)(bytewise && !is_shiny && below(2) ? 1 + below(300) : 0);
        struct glint_maps maps = {
            .normals = normals, .normals_stride = sizeof *normals * WIDE, .albedo_format = GLINT_RGB888};
        const ptrdiff_t stride = (ptrdiff_t)bytes * WIDE;
        maps.albedo_stride = maps.gloss_stride = maps.coverage_stride = maps.grain_stride = maps.shininess_stride =
            stride;
        for (unsigned i = 0; i < WIDE * HIGH; i++)
            normals[i] = random_normal(&look);
        for (unsigned i = 0; i < sizeof same; i++)
            same[i] = apart[i] = before[i] = (uint8_t)(below(3) ? below(256) : 0);
        struct glint_maps in_place = maps;
        const uint8_t *const of[2] = {before, same};
        for (int k = 0; k < 2; k++) {
            struct glint_maps *const to = k ? &in_place : &maps;
            to->albedo = bytewise ? NULL : of[k];
            to->gloss = bytewise && which & 1 ? of[k] : NULL;
            to->coverage = bytewise && which & 2 ? of[k] : NULL;
            to->grain = bytewise && which & 4 && !is_shiny ? of[k] : NULL;
            to->shininess = bytewise && is_shiny ? of[k] : NULL;
        }
        const struct glint_light lights[2] = {look.light, look.light};
        const struct glint_surface target = {apart, stride, 3, 2}, over = {same, stride, 3, 2};
        const unsigned count = 1 + below(2);
        struct glint_paint paint;
        struct glint_box box, same_box;
        const uint16_t w = (uint16_t)(1 + below(WIDE)), h = (uint16_t)(1 + below(HIGH));
        assert_int_equal(glint_paint_exact(&paint, &look.material, &look.output), GLINT_OK);
        assert_int_equal(glint_paint_light(&paint, lights, count, look.to_viewer), GLINT_OK);
        assert_int_equal(glint_draw_rect(&paint, &maps, w, h, &target, &box), GLINT_OK);
        assert_int_equal(glint_draw_rect(&paint, &in_place, w, h, &over, &same_box), GLINT_OK);
        assert_memory_equal(same, apart, sizeof same);
        assert_memory_equal(&same_box, &box, sizeof box);
    }
}

static void a_span_is_the_rectangle_sequence_at_its_own_t(void **state)
{
    (void)state;
    for (int i = 0; i < 500; i++) {
        const enum glint_format format = format_number(i);
        struct look look = random_look(format, (enum glint_space)below(2));
        struct glint_paint paint;
        if (look.material.model == GLINT_PHONG)
            look.material.model = GLINT_BLINN;
        paint_of(&paint, &look);
        /* Along a constant normal the span has the rectangle's t and nl in every pixel. */
        struct glint_vec n;
        struct glint_vec normals[W];
        struct glint_span span;
        do
            n = random_normal(&look);
        while (glint_span_init(&span, &paint, &n, &n, W) != GLINT_OK); /* garbage may be out of its range */
        for (int x = 0; x < W; x++)
            normals[x] = n;
        uint8_t rect[LINE], span_out[LINE];
        memset(rect, GUARD, sizeof rect);
        memset(span_out, GUARD, sizeof span_out);
        const struct glint_surface to_rect = {rect + 1, LINE, 2, 3}, to_span = {span_out + 1, LINE, 2, 3};
        const struct glint_maps maps = {.normals = normals};
        struct glint_box a, b;
        assert_int_equal(glint_draw_rect(&paint, &maps, W, 1, &to_rect, &a), GLINT_OK);
        assert_int_equal(glint_draw_span(&paint, &span, NULL, &to_span, &b), GLINT_OK);
        assert_memory_equal(rect, span_out, sizeof rect);
        assert_true(same_box(&a, &b));
    }
}

static void a_span_whose_t_dips_below_zero_shows_the_peak_there(void **state)
{
    (void)state;
    struct look look = random_look(GLINT_GREY8, GLINT_GAMMA);
    set_model(&look, GLINT_BLINN, 60, 8);
    look.output.dither = false;
    for (int k = 0; k < 3; k++) {
        look.material.ambient_q16[k] = look.material.diffuse_q16[k] = 0;
        look.material.specular_q16[k] = 65536;
    }
    const struct glint_span span = {1u << 24, 0u - (1u << 25), 0, 1 << 30, 0,
                                    3,        {{0, 0}, {0, 0}}}; /* t = 2^24, -2^24, -3 * 2^24 */
    uint8_t out[3];
    const struct glint_surface surface = {out, 3, 0, 0};
    struct glint_box box;
    assert_int_equal(draw_span(&look, &span, &surface, &box), GLINT_OK);
    assert_in_range(out[0], 90, 110); /* exp(-60 / 64) */
    assert_int_equal(out[1], 255);
    assert_int_equal(out[2], 255);
    assert_true(box.x == 0 && box.w == 3 && box.h == 1);
}

/* Rounding leads a span's t a little below 0, which modulo 2^32 is from 0xf8000000 on. */
static void t_a_little_below_0_is_0_and_nothing_shines_in_the_dark(void **state)
{
    (void)state;
    static const uint32_t t[] = {0, 1, UINT32_C(0xf7ffffff), UINT32_C(0xf8000000), UINT32_MAX};
    static const bool shines[] = {true, true, false, true, true};
    for (int i = 0; i < 100; i++) {
        struct look look = random_look(format_number(i), GLINT_GAMMA);
        uint8_t peak[4] = {0};
        for (int k = 0; k < 5; k++)
            for (int dark = 0; dark < 2; dark++) {
                const struct glint_span span = {t[k], 0, 0, dark ? -(1 << 20) : 1 << 20, 0, 1, {{0, 0}, {0, 0}}};
                uint8_t out[4] = {0};
                const struct glint_surface surface = {out, 4, 0, 0};
                struct glint_box box;
                assert_int_equal(draw_span(&look, &span, &surface, &box), GLINT_OK);
                assert_int_equal(box.w, shines[k] && !dark);
                if (k == 0 && !dark)
                    memcpy(peak, out, sizeof peak);
                if (k > 2 && !dark)
                    assert_memory_equal(out, peak, sizeof out);
            }
    }
}

static const struct glint_use_model *model_named(const struct look *look)
{
#define MODEL_BY_NAME(number, name, function, use, grain) [number] = &glint_use_##name,
    static const struct glint_use_model *const models[] = {GLINT_MODELS(MODEL_BY_NAME)};
#undef MODEL_BY_NAME
    return models[look->material.model];
}

static const struct glint_use_format *format_named(const struct look *look)
{
    static const struct glint_use_format *const groups[] = {
        [GLINT_RGB565] = &glint_use_rgb565,   [GLINT_RGB565_SWAPPED] = &glint_use_rgb565,
        [GLINT_RGB888] = &glint_use_rgb888,   [GLINT_GREY8] = &glint_use_grey,
        [GLINT_MONO] = &glint_use_grey,       [GLINT_BGR888] = &glint_use_rgb888,
        [GLINT_XRGB8888] = &glint_use_rgb888, [GLINT_ARGB8888] = &glint_use_rgb888,
        [GLINT_GREY4] = &glint_use_grey,      [GLINT_GREY2] = &glint_use_grey,
    };
    return look->output.space == GLINT_LINEAR ? &glint_use_linear : groups[look->output.format];
}

static void a_paint_of_a_model_and_format_by_name_draws_the_same_pixels(void **state)
{
    (void)state;
    static struct scene s, named;
    for (int i = 0; i < 300; i++) {
        struct glint_paint paint;
        scene_init(&s, format_number(i), i / GLINT_FORMAT_COUNT % 2 ? GLINT_LINEAR : GLINT_GAMMA);
        scene_copy(&named, &s);
        assert_int_equal(draw_scene(&s, NULL), GLINT_OK);
        assert_int_equal(glint_paint_exact_for(&paint, &s.look.material, &s.look.output, model_named(&s.look),
                                               format_named(&s.look)),
                         GLINT_OK);
        assert_int_equal(glint_paint_light_by(&paint, &s.look.light, 1, s.look.to_viewer, NULL), GLINT_OK);
        assert_int_equal(glint_draw_rect(&paint, &named.maps, W, H, &named.surface, NULL), GLINT_OK);
        assert_memory_equal(s.out, named.out, sizeof s.out);
    }
}

static void a_paint_is_not_made_for_another_model_or_format(void **state)
{
    (void)state;
    struct glint_paint paint;
    const struct look look = random_look(GLINT_RGB565, GLINT_GAMMA);
    const struct glint_material *m = &look.material;
    const struct glint_output *o = &look.output;
    const struct glint_use_model *own = model_named(&look);
    const struct glint_use_model *other = own == &glint_use_msh ? &glint_use_lyon : &glint_use_msh;
    memset(&paint, GUARD, sizeof paint);
    const struct glint_paint before = paint;
    assert_int_equal(glint_paint_exact_for(&paint, m, o, other, &glint_use_rgb565), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_exact_for(&paint, m, o, own, &glint_use_rgb888), GLINT_ERR_FORMAT);
    assert_int_equal(glint_paint_exact_for(&paint, m, o, own, &glint_use_linear), GLINT_ERR_FORMAT);
    assert_int_equal(glint_paint_exact_for(&paint, m, o, own, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_exact_for(&paint, m, o, NULL, &glint_use_rgb565), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_exact_for(&paint, m, NULL, own, &glint_use_rgb565), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_exact_for(&paint, NULL, o, own, &glint_use_rgb565), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_exact_for(NULL, m, o, own, &glint_use_rgb565), GLINT_ERR_ARG);
    assert_memory_equal(&paint, &before, sizeof paint);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gamma_pixels_are_the_correctly_rounded_sum_in_every_format),
        cmocka_unit_test(the_longest_normals_are_summed_without_overflow),
        cmocka_unit_test(a_light_has_its_colour_in_every_format),
        cmocka_unit_test(a_map_that_is_not_there_is_the_material_s),
        cmocka_unit_test(a_highlight_ends_with_the_last_t_of_the_cutoff),
        cmocka_unit_test(a_cutoff_of_0_is_what_the_output_needs),
        cmocka_unit_test(a_paint_tells_by_which_cutoff_it_draws),
        cmocka_unit_test(a_shininess_beyond_1000_counts_as_1000),
        cmocka_unit_test(linear_pixels_are_within_a_twentieth_of_a_level_of_the_real_sum),
        cmocka_unit_test(pixels_without_coverage_keep_what_was_there_and_full_ones_are_drawn),
        cmocka_unit_test(a_map_may_be_the_output_itself),
        cmocka_unit_test(a_span_is_the_rectangle_sequence_at_its_own_t),
        cmocka_unit_test(a_span_whose_t_dips_below_zero_shows_the_peak_there),
        cmocka_unit_test(t_a_little_below_0_is_0_and_nothing_shines_in_the_dark),
        cmocka_unit_test(a_paint_of_a_model_and_format_by_name_draws_the_same_pixels),
        cmocka_unit_test(a_paint_is_not_made_for_another_model_or_format),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
