/* SPDX-License-Identifier: MIT
 * The loops of batch.h that are left to the compiler, and the constants that they share with others. */
#ifndef GLINT_BATCH_PORTABLE_H
#define GLINT_BATCH_PORTABLE_H

#include "models/batch.h"

static inline int32_t batch_clamp_c(int32_t c)
{
    c = c > 0 ? c : 0;
    return c < GLINT_C_ONE ? c : GLINT_C_ONE;
}

/* MSH: with E = 4n(2^16 - C) + 5C, F 2^16 = 2^39 C / (5 E^2); and C is linear in E, so that with u = 1 / E
 *   F 2^16 = u (a u - b),  a = 2^39/5 (2^16 + 5 2^16 / k),  b = 2^39/5 / k,  k = 4n - 5.
 * |a u^2| < 1.7 2^18, reached at n = 1, bounds every term. A rounding costs at most 2^-53 of it, and there are 15: u
 * has 3 and counts twice, a has 4, b 2, the rest 3. So F 2^16 is within 8e-10, and none is within 1.4e-9 of a tie. */
struct batch_msh {
    int32_t k, e_at_0; /* E = e_at_0 - k C < 2^28 */
    double a, b;
};
struct batch_msh batch_msh_of(uint32_t n);

/* Cayley, n > 4: with D = 2^16 - C, F 2^16 = (16 p / s)^4, p = 8 2^16 - (n + 4) D, or 0 where that is negative, s = 8 2^16 +
 * (n - 4) D: integers below 2^27. Lyon: F 2^16 = ((4 2^16 - n D) / 2^14)^4 or 0. GGX: F 2^16 = (2^41 / D)^2, D = 2^33 + n (2^32 - C^2), an integer below 2^43. Roundings, at most 12 of
 * 2^-53 of F, are below the distance of every value from the nearest tie, as tests/exact/test_batch.c shows. */
bool batch_runs_portable(void);
batch_loop batch_msh_portable, batch_schlick_portable, batch_cayley_portable, batch_lyon_portable, batch_ggx_portable;
batch_lookup batch_lookup_portable;

#endif
