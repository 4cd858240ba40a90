/* SPDX-License-Identifier: MIT
 * Tables, lights and pixels as lib/sequence.md has them, to the bit. (COLOUR's packed normals and spans: test_tables_sequence.c.) */
#include "tables_model.h"

static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4];
static struct surface_normals scene_normals;

/* ---- COLOUR ---- */

static bool has_column(const struct look *s, uint32_t t)
{
    return column_of(s, t) > 0;
}

static void colour_tables_hold_what_their_sequence_says(void **state)
{
    (void)state;
    for (int i = 0; i < 40; i++) {
        const struct look s = tables_look((enum glint_format)below(2));
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_COLOUR, &s, memory);
        const struct glint_tables *t = &paint.of.tables.filled;
        const uint32_t u = last_t(&s, has_column);
        assert_int_equal(t->t_max_q30, u);
        assert_int_equal(t->shift, least_shift(u, 4080));
        for (uint32_t c = 0; c < 4096; c++)
            assert_int_equal(t->columns[c], 2 * column_of(&s, middle(u, t->shift, c)));
        for (uint32_t row = 0; row < 128; row++)
            for (uint32_t j = 0; j < 64; j++)
                assert_int_equal(t->colour.colours[64 * row + j],
                                 pixel_565(&s, row < 64 ? 1024 * row + 512 : 65536, f_of(&s, j)));
        assert_int_equal(t->dark, pixel_565(&s, 0, 0));
    }
}

static void a_light_for_colour_tables_is_what_its_sequence_says(void **state)
{
    (void)state;
    for (int i = 0; i < 200; i++) {
        const struct look s = tables_look(GLINT_RGB565);
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_COLOUR, &s, memory);
        const struct glint_tables *t = &paint.of.tables.filled;
        const int32_t y = (s.l.y + 1) >> 1, z = (s.l.z + 1) >> 1;
        const uint64_t sum = square(s.l.x) + square(2 * y) + square(2 * z + 32768), peak = root_of(sum << 28);
        const uint64_t reach = (uint64_t)((u128)t->t_max_q30 * peak >> 30);
        unsigned a = 0;
        while (reach >> 1 >> a > 32767)
            a++;
        const uint64_t r = peak ? (UINT64_C(1) << (50 + a - t->shift)) / peak : 0;
        assert_int_equal(paint.of.tables.x, 128 * s.l.x - y);
        assert_int_equal(paint.of.tables.y, y);
        assert_int_equal(paint.of.tables.z, z);
        assert_int_equal(paint.of.tables.peak, peak);
        assert_int_equal(paint.of.tables.cut, peak - reach);
        assert_int_equal(paint.of.tables.a, a);
        assert_int_equal(paint.of.tables.r, r < UINT32_MAX ? r : UINT32_MAX);
    }
}

static uint16_t colour_pixel(const struct glint_tables *t, const struct look *look, struct glint_vec n)
{
    const int64_t nl = dot(n, look->l), at = t_of(n, look->h);
    if (nl < 0)
        return t->dark;
    const unsigned j = at > t->t_max_q30 ? 0 : t->columns[(t->t_max_q30 - at) >> t->shift] / 2u;
    return t->colour.colours[64 * (nl >> 24) + j];
}

/* Into a buffer of its size, at any address, from the top or from the bottom; around it nothing is written. */
static uint8_t out[(4 * WIDE + 3) * LINES + 3];
static struct glint_surface any_surface(unsigned line_bytes)
{
    memset(out, GUARD, sizeof out);
    const ptrdiff_t stride = (ptrdiff_t)(line_bytes + below(4));
    uint8_t *first = out + below(4);
    const struct glint_surface down = {first, stride, (uint16_t)below(4), (uint16_t)below(4)};
    const struct glint_surface up = {first + stride * (LINES - 1), -stride, (uint16_t)below(4), (uint16_t)below(4)};
    return below(2) ? down : up;
}
static const uint8_t *line_of(const struct glint_surface *surface, int y)
{
    return (const uint8_t *)surface->pixels + surface->stride * y;
}
static void assert_guards(const struct glint_surface *surface, unsigned line_bytes)
{
    for (const uint8_t *b = out; b < out + sizeof out; b++) {
        bool inside = false;
        for (int y = 0; y < LINES; y++)
            inside = inside || (b >= line_of(surface, y) && b < line_of(surface, y) + line_bytes);
        assert_true(inside || *b == GUARD);
    }
}

static void assert_pixel(const struct glint_surface *surface, int x, int y, uint16_t wanted, bool is_drawn)
{
    uint16_t found;
    memcpy(&found, line_of(surface, y) + 2 * x, 2);
    assert_int_equal(found, is_drawn ? wanted : GUARD << 8 | GUARD);
}

