/* SPDX-License-Identifier: MIT
 * COLOUR tables: how far from the exact paint, what they may touch; packed normals; palettes. */
#include "run.h"
#include "tables_model.h"

enum { SIDE = 96, WALL = 256 };
static const char *const normals_names[] = {"int16", "int8"};

static struct glint_vec ball[SIDE * SIDE];
static uint32_t packed[SIDE * SIDE];
static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];

static void make_ball(void)
{
    for (int p = 0; p < SIDE * SIDE; p++) {
        const double x = (p % SIDE + .5) / SIDE * 2 - 1, y = 1 - (p / SIDE + .5) / SIDE * 2, r = x * x + y * y;
        const struct glint_vec none = {0, 0, 0};
        ball[p] = none;
        if (r < 1) {
            const int32_t v[3] = {(int32_t)(x * 1e6), (int32_t)(y * 1e6), (int32_t)(sqrt(1 - r) * 1e6)};
            assert_int_equal(glint_vec_normalize(&ball[p], v), GLINT_OK);
        }
    }
}

/* The middle of the rock wall, by the command. */
static void make_wall(void)
{
    assert_ends("$GLINT bake --height \"$GLINT_SOURCE/tests/data/rockwall-height.png\" --to int16 -o wall.bin", 0, "");
    FILE *file = fopen("wall.bin", "rb");
    assert_non_null(file);
    assert_int_equal(fseek(file, (long)(sizeof *ball * (WALL + 1) * (WALL - SIDE) / 2), SEEK_SET), 0);
    for (int y = 0; y < SIDE; y++) {
        assert_int_equal(fread(&ball[y * SIDE], sizeof *ball, SIDE, file), SIDE);
        assert_int_equal(fseek(file, (long)sizeof *ball * (WALL - SIDE), SEEK_CUR), 0);
    }
    fclose(file);
}

static struct look plain_look(uint16_t n, uint8_t q, enum glint_format format)
{
    struct look s;
    memset(&s, 0, sizeof s);
    set_model(&s, GLINT_MSH, n, q);
    static const int32_t to_light[3] = {3, 4, 5};
    assert_int_equal(look_light(&s, to_light, in_front), GLINT_OK);
    make_grey(&s, 3000, 30000);
    for (int k = 0; k < 3; k++) {
        s.material.specular_q16[k] = 32000;
        s.material.albedo[k] = 255;
    }
    s.output.format = (uint8_t)format;
    return s;
}

/* The ball's normals in a format, packed where they are. */
static struct glint_maps normals_in(enum glint_normals format)
{
    const bool is_8 = format == GLINT_NORMALS_INT8;
    for (int p = 0; p < SIDE * SIDE && is_8; p++)
        packed[p] = glint_normals_pack(format, &ball[p]);
    const struct glint_maps maps = {.normals = is_8 ? (const void *)packed : ball,
                                    .normals_stride = SIDE * (is_8 ? 4 : 6),
                                    .normals_format = (uint8_t)format};
    return maps;
}

static int channel(uint16_t pixel, int k)
{
    return k == 0 ? pixel >> 11 : k == 1 ? pixel >> 5 & 63 : pixel & 31;
}

/* Largest difference in steps of green (1/63), where normals were rounded, too, from the exact paint over INT16. */
static void differences(enum glint_normals format, uint16_t n, int *largest, double *mean)
{
    static uint16_t exact[SIDE * SIDE], fast[SIDE * SIDE];
    const struct look look = plain_look(n, 8, GLINT_RGB565);
    struct glint_paint paint;
    paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
    const struct glint_maps vectors = normals_in(GLINT_NORMALS_INT16), maps = normals_in(format);
    const struct glint_surface to_exact = {exact, 2 * SIDE, 0, 0}, to_fast = {fast, 2 * SIDE, 0, 0};
    assert_int_equal(draw_rect(&look, &vectors, SIDE, SIDE, &to_exact, NULL), GLINT_OK);
    memset(fast, GUARD, sizeof fast);
    assert_int_equal(glint_draw_rect(&paint, &maps, SIDE, SIDE, &to_fast, NULL), GLINT_OK);
    long sum = 0, count = 0;
    *largest = 0;
    for (int p = 0; p < SIDE * SIDE; p++) {
        if (!is_surface(ball[p])) {
            assert_int_equal(fast[p], GUARD << 8 | GUARD); /* left as it was */
            continue;
        }
        const int difference = abs(channel(exact[p], 1) - channel(fast[p], 1));
        *largest = difference > *largest ? difference : *largest;
        sum += difference;
        count++;
    }
    *mean = (double)sum / (double)count;
}

