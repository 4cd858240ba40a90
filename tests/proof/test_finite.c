/* SPDX-License-Identifier: MIT
 * What is finite is run whole: every mantissa of the reciprocal, of MSH's quotient and of the root's inverse, every fraction of Gauss's power;
 * every sum of a blended pixel, every place between four texels, every slope of an outline; every line of a few pixels that coverage cuts into runs.
 * The bounds are those of contracts.py, from which the proofs show the rest; finite.h is printed by cut.py, library.h by library.py. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmocka.h>

#include "library.h" /* all of lib/ */

#include "finite.h"

typedef __int128 i128;
static const uint32_t first_m = UINT32_C(1) << 27, end_m = UINT32_C(1) << 28;

static void reciprocals_of_every_mantissa_are_within_their_bounds(void **state)
{
    (void)state;
    long wrong = 0;
    uint32_t largest = 0;
#pragma omp parallel for reduction(+ : wrong) reduction(max : largest)
    for (uint32_t m = first_m; m < end_m; m++) {
        const int64_t y = glint_reciprocal(m), one = INT64_C(1) << 58;
        wrong += y < 1 << 29 || (m + INT64_C(1)) * y > one + RECIPROCAL_HIGH || m * y < one - RECIPROCAL_LOW;
        largest = largest > (uint32_t)y ? largest : (uint32_t)y;
    }
    printf("# largest reciprocal 2^31 + %d\n", (int)(largest - (UINT32_C(1) << 31)));
    assert_int_equal(wrong, 0);
    assert_true(largest <= (UINT32_C(1) << 31) + 15);
}

/* |p - 2^20 P| <= 1.1, 1 + P = 2^70 / (m y)^2: times 10 (m y)^2. */
static void factors_of_mshs_quotient_are_within_their_bounds_for_every_mantissa(void **state)
{
    (void)state;
    long wrong = 0;
#pragma omp parallel for reduction(+ : wrong)
    for (uint32_t m = first_m; m < end_m; m++) {
        uint32_t y;
        int32_t p;
        cut(m, &y, &p);
        const i128 my = (i128)m * y, z = my * my, error = 10 * (((1 << 20) + (i128)p) * z - ((i128)1 << 90));
        wrong += y < 128 || y > 254 || p < -QUOTIENT_P || p > QUOTIENT_P || error > 11 * z || error < -11 * z;
    }
    assert_int_equal(wrong, 0);
}

static void squares_of_every_mantissas_inverse_are_within_their_bounds(void **state)
{
    (void)state;
    long wrong = 0;
#pragma omp parallel for reduction(+ : wrong)
    for (uint32_t m = first_m; m < end_m; m++) {
        const uint32_t f = ggx_square(m);
        const i128 square = (i128)m * m, error = f * square - ((i128)1 << 85);
        wrong += f > GGX_SQUARE_MOST || error >= GGX_SQUARE_ERROR * square || error <= -GGX_SQUARE_ERROR * square;
    }
    assert_int_equal(wrong, 0);
}

/* 2^-(x / 2^27) = 2^-(j / 512) e^z, x = 2^18 j - y, z = y ln 2 / 2^27 < 0.0014: five terms are good to 2^-53, double's products to 2^-49. */
static void powers_of_two_are_within_their_bounds_for_every_argument(void **state)
{
    (void)state;
    const double low = 1 - FRACTION_LOW * 0x1p-32, high = 1 + FRACTION_HIGH * 0x1p-32;
    long wrong = 0;
#pragma omp parallel for reduction(+ : wrong)
    for (uint32_t x = 0; x < UINT32_C(1) << 27; x++) {
        const double z = (double)((UINT32_C(1) << 18) - (x & 0x3ffff)) * (0.69314718055994530942 * 0x1p-27);
        const double true_value =
            (double)root_powers[x >> 18] * 0x1p-32 * (1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4))));
        const double value = glint_exp2_near(x);
        wrong += !(value > true_value * low && value < true_value * high);
    }
    assert_int_equal(wrong, 0);
}

