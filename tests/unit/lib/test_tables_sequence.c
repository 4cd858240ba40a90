/* SPDX-License-Identifier: MIT
 * Spans and packed normals by COLOUR tables, pixel by pixel as lib/sequence.md has it, without the loops' short cuts. */
#include "shading.h"

enum { WIDE = 319 };
static const uint16_t widths[] = {0, 1, 2, 3, 15, 16, 17, 31, 32, 33, 63, 64, 65, WIDE};
enum { WIDTHS = sizeof widths / sizeof *widths };
static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4];

static struct glint_shader prepare(struct glint_tables *tables, struct glint_tables_light *light)
{
    struct glint_shader shader = random_shader(GLINT_RGB565, GLINT_GAMMA);
    shader.dither = false;
    if (shader.lobe.model == GLINT_PHONG)
        shader.lobe.model = GLINT_MSH;
    assert_int_equal(glint_tables_fill(tables, GLINT_TABLES_COLOUR, &shader, memory, sizeof memory), GLINT_OK);
    assert_int_equal(glint_tables_light_init(light, tables, &shader.light), GLINT_OK);
    return shader;
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
    struct glint_span s = {0, (uint32_t)within((1 << 25) >> fine), below((1u << 20) >> fine),
                           0, within((1 << 25) >> fine),           w};
    s.nl_q30 = (int32_t)below(1u << 30);
    s.t_q30 = below(tables->t_max_q30 + (1u << 20));
    if (kind % 8 >= 5) { /* the lowest t at pixel k, or about */
        s.dt_q30 = 0 - k * s.ddt_q30;
        s.dnl_q30 >>= 6;
    }
    const uint32_t to_k = k * s.dt_q30 + k * (k - 1) / 2 * s.ddt_q30;
    switch (kind % 8) {
    case 0:
        return (struct glint_span){any_bits(), any_bits(), any_bits(), (int32_t)any_bits(), (int32_t)any_bits(), w};
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
        struct glint_tables tables;
        struct glint_tables_light light;
        (void)prepare(&tables, &light);
        for (unsigned kind = 0; kind < 8 * 40; kind++) {
            const uint16_t w = widths[below(WIDTHS)];
            const struct glint_span span = tricky_span(&tables, kind, w);
            uint16_t pixels[WIDE + 2];
            memset(pixels, GUARD, sizeof pixels);
            const uint16_t guard = pixels[0];
            uint8_t *start = (uint8_t *)(pixels + 1) - (kind % 3 == 0);
            const struct glint_surface surface = {start, 0, 0, 0};
            assert_int_equal(glint_tables_span(&tables, &span, &surface), GLINT_OK);
            uint32_t t = span.t_q30, dt = span.dt_q30, nl = (uint32_t)span.nl_q30;
            for (uint16_t x = 0; x < w; x++) {
                uint16_t found;
                memcpy(&found, start + 2 * x, 2);
                if (found != span_pixel(&tables, t, nl))
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

static int64_t int8_d(const struct glint_tables_light *light, uint32_t word)
{
    const int64_t x = (int8_t)word, v = (int16_t)word, z = (int16_t)(word >> 16);
    return x * light->x + v * light->y + z * light->z;
}

static int64_t int8_e(const struct glint_tables_light *light, uint32_t word)
{
    return int8_d(light, word) + (int64_t)(int16_t)(word >> 16) * (1 << 14) - light->cut;
}

static uint16_t int8_pixel(const struct glint_tables *tables, const struct glint_tables_light *light, uint32_t word)
{
    const int64_t d = int8_d(light, word), e = int8_e(light, word);
    if (d < 0)
        return tables->dark;
    if (e < 0)
        return without_highlight(tables, (uint32_t)(d >> 23));
    return colour_of(tables, (uint32_t)(d >> 23), (uint32_t)(e >> light->a) * light->r >> 20);
}

static int64_t int10_u(const struct glint_tables_light *light, uint32_t word)
{
    const int64_t x = 32 * (int64_t)((int32_t)word >> 22) - ((light->h.x + 1) >> 1);
    const int64_t y = 32 * (int64_t)((int32_t)(word << 10) >> 22) - ((light->h.y + 1) >> 1);
    const int64_t z = 8 * (int64_t)((int32_t)(word << 20) >> 20) - ((light->h.z + 1) >> 1);
    return x * x + y * y + z * z;
}

static int64_t int10_d(const struct glint_tables_light *light, uint32_t word)
{
    const int64_t z = (int32_t)(word << 20) >> 20;
    return light->peak - (light->peak >> 15) * (int10_u(light, word) >> 14) - z * (1 << 18);
}

static uint16_t int10_pixel(const struct glint_tables *tables, const struct glint_tables_light *light, uint32_t word)
{
    const int64_t u = int10_u(light, word), t = tables->t_max_q30 >> 1, d = int10_d(light, word);
    if (d < 0)
        return tables->dark;
    return u > t ? without_highlight(tables, (uint32_t)(d >> 23))
                 : colour_of(tables, (uint32_t)(d >> 23), (uint32_t)((t - u) >> (tables->shift - 1)));
}

/* One of the words comes to lie where the highlight ends, or where the light does, to the unit: 0 or one below. */
static void put_on_an_edge(struct glint_tables *tables, struct glint_tables_light *light, enum glint_normals format,
                           const uint32_t words[WIDE])
{
    const uint32_t word = words[below(WIDE)], u = (uint32_t)int10_u(light, word);
    const int32_t less = (int32_t)below(2);
    if (format == GLINT_NORMALS_INT8)
        light->cut += llabs(int8_e(light, word)) < 1 << 26 ? (int32_t)int8_e(light, word) + less : 0;
    else if (below(2) && 2 * u < tables->t_max_q30)
        tables->t_max_q30 = 2 * u - 2 * (uint32_t)less;
    else
        for (int k = 0; k < 9 && llabs(int10_d(light, word)) < 1 << 26; k++)
            light->peak -= (int32_t)int10_d(light, word) + less;
}

/* A line: normals about the highlight, some bits at random, some runs without surface. */
static void random_words(uint32_t words[WIDE], enum glint_normals format, const struct glint_light *light)
{
    for (int i = 0; i < WIDE; i++) {
        const struct glint_vec n = random_normal(light);
        words[i] = below(9) ? glint_normals_pack(format, &n) : any_bits();
        if (below(40) == 0)
            words[i] = below(12) << (format == GLINT_NORMALS_INT10 ? 12 : 0);
    }
}

static void packed_normals_have_the_pixels_of_their_sequence_at_every_width(void **state)
{
    (void)state;
    struct glint_tables tables;
    struct glint_tables_light light;
    struct glint_shader shader = prepare(&tables, &light);
    for (unsigned i = 0; i < 600; i++) {
        if (i % 20 == 19)
            shader = prepare(&tables, &light);
        const bool is_8 = i & 1;
        const enum glint_normals format = is_8 ? GLINT_NORMALS_INT8 : GLINT_NORMALS_INT10;
        uint32_t words[WIDE];
        uint16_t pixels[WIDE + 1];
        random_words(words, format, &shader.light);
        memset(pixels, GUARD, sizeof pixels);
        const uint16_t left = pixels[0], w = widths[below(WIDTHS)];
        const struct glint_surface surface = {pixels, 0, 0, 0};
        const struct glint_tables whole = tables;
        const struct glint_tables_light straight = light;
        if (i % 4 > 1)
            put_on_an_edge(&tables, &light, format, words);
        assert_int_equal(glint_tables_rect(&tables, &light, format, words, 0, w, 1, &surface), GLINT_OK);
        for (uint32_t x = 0, none = 0; x < w; x++) {
            if (none == 0 && (is_8 ? words[x] >> 16 : words[x] << 20) == 0)
                none = is_8 ? words[x] : words[x] >> 12, none += none == 0;
            const uint16_t wanted = none   ? left
                                    : is_8 ? int8_pixel(&tables, &light, words[x])
                                           : int10_pixel(&tables, &light, words[x]);
            if (pixels[x] != wanted)
                fail_msg("int%d, pixel %u of %d, word %#x", is_8 ? 8 : 10, (unsigned)x, w, (unsigned)words[x]);
            none -= none > 0;
        }
        assert_int_equal(pixels[w], left);
        tables = whole;
        light = straight;
    }
}

/* Too long, or with a half vector that belongs to another light. */
static struct glint_light made_by_hand(void)
{
    struct glint_light light = {{0, 0, 0}, {0, 0, 32767}, {0, 0, 0}};
    int16_t *const lh[] = {&light.l.x, &light.l.y, &light.l.z, &light.h.x, &light.h.y, &light.h.z};
    for (int k = 0; k < 6; k++)
        *lh[k] = (int16_t)(below(4) ? below(65536) - 32768 : 32767);
    if (below(2)) {
        light.l.x = INT16_MIN;
        light.l.y = INT16_MAX;
    } else {
        light.h.z = (int16_t)(-1100 - (int32_t)below(31000));
    }
    return light;
}

static void for_a_viewer_aside_or_a_light_made_by_hand_10_bit_normals_are_shaded_as_16_bit_ones(void **state)
{
    (void)state;
    static const int32_t aside[3] = {1, 2, 4}, to_light[3] = {-1, 1, 2};
    for (unsigned i = 0; i < 400; i++) {
        struct glint_tables tables;
        struct glint_tables_light light;
        struct glint_shader shader = prepare(&tables, &light);
        if (i % 10)
            shader.light = made_by_hand();
        else
            assert_int_equal(glint_light_init(&shader.light, to_light, aside), GLINT_OK);
        assert_int_equal(glint_tables_light_init(&light, &tables, &shader.light), GLINT_OK);
        uint32_t words[WIDE];
        struct glint_vec normals[WIDE];
        uint16_t of_10[WIDE], of_16[WIDE];
        random_words(words, GLINT_NORMALS_INT10, &shader.light);
        for (unsigned x = 0; x < WIDE; x++) {
            words[x] = x % 32 < 4 ? (4u - x % 32) << 12 : words[x] << 20 ? words[x] : 0; /* a gap of 4 */
            normals[x] = glint_normals_unpack(GLINT_NORMALS_INT10, words[x]);
        }
        memset(of_10, GUARD, sizeof of_10);
        memset(of_16, GUARD, sizeof of_16);
        const struct glint_surface to_10 = {of_10, 0, 0, 0}, to_16 = {of_16, 0, 0, 0};
        assert_int_equal(glint_tables_rect(&tables, &light, GLINT_NORMALS_INT10, words, 0, WIDE, 1, &to_10), GLINT_OK);
        assert_int_equal(glint_tables_rect(&tables, &light, GLINT_NORMALS_INT16, normals, 0, WIDE, 1, &to_16),
                         GLINT_OK);
        assert_memory_equal(of_10, of_16, sizeof of_10);
    }
}

/* nl 0: in each channel the ambient part is 2^-16 of a level below the next one. */
static void what_faces_away_has_the_ambient_light_alone(void **state)
{
    (void)state;
    struct glint_shader shader = random_shader(GLINT_RGB565, GLINT_GAMMA);
    glint_lobe_init(&shader.lobe, GLINT_MSH, 10, 6);
    shader.dither = false;
    for (unsigned level = 0; level < 31; level++) {
        static const uint32_t max[3] = {31, 63, 31};
        for (int k = 0; k < 3; k++) {
            shader.material.albedo[k] = 255;
            shader.material.ambient_q16[k] = ((2 * level + 1) * 65536 - 1) / (2 * max[k]); /* (level + 1/2) / max */
            shader.material.diffuse_q16[k] = 65536;
        }
        struct glint_tables tables;
        assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &shader, memory, sizeof memory), GLINT_OK);
        assert_int_equal(tables.dark, level << 11 | level << 5 | level);
    }
}

/* r of `light`: of a highlight of few columns under a light from behind. */
static void a_light_s_factor_is_held_to_32_bits(void **state)
{
    (void)state;
    struct glint_shader shader = random_shader(GLINT_RGB565, GLINT_GAMMA);
    glint_lobe_init(&shader.lobe, GLINT_MSH, 10, 6);
    shader.lobe.t_max_q30 = 100;
    shader.light = (struct glint_light){.l = {1, 0, -32768}, .v = {0, 0, 32767}, .h = {32767, 0, 0}};
    shader.dither = false;
    for (int k = 0; k < 3; k++) {
        shader.material.ambient_q16[k] = 6000;
        shader.material.diffuse_q16[k] = 40000;
        shader.material.specular_q16[k] = 65536;
    }
    for (int i = 0; i < 2; i++) {
        const enum glint_tables_kind kind = i ? GLINT_TABLES_ALBEDO : GLINT_TABLES_COLOUR;
        struct glint_tables tables;
        struct glint_tables_light light;
        assert_int_equal(glint_tables_fill(&tables, kind, &shader, memory, sizeof memory), GLINT_OK);
        assert_int_equal(glint_tables_light_init(&light, &tables, &shader.light), GLINT_OK);
        assert_int_equal(light.r, i ? UINT32_MAX : UINT32_C(1) << 31);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_span_has_the_pixels_of_its_sequence_whatever_its_steps_and_width),
        cmocka_unit_test(packed_normals_have_the_pixels_of_their_sequence_at_every_width),
        cmocka_unit_test(for_a_viewer_aside_or_a_light_made_by_hand_10_bit_normals_are_shaded_as_16_bit_ones),
        cmocka_unit_test(what_faces_away_has_the_ambient_light_alone),
        cmocka_unit_test(a_light_s_factor_is_held_to_32_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