static void colour_tables_stay_within_their_documented_difference_from_the_exact_paint(void **state)
{
    (void)state;
    static const uint16_t shininess[4] = {10, 60, 200, 1000};
    static const int limits[2][4] = {{1, 1, 1, 1}, {2, 2, 4, 7}}; /* int8 differs by what its normals lost */
    for (int test = 0; test < 2 * 2 * 4; test++) {
        const int is_wall = test / 8, format = test / 4 % 2, i = test % 4;
        if (test % 8 == 0)
            is_wall ? make_wall() : make_ball();
        int largest;
        double mean;
        differences((enum glint_normals)format, shininess[i], &largest, &mean);
        if (largest > limits[format][i] || mean > .5)
            fail_msg("%s, %s, n = %u: largest %d steps of 63, mean %.3f", is_wall ? "wall" : "ball",
                     normals_names[format], (unsigned)shininess[i], largest, mean);
    }
}

static void a_packed_normal_keeps_its_direction_and_its_length(void **state)
{
    (void)state;
    make_ball();
    for (int p = 0; p < SIDE * SIDE; p++) {
        const uint32_t word = glint_normals_pack(GLINT_NORMALS_INT8, &ball[p]);
        const struct glint_vec back = glint_normals_unpack(GLINT_NORMALS_INT8, word);
        assert_in_range(abs(back.x - ball[p].x), 0, 256);
        assert_in_range(abs(back.y - ball[p].y), 0, 256);
        const double length = sqrt((double)dot(back, back)) / 32768;
        if (word && ball[p].z > 4000)
            assert_true(fabs(length - 1) < 2e-5);
    }
}

static int nearest_of(int value)
{
    const int rounded = (int)floor(value / 256. + .5);
    return rounded > 127 ? 127 : rounded < -127 ? -127 : rounded;
}

static void any_normal_is_packed_to_the_nearest_x_and_y_and_the_z_that_is_left(void **state)
{
    (void)state;
    static const struct glint_vec extremes[] = {{32767, 0, 0},  {-32768, 0, 1}, {0, 32767, -1},
                                                {0, -32768, 0}, {0, 0, -32768}, {32767, 32767, -32768},
                                                {0, 0, 32767},  {-1, 1, -32767}};
    const struct look look = plain_look(60, 8, GLINT_RGB565);
    for (int i = 0; i < 20000; i++) {
        struct glint_vec n = i < 8 ? extremes[i] : random_normal(&look);
        n.z = (int16_t)(i >= 8 && below(2) && n.z > INT16_MIN ? -n.z : n.z);
        const int x = nearest_of(n.x), y = nearest_of(n.y);
        const double left = 1073741824. - 65536. * (x * x + y * y);
        int z = (int)fmin(floor(sqrt(fmax(left, 0)) + .5), 32767);
        z = (n.z < 0 ? -1 : 1) * (z > 1 ? z : 1);
        const uint32_t word = glint_normals_pack(GLINT_NORMALS_INT8, &n);
        const uint32_t wanted = (uint32_t)z << 16 | ((uint32_t)(256 * y + x) & 65535);
        assert_int_equal(word, is_surface(n) ? wanted : 0);
        const struct glint_vec back = {(int16_t)(x * 256), (int16_t)(y * 256), (int16_t)z}, none = {0, 0, 0};
        const struct glint_vec found = glint_normals_unpack(GLINT_NORMALS_INT8, word);
        assert_memory_equal(&found, word ? &back : &none, sizeof back);
    }
}

