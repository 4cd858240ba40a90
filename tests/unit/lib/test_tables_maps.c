/* SPDX-License-Identifier: MIT
 * Tables under maps of gloss and shininess: their pixels as lib/sequence.md has them, and how far they are from the exact paint's. */
#include "tables_model.h"

static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];
static struct surface_normals scene_normals;
static uint16_t albedo[WIDE * LINES];
static uint8_t gloss[WIDE * LINES], codes[WIDE * LINES], coverage[WIDE * LINES];

static const unsigned most[3] = {31, 63, 31};

enum kind { COLOUR, DITHERED, ALBEDO };

static enum glint_tables_kind of_kind(enum kind kind)
{
    return kind == ALBEDO ? GLINT_TABLES_ALBEDO : GLINT_TABLES_COLOUR;
}

/* ---- The sequence ---- */

/* t as the columns have it. */
static int64_t scaled(const struct look *s, const struct glint_tables *t, int64_t t_q30, unsigned code)
{
    const uint64_t n = s->material.n, inverse = ((UINT64_C(1) << 31) + n / 2) / n, largest = (t->t_max_q30 >> 8) * n;
    const uint64_t m = (uint64_t)(t_q30 >> 8) * glint_shininess_n((uint8_t)code);
    if (t_q30 > 1 << 30 || m > largest)
        return INT64_MAX;
    const uint64_t a1 = (largest - m) >> 16, a0 = (largest - m) & 0xffff, b1 = inverse >> 16, b0 = inverse & 0xffff;
    return t->t_max_q30 - (int64_t)((a1 * b1 + (a1 * b0 >> 16) + (a0 * b1 >> 16)) << 9);
}

static unsigned part_of(unsigned full, unsigned g)
{
    return (full * (g + (g >> 7)) + 128) >> 8;
}

static unsigned level_of(const struct look *s, int k, unsigned of, uint32_t nl, uint32_t f, unsigned times)
{
    return gamma_level(value_of(s, k, of, nl, f), times * most[k], 16);
}

/* t: as the columns have it; what the table holds of rows is not this test's affair, so of colours it is read there. */
static uint16_t expected(enum kind kind, const struct look *s, const struct glint_tables *t, int64_t at, int64_t nl,
                         int p, unsigned g, unsigned x, unsigned y)
{
    const bool shines = nl >= 0 && at <= t->t_max_q30 && g;
    const uint32_t column = shines ? (uint32_t)((t->t_max_q30 - at) >> t->shift) : 0;
    const uint32_t f = shines && kind != COLOUR ? f_at(s, middle(t->t_max_q30, t->shift, column)) : 0;
    unsigned levels[3];
    if (kind == COLOUR)
        return nl < 0 ? t->dark
                      : t->colour.colours[64 * (nl >> 24) + (shines ? part_of(t->columns[column] / 2u, g) : 0)];
    for (int k = 0; k < 3; k++) {
        const unsigned at_bit = k == 0 ? 11 : k == 1 ? 5 : 0;
        unsigned sum;
        if (kind == ALBEDO) {
            const unsigned lit = nl < 0 ? t->dark : *(t->columns - 1 - (nl >> 23)), of_32 = (g + (g >> 7) + 4) >> 3;
            sum = ((albedo[p] >> at_bit & most[k]) * lit + 16) / 32;
            sum += shines ? (level_of(s, k, 0, 0, f, 1) * of_32 + 16) / 32 : 0;
        } else {
            static const int64_t eighths[4] = {7, 5, 1, 3};
            const unsigned b = (unsigned)bayer[(y & 3) * 4 + (x & 3)], color = s->material.albedo[k];
            const uint32_t row = nl < 0 ? 0 : (uint32_t)((nl + (eighths[y & 3] << 20)) >> 23);
            sum = shines ? (level_of(s, k, color, 512 * row, 0, 16) + b + part_of(level_of(s, k, 0, 0, f, 16), g)) / 16
                         : gamma_level(value_of(s, k, color, 512 * row, 0), most[k], 2 * b + 1);
        }
        levels[k] = sum < most[k] ? sum : most[k];
    }
    return in_order(s, levels[0] << 11 | levels[1] << 5 | levels[2]);
}

static struct look look_of(enum kind kind)
{
    struct look s = tables_look((enum glint_format)below(2));
    s.output.dither = kind == DITHERED;
    if (kind == ALBEDO)
        make_grey(&s, 6000, 58000);
    return s;
}

static void random_maps(void)
{
    for (int p = 0; p < WIDE * LINES; p++) {
        albedo[p] = (uint16_t)below(65536);
        gloss[p] = (uint8_t)(below(4) ? below(256) : 255 * below(2));
        codes[p] = (uint8_t)below(256);
        coverage[p] = (uint8_t)(below(3) ? 255 : below(256));
    }
}

