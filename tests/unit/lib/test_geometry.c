/* SPDX-License-Identifier: MIT
 * Directions, spans and sRGB against double precision. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "glint.h"

static uint64_t seed = 1;
static int32_t random_between(int32_t low, int32_t high)
{
    seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return low + (int32_t)((seed >> 33) % (uint64_t)((int64_t)high - low + 1));
}

static double q15_error(int16_t got, double wanted)
{
    return fabs(got - fmin(wanted * 32768, 32767));
}

static void a_vector_of_any_length_is_normalized_to_the_nearest_unit(void **state)
{
    (void)state;
    double worst = 0;
    for (int i = 0; i < 300000; i++) {
        const int32_t size = i % 3 == 0 ? 3 : i % 3 == 1 ? 70000 : INT32_MAX;
        const int32_t v[3] = {random_between(-size, size), random_between(-size, size), random_between(-size, size)};
        struct glint_vec out;
        if (!v[0] && !v[1] && !v[2]) {
            assert_int_equal(glint_vec_normalize(&out, v), GLINT_ERR_VECTOR);
            continue;
        }
        assert_int_equal(glint_vec_normalize(&out, v), GLINT_OK);
        const double length = sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
        worst = fmax(worst, q15_error(out.x, v[0] / length));
        worst = fmax(worst, q15_error(out.y, v[1] / length));
        worst = fmax(worst, q15_error(out.z, v[2] / length));
    }
    printf("# largest error %.5f of 2^-15\n", worst);
    assert_true(worst <= 0.501);
}

static void directions_that_are_not_there_are_refused(void **state)
{
    (void)state;
    static const int32_t up[3] = {0, 0, 1};
    struct glint_vec vec = {7, 7, 7};
    struct glint_light light = {{7, 7, 7}, {7, 7, 7}, {7, 7, 7}};
    assert_int_equal(glint_vec_normalize(NULL, up), GLINT_ERR_ARG);
    assert_int_equal(glint_vec_normalize(&vec, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_light_init(NULL, up, up), GLINT_ERR_ARG);
    assert_int_equal(glint_light_init(&light, NULL, up), GLINT_ERR_ARG);
    assert_int_equal(glint_light_init(&light, up, NULL), GLINT_ERR_ARG);
    assert_int_equal(vec.x + light.l.x + light.h.z, 21);
}

static void the_axes_and_the_longest_vectors_normalize_exactly(void **state)
{
    (void)state;
    const int32_t lengths[] = {1, 2, 1000, 32767, 65536, INT32_MAX, -1, -32768, INT32_MIN};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        const int32_t v[3] = {0, lengths[i], 0};
        struct glint_vec out;
        assert_int_equal(glint_vec_normalize(&out, v), GLINT_OK);
        assert_int_equal(out.x, 0);
        assert_int_equal(out.y, lengths[i] > 0 ? 32767 : -32768);
        assert_int_equal(out.z, 0);
    }
    const int32_t corner[3] = {INT32_MIN, INT32_MIN, INT32_MIN};
    struct glint_vec out;
    assert_int_equal(glint_vec_normalize(&out, corner), GLINT_OK);
    assert_int_equal(out.x, -18919);
}

static void the_half_vector_lies_halfway_to_half_a_unit(void **state)
{
    (void)state;
    double worst = 0;
    for (int i = 0; i < 100000; i++) {
        const int32_t l[3] = {random_between(-999, 999), random_between(-999, 999), random_between(0, 999)};
        const int32_t v[3] = {random_between(-50, 50), random_between(-50, 50), 100};
        struct glint_light light;
        if (glint_light_init(&light, l, v) != GLINT_OK) {
            assert_true(!l[0] && !l[1] && !l[2]);
            continue;
        }
        double ll = 0, vv = 0, hh = 0, h[3];
        for (int k = 0; k < 3; k++) {
            ll += (double)l[k] * l[k];
            vv += (double)v[k] * v[k];
        }
        for (int k = 0; k < 3; k++) {
            h[k] = l[k] / sqrt(ll) + v[k] / sqrt(vv);
            hh += h[k] * h[k];
        }
        worst = fmax(worst, q15_error(light.h.x, h[0] / sqrt(hh)));
        worst = fmax(worst, q15_error(light.h.y, h[1] / sqrt(hh)));
        worst = fmax(worst, q15_error(light.h.z, h[2] / sqrt(hh)));
        worst = fmax(worst, q15_error(light.l.z, l[2] / sqrt(ll)));
    }
    assert_true(worst <= 0.501);
}

static void a_light_without_direction_or_straight_behind_is_refused(void **state)
{
    (void)state;
    const int32_t zero[3] = {0, 0, 0}, front[3] = {0, 0, 5}, behind[3] = {0, 0, -900}, slant[3] = {1, 2, 3};
    const int32_t against[3] = {-100, -200, -300};
    struct glint_light light;
    assert_int_equal(glint_light_init(&light, zero, front), GLINT_ERR_VECTOR);
    assert_int_equal(glint_light_init(&light, front, zero), GLINT_ERR_VECTOR);
    assert_int_equal(glint_light_init(&light, behind, front), GLINT_ERR_VECTOR);
    assert_int_equal(glint_light_init(&light, slant, against), GLINT_ERR_VECTOR);
    assert_int_equal(glint_light_init(&light, slant, front), GLINT_OK);
}

/* Lengths that are no powers of two: the two units then differ in their last bits. */
static void a_light_straight_behind_is_refused_whatever_the_lengths(void **state)
{
    (void)state;
    for (int i = 0; i < 100000; i++) {
        const int32_t k = random_between(1, 1000);
        const int32_t l[3] = {random_between(-999, 999), random_between(-999, 999), random_between(-999, 999)};
        const int32_t v[3] = {-k * l[0], -k * l[1], -k * l[2]};
        struct glint_light light;
        assert_int_equal(glint_light_init(&light, l, v), GLINT_ERR_VECTOR);
    }
    const int32_t nearly[3] = {1, 0, -1000000}, front[3] = {0, 0, 1};
    struct glint_light light;
    assert_int_equal(glint_light_init(&light, nearly, front), GLINT_OK);
    assert_true(light.h.x > 32700);
}

