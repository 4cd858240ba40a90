/* SPDX-License-Identifier: MIT */
#include "glint_pixel_levels.h"

/* Called, not inlined, for less code: it is only set-up. */
#define LEVELS_CALLED __attribute__((noinline)) static

/* n / 2^bits, rounded down, and by how much that times 2^16 is low where n is low by less than 2. bits <= 16. */
struct levels_cut {
    uint32_t value, low; /* low <= 2^16 + 2^12 */
};
LEVELS_CALLED struct levels_cut levels_cut_of(uint32_t n, unsigned bits)
{
    const struct levels_cut cut = {n >> bits, ((n & (((uint32_t)1 << bits) - 1)) + 2) << (16 - bits)};
    return cut;
}

/* A coefficient in levels of channel k, Q16: low by < 1, in RGB exact. 2^16 255 256 < 2^32. */
LEVELS_CALLED uint32_t levels_scaled(uint32_t q16, struct glint_levels_kind kind, int k)
{
    return glint_coefficient(q16) * kind.max[k] * kind.part[k] >> 8;
}

/* n / 255, rounded down, without a division: the first sum is low by less than 4, and never high. */
static uint32_t levels_by_255(uint32_t n)
{
    uint32_t q = (n >> 8) + (n >> 16) + (n >> 24);
    while (n - q * 255 >= 255)
        q++;
    return q;
}

/* The largest shift at which the largest sum of a channel, or the largest level, and a threshold, less than 1, leave
 * V < 2^32 - 2^20. A sum of 3.03 * 255 leaves 22. */
static unsigned levels_shift(const struct glint_material *m, struct glint_levels_kind kind)
{
    uint32_t most = (uint32_t)kind.max[1] << 16;
    for (int k = 0; k < 3; k++) {
        const uint32_t s = glint_coefficient(m->specular_q16[k]); /* F <= 67109 < 33/32 2^16 */
        const uint32_t sum =
            (glint_coefficient(m->ambient_q16[k]) + glint_coefficient(m->diffuse_q16[k]) + s + (s >> 5) + 1) *
            kind.max[k];
        most = sum > most ? sum : most;
    }
    unsigned shift = 28;
    while (most + 65536 > UINT32_C(0xfff00000) >> (shift - 16))
        shift--;
    return shift;
}

/* Every n below is < 2^24, and low by < 2. */
void glint_levels_fold(struct glint_prepared *p, struct glint_levels_kind kind, bool threshold)
{
    const struct glint_material *m = &p->shader.material;
    const unsigned shift = levels_shift(m, kind);
    const bool grey = kind.part[0] < 256;
    const uint32_t half = threshold ? (uint32_t)1 << (shift - 1) : 0;
    p->shift = shift;
    p->w = p->w_maps = 0;
    for (int k = 0; k < 3; k++) {
        const uint32_t albedo = m->albedo[k], a = levels_scaled(m->ambient_q16[k], kind, k);
        const uint32_t d = levels_scaled(m->diffuse_q16[k], kind, k);
        const struct levels_cut q = levels_cut_of(levels_by_255(d * albedo), 32 - shift);
        const struct levels_cut r = levels_cut_of(levels_scaled(m->specular_q16[k], kind, k), 32 - shift);
        const struct levels_cut diffuse = levels_cut_of(levels_by_255(d * 256), 33 - shift);
        p->p[k] = (levels_by_255(a * albedo) << (shift - 16)) + half; /* low by < 2 2^(shift - 16) */
        p->ambient[k] = levels_by_255(a * 256) << (shift - 17);       /* low by < 2 2^(shift - 17), times 255 / 2^7 */
        p->q[k] = q.value;                                            /* Q nl: low by q.low, as nl <= 2^16 */
        p->diffuse[k] = diffuse.value;                                /* low by diffuse.low, times 255 / 2^7 */
        p->r[k] = r.value; /* R F: low by 33/32 r.low, and (R + 1) slack of F */
        /* 4: what the loop of grey takes off and step 6 cuts, < 2 in three channels (tests/proof) */
        const uint32_t both = ((uint32_t)2 << (shift - 16)) + r.low + (r.low >> 5) + 1 + p->slack * (r.value + 1) + 4;
        const uint32_t w = both + q.low;
        /* >> 7 loses < 1 of 255, and F gloss / 255 < 1 + 2^-6: glint_by_255. W < 2^shift for a slack up to 64, of which
         * a unit is R + 1 <= 2^(shift - 8) */
        const uint32_t w_maps = both + 2 * diffuse.low + 255 + r.value + (r.value >> 6) + 2;
        p->w = grey ? p->w + w : w > p->w ? w : p->w;
        p->w_maps = grey ? p->w_maps + w_maps : w_maps > p->w_maps ? w_maps : p->w_maps;
    }
}

/* The threshold of b, the lowest 4 bits of row, times 2^shift: 2b + 1 of 32, or 16. one: 2^15 / 32, or 16 times that, less
 * prepared->high. */
static inline uint32_t levels_threshold(uint32_t row, uint32_t one, uint32_t shift)
{
    return ((row << 28 >> 17) + one) << (shift - 15);
}

void glint_levels_bias(uint32_t bias[4], const struct glint_prepared *p, const struct glint_run *run)
{
    const bool dither = p->shader.dither;
    const uint32_t shift = p->shift, one = (dither ? 1024u : 16384u) - p->high;
    uint32_t row = dither ? glint_pixel_bayer_row(run->left + run->x, run->y) : 0;
    for (unsigned i = 0; i < 4; i++, row >>= 4)
        bias[i] = levels_threshold(row, one, shift);
}

void glint_levels_base(uint32_t base[12], const struct glint_prepared *p, const struct glint_run *run)
{
    const uint32_t shift = p->shift, one = 1024u - p->high;
    uint32_t row = glint_pixel_bayer_row(run->left + run->x, run->y);
    for (const uint32_t *end = base + 12; base != end; base += 3, row >>= 4) {
        const uint32_t threshold = levels_threshold(row, one, shift);
        for (unsigned k = 0; k < 3; k++)
            base[k] = p->p[k] + threshold;
    }
}

void glint_levels_exact(uint64_t v[3], const struct glint_shader *shader, const struct glint_run *run, unsigned i,
                        uint32_t nl_q16, uint32_t f_q16)
{
    const uint8_t *albedo = run->albedo ? run->albedo + 3 * i : shader->material.albedo;
    const uint64_t shine = (uint64_t)((run->gloss ? run->gloss[i] : 255) * 257u) * f_q16;
    for (int k = 0; k < 3; k++)
        v[k] = glint_exact_value(&shader->material, k, albedo[k] * 257u, nl_q16, shine);
}