static void sixteen_bit_normals_over_colour_tables_have_the_pixels_of_their_sequence(void **state)
{
    (void)state;
    for (int i = 0; i < 100; i++) {
        const struct look s = tables_look((enum glint_format)below(2));
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_COLOUR, &s, memory);
        struct glint_tables *t = &paint.of.tables.filled;
        random_surface(&scene_normals, GLINT_NORMALS_INT16, &s);
        const int64_t edge = t_of(scene_normals.vec[1], s.h); /* a pixel at the highlight's end, to the unit */
        if (edge > 0 && edge < t->t_max_q30)
            t->t_max_q30 = (uint32_t)edge - below(2);
        const struct glint_surface surface = any_surface(2 * WIDE);
        const struct glint_maps maps = maps_of(&scene_normals, GLINT_NORMALS_INT16);
        assert_int_equal(glint_draw_rect(&paint, &maps, WIDE, LINES, &surface, NULL), GLINT_OK);
        for (int p = 0; p < WIDE * LINES; p++)
            assert_pixel(&surface, p % WIDE, p / WIDE, colour_pixel(t, &s, scene_normals.vec[p]),
                         is_surface(scene_normals.vec[p]));
        assert_guards(&surface, 2 * WIDE);
    }
}

/* ---- ALBEDO ---- */

static struct look albedo_look(void)
{
    struct look s = tables_look((enum glint_format)below(2));
    const uint32_t ambient = below(4) ? below(65537) : 0, diffuse = below(4) ? below(65537 - ambient) : 65536 - ambient;
    make_grey(&s, ambient, diffuse);
    return s;
}

static unsigned shine_level(const struct look *s, int k, uint32_t f)
{
    return nearest_level(value_of(s, k, 0, 0, f), k == 1 ? 63 : 31);
}

static bool shines(const struct look *s, uint32_t t)
{
    return shine_level(s, 0, f_at(s, t)) || shine_level(s, 1, f_at(s, t)) || shine_level(s, 2, f_at(s, t));
}

static unsigned light_level(const struct look *s, int64_t row)
{
    const uint64_t nl = row < 128 ? (uint64_t)(512 * row + 256) : 65536;
    const uint64_t sum = ((uint64_t)s->material.ambient_q16[0] << 16) + s->material.diffuse_q16[0] * nl;
    return (unsigned)((32 * sum + (UINT64_C(1) << 31)) >> 32);
}

/* In the machine's order. column: 0 where there is no highlight, else 1 and the column. */
static unsigned albedo_pixel(const struct look *s, const struct glint_tables *t, unsigned albedo, unsigned level,
                             uint32_t column)
{
    const uint32_t f = column ? f_at(s, middle(t->t_max_q30, t->shift, column - 1)) : 0;
    unsigned pixel = 0;
    for (int k = 0; k < 3; k++) {
        const unsigned max = k == 1 ? 63 : 31, at = k == 0 ? 11 : k == 1 ? 5 : 0;
        const unsigned sum = ((albedo >> at & max) * level + 16) / 32 + (column ? shine_level(s, k, f) : 0);
        pixel |= (sum < max ? sum : max) << at;
    }
    return pixel;
}

static unsigned wide_pixel(const struct look *s, const struct glint_tables *t, unsigned albedo, int64_t at, int64_t nl)
{
    const uint32_t column = nl >= 0 && at <= t->t_max_q30 ? 1 + (uint32_t)((t->t_max_q30 - at) >> t->shift) : 0;
    return albedo_pixel(s, t, albedo, nl < 0 ? (unsigned)t->dark : light_level(s, nl >> 23), column);
}

/* edge: how far from its place the highlight's end is. */
static unsigned int8_pixel(const struct look *s, const struct glint_tables *t, unsigned albedo, uint32_t word,
                           int64_t edge)
{
    const struct glint_vec l = s->l;
    const int64_t y_q10 = -((l.y + 16) >> 5), z_q10 = -((l.z + 16) >> 5), x_q18 = -8 * (int64_t)l.x - y_q10;
    const int64_t peak = (int64_t)root_of((square(l.x) + square(32 * y_q10) + square(32 * z_q10 - 32768)) << 20);
    uint64_t r = peak ? ((UINT64_C(1) << (51 - t->shift)) + (uint64_t)peak / 2) / (uint64_t)peak : 0;
    r = r < 1 ? 1 : r < UINT32_MAX ? r : UINT32_MAX;
    const int64_t cut = peak - (int64_t)((((uint64_t)t->t_max_q30 << 21) >> t->shift) / r) + edge;
    const int64_t x = (int8_t)word, v = (int16_t)word, z = (int16_t)(word >> 16);
    const int64_t d = x * x_q18 + v * y_q10 + z * z_q10, e = z * 1024 - cut - d;
    if (d >= 0)
        return albedo_pixel(s, t, albedo, t->dark, 0);
    const uint32_t column = e < 0 ? 0 : 1 + ((uint32_t)((uint64_t)e * r) >> 21);
    return albedo_pixel(s, t, albedo, light_level(s, -1 - (d >> 18)), column);
}