static void what_cannot_be_packed_is_0_and_unpacks_to_no_surface(void **state)
{
    (void)state;
    static const struct glint_vec up = {0, 0, 32767}, none = {0, 0, 0};
    for (int format = 0; format < 5; format++) {
        const bool is_packed = format == GLINT_NORMALS_INT8;
        assert_int_equal(glint_normals_pack((enum glint_normals)format, &up) != 0, is_packed);
        assert_int_equal(glint_normals_pack((enum glint_normals)format, &none), 0);
        assert_int_equal(glint_normals_pack((enum glint_normals)format, NULL), 0);
        const struct glint_vec back = glint_normals_unpack((enum glint_normals)format, 0x7fff7fff);
        assert_int_equal(is_surface(back), is_packed);
    }
    static const uint32_t runs[] = {0, 1, 9, 0x7fff, 0x8000, 0xffff};
    for (int i = 0; i < 6; i++) {
        const struct glint_vec back = glint_normals_unpack(GLINT_NORMALS_INT8, runs[i]);
        assert_memory_equal(&back, &none, sizeof none);
    }
}

/* The rectangle cut anywhere, at any alignment, gives the same pixels as whole, and nothing around it is written. */
static void colour_tables_write_their_rectangle_and_nothing_else_at_any_alignment(void **state)
{
    (void)state;
    static const uint16_t widths[] = {0, 1, 2, 3, 95};
    make_ball();
    for (int i = 0; i < 300; i++) {
        const enum glint_format format = (enum glint_format)below(2);
        struct look look = random_look(format, GLINT_GAMMA);
        look.output.dither = i & 1;
        look.material.model = GLINT_MSH;
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
        struct glint_maps maps = normals_in((enum glint_normals)below(2));
        maps.normals = (const uint8_t *)maps.normals + 40 * maps.normals_stride;
        const uint16_t w = widths[below(5)], h = (uint16_t)below(5);
        const unsigned need = bytes_of(format, w), whole_need = bytes_of(format, SIDE);
        uint8_t *out = malloc((size_t)(need + 5) * 5 + 64), *whole = malloc((size_t)whole_need * 5 + 1);
        assert_true(out && whole);
        memset(out, GUARD, (size_t)(need + 5) * 5 + 64);
        memset(whole, GUARD, (size_t)whole_need * 5);
        const unsigned start = 1 + below(8), stride = need + below(6);
        const struct glint_surface surface = {out + start, (ptrdiff_t)stride, 0, 0};
        const struct glint_surface full = {whole, (ptrdiff_t)whole_need, 0, 0};
        assert_int_equal(glint_draw_rect(&paint, &maps, w, h, &surface, NULL), GLINT_OK);
        assert_int_equal(glint_draw_rect(&paint, &maps, SIDE, h, &full, NULL), GLINT_OK);
        for (size_t b = 0; b < (size_t)(need + 5) * 5 + 64; b++) {
            const ptrdiff_t at = (ptrdiff_t)b - (ptrdiff_t)start;
            const bool inside =
                stride && at >= 0 && at < (ptrdiff_t)(stride * h) && at % (ptrdiff_t)stride < (ptrdiff_t)need;
            if (!inside)
                assert_int_equal(out[b], GUARD);
            else
                assert_int_equal(out[b], whole[(size_t)at / stride * whole_need + (size_t)at % stride]);
        }
        free(out);
        free(whole);
    }
}