/* Of a mantissa A whose floor is a, 2^46 / sqrt(A) is between those of a and a + 1; double is good to 2^-20 of what is asked. */
static void inverses_of_the_root_of_every_mantissa_are_within_their_bounds(void **state)
{
    (void)state;
    const double one = 0x1p46, margin = 0x1p-10;
    long wrong = 0;
#pragma omp parallel for reduction(+ : wrong)
    for (uint32_t top = UINT32_C(1) << 14; top < UINT32_C(1) << 16; top++) {
        if (wrong)
            continue;
        double root = sqrt((double)(top << 16));
        for (uint32_t rest = 0; rest <= 0xffff; rest++) {
            const uint32_t a = top << 16 | rest, r = unit_inverse(a);
            const double next = sqrt((double)a + 1);
            wrong += r < UINT32_C(1) << 30 || r >= UINT32_C(1) << 31 ||
                     (r + INVERSE_LOW) * root <= one + margin * root ||
                     (r - INVERSE_HIGH) * next >= one - margin * next;
            root = next;
        }
    }
    assert_int_equal(wrong, 0);
}

/* Longer ones are the words' claim of GLINT_UNIT_GROWS. */
static void short_vectors_that_are_off_by_1_are_off_by_what_grows(void **state)
{
    (void)state;
    enum { LONGEST = 7, SIDE = 2 * LONGEST + 1 };
    long checked = 0;
    for (int i = 0; i < SIDE * SIDE * SIDE * 27; i++) {
        const int32_t v[3] = {i % SIDE - LONGEST, i / SIDE % SIDE - LONGEST, i / SIDE / SIDE % SIDE - LONGEST};
        const int off = i / (SIDE * SIDE * SIDE);
        const int32_t w[3] = {v[0] + off % 3 - 1, v[1] + off / 3 % 3 - 1, v[2] + off / 9 - 1};
        struct glint_unit unit;
        int32_t other[3];
        if (!glint_unit_near(&unit, v) || !glint_unit_q30(other, w))
            continue;
        for (int k = 0; k < 3; k++)
            assert_true(llabs((int64_t)unit.unit_q30[k] - other[k]) <=
                        GLINT_UNIT_SLACK + ((int64_t)GLINT_UNIT_GROWS << unit.up));
        checked++;
    }
    assert_true(checked > 90000);
}

/* Of pixels that are blended: every sum that step 8 divides is below (65535 + 1) 255 255 (sequence.md). */
static void quotients_of_blended_sums_are_rounded_down(void **state)
{
    (void)state;
    const uint32_t one = 255 * UINT32_C(65535), end = 255 * (one + 65535);
    long wrong = 0;
#pragma omp parallel for reduction(+ : wrong)
    for (uint32_t whole = 0; whole <= end / one; whole++)
        for (uint32_t rest = 0; rest < one && whole * one + rest <= end; rest++)
            wrong += coverage_divide(whole * one + rest) != whole;
    assert_int_equal(wrong, 0);
}