static void add_maps(struct glint_maps *maps, enum kind kind, bool glossy, bool shiny)
{
    maps->gloss = glossy ? gloss : NULL;
    maps->shininess = shiny ? codes : NULL;
    maps->gloss_stride = maps->shininess_stride = WIDE;
    if (kind == ALBEDO) {
        maps->albedo = (const uint8_t *)albedo;
        maps->albedo_stride = 2 * WIDE;
        maps->albedo_format = GLINT_RGB565;
    }
}

/* Rows end at nl = 1 (dithered) or 2. */
static bool in_rows(struct glint_vec n, const struct look *s)
{
    return dot(n, s->l) < 1 << 30;
}

static void rectangles_by_maps_of_gloss_and_shininess_have_the_pixels_of_their_sequence(void **state)
{
    (void)state;
    unsigned wide = 0; /* pixels that shine beyond the tables' own highlight */
    for (int i = 0; i < 360; i++) {
        const enum kind kind = (enum kind)(i % 3);
        const enum glint_normals format = (enum glint_normals)(i / 3 % 2);
        const bool glossy = i / 6 % 3 != 1, shiny = format == GLINT_NORMALS_INT8 || i / 6 % 3 != 2;
        const struct look s = look_of(kind);
        struct glint_paint paint;
        paint_of_tables(&paint, of_kind(kind), &s, memory);
        const struct glint_tables *t = &paint.of.tables.filled;
        random_surface(&scene_normals, format, &s);
        random_maps();
        uint16_t out[WIDE * LINES];
        memset(out, GUARD, sizeof out);
        const struct glint_surface surface = {out, 2 * WIDE, (uint16_t)below(4), (uint16_t)below(4)};
        struct glint_maps maps = maps_of(&scene_normals, format);
        struct glint_box box, wanted_box = {WIDE, LINES, 0, 0};
        int right = -1, bottom = -1;
        add_maps(&maps, kind, glossy, shiny);
        assert_int_equal(glint_draw_rect(&paint, &maps, WIDE, LINES, &surface, below(2) ? &box : NULL), GLINT_OK);
        for (int p = 0; p < WIDE * LINES; p++) {
            const struct glint_vec n = scene_normals.vec[p];
            const int x = p % WIDE, y = p / WIDE;
            const int64_t t_q30 = t_of(n, s.h), at = shiny ? scaled(&s, t, t_q30, codes[p]) : t_q30, nl = dot(n, s.l);
            const unsigned g = glossy ? gloss[p] : 255;
            if (!is_surface(n)) {
                assert_int_equal(out[p], GUARD << 8 | GUARD);
                continue;
            }
            if (in_rows(n, &s))
                assert_int_equal(out[p],
                                 expected(kind, &s, t, at, nl, p, g, surface.x + (unsigned)x, surface.y + (unsigned)y));
            if (nl < 0 || at > t->t_max_q30)
                continue;
            wide += t_q30 > t->t_max_q30;
            wanted_box.x = (uint16_t)(x < wanted_box.x ? x : wanted_box.x);
            wanted_box.y = (uint16_t)(y < wanted_box.y ? y : wanted_box.y);
            right = x > right ? x : right;
            bottom = y;
        }
        assert_int_equal(glint_draw_rect(&paint, &maps, WIDE, LINES, &surface, &box), GLINT_OK);
        wanted_box.w = (uint16_t)(right + 1 - (right < 0 ? 0 : wanted_box.x));
        wanted_box.h = (uint16_t)(bottom + 1 - (bottom < 0 ? 0 : wanted_box.y));
        if (right < 0)
            wanted_box.x = wanted_box.y = 0;
        assert_memory_equal(&box, &wanted_box, sizeof box);
    }
    assert_true(wide > 1000);
}

static void spans_by_maps_of_gloss_and_shininess_have_the_pixels_of_their_sequence(void **state)
{
    (void)state;
    for (int i = 0; i < 300; i++) {
        const enum kind kind = (enum kind)(i % 3);
        const struct look s = look_of(kind);
        struct glint_paint paint;
        paint_of_tables(&paint, of_kind(kind), &s, memory);
        random_maps();
        const struct glint_span span = {below(1u << 30) - below(9),
                                        below(1u << 25) - (1u << 24),
                                        below(1u << 20),
                                        (int32_t)below(1u << 29) - (1 << 28),
                                        (int32_t)below(1u << 22),
                                        WIDE,
                                        {{0, 0}, {0, 0}}};
        uint16_t out[WIDE];
        const struct glint_surface surface = {out, 0, (uint16_t)below(4), (uint16_t)below(4)};
        struct glint_maps maps = {.albedo = NULL};
        add_maps(&maps, kind, i & 4, !(i & 4) || i & 8);
        assert_int_equal(glint_draw_span(&paint, &span, &maps, &surface, NULL), GLINT_OK);
        uint32_t t = span.t_q30, dt = span.dt_q30, nl = (uint32_t)span.nl_q30;
        for (unsigned x = 0; x < WIDE; x++) {
            const uint32_t at = t >= UINT32_C(0xf8000000) ? 0 : t;
            const int64_t column = maps.shininess ? scaled(&s, &paint.of.tables.filled, at, codes[x]) : at;
            assert_int_equal(out[x], expected(kind, &s, &paint.of.tables.filled, column, (int32_t)nl, (int)x,
                                              maps.gloss ? gloss[x] : 255, surface.x + x, surface.y));
            t += dt;
            dt += span.ddt_q30;
            nl += (uint32_t)span.dnl_q30;
        }
    }
}

