/* SPDX-License-Identifier: MIT
 * Blinn and Phong, eq. (1): F = c^n; Phong is Blinn's power in other geometry. */
#include "glint_lobe.h"
#include "glint_math.h"

static uint64_t blinn_power(uint32_t n, uint32_t t)
{
    return glint_power((uint64_t)(GLINT_T_ONE - t) << 34, n);
}

/* The normative sequence: within 2^-37 ulp before rounding, which is enough: no c_q16 but the tie c = 1/2, n = 17, where
 * the power is exact, lies that near to a half. (From t some may: 0.501 ulp is promised.) glint_power_near decides its
 * rounding but for one t in 65536 / (3n - 1). */
uint32_t glint_blinn_t(uint32_t n, uint32_t t)
{
    if (t >= GLINT_T_ONE)
        return 0;
    if (t == 0)
        return (uint32_t)GLINT_C_ONE; /* 1.0 has no place in Q0.64 */
    n = glint_clamp_n(n);
    const uint32_t near = glint_power_near((GLINT_T_ONE - t) << 2, n), low = (near >> 1) + 16384;
    if ((low ^ (low + (GLINT_POWER_LOW(n) + 1) / 2)) >> 15 == 0)
        return low >> 15;
    return glint_power_round(blinn_power(n, t));
}

uint32_t glint_blinn(uint32_t n, int32_t c_q16)
{
    return glint_blinn_t(n, glint_t_of_c(c_q16));
}

/* Powers of two, where F = 2^-q can hold exactly, are exact; elsewhere the margin is tested for every n and q. */
static bool blinn_reaches(uint32_t n, uint32_t t, unsigned q)
{
    return blinn_power(n, t) >> (64 - q) != 0;
}

uint32_t glint_blinn_cutoff_t(uint32_t n, unsigned q)
{
    return q == 0 ? 0 : glint_largest_t(blinn_reaches, n, q); /* F >= 1 only at t = 0 */
}

uint32_t glint_blinn_cutoff(uint32_t n, unsigned q)
{
    return glint_c_of_cutoff_t(glint_blinn_cutoff_t(n, q));
}

/* ---- from below, over a run of samples ---- */

/* The power is f 2^-32 or up to 3n - 2 < 2^12 more of 2^-32: F is this or 1 more. */
static inline uint32_t blinn_near(const struct glint_paint *paint, uint32_t t)
{
    return t == 0 ? 65536 : ((glint_power_near((GLINT_T_ONE - t) << 2, paint->of.exact.n) >> 15) + 1) >> 1;
}

void glint_blinn_run(const struct glint_paint *paint, struct glint_sample *samples, unsigned count)
{
    glint_near_run(paint, samples, count, blinn_near);
}

const struct glint_use_model glint_use_blinn GLINT_FLASH = {
    GLINT_BLINN, 1, NULL, NULL, glint_blinn_run, glint_blinn_t, glint_blinn_cutoff_t, NULL, NULL};

/* ---- Phong ---- */

/* A component of step 1's w, L + V - R in Q24, in 32 bits as p = N.L fits: of p n the halves of p, as floors of floors are
 * one floor. ph n <= 2^30, pl n < 2^31. */
static int32_t phong_off(int32_t l, int32_t v, int32_t p, int32_t n)
{
    const int32_t ph = p >> 16, pl = p & 0xffff;
    return (l + v) * 512 + ((8 - ph * n + (-(pl * n) >> 16)) >> 4);
}

/* t from w, each below 1.5 2^24 in size: with w = 2^13 a + b, w^2 = 2^26 a^2 + 2^14 a b + b^2. Sums: < 6.75 2^22, 3 2^25, 3 2^26. */
static uint32_t phong_squares(const int32_t w[3])
{
    int32_t aa = 0, ab = 0, bb = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t a = w[i] >> 13, b = w[i] & 0x1fff;
        aa += a * a;
        ab += a * b;
        bb += b * b;
    }
    return ((uint32_t)aa << 7) + (uint32_t)((ab + (bb >> 14)) >> 5);
}

void glint_samples_phong(const struct glint_vec *l_of, const struct glint_vec *v_of, const struct glint_vec *h,
                         const struct glint_vec *normals, struct glint_sample *samples, unsigned count)
{
    const int32_t far = (int32_t)3 << 23; /* t > 2^30: F = 0 */
    const struct glint_vec l = *l_of, v = *v_of;
    (void)h;
    for (const struct glint_vec *n = normals; n != normals + count; n++, samples++) {
        const int32_t x = n->x, y = n->y, z = n->z, p = x * l.x + y * l.y + z * l.z;
        samples->nl_q16 = glint_sample_nl(p);
        samples->t_q30 = UINT32_MAX;
        if (samples->nl_q16 == 0)
            continue;
        const int32_t w[3] = {phong_off(l.x, v.x, p, x), phong_off(l.y, v.y, p, y), phong_off(l.z, v.z, p, z)};
        if (w[0] < far && w[0] > -far && w[1] < far && w[1] > -far && w[2] < far && w[2] > -far)
            samples->t_q30 = phong_squares(w);
    }
}

const struct glint_use_model glint_use_phong GLINT_FLASH = {
    GLINT_PHONG, 1, glint_samples_phong, NULL, glint_blinn_run, glint_blinn_t, glint_blinn_cutoff_t, NULL, NULL};