/* One texel of the four is not black: no weight is negative, and nothing leaks from a field into another. */
static void four_texels_are_weighed_field_by_field(void **state)
{
    (void)state;
    static const unsigned shift[3] = {11, 5, 0}, most[3] = {31, 63, 31}, field[3] = {11, 21, 0};
    uint32_t places = 0;
    for (uint32_t i = 0; i < 32 * 32; i++) {
        const uint32_t x = i % 32, y = i / 32, both = (x * y + 16) >> 5;
        const int32_t weights[4] = {(int32_t)(32 + both) - (int32_t)(x + y), (int32_t)x - (int32_t)both,
                                    (int32_t)y - (int32_t)both, (int32_t)both};
        int32_t sum = 0;
        for (unsigned k = 0; k < 4; k++) {
            assert_true(weights[k] >= 0);
            sum += weights[k];
            for (unsigned all = 1; all < 8; all++) {
                uint32_t colour = 0, expected = 0;
                for (unsigned c = 0; c < 3; c++) {
                    const uint32_t level = all >> c & 1 ? most[c] : 0;
                    colour |= level << shift[c];
                    expected |= (level * (uint32_t)weights[k] + 16) >> 5 << field[c];
                }
                uint16_t pixels[4] = {0, 0, 0, 0};
                pixels[k] = (uint16_t)colour;
                const struct glint_mesh_picture picture = {(const uint8_t *)pixels, NULL, 2, 2};
                /* 2 texels a side: their first is at 0, and 2^31 is the next */
                assert_int_equal(glint_mesh_smooth_fields(&picture, x << 26, y << 26), expected);
            }
        }
        assert_int_equal(sum, 32);
        places += both <= x && both <= y;
    }
    assert_int_equal(places, 32 * 32);
}

/* 65536 length of the side's rise, and what the walk's step is off over all of it: with what offsets cut off it is at most 1/16 pixel.
 * Of a side with this length along its longer axis, from 0, 0. */
static bool is_near_its_side(int32_t along, int32_t across)
{
    static const uint16_t face[3] = {0, 1, 2};
    static const struct glint_mesh mesh = {.faces = face, .vertex_count = 3, .face_count = 1};
    static const struct glint_mesh_window all = {-4096, -4096, 4096, 4096};
    const bool is_flat = (across < 0 ? -across : across) < along;
    struct glint_mesh_vertex vertices[3] = {{0}};
    struct glint_mesh_rim rim;
    vertices[1].x = (int16_t)(is_flat ? along : across);
    vertices[1].y = (int16_t)(is_flat ? across : along);
    const struct glint_mesh_drawn drawn = {.mesh = &mesh, .vertices = vertices};
    if (!glint_mesh_rim_set(&rim, &drawn, 0, 0, &all))
        return along < 9; /* no middle of a pixel lies along it */
    const int64_t off = (int64_t)rim.step * along - (int64_t)65536 * across;
    return rim.at == 0 && rim.end == (along + 7) >> 4 && rim.e == (rim.step >> 4) * 8 && rim.step <= 65537 &&
           rim.step >= -65537 && off <= 65536 - 16 * 15 && off >= -(65536 - 16 * 15);
}

static void outlines_of_every_slope_stay_within_a_sixteenth_of_a_pixel(void **state)
{
    (void)state;
    long wrong = 0;
#pragma omp parallel for schedule(dynamic, 64) reduction(+ : wrong)
    for (int32_t along = 1; along < 32767; along++)
        for (int32_t across = -along; across <= along; across++)
            wrong += !is_near_its_side(along, across);
    assert_int_equal(wrong, 0);
}

/* ---- The walk over coverage and gaps ---- */

enum { WALK_MOST = 9 };

/* Of a pixel: 0 is nothing, 1 in part, 2 in full; where words have gaps, 3 and more have no surface. */
static bool walk_draws(unsigned kind)
{
    return kind == 1 || kind == 2;
}

/* A line of w pixels of these kinds, as drawn from its first one on: are its runs what a pixel at a time finds? Behind its coverage and its words
 * no memory can be read. */