/* ---- What must not matter ---- */

static void full_gloss_draws_what_no_map_does_and_coverage_blends_what_the_maps_draw(void **state)
{
    (void)state;
    for (int i = 0; i < 120; i++) {
        const enum kind kind = (enum kind)(i % 3);
        const enum glint_normals format = (enum glint_normals)(i / 3 % 2);
        const struct look s = look_of(kind);
        struct glint_paint paint;
        paint_of_tables(&paint, of_kind(kind), &s, memory);
        random_surface(&scene_normals, format, &s);
        random_maps();
        struct glint_maps maps = maps_of(&scene_normals, format);
        uint16_t plain[WIDE * LINES] = {0}, full[WIDE * LINES] = {0}, soft[WIDE * LINES] = {0};
        const struct glint_surface to_plain = {plain, 2 * WIDE, 1, 2}, to_full = {full, 2 * WIDE, 1, 2},
                                   to_soft = {soft, 2 * WIDE, 1, 2};
        add_maps(&maps, kind, false, false);
        assert_int_equal(glint_draw_rect(&paint, &maps, WIDE, LINES, &to_plain, NULL), GLINT_OK);
        add_maps(&maps, kind, true, false);
        memset(gloss, 255, sizeof gloss);
        assert_int_equal(glint_draw_rect(&paint, &maps, WIDE, LINES, &to_full, NULL), GLINT_OK);
        assert_memory_equal(plain, full, sizeof plain);
        random_maps();
        add_maps(&maps, kind, true, true);
        assert_int_equal(glint_draw_rect(&paint, &maps, WIDE, LINES, &to_full, NULL), GLINT_OK);
        maps.coverage = coverage;
        maps.coverage_stride = WIDE;
        assert_int_equal(glint_draw_rect(&paint, &maps, WIDE, LINES, &to_soft, NULL), GLINT_OK);
        for (int p = 0; p < WIDE * LINES; p++) { /* over black */
            unsigned wanted = 0;
            for (int k = 0; k < 3; k++) {
                const unsigned bit = k == 0 ? 11 : k == 1 ? 5 : 0;
                const unsigned level = in_order(&s, full[p]) >> bit & (unsigned)most[k];
                wanted |= (2 * level * coverage[p] + 255) / 510 << bit;
            }
            assert_int_equal(soft[p], is_surface(scene_normals.vec[p]) ? in_order(&s, wanted) : 0);
        }
    }
}

/* As tables that were written by hand may be. */
static void shininess_over_tables_whose_own_is_none_is_an_error(void **state)
{
    (void)state;
    static const uint16_t none[] = {0, GLINT_N_MAX + 1, UINT16_MAX};
    for (unsigned i = 0; i < 9; i++) {
        const enum kind kind = (enum kind)(i % 3);
        const struct look s = look_of(kind);
        struct glint_paint paint;
        paint_of_tables(&paint, of_kind(kind), &s, memory);
        random_surface(&scene_normals, GLINT_NORMALS_INT16, &s);
        random_maps();
        struct glint_maps maps = maps_of(&scene_normals, GLINT_NORMALS_INT16);
        uint16_t out[WIDE * LINES];
        const struct glint_surface surface = {out, 2 * WIDE, 0, 0};
        paint.of.tables.filled.n = none[i / 3];
        add_maps(&maps, kind, true, true);
        assert_int_equal(glint_draw_rect(&paint, &maps, WIDE, LINES, &surface, NULL), GLINT_ERR_ARG);
        add_maps(&maps, kind, true, false);
        assert_int_equal(glint_draw_rect(&paint, &maps, WIDE, LINES, &surface, NULL), GLINT_OK);
    }
}

/* ---- How near ---- */

enum { SIDE = 96 };

