/* SPDX-License-Identifier: MIT
 * Soft edges: step 8 over what the buffer holds, for every coverage and every level there, beside a model in 128 bits. Pixels of any
 * normals, maps and lights are held to the sequence by tier exact. */
#include "shading.h"

enum { SIDE = 256, MOST_BYTES = 4 };
static uint8_t coverage[SIDE * SIDE], before[SIDE * SIDE * MOST_BYTES], found[SIDE * SIDE * MOST_BYTES],
    full[SIDE * SIDE * MOST_BYTES];
static struct glint_vec normals[SIDE * SIDE];
static uint32_t words[SIDE * SIDE];
static uint16_t albedo[SIDE * SIDE];

enum source { RECT_INT16, RECT_INT8, SPAN, LIGHTS, SOURCES };

/* Column m is covered by m; line q holds level q of each channel, or their largest. */
static void square(enum glint_format format)
{
    for (unsigned q = 0; q < SIDE; q++)
        for (unsigned m = 0; m < SIDE; m++) {
            const unsigned i = SIDE * q + m, r = q & 31, g = q & 63;
            coverage[i] = (uint8_t)m;
            if (format <= GLINT_RGB565_SWAPPED) {
                const unsigned pixel = r << 11 | g << 5 | r, swapped = format == GLINT_RGB565_SWAPPED;
                before[2 * i + swapped] = (uint8_t)pixel;
                before[2 * i + !swapped] = (uint8_t)(pixel >> 8);
            } else if (pixel_bits(format) < 8) {
                const unsigned bits = pixel_bits(format), level = q & ((1u << bits) - 1);
                before[i * bits / 8] = (uint8_t)(level * (255 / ((1u << bits) - 1)));
            } else {
                const unsigned bytes = bytes_of(format, 1);
                for (unsigned k = 0; k < bytes; k++)
                    before[bytes * i + k] = (uint8_t)q;
            }
        }
}

static void draw(const struct look *look, enum source source, const uint8_t *covered, uint8_t *out)
{
    struct glint_paint paint;
    const ptrdiff_t stride = (ptrdiff_t)bytes_of((enum glint_format)look->output.format, SIDE);
    const struct glint_surface surface = {out, stride, 1, 2};
    struct glint_light lights[2] = {look->light, look->light};
    struct glint_maps maps = {.normals = source == RECT_INT8 ? (const void *)words : normals,
                              .normals_stride = SIDE * (source == RECT_INT8 ? 4 : 6),
                              .normals_format = source == RECT_INT8 ? GLINT_NORMALS_INT8 : GLINT_NORMALS_INT16,
                              .coverage = covered,
                              .coverage_stride = SIDE};
    memcpy(out, before, (size_t)stride * SIDE);
    paint_of(&paint, look);
    if (source == LIGHTS) {
        lights[1].color_q16[0] = 9000; /* channels apart */
        assert_int_equal(glint_paint_light(&paint, lights, 2, look->to_viewer), GLINT_OK);
    }
    if (source != SPAN) {
        assert_int_equal(glint_draw_rect(&paint, &maps, SIDE, SIDE, &surface, NULL), GLINT_OK);
        return;
    }
    const struct glint_span span = {.t_q30 = 1u << 29, .nl_q30 = 1 << 29, .w = SIDE};
    for (unsigned y = 0; y < SIDE; y++) {
        const struct glint_surface line = {out + stride * (ptrdiff_t)y, stride, 1, (uint16_t)(2 + y)};
        maps.coverage = covered ? covered + SIDE * y : NULL;
        assert_int_equal(glint_draw_span(&paint, &span, &maps, &line, NULL), GLINT_OK);
    }
}

/* The value, over 65535 2^32, that a look without diffuse and specular has everywhere: steps 4 to 7. */
static uint64_t value_of(const struct look *look, unsigned k)
{
    uint64_t x[3];
    for (unsigned i = 0; i < 3; i++)
        x[i] = (look->output.space == GLINT_LINEAR ? glint_srgb_decode(look->material.albedo[i])
                                                   : look->material.albedo[i] * 257u) *
               ((uint64_t)look->material.ambient_q16[i] << 16);
    const uint64_t value =
        is_grey((enum glint_format)look->output.format) ? (54 * x[0] + 183 * x[1] + 19 * x[2]) >> 8 : x[k];
    return look->output.space == GLINT_GAMMA
               ? value
               : (uint64_t)glint_srgb_encode((uint16_t)((value + (UINT64_C(1) << 31)) >> 32)) << 32;
}