static struct glint_vec random_direction(void)
{
    const int32_t v[3] = {random_between(-100, 100), random_between(-100, 100), random_between(20, 100)};
    struct glint_vec out;
    assert_int_equal(glint_vec_normalize(&out, v), GLINT_OK);
    return out;
}

static double half_distance(const double a[3], const struct glint_vec *b) /* |a - b|^2 / 2 in Q2.30 */
{
    const double x = a[0] - b->x, y = a[1] - b->y, z = a[2] - b->z;
    return (x * x + y * y + z * z) / 2;
}

static void a_span_follows_its_quadratic_within_the_stated_error(void **state)
{
    (void)state;
    double worst_end = 0, worst_middle = 0;
    for (int i = 0; i < 3000; i++) {
        const int32_t to_light[3] = {random_between(-100, 100), random_between(-100, 100), 60}, view[3] = {0, 0, 1};
        struct glint_light light;
        assert_int_equal(glint_light_init(&light, to_light, view), GLINT_OK);
        const uint16_t widths[] = {1, 2, 3, 17, 240, 1023, GLINT_SPAN_MAX};
        const uint16_t w = widths[i % 7];
        const struct glint_vec a = random_direction(), b = random_direction();
        struct glint_span span;
        assert_int_equal(glint_span_init(&span, &light, &a, &b, w), GLINT_OK);
        uint32_t t = span.t_q30, dt = span.dt_q30;
        int64_t nl = span.nl_q30;
        for (int k = 0; k < w; k++) {
            const double s = w > 1 ? (double)k / (w - 1) : 0;
            const double n[3] = {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)};
            const double error = fabs((double)(int32_t)t - half_distance(n, &light.h));
            if (k == 0 || k == w - 1)
                worst_end = fmax(worst_end, error / (w / 2.0 + 1));
            worst_middle = fmax(worst_middle, error / (w * (double)w / 16 + w + 1));
            const double lit = n[0] * light.l.x + n[1] * light.l.y + n[2] * light.l.z;
            assert_true(fabs((double)nl - lit) <= w / 2.0 + 1);
            t += dt;
            dt += span.ddt_q30;
            nl += span.dnl_q30;
        }
    }
    printf("# of the bounds: ends %.3f, middle %.3f\n", worst_end, worst_middle);
    assert_true(worst_end <= 1 && worst_middle <= 1);
}

static void a_span_out_of_range_is_refused(void **state)
{
    (void)state;
    const int32_t front[3] = {0, 0, 1};
    const struct glint_vec up = {0, 0, 32767}, far = {-32768, -32768, -32768};
    struct glint_light light;
    struct glint_span span;
    assert_int_equal(glint_light_init(&light, front, front), GLINT_OK);
    assert_int_equal(glint_span_init(&span, &light, &up, &up, GLINT_SPAN_MAX + 1), GLINT_ERR_ARG);
    assert_int_equal(glint_span_init(&span, &light, NULL, &up, 4), GLINT_ERR_ARG);
    assert_int_equal(glint_span_init(&span, &light, &up, NULL, 4), GLINT_ERR_ARG);
    assert_int_equal(glint_span_init(&span, NULL, &up, &up, 4), GLINT_ERR_ARG);
    assert_int_equal(glint_span_init(NULL, &light, &up, &up, 4), GLINT_ERR_ARG);
    light.h = (struct glint_vec){32767, 32767, 32767};
    assert_int_equal(glint_span_init(&span, &light, &up, &far, 4), GLINT_ERR_VECTOR);
    assert_int_equal(glint_span_init(&span, &light, &up, &up, 0), GLINT_OK);
}