static int64_t int8_e(const struct glint_paint *paint, uint32_t word)
{
    const int64_t x = (int8_t)word, v = (int16_t)word, z = (int16_t)(word >> 16);
    return z * 1024 - paint->of.tables.cut - (x * paint->of.tables.x + v * paint->of.tables.y + z * paint->of.tables.z);
}

static void albedo_tables_draw_the_pixels_of_their_sequence(void **state)
{
    (void)state;
    for (int i = 0; i < 300; i++) {
        const struct look s = albedo_look();
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &s, memory);
        const struct glint_tables *t = &paint.of.tables.filled;
        assert_int_equal(t->t_max_q30, last_t(&s, shines));
        assert_int_equal(t->shift, least_shift(t->t_max_q30, 2032));
        assert_int_equal(t->dark, (32 * s.material.ambient_q16[0] + 32768) >> 16);
        const enum glint_normals format = (enum glint_normals)(i % 2);
        random_surface(&scene_normals, format, &s);
        uint16_t map[WIDE * LINES];
        for (int p = 0; p < WIDE * LINES; p++)
            map[p] = (uint16_t)below(65536);
        const int64_t edge = format == GLINT_NORMALS_INT8 && below(2) ? int8_e(&paint, scene_normals.word[1]) : 0;
        paint.of.tables.cut += (int32_t)edge;
        const struct glint_surface surface = any_surface(2 * WIDE);
        struct glint_maps maps = maps_of(&scene_normals, format);
        maps.albedo = (const uint8_t *)map;
        maps.albedo_stride = 2 * WIDE;
        maps.albedo_format = GLINT_RGB565;
        assert_int_equal(glint_draw_rect(&paint, &maps, WIDE, LINES, &surface, NULL), GLINT_OK);
        for (int p = 0; p < WIDE * LINES; p++) {
            const struct glint_vec n = scene_normals.vec[p];
            const unsigned wanted = format == GLINT_NORMALS_INT8
                                        ? int8_pixel(&s, t, map[p], scene_normals.word[p], edge)
                                        : wide_pixel(&s, t, map[p], t_of(n, s.h), dot(n, s.l));
            assert_pixel(&surface, p % WIDE, p / WIDE, in_order(&s, wanted), is_surface(n));
        }
        assert_guards(&surface, 2 * WIDE);
    }
}

static void albedo_spans_have_the_pixels_of_their_sequence(void **state)
{
    (void)state;
    for (int i = 0; i < 300; i++) {
        const struct look s = albedo_look();
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &s, memory);
        const struct glint_tables *tables = &paint.of.tables.filled;
        uint16_t map[WIDE];
        for (int p = 0; p < WIDE; p++)
            map[p] = (uint16_t)below(65536);
        const struct glint_span span = {below(tables->t_max_q30 + 9) - below(9),
                                        below(1u << 25) - (1u << 24),
                                        below(1u << 20),
                                        (int32_t)below(1u << 30),
                                        (int32_t)below(1u << 27) - (1 << 26),
                                        WIDE,
                                        {{0, 0}, {0, 0}}};
        const struct glint_surface surface = any_surface(2 * WIDE);
        const struct glint_maps maps = {.albedo = (const uint8_t *)map, .albedo_format = GLINT_RGB565};
        assert_int_equal(glint_draw_span(&paint, &span, &maps, &surface, NULL), GLINT_OK);
        uint32_t t = span.t_q30, dt = span.dt_q30, nl = (uint32_t)span.nl_q30;
        for (int x = 0; x < WIDE; x++) {
            const uint32_t at = t >= UINT32_C(0xf8000000) ? 0 : t;
            assert_pixel(&surface, x, 0, in_order(&s, wide_pixel(&s, tables, map[x], at, (int32_t)nl)), true);
            t += dt;
            dt += span.ddt_q30;
            nl += (uint32_t)span.dnl_q30;
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(colour_tables_hold_what_their_sequence_says),
        cmocka_unit_test(a_light_for_colour_tables_is_what_its_sequence_says),
        cmocka_unit_test(sixteen_bit_normals_over_colour_tables_have_the_pixels_of_their_sequence),
        cmocka_unit_test(albedo_tables_draw_the_pixels_of_their_sequence),
        cmocka_unit_test(albedo_spans_have_the_pixels_of_their_sequence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
