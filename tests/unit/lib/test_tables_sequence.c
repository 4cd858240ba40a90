/* SPDX-License-Identifier: MIT
 * Spans and INT8 normals by COLOUR tables, pixel by pixel as lib/sequence.md has it, without the loops' short cuts. */
#include "tables_model.h"

enum { LONG = 319 };
static const uint16_t widths[] = {0, 1, 2, 3, 15, 16, 17, 31, 32, 33, 63, 64, 65, LONG};
enum { WIDTHS = sizeof widths / sizeof *widths };
static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4];

static struct look any_paint(struct glint_paint *paint)
{
    struct look look = random_look(GLINT_RGB565, GLINT_GAMMA);
    look.output.dither = false;
    if (look.material.model == GLINT_PHONG)
        look.material.model = GLINT_MSH;
    paint_of_tables(paint, GLINT_TABLES_COLOUR, &look, memory);
    return look;
}

static uint16_t colour_of(const struct glint_tables *tables, uint32_t row, uint32_t column)
{
    assert_in_range(row, 0, 127);
    assert_in_range(column, 0, 4095);
    return tables->colour.colours[64 * row + tables->columns[column] / 2u];
}

static uint16_t without_highlight(const struct glint_tables *tables, uint32_t row)
{
    assert_in_range(row, 0, 127);
    return tables->colour.colours[64 * row];
}

static uint16_t span_pixel(const struct glint_tables *tables, uint32_t t, uint32_t nl)
{
    if (nl >= UINT32_C(0x80000000))
        return tables->dark;
    if (t >= UINT32_C(0xf8000000))
        t = 0;
    return t > tables->t_max_q30 ? without_highlight(tables, nl >> 24)
                                 : colour_of(tables, nl >> 24, (tables->t_max_q30 - t) >> tables->shift);
}

static uint32_t any_bits(void)
{
    return below(65536) << 16 | below(65536);
}

static int32_t within(int32_t limit)
{
    return (int32_t)below(2 * (uint32_t)limit + 1) - limit;
}

/* What loops might get wrong: t at t_max or 0 to the unit, and nl at 0, at a pixel in the middle; steps about the largest
 * that the loops take for small; anything. */
static struct glint_span tricky_span(const struct glint_tables *tables, unsigned kind, uint16_t w)
{
    const uint32_t k = below(w + 1u), fine = 1 + below(16);
    struct glint_span s = {0,
                           (uint32_t)within((1 << 25) >> fine),
                           below((1u << 20) >> fine),
                           0,
                           within((1 << 25) >> fine),
                           w,
                           {{0, 0}, {0, 0}}};
    s.nl_q30 = (int32_t)below(1u << 30);
    s.t_q30 = below(tables->t_max_q30 + (1u << 20));
    if (kind % 8 >= 5) { /* the lowest t at pixel k, or about */
        s.dt_q30 = 0 - k * s.ddt_q30;
        s.dnl_q30 >>= 6;
    }
    const uint32_t to_k = k * s.dt_q30 + k * (k - 1) / 2 * s.ddt_q30;
    switch (kind % 8) {
    case 0:
        return (struct glint_span){any_bits(),          any_bits(), any_bits(),      (int32_t)any_bits(),
                                   (int32_t)any_bits(), w,          {{0, 0}, {0, 0}}};
    case 1:
        s.dt_q30 = (uint32_t)within(1 << (24 + fine % 6));
        s.ddt_q30 = below(1u << (10 + fine));
        s.dnl_q30 = within(1 << (24 + fine % 6));
        s.t_q30 = below(1u << 31);
        s.nl_q30 = (int32_t)any_bits();
        break;
    case 2:
    case 5:
        s.t_q30 = tables->t_max_q30 + (uint32_t)within(1) - to_k;
        break;
    case 3:
        s.nl_q30 = within(1) - (int32_t)(k * (uint32_t)s.dnl_q30);
        break;
    case 6:
        s.t_q30 = (uint32_t)within(3) - to_k;
        break;
    case 7: /* to the end of what is a little below 0 */
        s.t_q30 = UINT32_C(0xf8000000) + (uint32_t)within(1) - to_k;
    }
    return s;
}

static void a_span_has_the_pixels_of_its_sequence_whatever_its_steps_and_width(void **state)
{
    (void)state;
    for (unsigned i = 0; i < 40; i++) {
        struct glint_paint paint;
        (void)any_paint(&paint);
        const struct glint_tables *tables = &paint.of.tables.filled;
        for (unsigned kind = 0; kind < 8 * 40; kind++) {
            const uint16_t w = widths[below(WIDTHS)];
            const struct glint_span span = tricky_span(tables, kind, w);
            uint16_t pixels[LONG + 2];
            memset(pixels, GUARD, sizeof pixels);
            const uint16_t guard = pixels[0];
            uint8_t *start = (uint8_t *)(pixels + 1) - (kind % 3 == 0);
            const struct glint_surface surface = {start, 0, 0, 0};
            assert_int_equal(glint_draw_span(&paint, &span, NULL, &surface, NULL), GLINT_OK);
            uint32_t t = span.t_q30, dt = span.dt_q30, nl = (uint32_t)span.nl_q30;
            for (uint16_t x = 0; x < w; x++) {
                uint16_t found;
                memcpy(&found, start + 2 * x, 2);
                if (found != span_pixel(tables, t, nl))
                    fail_msg("kind %u, pixel %d of %d: t %#x, nl %#x", kind % 8, x, w, (unsigned)t, (unsigned)nl);
                t += dt;
                dt += span.ddt_q30;
                nl += (uint32_t)span.dnl_q30;
            }
            assert_memory_equal(start + 2 * w, &guard, 2);
            assert_int_equal(*(uint8_t *)pixels, GUARD);
        }
    }
}

