/* SPDX-License-Identifier: MIT
 * Gauss, eq. (1): F = exp(-n x^2 / 2), x = acos c. One function of c suffices: F = g^n, g = exp(-acos(c)^2 / 2). */
#include "glint_lobe_domain.h"
#include "glint_lobe_largest_t.h"
#include "glint_math_power.h"

/* g as a polynomial in t = 1 - c, Q1.62, off by < 2^-63 on 0..1; printed by tests/exact/gauss_coefficients.py. */
/* clang-format off */
static const int64_t gauss_coefficient[] = {
    INT64_C(4611686018427387904),
    INT64_C(-4611686018427387904),
    INT64_C(1537228672809129187),
    INT64_C(-204963823041202087),
    INT64_C(10980204804983791),
    INT64_C(-244004529195297),
    INT64_C(-7394449473368),
    INT64_C(-5358566600847),
    INT64_C(-2889535085333),
    INT64_C(-1261383954339),
    INT64_C(-1517806780370),
    INT64_C(2270939252367),
    INT64_C(-6708310050724),
    INT64_C(12548361250167),
    INT64_C(-18818080236510),
    INT64_C(21332030655007),
    INT64_C(-18243119585130),
    INT64_C(11344592357050),
    INT64_C(-4875727488197),
    INT64_C(1297533102584),
    INT64_C(-164032749236),
};
/* clang-format on */
enum { GAUSS_DEGREE = sizeof gauss_coefficient / sizeof *gauss_coefficient - 1 };

/* g^n in Q0.64, 0 < t <= 1. Each Horner step truncates by < 2^-61 and is then multiplied by t <= 1: g is good to 2^-57,
 * g^n to 2^-48 = 2^-32 ulp. As g' <= -0.29 a step of t moves g by 2^-32 at the least: monotone. */
static uint64_t gauss_power(uint32_t n, uint32_t t)
{
    int64_t g = gauss_coefficient[GAUSS_DEGREE]; /* |g| <= 1 */
    for (int k = GAUSS_DEGREE - 1; k >= 0; k--)
        g = gauss_coefficient[k] + (g >> 32) * (int64_t)t * 4 + (int64_t)((uint64_t)(uint32_t)g * t >> 30);
    return glint_power((uint64_t)g << 2, n);
}

uint32_t glint_gauss_t(uint32_t n, uint32_t t)
{
    if (t > GLINT_T_ONE)
        return 0;
    if (t == 0)
        return (uint32_t)GLINT_C_ONE; /* 1.0 has no place in Q0.64 */
    return glint_power_round(gauss_power(glint_clamp_n(n), t));
}

uint32_t glint_gauss(uint32_t n, int32_t c_q16)
{
    return glint_gauss_t(n, glint_t_of_c(c_q16));
}

static bool gauss_reaches(uint32_t n, uint32_t t, unsigned q)
{
    return gauss_power(n, t) >> (64 - q) != 0;
}

uint32_t glint_gauss_cutoff_t(uint32_t n, unsigned q)
{
    return q == 0 ? 0 : glint_largest_t(gauss_reaches, n, q); /* F >= 1 only at t = 0 */
}

uint32_t glint_gauss_cutoff(uint32_t n, unsigned q)
{
    return glint_c_of_cutoff_t(glint_gauss_cutoff_t(n, q));
}