static bool walk_is_right(const uint8_t *kinds, unsigned w, unsigned most, uint8_t *coverage, uint32_t *words)
{
    const struct glint_maps maps = {.coverage = coverage, .normals = words, .normals_format = GLINT_NORMALS_INT8};
    const struct glint_surface surface = {words, 0, 0, 0};
    static const struct glint_paint paint;
    struct glint_lines lines = {.maps = &maps,
                                .target = &surface,
                                .soft = &glint_use_coverage,
                                .paint = &paint,
                                .w = w,
                                .most = (uint16_t)most,
                                .has_gaps = words};
    unsigned x = 0;
    for (unsigned i = 0; i < w; i++) {
        coverage[i] = (uint8_t)(kinds[i] % 3 == 1 ? 1 + 253 * (i & 1) : kinds[i] % 3 == 2 ? 255 : 0);
        if (words)
            words[i] = (uint32_t)(kinds[i] < 3) << 16;
    }
    for (glint_lines_set(&lines, 0); glint_lines_next(&lines); lines.run.x += lines.count) {
        unsigned count = 0;
        while (x < w && !walk_draws(kinds[x]))
            x++;
        while (x + count < w && count < most && walk_draws(kinds[x + count]) && kinds[x + count] == kinds[x])
            count++;
        if (lines.run.x != x || lines.count != count || !count || (lines.run.soft == NULL) != (kinds[x] == 2))
            return false;
        x += count;
    }
    while (x < w && !walk_draws(kinds[x]))
        x++;
    return x == w;
}

/* Two pages, of which only the first one can be read: its end. */
static uint8_t *walk_memory(void)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    uint8_t *const at = mmap(NULL, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_true(at != MAP_FAILED && !mprotect(at + page, page, PROT_NONE));
    return at + page;
}

/* Every line of up to `longest` pixels of so many kinds, at each of `places` places from memory's end. */
static long walks_wrong(unsigned kind_count, unsigned longest, unsigned places, bool has_words)
{
    uint8_t *const coverage = walk_memory(), *const words = walk_memory(), kinds[WALK_MOST] = {0};
    long wrong = 0;
    for (unsigned w = 1; w <= longest; w++) {
        unsigned long count = 1;
        for (unsigned i = 0; i < w; i++)
            count *= kind_count;
        for (unsigned long line = 0; line < count; line++) {
            unsigned long rest = line;
            for (unsigned i = 0; i < w; i++, rest /= kind_count)
                kinds[i] = (uint8_t)(rest % kind_count);
            for (unsigned place = 0; place < places; place++)
                for (unsigned most = 2; most <= GLINT_RUN; most += GLINT_RUN - 2)
                    wrong += !walk_is_right(kinds, w, most, coverage - w - place,
                                            has_words ? (uint32_t *)(void *)words - w : NULL);
        }
    }
    return wrong;
}

static void runs_of_every_line_of_nine_pixels_or_less_are_those_that_its_coverage_asks_for(void **state)
{
    (void)state;
    assert_int_equal(walks_wrong(3, WALK_MOST, 4, false), 0);
}

static void runs_of_every_line_of_six_pixels_or_less_end_where_there_is_no_surface(void **state)
{
    (void)state;
    assert_int_equal(walks_wrong(6, 6, 4, true), 0);
}

/* With an argument, the tests of that name: wildcards may be in it. */
int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reciprocals_of_every_mantissa_are_within_their_bounds),
        cmocka_unit_test(powers_of_two_are_within_their_bounds_for_every_argument),
        cmocka_unit_test(inverses_of_the_root_of_every_mantissa_are_within_their_bounds),
        cmocka_unit_test(short_vectors_that_are_off_by_1_are_off_by_what_grows),
        cmocka_unit_test(factors_of_mshs_quotient_are_within_their_bounds_for_every_mantissa),
        cmocka_unit_test(squares_of_every_mantissas_inverse_are_within_their_bounds),
        cmocka_unit_test(quotients_of_blended_sums_are_rounded_down),
        cmocka_unit_test(four_texels_are_weighed_field_by_field),
        cmocka_unit_test(outlines_of_every_slope_stay_within_a_sixteenth_of_a_pixel),
        cmocka_unit_test(runs_of_every_line_of_nine_pixels_or_less_are_those_that_its_coverage_asks_for),
        cmocka_unit_test(runs_of_every_line_of_six_pixels_or_less_end_where_there_is_no_surface),
    };
    if (argc > 1)
        cmocka_set_test_filter(argv[1]);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