static void assert_square_is_blended(const struct look *look)
{
    const enum glint_format format = (enum glint_format)look->output.format;
    const unsigned stride = bytes_of(format, SIDE);
    const u128 one = (u128)65535 << 32;
    for (unsigned i = 0; i < SIDE * SIDE; i++) {
        unsigned old[3], now[3];
        const unsigned x = i % SIDE, y = i / SIDE, m = format == GLINT_ARGB8888 && x ? 255 : x;
        const unsigned threshold =
            look->output.dither ? 2 * (unsigned)bayer[4 * ((y + 2) & 3) + ((x + 1) & 3)] + 1 : 16;
        stored_levels(format, before + stride * y, x, old);
        stored_levels(format, found + stride * y, x, now);
        for (unsigned k = 0; k < 3; k++) {
            const unsigned max = max_of(format, k);
            const u128 sum = m * (u128)value_of(look, k) * max + (255 - m) * (u128)old[k] * one;
            const unsigned wanted = (unsigned)((sum + 255 * one / 32 * threshold) / (255 * one));
            if (now[k] != wanted)
                fail_msg("format %d, coverage %u over %u: %u, not %u", format, m, old[k], now[k], wanted);
        }
        if (format == GLINT_ARGB8888 && x)
            assert_int_equal(found[stride * y + 4 * x + 3], x);
    }
}

static struct look look_of(enum glint_format format, enum glint_space space, bool dither)
{
    struct look look = random_look(format, space);
    look.output.dither = dither;
    for (unsigned k = 0; k < 3; k++) {
        look.material.ambient_q16[k] = below(4) ? below(65537) : 65536 * below(2);
        look.material.albedo[k] = (uint8_t)(below(4) ? below(256) : 255);
    }
    return look;
}

static void every_coverage_is_blended_over_every_level_in_every_format_and_space(void **state)
{
    (void)state;
    for (unsigned i = 0; i < GLINT_FORMAT_COUNT * 2 * 2 * SOURCES; i++) {
        const enum glint_format format = (enum glint_format)(i / 4 / SOURCES);
        struct look look = look_of(format, (enum glint_space)(i & 1), i >> 1 & 1);
        const enum source source = (enum source)(i / 4 % SOURCES);
        if (format != GLINT_RGB565 && source != (enum source)((format + i) % SOURCES))
            continue; /* each format by one source a space, to save time */
        if (look.material.model == GLINT_PHONG)
            look.material.model = GLINT_CAYLEY;
        for (unsigned k = 0; k < 3; k++)
            look.material.diffuse_q16[k] = look.material.specular_q16[k] = 0;
        for (unsigned p = 0; p < SIDE * SIDE; p++) {
            normals[p] = random_normal(&look);
            words[p] = glint_normals_pack(GLINT_NORMALS_INT8, &normals[p]) | 1u << 16;
        }
        square(format);
        draw(&look, source, coverage, found);
        assert_square_is_blended(&look);
    }
}

/* Lit, with highlight. */
static void full_coverage_is_no_coverage_map_and_none_leaves_every_byte(void **state)
{
    (void)state;
    for (unsigned i = 0; i < GLINT_FORMAT_COUNT * 4; i++) {
        const enum glint_format format = (enum glint_format)(i / 4);
        const struct look look = look_of(format, (enum glint_space)(i & 1), i >> 1 & 1);
        const size_t bytes = (size_t)bytes_of(format, SIDE) * SIDE;
        for (unsigned p = 0; p < SIDE * SIDE; p++)
            normals[p] = random_normal(&look);
        square(format);
        memset(coverage, 255, sizeof coverage);
        draw(&look, RECT_INT16, coverage, found);
        draw(&look, RECT_INT16, NULL, full);
        assert_memory_equal(found, full, bytes);
        memset(coverage, 0, sizeof coverage);
        draw(&look, RECT_INT16, coverage, found);
        assert_memory_equal(found, before, bytes);
    }
}

static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];

