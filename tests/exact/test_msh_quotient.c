/* SPDX-License-Identifier: MIT
 * The approximation inside MSH, every one of its 2^27 mantissas: with its error below SLACK, the exact comparison is
 * reached wherever it is needed, from c and from every t. The file under test is included to reach what is static.
 * GLINT_FAULT, slack or half-slack: a slack of 0, or halved, which is to be found (test_bounds).
 * EXACT_EVERY=K in the environment: every K-th 256 of the mantissas. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../../lib/lobe_msh.c"
#include "chosen.h"
#include "wide.h"

enum { COUNT = 256 };

/* The largest error where E = 2^-s m, of COUNT m from `first`: at the largest u = 2^8 C that belongs to that E for an n in 1..1000,
 * and at any u below it. E = 5 2^16 + (4n - 5)(2^16 - C), so n is 1000 or, where E < 5 2^16, 1. Each u * 2^63 is exact, and
 * double good to 2^-20 here. */
WIDE static double worst_of(uint32_t first, int s)
{
    const double unit = 1.0 / (1 << s);
    const int n = first * unit < 327680 ? 1 : 1000;
    int32_t most[COUNT], any[COUNT];
    double error[COUNT];
    for (int32_t i = 0; i < COUNT; i++) {
        const int32_t m = (int32_t)first + i;
        const double e = m * unit;
        most[i] = (int32_t)(n == 1 ? (e - 262144) * 256 : (65536 - (e - 327680) / 3995) * 256);
        any[i] = most[i] - (int32_t)((uint64_t)((uint32_t)m * UINT32_C(2654435761)) * (uint32_t)most[i] >> 32);
    }
    for (int32_t i = 0; i < COUNT; i++) {
        const uint32_t m = first + (uint32_t)i;
        const double per_u = 0x1p63 / (5.0 * (int32_t)m * (int32_t)m);
        const double at_most = (int32_t)msh_quotient((uint32_t)most[i], m) - most[i] * per_u; /* q < 2^31 */
        const double at_any = (int32_t)msh_quotient((uint32_t)any[i], m) - any[i] * per_u;
        error[i] = fabs(at_most) > fabs(at_any) ? fabs(at_most) : fabs(at_any);
    }
    double worst = 0;
    for (int i = 0; i < COUNT; i++)
        worst = error[i] > worst ? error[i] : worst;
    return worst;
}

/* From s = 1: where E >= 2^27, F is 0 without a quotient; to 9, as E >= 2^18. */
static void the_approximation_is_within_its_stated_2400_for_every_mantissa(void **state)
{
    (void)state;
    const uint32_t step = COUNT * exact_every();
    double worst = 0;
#pragma omp parallel for schedule(dynamic, 256) reduction(max : worst)
    for (uint32_t first = UINT32_C(1) << 27; first < UINT32_C(1) << 28; first += step)
        for (int s = 1; s <= 9; s++)
            worst = fmax(worst, worst_of(first, s));
    printf("# largest error %.0f of 2400, slack %d\n", worst, SLACK);
    assert_true(worst <= 2400);
    assert_true(worst > 1000); /* the loop has seen something */
    const char *fault = getenv("GLINT_FAULT");
    const int slack = !fault ? SLACK : !strcmp(fault, "slack") ? 0 : !strcmp(fault, "half-slack") ? SLACK / 2 : SLACK;
    assert_true(slack > 2400 + 101 + 26); /* from t, cutting u and m adds the latter two */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_approximation_is_within_its_stated_2400_for_every_mantissa),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
