/* SPDX-License-Identifier: MIT
 * The approximation inside MSH, every one of its 2^27 mantissas: with its error below SLACK, the exact comparison is
 * reached wherever it is needed, from c and from every t. The file under test is included to reach what is static. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

#include "../../lib/lobe_msh.c"

_Static_assert(SLACK > 2400 + 127, "from t, cutting u and m adds 101 and 26"); /* the bound that is used */

/* The largest 2^8 C that belongs to E = 2^-s m for an n in 1..1000, or 0: E = 5 2^16 + (4n - 5)(2^16 - C). */
static double largest_u(uint32_t m, int s)
{
    const double e = ldexp(m, -s);
    if (e >= 327680)
        return floor((65536 - (e - 327680) / 3995) * 256);
    return s == 9 ? (e - 262144) * 256 : 0; /* n = 1 */
}

static double error_of(uint32_t m, uint32_t u)
{
    return fabs(glint_msh_quotient(u, m) - u / 256.0 * 0x1p71 / (5.0 * m * m)); /* double is good to 2^-20 here */
}

static void the_approximation_is_within_its_stated_2400_for_every_mantissa(void **state)
{
    (void)state;
    double worst = 0;
#pragma omp parallel for schedule(dynamic, 65536) reduction(max : worst)
    for (uint32_t m = UINT32_C(1) << 27; m < UINT32_C(1) << 28; m++) {
        for (int s = 0; s <= 9; s++) {
            const double u = largest_u(m, s);
            if (u < 1)
                continue;
            const uint32_t most = (uint32_t)u;
            worst = fmax(worst, fmax(error_of(m, most), error_of(m, most - m * UINT32_C(2654435761) % most)));
        }
    }
    printf("# largest error %.0f of 2400, slack %d\n", worst, SLACK);
    assert_true(worst <= 2400);
    assert_true(worst > 1000); /* the loop has seen something */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_approximation_is_within_its_stated_2400_for_every_mantissa),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