/* For the sanitizers: any words, any normals, any span; any light, from behind, too. */
static void garbage_in_normals_and_spans_reads_nothing_outside_the_tables(void **state)
{
    (void)state;
    for (int i = 0; i < 200; i++) {
        struct look look = tables_look((enum glint_format)below(2));
        look.output.dither = i & 1;
        const size_t bytes = glint_tables_bytes(GLINT_TABLES_COLOUR, look.output.dither);
        uint32_t *tight = malloc(bytes);
        assert_non_null(tight);
        if (i % 3) /* as near to straight behind as it may be */
            (void)look_light(&look, (const int32_t[]){(int32_t)below(9), (int32_t)below(9), -(1 << below(29))},
                             in_front);
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, tight);
        uint32_t words[300];
        for (int k = 0; k < 300; k++)
            words[k] = below(UINT32_MAX);
        uint16_t out[150];
        for (int at = 0; at < 2; at++) { /* at an odd address, too */
            const struct glint_surface surface = {(uint8_t *)out + at, 0, (uint16_t)below(4), (uint16_t)below(4)};
            for (int format = 0; format < 2; format++) {
                const struct glint_maps maps = {.normals = words, .normals_format = (uint8_t)format};
                const enum glint_err err = glint_draw_rect(&paint, &maps, 100, 1, &surface, NULL);
                assert_true(err == GLINT_OK || (err == GLINT_ERR_VECTOR && format == GLINT_NORMALS_INT8));
            }
            const struct glint_span span = {words[0],          words[1], words[2],        (int32_t)words[3],
                                            (int32_t)words[4], 149,      {{0, 0}, {0, 0}}};
            assert_int_equal(glint_draw_span(&paint, &span, NULL, &surface, NULL), GLINT_OK);
        }
        free(tight);
    }
}

static void a_span_by_tables_is_within_one_step_of_the_exact_span(void **state)
{
    (void)state;
    const struct look look = plain_look(60, 8, GLINT_RGB565);
    struct glint_paint paint;
    paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
    for (int i = 0; i < 500; i++) {
        const struct glint_vec first = random_normal(&look);
        struct glint_vec last = {(int16_t)(first.x / 2 + 6000), first.y, first.z};
        struct glint_span span;
        const int32_t v[3] = {last.x, last.y, last.z};
        if (glint_vec_normalize(&last, v) || glint_span_init(&span, &paint, &first, &last, (uint16_t)(1 + below(320))))
            continue;
        uint16_t exact[320], fast[321];
        const struct glint_surface to_exact = {exact, 0, 0, 0}, to_fast = {fast, 0, 0, 0};
        const struct glint_surface unaligned = {(uint8_t *)fast + 1, 0, 0, 0};
        assert_int_equal(draw_span(&look, &span, &to_exact, NULL), GLINT_OK);
        assert_int_equal(glint_draw_span(&paint, &span, NULL, &to_fast, NULL), GLINT_OK);
        for (int x = 0; x < span.w; x++)
            for (int k = 0; k < 3; k++)
                assert_in_range(abs(channel(exact[x], k) - channel(fast[x], k)), 0, 1);
        uint16_t aligned[320];
        memcpy(aligned, fast, sizeof aligned);
        assert_int_equal(glint_draw_span(&paint, &span, NULL, &unaligned, NULL), GLINT_OK);
        assert_memory_equal((uint8_t *)fast + 1, aligned, 2u * span.w);
    }
}

static void a_palette_gives_the_exact_pixels_of_its_normals(void **state)
{
    (void)state;
    make_ball();
    const struct look look = plain_look(60, 8, GLINT_RGB565);
    uint16_t colours[SIDE], offsets[SIDE], out[SIDE];
    const struct glint_maps maps = {.normals = ball + 40 * SIDE};
    const struct glint_surface to_palette = {colours, 0, 0, 0}, surface = {out, 0, 0, 0};
    memset(colours, 0, sizeof colours);
    assert_int_equal(draw_rect(&look, &maps, SIDE, 1, &to_palette, NULL), GLINT_OK);
    for (int i = 0; i < SIDE; i++)
        offsets[i] = (uint16_t)(2 * (SIDE - 1 - i));
    assert_int_equal(glint_draw_palette(colours, offsets, 0, SIDE, 1, &surface), GLINT_OK);
    for (int i = 0; i < SIDE; i++)
        assert_int_equal(out[i], colours[SIDE - 1 - i]);
}

