/* SPDX-License-Identifier: MIT
 * Table loops: how far from the exact path, what they may touch. */
#include "run.h"
#include "shading.h"

enum { SIDE = 96, WALL = 256 };
static const char *const kind_names[] = {"colour", "small"};
static const char *const normals_names[] = {"int16", "int10", "int8"};

static struct glint_vec ball[SIDE * SIDE];
static uint32_t packed[SIDE * SIDE];
static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4 + 1];

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

static struct glint_shader plain_shader(uint32_t n, unsigned q, enum glint_format format)
{
    struct glint_shader s;
    memset(&s, 0, sizeof s);
    glint_lobe_init(&s.lobe, GLINT_MSH, n, q);
    static const int32_t to_light[3] = {3, 4, 5}, to_viewer[3] = {0, 0, 1};
    assert_int_equal(glint_light_init(&s.light, to_light, to_viewer), GLINT_OK);
    for (int k = 0; k < 3; k++) {
        s.material.ambient_q16[k] = 3000;
        s.material.diffuse_q16[k] = 30000;
        s.material.specular_q16[k] = 32000;
        s.material.albedo[k] = 255;
    }
    s.format = (uint8_t)format;
    return s;
}

/* The normals of a format, packed where they are. */
static const void *normals_in(enum glint_normals format, ptrdiff_t *stride)
{
    if (format == GLINT_NORMALS_INT16) {
        *stride = SIDE * (ptrdiff_t)sizeof *ball;
        return ball;
    }
    for (int p = 0; p < SIDE * SIDE; p++)
        packed[p] = glint_normals_pack(format, &ball[p]);
    *stride = SIDE * (ptrdiff_t)sizeof *packed;
    return packed;
}

static int channel(uint16_t pixel, int k)
{
    return k == 0 ? pixel >> 11 : k == 1 ? pixel >> 5 & 63 : pixel & 31;
}

