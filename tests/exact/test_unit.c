/* SPDX-License-Identifier: MIT
 * Directions in 32 bits: the bound of the root's first steps for every argument, that of the whole beside the 64-bit one.
 * EXACT_EVERY=K in the environment: every K-th batch of vectors. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "chosen.h"
#include "glint_math.h"
#include "glint_math_vector.h"
#include "reference_lights.h"

#if GLINT_WIDE

/* Of a mantissa A whose floor is a, 2^47 / sqrt(A) is between those of a and a + 1: glint_math_vector.h. */
static void roots_inverse_is_near_for_every_argument(void **state)
{
    (void)state;
    const uint32_t step = exact_every();
    int wrong = 0;
#pragma omp parallel for reduction(+ : wrong)
    for (uint32_t top = UINT32_C(1) << 14; top < UINT32_C(1) << 16; top++) {
        double next = 0;
        for (uint32_t rest = top % step; rest <= 0xffff; rest += step) {
            const uint32_t a = top << 16 | rest;
            const double r = (double)glint_wide_inverse(a) + 0x1p32, root = step == 1 && rest ? next : sqrt((double)a);
            next = sqrt((double)a + 1);
            wrong += (r + 1.5) * root < 0x1p47 || (r - 4.5) * next > 0x1p47;
        }
    }
    assert_int_equal(wrong, 0);
}

#else

/* The error falls with x: the ends of what is cut to t are its worst. */
static void roots_inverse_is_near_for_every_argument(void **state)
{
    (void)state;
    for (uint32_t t = 1 << 14; t < 1 << 16; t++) {
        const uint64_t y = glint_root_inverse(t), one = UINT64_C(1) << 62;
        assert_true(y < 65536);
        const double low = (double)(int64_t)(one - ((y * y * t) << 16)) / (double)one;
        const double high = (double)(int64_t)(one - y * y * ((t << 16) | 0xffff)) / (double)one;
        assert_true(fabs(low) < 0.95 / 4096 && fabs(high) < 0.95 / 4096);
    }
}

#endif

static uint32_t below(uint64_t *seed, uint32_t limit)
{
    *seed = *seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)((*seed >> 32) * limit >> 32);
}

/* Of any length, often near a power of two, with a component of 0 or a small one. */
static void vector(uint64_t *seed, int32_t v[3])
{
    const unsigned bits = 1 + below(seed, 30);
    for (int i = 0; i < 3; i++) {
        const unsigned own = below(seed, 3) ? bits : below(seed, bits + 1);
        uint32_t size = below(seed, UINT32_C(1) << own);
        if (below(seed, 8) == 0)
            size = (UINT32_C(1) << own) - 1 - below(seed, size < 4 ? size + 1 : 4);
        v[i] = below(seed, 2) ? (int32_t)size : -(int32_t)size;
    }
}

/* 16 million cases, in batches that each have a seed: how many are wrong. */
static int wrong_of(int (*one)(uint64_t *seed))
{
    const int step = (int)exact_every();
    int wrong = 0;
#pragma omp parallel for reduction(+ : wrong)
    for (int batch = 0; batch < 4096; batch += step) {
        uint64_t seed = (uint64_t)batch * UINT64_C(0x9e3779b97f4a7c15) + 1;
        for (int i = 0; i < 4096; i++)
            wrong += one(&seed);
    }
    return wrong;
}

/* A bound, or 1 where GLINT_FAULT in the environment names it, which a test then is to find (test_bounds). */
static int64_t bound(const char *name, int value)
{
    const char *fault = getenv("GLINT_FAULT");
    return fault && !strcmp(fault, name) ? 1 : value;
}

/* 1 where a component is farther from the exact one than `bound`. */
static int far(const int32_t q30[3], const int64_t exact[3], int64_t bound)
{
    for (int k = 0; k < 3; k++)
        if (llabs(q30[k] - exact[k]) > bound)
            return 1;
    return 0;
}

static int direction(uint64_t *seed)
{
    int32_t v[3];
    struct glint_unit near;
    vector(seed, v);
    const int64_t wide[3] = {v[0], v[1], v[2]};
    int64_t exact[3];
    const bool there = reference_unit(exact, wide);
    if (glint_unit_near(&near, v) != there)
        return 1;
    if (!there)
        return 0;
    /* A square of 48 bits is a double's */
    const double square =
        (double)wide[0] * (double)wide[0] + (double)wide[1] * (double)wide[1] + (double)wide[2] * (double)wide[2];
    const double unit = square - ldexp(near.square, near.exponent);
    return far(near.unit_q30, exact, bound("SLACK", GLINT_UNIT_SLACK)) ||
           (labs(v[0]) < 1 << 24 && labs(v[1]) < 1 << 24 && labs(v[2]) < 1 << 24 &&
            (unit < 0 || unit > ldexp(1.001, near.exponent)));
}