static int64_t int8_d(const struct glint_paint *paint, uint32_t word)
{
    const int64_t x = (int8_t)word, v = (int16_t)word, z = (int16_t)(word >> 16);
    return x * paint->of.tables.x + v * paint->of.tables.y + z * paint->of.tables.z;
}

static int64_t int8_e(const struct glint_paint *paint, uint32_t word)
{
    return int8_d(paint, word) + (int64_t)(int16_t)(word >> 16) * (1 << 14) - paint->of.tables.cut;
}

static uint16_t int8_pixel(const struct glint_paint *paint, uint32_t word)
{
    const struct glint_tables *tables = &paint->of.tables.filled;
    const int64_t d = int8_d(paint, word), e = int8_e(paint, word);
    if (d < 0)
        return tables->dark;
    if (e < 0)
        return without_highlight(tables, (uint32_t)(d >> 23));
    return colour_of(tables, (uint32_t)(d >> 23), (uint32_t)(e >> paint->of.tables.a) * paint->of.tables.r >> 20);
}

/* A line: normals about the highlight, some bits at random, some runs without surface, which say how long they are, or less. */
static void random_words(uint32_t words[LONG], const struct look *look)
{
    for (uint32_t i = 0, none = 0; i < LONG; i++) {
        const struct glint_vec n = random_normal(look);
        words[i] = below(9) ? glint_normals_pack(GLINT_NORMALS_INT8, &n) : any_bits() | 1 << 16;
        if (none == 0 && below(40) == 0)
            none = below(12);
        if (none)
            words[i] = below(2) ? none-- : below(none--);
    }
}

static void packed_normals_have_the_pixels_of_their_sequence_at_every_width(void **state)
{
    (void)state;
    struct glint_paint whole;
    struct look look = any_paint(&whole);
    for (unsigned i = 0; i < 600; i++) {
        if (i % 20 == 19)
            look = any_paint(&whole);
        struct glint_paint paint = whole;
        uint32_t words[LONG];
        uint16_t pixels[LONG + 2];
        random_words(words, &look);
        memset(pixels, GUARD, sizeof pixels);
        const uint16_t left = pixels[0], w = widths[below(WIDTHS)];
        uint8_t *const start = (uint8_t *)(pixels + 1) - (i % 5 == 0);
        const struct glint_surface surface = {start, 0, 0, 0};
        const struct glint_maps maps = {.normals = words, .normals_format = GLINT_NORMALS_INT8};
        if (i % 4 > 1) { /* one of the words comes to lie where the highlight ends, to the unit: 0 or one below */
            const int64_t e = int8_e(&paint, words[below(LONG)]);
            paint.of.tables.cut += llabs(e) < 1 << 26 ? (int32_t)e + (int32_t)below(2) : 0;
        }
        assert_int_equal(glint_draw_rect(&paint, &maps, w, 1, &surface, NULL), GLINT_OK);
        for (uint32_t x = 0; x < w; x++) {
            const uint16_t wanted = words[x] >> 16 ? int8_pixel(&paint, words[x]) : left;
            uint16_t found;
            memcpy(&found, start + 2 * x, 2);
            if (found != wanted)
                fail_msg("%u, pixel %u of %d, word %#x", i, (unsigned)x, w, (unsigned)words[x]);
        }
        assert_memory_equal(start + 2 * w, &left, 1);
    }
}

/* nl 0: in each channel the ambient part is 2^-16 of a level below the next one. */
static void what_faces_away_has_the_ambient_light_alone(void **state)
{
    (void)state;
    struct look look = random_look(GLINT_RGB565, GLINT_GAMMA);
    set_model(&look, GLINT_MSH, 10, 6);
    look.output.dither = false;
    for (unsigned level = 0; level < 31; level++) {
        static const uint32_t max[3] = {31, 63, 31};
        for (int k = 0; k < 3; k++) {
            look.material.albedo[k] = 255;
            look.material.ambient_q16[k] = ((2 * level + 1) * 65536 - 1) / (2 * max[k]); /* (level + 1/2) / max */
            look.material.diffuse_q16[k] = 65536;
        }
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
        assert_int_equal(paint.of.tables.filled.dark, level << 11 | level << 5 | level);
    }
}

/* r of `light` under one nearly straight behind: of a highlight of few columns it would need more bits. */
static void a_light_s_factor_is_held_to_32_bits(void **state)
{
    (void)state;
    static const int32_t behind[3] = {1, 0, -32768};
    struct look look = random_look(GLINT_RGB565, GLINT_GAMMA);
    set_model(&look, GLINT_MSH, 1000, 1);
    look.output.dither = false;
    assert_int_equal(look_light(&look, behind, in_front), GLINT_OK);
    make_grey(&look, 6000, 40000);
    for (int k = 0; k < 3; k++)
        look.material.specular_q16[k] = 65536;
    for (int i = 0; i < 2; i++) {
        struct glint_paint paint;
        paint_of_tables(&paint, i ? GLINT_TABLES_ALBEDO : GLINT_TABLES_COLOUR, &look, memory);
        paint.of.tables.filled.t_max_q30 = 100;
        paint.of.tables.filled.shift = i ? 6 : 5;
        assert_int_equal(glint_paint_light(&paint, &look.light, 1, in_front), GLINT_OK);
        assert_int_equal(paint.of.tables.r, i ? UINT32_MAX : UINT32_C(1) << 31);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_span_has_the_pixels_of_its_sequence_whatever_its_steps_and_width),
        cmocka_unit_test(packed_normals_have_the_pixels_of_their_sequence_at_every_width),
        cmocka_unit_test(what_faces_away_has_the_ambient_light_alone),
        cmocka_unit_test(a_light_s_factor_is_held_to_32_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