/* Any width, at any stride, from the top or from the bottom; around it nothing is written. */
static void a_palette_is_looked_up_line_by_line(void **state)
{
    (void)state;
    enum { COLOURS = 300, WIDEST = 40, ROOM = 2 + LINES * (WIDEST + 3) };
    uint16_t colours[COLOURS], offsets[LINES * (WIDEST + 5)], out[ROOM];
    for (int i = 0; i < COLOURS; i++)
        colours[i] = (uint16_t)below(65536);
    for (size_t i = 0; i < sizeof offsets / sizeof *offsets; i++)
        offsets[i] = (uint16_t)(2 * below(COLOURS));
    for (uint16_t w = 0; w <= WIDEST; w++) {
        const ptrdiff_t from = WIDEST + (ptrdiff_t)below(5), to = w + (ptrdiff_t)below(3);
        const bool is_up = w % 2;
        uint16_t *first = out + 1 + (is_up ? (LINES - 1) * to : 0);
        const struct glint_surface surface = {first, is_up ? -2 * to : 2 * to, 0, 0};
        memset(out, GUARD, sizeof out);
        assert_int_equal(glint_draw_palette(colours, offsets, 2 * from, w, LINES, &surface), GLINT_OK);
        for (ptrdiff_t i = 0; i < ROOM; i++) {
            const ptrdiff_t at = i - 1, y = to ? at / to : LINES, x = to ? at % to : 0;
            const bool is_drawn = at >= 0 && y < LINES && x < w;
            const ptrdiff_t line = is_up ? LINES - 1 - y : y;
            assert_int_equal(out[i], is_drawn ? colours[offsets[line * from + x] / 2] : GUARD << 8 | GUARD);
        }
    }
}

static void a_run_without_surface_ends_with_the_line_whatever_it_says(void **state)
{
    (void)state;
    const struct look look = plain_look(60, 8, GLINT_RGB565);
    static const struct glint_vec up = {0, 0, 32767};
    uint32_t words[8];
    for (int i = 0; i < 8; i++)
        words[i] = glint_normals_pack(GLINT_NORMALS_INT8, &up);
    words[1] = 2;
    words[2] = 1;
    words[5] = 60000;
    words[6] = words[7] = 0;
    for (int exact = 0; exact < 2; exact++)
        for (int odd = 0; odd < 2; odd++) {
            struct glint_paint paint;
            uint16_t out[10];
            memset(out, GUARD, sizeof out);
            const uint16_t left = out[0];
            const struct glint_surface surface = {(uint8_t *)out + odd, 0, 0, 0};
            const struct glint_maps maps = {.normals = words, .normals_format = GLINT_NORMALS_INT8};
            if (exact)
                paint_of(&paint, &look);
            else
                paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
            assert_int_equal(glint_draw_rect(&paint, &maps, 8, 1, &surface, NULL), GLINT_OK);
            for (int i = 0; i < 9; i++) {
                const bool is_left = memcmp((uint8_t *)out + odd + 2 * i, &left, 2) == 0;
                assert_int_equal(is_left, i == 1 || i == 2 || i >= 5);
            }
        }
}