static void directions_are_within_their_bound_of_the_64_bit_ones(void **state)
{
    (void)state;
    assert_int_equal(wrong_of(direction), 0);
}

/* A vector that is off by 2 in its components: by GLINT_UNIT_GROWS each. */
static int direction_a_little_off(uint64_t *seed)
{
    int32_t v[3];
    int64_t off[3], exact[3];
    struct glint_unit near;
    vector(seed, v);
    for (int k = 0; k < 3; k++)
        off[k] = v[k] + (int64_t)below(seed, 5) - 2;
    return glint_unit_near(&near, v) && near.up <= 8 && reference_unit(exact, off) &&
           far(near.unit_q30, exact, GLINT_UNIT_SLACK + (2 * bound("GROWS", GLINT_UNIT_GROWS) << near.up));
}

static void directions_of_vectors_that_are_a_little_off_are_within_their_bound(void **state)
{
    (void)state;
    assert_int_equal(wrong_of(direction_a_little_off), 0);
}

static int half_in_front(uint64_t *seed)
{
    int32_t v[3], h[3];
    struct glint_unit near;
    vector(seed, v);
    v[2] = abs(v[2]);
    const int64_t wide[3] = {v[0], v[1], v[2]};
    int64_t l[3], exact[3];
    if (!glint_unit_near(&near, v) || near.unit_q30[2] < 0 || !reference_unit(l, wide))
        return 0;
    const int64_t half[3] = {l[0] >> 1, l[1] >> 1, (l[2] + (1 << 30)) >> 1};
    (void)reference_unit(exact, half);
    glint_unit_front(h, near.unit_q30);
    return far(h, exact, bound("FRONT", GLINT_UNIT_FRONT));
}

static int root(uint64_t *seed)
{
    const uint32_t size = below(seed, UINT32_C(1) << (1 + below(seed, 31)));
    const uint64_t off = below(seed, 4), square = (uint64_t)size * size,
                   x = below(seed, 2) ? square + off
                       : square < off ? 0
                                      : square - off,
                   found = glint_root(x);
    return found * found > x || x - found * found > 2 * found;
}

static void roots_are_rounded_down_also_beside_squares(void **state)
{
    (void)state;
    assert_int_equal(wrong_of(root), 0);
}

/* Up to 7 long, where tests/proof does not say it of longer ones. */
static void short_vectors_that_are_off_by_1_are_off_by_what_grows(void **state)
{
    (void)state;
    enum { LONGEST = 7, SIDE = 2 * LONGEST + 1 };
    int wrong = 0;
    for (int i = 0; i < SIDE * SIDE * SIDE * 27; i++) {
        const int32_t v[3] = {i % SIDE - LONGEST, i / SIDE % SIDE - LONGEST, i / SIDE / SIDE % SIDE - LONGEST};
        const int by = i / (SIDE * SIDE * SIDE);
        const int64_t off[3] = {v[0] + by % 3 - 1, v[1] + by / 3 % 3 - 1, v[2] + by / 9 - 1};
        int64_t exact[3];
        struct glint_unit near;
        wrong += glint_unit_near(&near, v) && reference_unit(exact, off) &&
                 far(near.unit_q30, exact, GLINT_UNIT_SLACK + ((int64_t)GLINT_UNIT_GROWS << near.up));
    }
    assert_int_equal(wrong, 0);
}

/* The half vector of a viewer straight in front, from nearly the light's direction and from its own. */
static void halves_for_a_viewer_in_front_are_within_their_bound(void **state)
{
    (void)state;
    assert_int_equal(wrong_of(half_in_front), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(roots_inverse_is_near_for_every_argument),
        cmocka_unit_test(directions_are_within_their_bound_of_the_64_bit_ones),
        cmocka_unit_test(directions_of_vectors_that_are_a_little_off_are_within_their_bound),
        cmocka_unit_test(roots_are_rounded_down_also_beside_squares),
        cmocka_unit_test(short_vectors_that_are_off_by_1_are_off_by_what_grows),
        cmocka_unit_test(halves_for_a_viewer_in_front_are_within_their_bound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
