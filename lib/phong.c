/* SPDX-License-Identifier: MIT
 * Phong: Blinn's power in other geometry. */
#include "glint_lobe.h"

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