static void tables_draw(const struct glint_paint *paint, enum source source, bool is_albedo, const uint8_t *covered,
                        uint8_t *out)
{
    const struct glint_surface surface = {out, 2 * SIDE, 3, 1};
    struct glint_maps maps = {.normals = source == RECT_INT8 ? (const void *)words : normals,
                              .normals_stride = SIDE * (source == RECT_INT8 ? 4 : 6),
                              .normals_format = source == RECT_INT8 ? GLINT_NORMALS_INT8 : GLINT_NORMALS_INT16,
                              .albedo = is_albedo ? (const uint8_t *)albedo : NULL,
                              .albedo_stride = 2 * SIDE,
                              .albedo_format = GLINT_RGB565,
                              .coverage = covered,
                              .coverage_stride = SIDE};
    memcpy(out, before, 2 * SIDE * SIDE);
    if (source != SPAN) {
        struct glint_box box;
        assert_int_equal(glint_draw_rect(paint, &maps, SIDE, SIDE, &surface, covered && below(2) ? &box : NULL),
                         GLINT_OK);
        return;
    }
    const struct glint_span span = {.t_q30 = 1u << 27,
                                    .dt_q30 = 0u - (1u << 19),
                                    .ddt_q30 = 1 << 13,
                                    .nl_q30 = 1 << 29,
                                    .dnl_q30 = 1 << 20,
                                    .w = SIDE};
    for (unsigned y = 0; y < SIDE; y++) {
        const struct glint_surface line = {out + 2 * SIDE * y, 0, 3, (uint16_t)(1 + y)};
        maps.coverage = covered ? covered + SIDE * y : NULL;
        maps.albedo = is_albedo ? (const uint8_t *)(albedo + SIDE * y) : NULL;
        assert_int_equal(glint_draw_span(paint, &span, &maps, &line, NULL), GLINT_OK);
    }
}

/* Some are full or left out side by side, as in a mask. */
static void mask_shuffle(void)
{
    for (unsigned i = 0; i < SIDE * SIDE;) {
        const unsigned end = i + 1 + below(40), kind = below(3);
        for (; i < end && i < SIDE * SIDE; i++)
            coverage[i] = kind == 0 ? 255 : kind == 1 ? 0 : coverage[i];
    }
}

static void pixels_of_tables_are_blended_from_their_finished_levels(void **state)
{
    (void)state;
    for (unsigned i = 0; i < 36; i++) {
        const bool is_albedo = i % 3 == 2, dither = i % 3 == 1;
        const enum source source = (enum source)(i / 3 % 3);
        struct look look = random_look(i & 1 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED, GLINT_GAMMA);
        struct glint_paint paint;
        look.output.dither = dither;
        if (look.material.model == GLINT_PHONG)
            look.material.model = GLINT_MSH;
        for (unsigned k = 0; k < 3 && is_albedo; k++) {
            look.material.ambient_q16[k] = 6000;
            look.material.diffuse_q16[k] = 50000;
        }
        assert_int_equal(
            glint_paint_tables(&paint, is_albedo ? GLINT_TABLES_ALBEDO : GLINT_TABLES_COLOUR, &look.material,
                               &look.output, memory,
                               glint_tables_bytes(is_albedo ? GLINT_TABLES_ALBEDO : GLINT_TABLES_COLOUR, dither)),
            GLINT_OK);
        assert_int_equal(glint_paint_light(&paint, &look.light, 1, look.to_viewer), GLINT_OK);
        for (unsigned p = 0; p < SIDE * SIDE; p++) {
            do
                normals[p] = random_normal(&look);
            while (t_of(normals[p], (struct glint_vec){0, 0, 0}) >> 29 != 1); /* unit vectors, as tables want them */
            words[p] = below(9) ? glint_normals_pack(GLINT_NORMALS_INT8, &normals[p]) : 0;
            albedo[p] = (uint16_t)below(65536);
        }
        square((enum glint_format)look.output.format);
        if (i >= 18)
            mask_shuffle();
        tables_draw(&paint, source, is_albedo, NULL, full);
        tables_draw(&paint, source, is_albedo, coverage, found);
        for (unsigned p = 0; p < SIDE * SIDE; p++) {
            unsigned old[3], now[3], finished[3];
            stored_levels((enum glint_format)look.output.format, before, p, old);
            stored_levels((enum glint_format)look.output.format, found, p, now);
            stored_levels((enum glint_format)look.output.format, full, p, finished);
            for (unsigned k = 0; k < 3; k++)
                assert_int_equal(now[k], (coverage[p] * finished[k] + (255u - coverage[p]) * old[k] + 127) / 255);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_coverage_is_blended_over_every_level_in_every_format_and_space),
        cmocka_unit_test(full_coverage_is_no_coverage_map_and_none_leaves_every_byte),
        cmocka_unit_test(pixels_of_tables_are_blended_from_their_finished_levels),
    };
    return cmocka_run_group_tests_name("coverage", tests, NULL, NULL);
}
