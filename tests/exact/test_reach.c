/* SPDX-License-Identifier: MIT
 * What 32 bits decide of a lamp at a pixel is what 64 bits find: the bounds of falloff, cone, L and H. Random lamps, and cones whose
 * edges lie about the pixel. GLINT_PIXELS: thousands of lamps, 2000 unless set.
 * GLINT_FAULT: what 32 bits see wrongly, and test_bounds is to find. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "cases.h"
#include "glint_lights.h"
#include "glint_math_vector.h"

enum { FAR = GLINT_LIGHT_FAR, ONE = 1 << 30 };

static int32_t within(uint64_t *seed, uint32_t limit)
{
    return (int32_t)BELOW(2 * limit + 1) - (int32_t)limit;
}

static void direction(uint64_t *seed, int32_t v_q30[3])
{
    int32_t v[3] = {0, 0, 1};
    if (ONE_IN(2))
        for (int i = 0; i < 3; i++)
            v[i] = within(seed, UINT32_C(1) << BELOW(16));
    if (!glint_unit_q30(v_q30, v)) {
        v_q30[0] = v_q30[1] = 0;
        v_q30[2] = ONE;
    }
}

/* A lamp e away, whose range is near |e|, or any. */
static void lamp_at(uint64_t *seed, struct glint_light *lamp, const struct glint_sight *sight)
{
    double square = 0;
    for (int i = 0; i < 3; i++)
        square += (double)sight->e[i] * sight->e[i];
    const double range = sqrt(square) * (1 + BELOW(65536) / 40000.0);
    static const int32_t above[3] = {0, 0, 1}, below[3] = {0, 0, 0};
    const uint32_t reach = ONE_IN(4) ? 1 + BELOW((uint32_t)FAR) : 1 + (uint32_t)fmin(range, FAR - 1.0);
    if (ONE_IN(2))
        (void)glint_light_spot(lamp, above, below, reach, 0, 0);
    else
        (void)glint_light_point(lamp, above, reach);
    int32_t l[3], turned[3];
    if (!glint_unit_q30(l, sight->e))
        return;
    for (int i = 0; i < 3; i++)
        turned[i] = l[i] / 2 + within(seed, UINT32_C(1) << BELOW(29));
    if (!glint_unit_q30(turned, turned))
        return;
    double cosine = 0;
    for (int i = 0; i < 3; i++) {
        lamp->direction_q30[i] = -turned[i];
        cosine += (double)l[i] * turned[i] / ONE;
    }
    const double width = ldexp(1 + BELOW(1024) / 1024.0, (int)BELOW(30)), part = BELOW(65536) / 65536.0;
    lamp->cos_outer_q30 = (int32_t)fmin(fmax(floor(cosine - part * width), -ONE), ONE);
    lamp->cos_inner_q30 = (int32_t)fmin(lamp->cos_outer_q30 + width, ONE);
}

/* By light_place.c a cosine may be so much low or high, of 2^30, and a falloff's quotient so much low. Faults that take up all of
 * that leave a bound of 0 on that side. */
enum { COSINE_LOW = 8, COSINE_HIGH = 12, FALLOFF_LOW = 8 };

static void lower_falloff(struct glint_reach *reach, const struct glint_light *lamp, const struct glint_sight *sight)
{
    double square = 0;
    for (int i = 0; i < 3; i++)
        square += (double)sight->e[i] * sight->e[i];
    const double quotient = square / ((double)lamp->range * lamp->range);
    if (quotient > 0x1p-20)
        reach->range_inverse -= (uint32_t)(FALLOFF_LOW * 0x1p-30 / quotient * reach->range_inverse);
}

static void move_cones(struct glint_light *lamp, int32_t by)
{
    if (abs(lamp->cos_outer_q30) < ONE - COSINE_HIGH && abs(lamp->cos_inner_q30) < ONE - COSINE_HIGH) {
        lamp->cos_outer_q30 += by;
        lamp->cos_inner_q30 += by;
    }
}

static void make_fault(const char *fault, struct glint_reach *reach, struct glint_light *lamp,
                       const struct glint_sight *sight)
{
    if (!strcmp(fault, "blur") && reach->blur)
        reach->blur = 1;
    else if (!strcmp(fault, "range"))
        reach->range_inverse -= reach->range_inverse >> 26; /* 16 of 2^30 */
    else if (!strcmp(fault, "falloff-low"))
        lower_falloff(reach, lamp, sight);
    else if (!strcmp(fault, "cosine-low"))
        move_cones(lamp, COSINE_LOW);
    else if (!strcmp(fault, "cosine-high"))
        move_cones(lamp, -COSINE_HIGH);
}

static void what_32_bits_decide_of_a_lamp_is_what_64_bits_find(void **state)
{
    (void)state;
    const char *set = getenv("GLINT_PIXELS"), *fault = getenv("GLINT_FAULT");
    const int batches = set ? atoi(set) : 2000;
    int wrong = 0;
    long open = 0;
#pragma omp parallel for reduction(+ : wrong, open)
    for (int batch = 0; batch < batches; batch++) {
        uint64_t random = (uint64_t)batch * UINT64_C(0x9e3779b97f4a7c15) + 1, *seed = &random;
        for (int i = 0; i < 1000; i++) {
            struct glint_light lamp;
            struct glint_sight sight;
            struct glint_reach reach;
            struct glint_view near, exact;
            direction(seed, sight.v_q30);
            const uint32_t size = UINT32_C(1) << (4 + BELOW(21));
            for (int k = 0; k < 3; k++)
                sight.e[k] = within(seed, ONE_IN(4) ? size >> BELOW(8) : size);
            lamp_at(seed, &lamp, &sight);
            lamp.kind->begin(&reach, &lamp);
            struct glint_light seen = lamp;
            if (fault)
                make_fault(fault, &reach, &seen, &sight);
            memset(&near, 0, sizeof near);
            memset(&exact, 0, sizeof exact);
            const uint32_t found = lamp.kind->near(&reach, &seen, &sight, &near);
            if (found == GLINT_REACH_OPEN) {
                open++;
                continue;
            }
            const uint32_t att = lamp.kind->exact(&lamp, &sight, &exact);
            wrong += found != att || (att && memcmp(&near, &exact, sizeof near));
        }
    }
    printf("# %.3f million lamps, open: %.2f %%\n", (double)batches / 1e3, (double)open / (10.0 * (double)batches));
    assert_int_equal(wrong, 0);
    assert_true(open < 500L * batches); /* of 1000 each: were most open, this would be no test */
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_32_bits_decide_of_a_lamp_is_what_64_bits_find)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
