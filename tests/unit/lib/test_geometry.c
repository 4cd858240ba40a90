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
    assert_int_equal(glint_vec_normalize(NULL, up), GLINT_ERR_ARG);
    assert_int_equal(glint_vec_normalize(&vec, NULL), GLINT_ERR_ARG);
    assert_int_equal(vec.x + vec.y + vec.z, 21);
}

/* A paint to be lit. */
static struct glint_paint any_paint(void)
{
    const struct glint_material material = {.model = GLINT_MSH, .n = 60};
    const struct glint_output output = {.format = GLINT_GREY8};
    struct glint_paint paint;
    assert_int_equal(glint_paint_exact(&paint, &material, &output), GLINT_OK);
    return paint;
}

/* The paint under a white light from there. */
static enum glint_err light_from(struct glint_paint *paint, const int32_t to_light[3], const int32_t to_viewer[3])
{
    struct glint_light light;
    const enum glint_err err = glint_light_directional(&light, to_light);
    return err ? err : glint_paint_light(paint, &light, 1, to_viewer);
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
    struct glint_paint paint = any_paint();
    for (int i = 0; i < 100000; i++) {
        const int32_t l[3] = {random_between(-999, 999), random_between(-999, 999), random_between(0, 999)};
        const int32_t v[3] = {random_between(-50, 50), random_between(-50, 50), 100};
        if (light_from(&paint, l, v) != GLINT_OK) {
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
        worst = fmax(worst, q15_error(paint.h.x, h[0] / sqrt(hh)));
        worst = fmax(worst, q15_error(paint.h.y, h[1] / sqrt(hh)));
        worst = fmax(worst, q15_error(paint.h.z, h[2] / sqrt(hh)));
        worst = fmax(worst, q15_error(paint.l.z, l[2] / sqrt(ll)));
        worst = fmax(worst, q15_error(paint.v.y, v[1] / sqrt(vv)));
    }
    assert_true(worst <= 0.501);
}

static void a_light_without_direction_or_straight_behind_is_refused(void **state)
{
    (void)state;
    const int32_t zero[3] = {0, 0, 0}, front[3] = {0, 0, 5}, behind[3] = {0, 0, -900}, slant[3] = {1, 2, 3};
    const int32_t against[3] = {-100, -200, -300};
    struct glint_paint paint = any_paint();
    assert_int_equal(light_from(&paint, zero, front), GLINT_ERR_VECTOR);
    assert_int_equal(light_from(&paint, front, zero), GLINT_ERR_VECTOR);
    assert_int_equal(light_from(&paint, behind, front), GLINT_ERR_VECTOR);
    assert_int_equal(light_from(&paint, slant, against), GLINT_ERR_VECTOR);
    assert_int_equal(glint_paint_light(&paint, NULL, 0, zero), GLINT_ERR_VECTOR);
}

static void a_light_straight_behind_is_refused_whatever_the_lengths(void **state)
{
    (void)state;
    struct glint_paint paint = any_paint();
    for (int i = 0; i < 100000; i++) {
        const int32_t k = random_between(1, 1000);
        const int32_t l[3] = {random_between(-999, 999), random_between(-999, 999), random_between(-999, 999)};
        const int32_t v[3] = {-k * l[0], -k * l[1], -k * l[2]};
        assert_int_equal(light_from(&paint, l, v), GLINT_ERR_VECTOR);
    }
    const int32_t nearly[3] = {1, 0, -1000000}, front[3] = {0, 0, 1};
    assert_int_equal(light_from(&paint, nearly, front), GLINT_OK);
    assert_true(paint.h.x > 32700);
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

/* Walks along a span; how far t, nl are from those of the normals between a and b at the paint's light, in parts of what is stated: at the ends
 * of t, within it. Differences modulo 2^32, as the span has them. */
static void span_errors(const struct glint_span *span, const struct glint_paint *paint, const struct glint_vec *a,
                        const struct glint_vec *b, double *end, double *middle)
{
    const uint16_t w = span->w;
    uint32_t t = span->t_q30, dt = span->dt_q30, nl = (uint32_t)span->nl_q30;
    for (int k = 0; k < w; k++) {
        const double s = w > 1 ? (double)k / (w - 1) : 0;
        const double n[3] = {a->x + s * (b->x - a->x), a->y + s * (b->y - a->y), a->z + s * (b->z - a->z)};
        const double wanted = half_distance(n, &paint->h), whole = floor(wanted);
        const double error = fabs((int32_t)(t - (uint32_t)(int64_t)whole) - (wanted - whole));
        if (k == 0 || k == w - 1)
            *end = fmax(*end, error / (w / 2.0 + 1));
        *middle = fmax(*middle, error / (w * (double)w / 16 + w + 1));
        const double lit = n[0] * paint->l.x + n[1] * paint->l.y + n[2] * paint->l.z;
        assert_true(fabs((int32_t)nl - lit) <= w / 2.0 + 1);
        t += dt;
        dt += span->ddt_q30;
        nl += (uint32_t)span->dnl_q30;
    }
}

static void a_span_follows_its_quadratic_within_the_stated_error(void **state)
{
    (void)state;
    double worst_end = 0, worst_middle = 0;
    struct glint_paint paint = any_paint();
    for (int i = 0; i < 3000; i++) {
        const int32_t to_light[3] = {random_between(-100, 100), random_between(-100, 100), 60}, view[3] = {0, 0, 1};
        assert_int_equal(light_from(&paint, to_light, view), GLINT_OK);
        const uint16_t widths[] = {1, 2, 3, 17, 240, 1023, GLINT_SPAN_MAX};
        const struct glint_vec a = random_direction(), b = random_direction();
        struct glint_span span;
        assert_int_equal(glint_span_init(&span, &paint, &a, &b, widths[i % 7]), GLINT_OK);
        assert_int_equal(span.w, widths[i % 7]);
        span_errors(&span, &paint, &a, &b, &worst_end, &worst_middle);
    }
    printf("# of the bounds: ends %.3f, middle %.3f\n", worst_end, worst_middle);
    assert_true(worst_end <= 1 && worst_middle <= 1);
}

/* The farthest from a light's half vector, and from 0, that 16 bits hold: t is 3.73 there, |nl| 1.73. */
static void a_span_takes_the_longest_normals(void **state)
{
    (void)state;
    struct glint_paint paint = any_paint();
    const int32_t corner[3] = {1, 1, 1};
    double worst_end = 0, worst_middle = 0;
    assert_int_equal(light_from(&paint, corner, corner), GLINT_OK);
    for (int i = 0; i < 64; i++) {
        const int16_t low = INT16_MIN, high = INT16_MAX;
        const struct glint_vec a = {i & 1 ? high : low, i & 2 ? high : low, i & 4 ? high : low},
                               b = {i & 8 ? high : low, i & 16 ? high : low, i & 32 ? high : low};
        struct glint_span span;
        assert_int_equal(glint_span_init(&span, &paint, &a, &b, (uint16_t)(1 + 64 * i)), GLINT_OK);
        span_errors(&span, &paint, &a, &b, &worst_end, &worst_middle);
    }
    assert_true(worst_end <= 1 && worst_middle <= 1);
}

static void a_span_that_cannot_be_is_refused(void **state)
{
    (void)state;
    const int32_t front[3] = {0, 0, 1}, place[3] = {0, 0, 100};
    const struct glint_vec up = {0, 0, 32767};
    struct glint_paint paint = any_paint(), none = {0};
    struct glint_span span = {7, 7, 7, 7, 7, 7, {{0, 0}, {0, 0}}};
    struct glint_light two[2], point;
    assert_int_equal(glint_span_init(&span, &paint, &up, &up, 4), GLINT_ERR_ARG); /* never lit */
    assert_int_equal(light_from(&paint, front, front), GLINT_OK);
    assert_int_equal(glint_span_init(&span, &paint, &up, &up, GLINT_SPAN_MAX + 1), GLINT_ERR_ARG);
    assert_int_equal(glint_span_init(&span, &paint, NULL, &up, 4), GLINT_ERR_ARG);
    assert_int_equal(glint_span_init(&span, &paint, &up, NULL, 4), GLINT_ERR_ARG);
    assert_int_equal(glint_span_init(&span, NULL, &up, &up, 4), GLINT_ERR_ARG);
    assert_int_equal(glint_span_init(&span, &none, &up, &up, 4), GLINT_ERR_ARG);
    assert_int_equal(glint_span_init(NULL, &paint, &up, &up, 4), GLINT_ERR_ARG);
    assert_int_equal(glint_light_directional(&two[0], front), GLINT_OK);
    two[1] = two[0];
    assert_int_equal(glint_paint_light(&paint, two, 2, front), GLINT_OK);
    assert_int_equal(glint_span_init(&span, &paint, &up, &up, 4), GLINT_ERR_ARG);
    assert_int_equal(glint_light_point(&point, place, 1000), GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, &point, 1, front), GLINT_OK);
    assert_int_equal(glint_span_init(&span, &paint, &up, &up, 4), GLINT_ERR_ARG);
    assert_true(span.t_q30 == 7 && span.nl_q30 == 7 && span.w == 7);
    assert_int_equal(glint_paint_light(&paint, NULL, 0, front), GLINT_OK);
    assert_int_equal(glint_span_init(&span, &paint, &up, &up, 4), GLINT_OK);
    assert_int_equal(glint_span_init(&span, &paint, &up, &up, 0), GLINT_OK);
}

/* |N.L| <= 2^31 - 1 - 2^13 of 2^30 = 1.0, by vectors that are far from unit length. */
static void a_span_takes_n_l_up_to_2_less_2_to_minus_17(void **state)
{
    (void)state;
    static const struct {
        struct glint_vec l, n;
    } last[] = {{{-32768, -32768, 1}, {-32768, -32767, 24575}}, {{-32768, -32768, -3}, {32767, 32767, 19114}}};
    const int32_t front[3] = {0, 0, 1};
    struct glint_paint paint = any_paint();
    struct glint_span span;
    assert_int_equal(light_from(&paint, front, front), GLINT_OK);
    for (unsigned i = 0; i < 2; i++) {
        struct glint_vec n = last[i].n;
        paint.l = last[i].l;
        paint.h = n;
        assert_int_equal(glint_span_init(&span, &paint, &n, &n, 4), GLINT_OK);
        n.z++;
        assert_int_equal(glint_span_init(&span, &paint, &n, &last[i].n, 4), GLINT_ERR_VECTOR);
        assert_int_equal(glint_span_init(&span, &paint, &last[i].n, &n, 4), GLINT_ERR_VECTOR);
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
        cmocka_unit_test(a_span_takes_the_longest_normals),
        cmocka_unit_test(a_span_that_cannot_be_is_refused),
        cmocka_unit_test(a_span_takes_n_l_up_to_2_less_2_to_minus_17),
        cmocka_unit_test(srgb_decoding_is_correctly_rounded),
        cmocka_unit_test(srgb_encoding_is_monotone_and_within_its_stated_error),
        cmocka_unit_test(srgb_encoding_is_what_its_sequence_says),
        cmocka_unit_test(every_srgb_byte_survives_decoding_and_encoding),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
