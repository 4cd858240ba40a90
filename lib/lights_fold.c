/* SPDX-License-Identifier: MIT
 * Under one lamp of colour c a channel of the sequence takes D N and S F, with N = round(c x), x = att nl, and F likewise. Here
 * D' n takes the place of D N, with n = round(C x) of the brightest channel, C, which all share, and D' = floor(D c / C): coloured
 * is as fast as white.
 *
 * In units of 2^-16, with c <= C: N = c x + a and n = C x + b, |a|, |b| <= 1/2; D' = D c / C - e, 0 <= e < 1 + 2^-7. So
 * D N - D' n = D (a - b c / C) + e n, from -D to D + (1 + 2^-7) 2, as n <= 2; and of S and F, which is up to 33/16 and its slack,
 * likewise. With M levels V is high by at most M (D + S) units of 2^(shift - 16), which is taken off thresholds, and W grows by
 * twice that and by 33/8 M. Albedo and gloss, <= 1, only lessen this; in grey the channels' parts of M add up to M. tests/proof
 * shows it. */
#include "glint_lights_fold.h"
#include "glint_lights.h"
#include "glint_pixel_exact.h"

/* x c / C, rounded down, low by < 1 + 2^-7: c / C in 23 bits, 11 and then 12. x <= 2^16, c <= C <= 2^20. */
static uint32_t fold_by(uint32_t x, uint32_t c, uint32_t most)
{
    const uint32_t first = (c << 11) / most, rest = (c << 11) - first * most; /* rest < 2^20 */
    return (uint32_t)((uint64_t)x * ((first << 12) + (rest << 12) / most) >> 23);
}

void glint_lights_fold(struct glint_prepared *p, const struct glint_lamp *lamp)
{
    struct glint_material *const m = &p->shader.material;
    const struct glint_material given = *m;
    const uint32_t peak = glint_lights_peak(lamp);
    const uint32_t max = GLINT_FLASH_U8(glint_exact_formats[p->shader.format].max[1]); /* the largest channel's */
    uint32_t most = 0;                                                                 /* D + S, <= 2^17 */
    for (unsigned k = 0; k < 3; k++) {
        const uint32_t d = glint_coefficient(m->diffuse_q16[k]), s = glint_coefficient(m->specular_q16[k]);
        const uint32_t color = glint_lights_color(lamp, k);
        m->diffuse_q16[k] = fold_by(d, color, peak);
        m->specular_q16[k] = fold_by(s, color, peak);
        most = d + s > most ? d + s : most;
    }
    const uint32_t high = (max * most + 131071) >> 17; /* of 2^(shift - 15): <= 255 */
    p->high = (uint8_t)(high ? high : 1);              /* 0: this was not done */
    GLINT_FLASH_POINTER(p->format->fold)(p);
    const uint32_t w = 4 * (uint32_t)p->high + 4 * max + (max >> 3) + 1; /* of 2^(shift - 16): < 2^12 */
    if (!glint_format_is_grey(p->shader.format) && !p->shader.dither)    /* P has the threshold, if there are no maps */
        for (unsigned k = 0; k < 3; k++)
            p->p[k] -= (uint32_t)p->high << (p->shift - 15);
    p->w += w << (p->shift - 16);
    p->w_maps += w << (p->shift - 16);
    *m = given;
}