/* What glint bake --filter makes of a surface of n: a shininess, and the gloss that goes with it. */
static void filtered(double n, uint8_t *code, uint8_t *shine)
{
    const double length = 1 - .3 * below(1000) / 1000. * below(1000) / 1000.,
                 wider = length * n / (length + n * (1 - length));
    *code = glint_shininess_code((uint32_t)fmax(1, round(wider)));
    *shine = (uint8_t)lround(255 * (1 + wider) / (1 + n));
}

static void
filtered_maps_by_tables_are_within_2_steps_of_green_of_the_exact_paint_or_3_by_schlick_and_cayley(void **state)
{
    (void)state;
    static struct glint_vec normals[SIDE * SIDE];
    static uint8_t shine[SIDE * SIDE], code[SIDE * SIDE], grey888[3 * SIDE * SIDE];
    static uint16_t grey565[SIDE * SIDE], exact[SIDE * SIDE], fast[SIDE * SIDE];
    static const enum glint_model models[] = {GLINT_MSH, GLINT_SCHLICK, GLINT_CAYLEY, GLINT_LYON, GLINT_GGX};
    static const uint16_t shininess[] = {20, 60, 200, 1000};
    for (int test = 0; test < 5 * 4 * 2; test++) {
        const enum kind kind = test % 2 ? ALBEDO : COLOUR;
        struct look look = {.output = {GLINT_RGB565, GLINT_GAMMA, false}};
        set_model(&look, models[test / 8], shininess[test / 2 % 4], 8);
        make_grey(&look, 6000, 50000);
        for (int k = 0; k < 3; k++) {
            look.material.specular_q16[k] = 60000;
            look.material.albedo[k] = 132;
        }
        assert_int_equal(look_light(&look, (const int32_t[]){2, 3, 6}, in_front), GLINT_OK);
        for (int p = 0; p < SIDE * SIDE; p++) {
            const double x = (p % SIDE - SIDE / 2.) / SIDE * 1.6, y = (SIDE / 2. - p / SIDE) / SIDE * 1.6;
            const double z = sqrt(fmax(0, 1 - x * x - y * y)), length = sqrt(x * x + y * y + z * z);
            normals[p] = (struct glint_vec){(int16_t)lrint(32767 * x / length), (int16_t)lrint(32767 * y / length),
                                            (int16_t)lrint(32767 * z / length)};
            filtered(look.material.n, &code[p], &shine[p]);
            memset(&grey888[3 * p], 132, 3);
            grey565[p] = 16 << 11 | 33 << 5 | 16;
        }
        struct glint_maps maps = {.normals = normals,
                                  .normals_stride = SIDE * 6,
                                  .gloss = shine,
                                  .gloss_stride = SIDE,
                                  .shininess = code,
                                  .shininess_stride = SIDE};
        const struct glint_surface to_exact = {exact, 2 * SIDE, 0, 0}, to_fast = {fast, 2 * SIDE, 0, 0};
        struct glint_paint paint;
        if (kind == ALBEDO) {
            maps.albedo = grey888;
            maps.albedo_stride = 3 * SIDE;
            maps.albedo_format = GLINT_RGB888;
        }
        assert_int_equal(draw_rect(&look, &maps, SIDE, SIDE, &to_exact, NULL), GLINT_OK);
        if (kind == ALBEDO) {
            maps.albedo = (const uint8_t *)grey565;
            maps.albedo_stride = 2 * SIDE;
            maps.albedo_format = GLINT_RGB565;
        }
        paint_of_tables(&paint, of_kind(kind), &look, memory);
        assert_int_equal(glint_draw_rect(&paint, &maps, SIDE, SIDE, &to_fast, NULL), GLINT_OK);
        int largest = 0;
        double sum = 0;
        for (int p = 0; p < SIDE * SIDE; p++) {
            const int off = abs((exact[p] >> 5 & 63) - (fast[p] >> 5 & 63));
            largest = off > largest ? off : largest;
            sum += off;
        }
        const bool far = look.material.model == GLINT_SCHLICK || look.material.model == GLINT_CAYLEY;
        if (largest > 2 + far || sum / (SIDE * SIDE) > (far ? 1.1 : .6))
            fail_msg("model %d, n = %d, %s tables: largest %d steps of 63, mean %.3f", look.material.model,
                     look.material.n, kind == ALBEDO ? "albedo" : "colour", largest, sum / (SIDE * SIDE));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangles_by_maps_of_gloss_and_shininess_have_the_pixels_of_their_sequence),
        cmocka_unit_test(spans_by_maps_of_gloss_and_shininess_have_the_pixels_of_their_sequence),
        cmocka_unit_test(shininess_over_tables_whose_own_is_none_is_an_error),
        cmocka_unit_test(full_gloss_draws_what_no_map_does_and_coverage_blends_what_the_maps_draw),
        cmocka_unit_test(
            filtered_maps_by_tables_are_within_2_steps_of_green_of_the_exact_paint_or_3_by_schlick_and_cayley),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