/* No promise is made of it, but that nothing else is read or written: for the sanitizers. */
static void a_run_that_says_more_than_there_is_does_no_harm(void **state)
{
    (void)state;
    struct look look = plain_look(60, 8, GLINT_RGB565);
    for (int i = 0; i < 200; i++) {
        struct glint_paint paint;
        const uint16_t w = (uint16_t)(1 + below(60));
        uint32_t *const words = malloc(w * sizeof *words);
        uint16_t *const out = malloc(w * sizeof *out);
        uint8_t *const coverage = malloc(w);
        assert_true(words && out && coverage);
        look.output.dither = i & 1;
        if (i % 3)
            paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
        else
            paint_of(&paint, &look);
        for (int x = 0; x < w; x++) {
            const struct glint_vec n = random_normal(&look);
            words[x] = below(4) ? glint_normals_pack(GLINT_NORMALS_INT8, &n) : below(below(2) ? 70 : 65536);
            coverage[x] = (uint8_t)below(2);
        }
        const struct glint_maps maps = {
            .normals = words, .normals_format = GLINT_NORMALS_INT8, .coverage = i % 5 ? NULL : coverage};
        struct glint_box box;
        const struct glint_surface surface = {out, 0, 0, 0};
        assert_int_equal(glint_draw_rect(&paint, &maps, w, 1, &surface, i & 2 ? &box : NULL), GLINT_OK);
        free(words);
        free(out);
        free(coverage);
    }
}

/* Diffuse light that at 1.0 is a unit, of 2^-16, below the next level of red, or just there. */
static void what_is_lit_by_more_than_1_has_the_exact_colour_of_1(void **state)
{
    (void)state;
    static const struct glint_vec longer = {32767, 32767, 32767};
    static const int32_t aslant[3] = {1, 1, 1};
    const struct glint_maps maps = {.normals = &longer};
    struct look look = random_look(GLINT_RGB565, GLINT_GAMMA);
    struct glint_paint exact, tables;
    set_model(&look, GLINT_MSH, 60, 8);
    look.output.dither = false;
    assert_int_equal(look_light(&look, aslant, in_front), GLINT_OK);
    memset(look.material.albedo, 255, sizeof look.material.albedo);
    memset(look.material.ambient_q16, 0, sizeof look.material.ambient_q16);
    memset(look.material.specular_q16, 0, sizeof look.material.specular_q16);
    for (uint32_t i = 2; i < 64; i++) {
        const uint32_t level = i / 2, reaches = i % 2;
        uint16_t by_exact = 0, by_tables = 0;
        const struct glint_surface first = {.pixels = &by_exact}, second = {.pixels = &by_tables};
        for (int k = 0; k < 3; k++)
            look.material.diffuse_q16[k] = ((2 * level - 1) * 32768 - 1) / 31 + reaches;
        paint_of(&exact, &look);
        paint_of_tables(&tables, GLINT_TABLES_COLOUR, &look, memory);
        assert_int_equal(glint_draw_rect(&exact, &maps, 1, 1, &first, NULL), GLINT_OK);
        assert_int_equal(glint_draw_rect(&tables, &maps, 1, 1, &second, NULL), GLINT_OK);
        assert_int_equal(by_exact >> 11, level - 1 + reaches);
        assert_int_equal(by_tables, by_exact);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(colour_tables_stay_within_their_documented_difference_from_the_exact_paint),
        cmocka_unit_test(what_is_lit_by_more_than_1_has_the_exact_colour_of_1),
        cmocka_unit_test(a_packed_normal_keeps_its_direction_and_its_length),
        cmocka_unit_test(any_normal_is_packed_to_the_nearest_x_and_y_and_the_z_that_is_left),
        cmocka_unit_test(what_cannot_be_packed_is_0_and_unpacks_to_no_surface),
        cmocka_unit_test(colour_tables_write_their_rectangle_and_nothing_else_at_any_alignment),
        cmocka_unit_test(garbage_in_normals_and_spans_reads_nothing_outside_the_tables),
        cmocka_unit_test(a_span_by_tables_is_within_one_step_of_the_exact_span),
        cmocka_unit_test(a_palette_gives_the_exact_pixels_of_its_normals),
        cmocka_unit_test(a_palette_is_looked_up_line_by_line),
        cmocka_unit_test(a_run_without_surface_ends_with_the_line_whatever_it_says),
        cmocka_unit_test(a_run_that_says_more_than_there_is_does_no_harm),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