/* Largest difference in steps of green (1/63) where normals were rounded, and of the format, from the exact path. */
static void differences(enum glint_tables_kind kind, enum glint_normals format, uint32_t n, int *largest, double *mean)
{
    static uint16_t exact[SIDE * SIDE], fast[SIDE * SIDE];
    const struct glint_shader shader = plain_shader(n, 8, GLINT_RGB565);
    struct glint_tables tables;
    struct glint_tables_light light;
    assert_int_equal(glint_tables_fill(&tables, kind, &shader, memory, glint_tables_bytes(kind)), GLINT_OK);
    assert_int_equal(glint_tables_light_init(&light, &tables, &shader.light), GLINT_OK);
    const struct glint_source source = {.normals = ball, .normals_stride = SIDE * (ptrdiff_t)sizeof *ball};
    const struct glint_surface to_exact = {exact, 2 * SIDE, 0, 0}, to_fast = {fast, 2 * SIDE, 0, 0};
    assert_int_equal(glint_shade_rect(&shader, &source, SIDE, SIDE, &to_exact, NULL), GLINT_OK);
    memset(fast, GUARD, sizeof fast);
    ptrdiff_t stride;
    const void *normals = normals_in(format, &stride);
    assert_int_equal(glint_tables_rect(&tables, &light, format, normals, stride, SIDE, SIDE, &to_fast), GLINT_OK);
    long sum = 0, count = 0;
    *largest = 0;
    for (int p = 0; p < SIDE * SIDE; p++) {
        if (!(ball[p].x | ball[p].y | ball[p].z)) {
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

static void each_loop_stays_within_its_documented_difference_from_the_exact_path(void **state)
{
    (void)state;
    static const uint32_t shininess[4] = {10, 60, 200, 1000};
    /* steps of 63; int8 and int10 differ by what their normals lost */
    static const int limits[2][3][4] = {{{1, 1, 1, 1}, {1, 1, 2, 2}, {2, 2, 4, 7}},
                                        {{2, 2, 2, 2}, {2, 2, 3, 3}, {3, 3, 4, 7}}};
    for (int test = 0; test < 2 * 2 * 3 * 4; test++) {
        const int is_wall = test / 24, kind = test / 12 % 2, format = test / 4 % 3, i = test % 4;
        if (test % 24 == 0)
            is_wall ? make_wall() : make_ball();
        int largest;
        double mean;
        differences((enum glint_tables_kind)kind, (enum glint_normals)format, shininess[i], &largest, &mean);
        if (largest > limits[kind][format][i] || mean > .5)
            fail_msg("%s, %s, %s, n = %u: largest %d steps of 63, mean %.3f", is_wall ? "wall" : "ball",
                     kind_names[kind], normals_names[format], (unsigned)shininess[i], largest, mean);
    }
}

static void a_packed_normal_keeps_its_direction_and_its_length(void **state)
{
    (void)state;
    make_ball();
    for (int format = GLINT_NORMALS_INT10; format <= GLINT_NORMALS_INT8; format++)
        for (int p = 0; p < SIDE * SIDE; p++) {
            const uint32_t word = glint_normals_pack((enum glint_normals)format, &ball[p]);
            const struct glint_vec back = glint_normals_unpack((enum glint_normals)format, word);
            const int step = format == GLINT_NORMALS_INT8 ? 256 : 64;
            assert_in_range(abs(back.x - ball[p].x), 0, step);
            assert_in_range(abs(back.y - ball[p].y), 0, step);
            const double length = sqrt((double)dot(back, back)) / 32768;
            if (word && ball[p].z > 4000)
                assert_true(fabs(length - 1) < (format == GLINT_NORMALS_INT8 ? 2e-5 : 6e-4));
        }
}

/* The rectangle cut anywhere, at any alignment, gives the same pixels as whole, and nothing around it is written. */
static int nearest_of(int value, int step, int most)
{
    const int rounded = (int)floor((double)value / step + .5);
    return rounded > most ? most : rounded < -most ? -most : rounded;
}

static void any_normal_is_packed_to_the_nearest_x_and_y_and_the_z_that_is_left(void **state)
{
    (void)state;
    static const struct glint_vec extremes[] = {{32767, 0, 0},  {-32768, 0, 1}, {0, 32767, -1},
                                                {0, -32768, 0}, {0, 0, -32768}, {32767, 32767, -32768},
                                                {0, 0, 32767},  {-1, 1, -32767}};
    const struct glint_shader shader = plain_shader(60, 8, GLINT_RGB565);
    for (int i = 0; i < 20000; i++) {
        struct glint_vec n = i < 8 ? extremes[i] : random_normal(&shader.light);
        n.z = (int16_t)(i >= 8 && below(2) && n.z > INT16_MIN ? -n.z : n.z);
        for (int is_8 = 0; is_8 < 2; is_8++) {
            const int step = is_8 ? 256 : 64, most = is_8 ? 127 : 511, z_step = is_8 ? 1 : 16;
            const int x = nearest_of(n.x, step, most), y = nearest_of(n.y, step, most);
            const double left = 1073741824. - (double)step * step * (x * x + y * y);
            int z = nearest_of((int)floor(sqrt(fmax(left, 0)) + .5), z_step, 32768 / z_step - 1);
            z = (n.z < 0 ? -1 : 1) * (z > 1 ? z : 1);
            const uint32_t word = glint_normals_pack(is_8 ? GLINT_NORMALS_INT8 : GLINT_NORMALS_INT10, &n);
            const uint32_t wanted = is_8 ? (uint32_t)z << 16 | ((uint32_t)(256 * y + x) & 65535)
                                         : (uint32_t)x << 22 | ((uint32_t)y & 1023) << 12 | ((uint32_t)z & 4095);
            assert_int_equal(word, n.x | n.y | n.z ? wanted : 0);
            const struct glint_vec back = {(int16_t)(x * step), (int16_t)(y * step), (int16_t)(z * z_step)},
                                   none = {0, 0, 0};
            const struct glint_vec found = glint_normals_unpack(is_8 ? GLINT_NORMALS_INT8 : GLINT_NORMALS_INT10, word);
            assert_memory_equal(&found, word ? &back : &none, sizeof back);
        }
    }
}

static void what_cannot_be_packed_is_0_and_unpacks_to_no_surface(void **state)
{
    (void)state;
    static const struct glint_vec up = {0, 0, 32767}, none = {0, 0, 0};
    for (int format = 0; format < 5; format++) {
        const bool is_packed = format == GLINT_NORMALS_INT10 || format == GLINT_NORMALS_INT8;
        assert_int_equal(glint_normals_pack((enum glint_normals)format, &up) != 0, is_packed);
        assert_int_equal(glint_normals_pack((enum glint_normals)format, &none), 0);
        const struct glint_vec back = glint_normals_unpack((enum glint_normals)format, 0x7fff7fff);
        assert_int_equal((back.x | back.y | back.z) != 0, is_packed);
    }
    static const uint32_t runs[] = {0, 1, 9, 0x7fff};
    for (int i = 0; i < 4; i++) {
        const struct glint_vec of_8 = glint_normals_unpack(GLINT_NORMALS_INT8, runs[i]);
        const struct glint_vec of_10 = glint_normals_unpack(GLINT_NORMALS_INT10, runs[i] << 12);
        assert_memory_equal(&of_8, &none, sizeof none);
        assert_memory_equal(&of_10, &none, sizeof none);
    }
}

static void tables_write_their_rectangle_and_nothing_else_at_any_alignment(void **state)
{
    (void)state;
    static const uint16_t widths[] = {0, 1, 2, 3, 95};
    make_ball();
    for (int i = 0; i < 300; i++) {
        const enum glint_tables_kind kind = (enum glint_tables_kind)(i & 1);
        const enum glint_format format =
            kind == GLINT_TABLES_COLOUR ? (enum glint_format)below(2) : format_number(below(GLINT_FORMAT_COUNT));
        struct glint_shader shader = random_shader(format, GLINT_GAMMA);
        shader.dither = kind == GLINT_TABLES_SMALL && shader.dither;
        shader.lobe.model = GLINT_MSH;
        struct glint_tables tables;
        struct glint_tables_light light;
        assert_int_equal(glint_tables_fill(&tables, kind, &shader, memory, sizeof memory), GLINT_OK);
        assert_int_equal(glint_tables_light_init(&light, &tables, &shader.light), GLINT_OK);
        const enum glint_normals held = (enum glint_normals)below(3);
        ptrdiff_t normals_stride;
        const char *normals = normals_in(held, &normals_stride);
        const uint16_t w = widths[below(5)], h = (uint16_t)below(5);
        const unsigned need = bytes_of(format, w), whole_need = bytes_of(format, SIDE);
        uint8_t *out = malloc((size_t)(need + 5) * 5 + 64), *whole = malloc((size_t)whole_need * 5 + 1);
        assert_true(out && whole);
        memset(out, GUARD, (size_t)(need + 5) * 5 + 64);
        memset(whole, GUARD, (size_t)whole_need * 5);
        const unsigned start = 1 + below(8), stride = need + below(6);
        const char *first = normals + 40 * normals_stride;
        const struct glint_surface surface = {out + start, (ptrdiff_t)stride, 0, 0};
        const struct glint_surface full = {whole, (ptrdiff_t)whole_need, 0, 0};
        assert_int_equal(glint_tables_rect(&tables, &light, held, first, normals_stride, w, h, &surface), GLINT_OK);
        assert_int_equal(glint_tables_rect(&tables, &light, held, first, normals_stride, SIDE, h, &full), GLINT_OK);
        for (size_t b = 0; b < (size_t)(need + 5) * 5 + 64; b++) {
            const ptrdiff_t at = (ptrdiff_t)b - (ptrdiff_t)start;
            const bool inside =
                stride && at >= 0 && at < (ptrdiff_t)(stride * h) && at % (ptrdiff_t)stride < (ptrdiff_t)need;
            if (!inside)
                assert_int_equal(out[b], GUARD);
            else if (format != GLINT_MONO)
                assert_int_equal(out[b], whole[(size_t)at / stride * whole_need + (size_t)at % stride]);
        }
        free(out);
        free(whole);
    }
}

/* For the sanitizers: any words, any light, any normals, any span. */
static void garbage_in_normals_and_spans_reads_nothing_outside_the_tables(void **state)
{
    (void)state;
    uint32_t *tight = malloc(GLINT_TABLES_COLOUR_BYTES);
    assert_non_null(tight);
    for (int i = 0; i < 200; i++) {
        const enum glint_tables_kind kind = (enum glint_tables_kind)(i & 1);
        struct glint_shader shader = random_shader(GLINT_RGB565, GLINT_GAMMA);
        shader.dither = false;
        shader.lobe.model = (uint8_t)below(3);
        int16_t *lvh = (int16_t *)(void *)&shader.light;
        for (int k = 0; k < 9 && i % 3; k++) /* by hand: any light, any half vector, for a viewer in front */
            lvh[k] = k / 3 == 1 ? lvh[k] : (int16_t)(below(65536) - 32768);
        uint32_t *small = malloc(GLINT_TABLES_SMALL_BYTES);
        struct glint_tables tables;
        struct glint_tables_light light;
        assert_int_equal(glint_tables_fill(&tables, kind, &shader, kind ? small : tight, glint_tables_bytes(kind)),
                         GLINT_OK);
        assert_int_equal(glint_tables_light_init(&light, &tables, &shader.light), GLINT_OK);
        uint32_t words[300];
        for (int k = 0; k < 300; k++)
            words[k] = below(UINT32_MAX);
        uint16_t out[150];
        const struct glint_surface surface = {out, 0, 0, 0};
        for (int format = 0; format < 3; format++) {
            const enum glint_err error =
                glint_tables_rect(&tables, &light, (enum glint_normals)format, words, 0, 100, 1, &surface);
            if (error != GLINT_ERR_VECTOR || format != GLINT_NORMALS_INT8 || !(i % 3))
                assert_int_equal(error, GLINT_OK);
        }
        const struct glint_span span = {words[0], words[1], words[2], (int32_t)words[3], (int32_t)words[4], 150};
        assert_int_equal(glint_tables_span(&tables, &span, &surface), GLINT_OK);
        free(small);
    }
    free(tight);
}

static void a_span_by_tables_is_within_one_step_of_the_exact_span(void **state)
{
    (void)state;
    const struct glint_shader shader = plain_shader(60, 8, GLINT_RGB565);
    struct glint_tables tables;
    assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &shader, memory, sizeof memory), GLINT_OK);
    for (int i = 0; i < 500; i++) {
        const struct glint_vec first = random_normal(&shader.light);
        struct glint_vec last = {(int16_t)(first.x / 2 + 6000), first.y, first.z};
        struct glint_span span;
        const int32_t v[3] = {last.x, last.y, last.z};
        if (glint_vec_normalize(&last, v) ||
            glint_span_init(&span, &shader.light, &first, &last, (uint16_t)(1 + below(320))))
            continue;
        uint16_t exact[320], fast[321];
        const struct glint_surface to_exact = {exact, 0, 0, 0}, to_fast = {fast, 0, 0, 0};
        const struct glint_surface unaligned = {(uint8_t *)fast + 1, 0, 0, 0};
        assert_int_equal(glint_shade_span(&shader, &span, &to_exact, NULL), GLINT_OK);
        assert_int_equal(glint_tables_span(&tables, &span, &to_fast), GLINT_OK);
        for (int x = 0; x < span.w; x++)
            for (int k = 0; k < 3; k++)
                assert_in_range(abs(channel(exact[x], k) - channel(fast[x], k)), 0, 1);
        uint16_t aligned[320];
        memcpy(aligned, fast, sizeof aligned);
        assert_int_equal(glint_tables_span(&tables, &span, &unaligned), GLINT_OK);
        assert_memory_equal((uint8_t *)fast + 1, aligned, 2u * span.w);
    }
}

static void a_palette_gives_the_exact_pixels_of_its_normals(void **state)
{
    (void)state;
    make_ball();
    const struct glint_shader shader = plain_shader(60, 8, GLINT_RGB565);
    uint16_t colours[SIDE], offsets[SIDE], out[SIDE];
    const struct glint_source source = {.normals = ball + 40 * SIDE, .normals_stride = 0};
    const struct glint_surface to_palette = {colours, 0, 0, 0}, surface = {out, 0, 0, 0};
    memset(colours, 0, sizeof colours);
    assert_int_equal(glint_shade_rect(&shader, &source, SIDE, 1, &to_palette, NULL), GLINT_OK);
    for (int i = 0; i < SIDE; i++)
        offsets[i] = (uint16_t)(2 * (SIDE - 1 - i));
    assert_int_equal(glint_palette_rect(colours, offsets, 0, SIDE, 1, &surface), GLINT_OK);
    for (int i = 0; i < SIDE; i++)
        assert_int_equal(out[i], colours[SIDE - 1 - i]);
}

/* Any width, at any stride, from the top or from the bottom; around it nothing is written. */
static void a_palette_is_looked_up_line_by_line(void **state)
{
    (void)state;
    enum { COLOURS = 300, WIDEST = 40, LINES = 3, ROOM = 2 + LINES * (WIDEST + 3) };
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
        assert_int_equal(glint_palette_rect(colours, offsets, 2 * from, w, LINES, &surface), GLINT_OK);
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
    const struct glint_shader shader = plain_shader(60, 8, GLINT_RGB565);
    struct glint_tables tables;
    struct glint_tables_light light;
    assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &shader, memory, sizeof memory), GLINT_OK);
    assert_int_equal(glint_tables_light_init(&light, &tables, &shader.light), GLINT_OK);
    static const struct glint_vec up = {0, 0, 32767};
    uint32_t words[8];
    for (int i = 0; i < 8; i++)
        words[i] = glint_normals_pack(GLINT_NORMALS_INT8, &up);
    words[1] = 2;
    words[5] = 60000;
    uint16_t out[9];
    memset(out, GUARD, sizeof out);
    const uint16_t left = out[0];
    const struct glint_surface surface = {out, 0, 0, 0};
    assert_int_equal(glint_tables_rect(&tables, &light, GLINT_NORMALS_INT8, words, 0, 8, 1, &surface), GLINT_OK);
    for (int i = 0; i < 9; i++)
        assert_int_equal(out[i] == left, i == 1 || i == 2 || i >= 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_loop_stays_within_its_documented_difference_from_the_exact_path),
        cmocka_unit_test(a_packed_normal_keeps_its_direction_and_its_length),
        cmocka_unit_test(any_normal_is_packed_to_the_nearest_x_and_y_and_the_z_that_is_left),
        cmocka_unit_test(what_cannot_be_packed_is_0_and_unpacks_to_no_surface),
        cmocka_unit_test(tables_write_their_rectangle_and_nothing_else_at_any_alignment),
        cmocka_unit_test(garbage_in_normals_and_spans_reads_nothing_outside_the_tables),
        cmocka_unit_test(a_span_by_tables_is_within_one_step_of_the_exact_span),
        cmocka_unit_test(a_palette_gives_the_exact_pixels_of_its_normals),
        cmocka_unit_test(a_palette_is_looked_up_line_by_line),
        cmocka_unit_test(a_run_without_surface_ends_with_the_line_whatever_it_says),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