static void a_span_is_refused_from_its_stated_limits_on(void **state)
{
    (void)state;
    struct glint_light light = {{0, 0, 32767}, {0, 0, 32767}, {32767, 30652, 0}};
    struct glint_span span;
    const struct glint_vec up = {0, 0, 32767}, under = {-32768, -30652, 0}, over = {-32768, -30653, 0}; /* t = 3.75 */
    assert_int_equal(glint_span_init(&span, &light, &up, &under, 9), GLINT_OK);
    assert_int_equal(glint_span_init(&span, &light, &under, &up, 9), GLINT_OK);
    assert_int_equal(glint_span_init(&span, &light, &up, &over, 9), GLINT_ERR_VECTOR);
    assert_int_equal(glint_span_init(&span, &light, &over, &up, 9), GLINT_ERR_VECTOR);
    light = (struct glint_light){{32767, 32767, 1000}, up, up};
    for (int16_t sign = -1; sign <= 1; sign += 2) {
        const struct glint_vec in = {(int16_t)(sign * 32767), (int16_t)(sign * 32767), (int16_t)(sign * 122)};
        const struct glint_vec out = {(int16_t)(sign * 32767), (int16_t)(sign * 32767), (int16_t)(sign * 123)};
        assert_int_equal(glint_span_init(&span, &light, &in, &in, 9), GLINT_OK); /* |nl| = 2^31 - 9070 */
        assert_int_equal(glint_span_init(&span, &light, &in, &out, 9), GLINT_ERR_VECTOR);
        assert_int_equal(glint_span_init(&span, &light, &out, &in, 9), GLINT_ERR_VECTOR);
    }
}

static double decode(double e)
{
    return e <= 0.04045 ? e / 12.92 : pow((e + 0.055) / 1.055, 2.4);
}

static double encode(double v)
{
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1 / 2.4) - 0.055;
}

static void srgb_decoding_is_correctly_rounded(void **state)
{
    (void)state;
    for (int e = 0; e < 256; e++)
        assert_int_equal(glint_srgb_decode((uint8_t)e), (int)floor(65535 * decode(e / 255.0) + 0.5));
}

static void srgb_encoding_is_monotone_and_within_its_stated_error(void **state)
{
    (void)state;
    double worst = 0;
    uint16_t before = 0;
    for (int v = 0; v <= 65535; v++) {
        const uint16_t e = glint_srgb_encode((uint16_t)v);
        assert_true(e >= before);
        before = e;
        worst = fmax(worst, fabs(e - 65535 * encode(v / 65535.0)));
    }
    printf("# largest error %.2f of 65535\n", worst);
    assert_true(worst <= 3);
    assert_int_equal(glint_srgb_encode(0), 0);
    assert_int_equal(glint_srgb_encode(65535), 65535);
}

static int knot(int v)
{
    return (int)fmin(floor(65535 * encode(v / 65535.0) + 0.5), 65535);
}

static void srgb_encoding_is_what_its_sequence_says(void **state)
{
    (void)state;
    for (int v = 0; v <= 65535; v++) {
        int width = 4; /* of a chord: 32 an octave */
        while (v >= 64 * width)
            width *= 2;
        const int from = v / width * width, e0 = knot(from), e1 = knot(from + width);
        const int chord = e0 + ((e1 - e0) * (v - from) + width / 2) / width;
        assert_int_equal(glint_srgb_encode((uint16_t)v), v < 128 ? (3308 * v + 128) / 256 : chord);
    }
}

static void every_srgb_byte_survives_decoding_and_encoding(void **state)
{
    (void)state;
    for (int e = 0; e < 256; e++)
        assert_int_equal((glint_srgb_encode(glint_srgb_decode((uint8_t)e)) + 128) / 257, e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_vector_of_any_length_is_normalized_to_the_nearest_unit),
        cmocka_unit_test(directions_that_are_not_there_are_refused),
        cmocka_unit_test(the_axes_and_the_longest_vectors_normalize_exactly),
        cmocka_unit_test(the_half_vector_lies_halfway_to_half_a_unit),
        cmocka_unit_test(a_light_without_direction_or_straight_behind_is_refused),
        cmocka_unit_test(a_light_straight_behind_is_refused_whatever_the_lengths),
        cmocka_unit_test(a_span_follows_its_quadratic_within_the_stated_error),
        cmocka_unit_test(a_span_out_of_range_is_refused),
        cmocka_unit_test(a_span_is_refused_from_its_stated_limits_on),
        cmocka_unit_test(srgb_decoding_is_correctly_rounded),
        cmocka_unit_test(srgb_encoding_is_monotone_and_within_its_stated_error),
        cmocka_unit_test(srgb_encoding_is_what_its_sequence_says),
        cmocka_unit_test(every_srgb_byte_survives_decoding_and_encoding),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
