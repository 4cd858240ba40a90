/* SPDX-License-Identifier: MIT
 * Every format in linear space. The light x of step 7 is found as V, 65535 2^14 = 1.0, low by at most W; encoded and as a level,
 * V and V + W mostly agree. */
#include "glint_pixel.h"
#include "glint_pixel_levels.h"

#define LINEAR_ONE UINT32_C(65535)
enum { LINEAR_BITS = 14 };

static bool linear_draws(const struct glint_shader *shader)
{
    return shader->format <= GLINT_MONO && shader->space == GLINT_LINEAR;
}

/* What V is low by, in its units, where nl <= 2^16 and F <= 67109 < 33/32 2^16. */
static void linear_fold(struct glint_prepared *p)
{
    const struct glint_material *m = &p->shader.material;
    const uint32_t slack = GLINT_FLASH_U8(p->model->slack);
    p->w = p->w_maps = 0;
    for (int k = 0; k < 3; k++) {
        const uint32_t d = glint_coefficient(m->diffuse_q16[k]), s = glint_coefficient(m->specular_q16[k]);
        p->p[k] = glint_coefficient(m->ambient_q16[k]) << 14;
        p->q[k] = d < 65536 ? d : 65535; /* its product with nl in 32 bits */
        p->r[k] = s >> 1;                /* its product with F < 2^32 */
        p->ambient[k] = glint_srgb_decode(m->albedo[k]);
        /* lit, Q30: nl / 4 where d is cut, and 1, times albedo 2^-16; that product: 1. S: F / 4 where s is odd, S / 4 + 1 a unit
         * of F. Sums and shifts of step 6: 256. The rest: 4. */
        const uint32_t w = (d - p->q[k]) * (1 << 14) + 2 + (s & 1) * (33 << 9) + slack * (s / 4 + 1) + 256 + 4;
        const uint32_t w_maps = w + s / 4 + s / 256 + 2; /* F gloss / 255: glint_by_255 */
        p->w = w > p->w ? w : p->w;
        p->w_maps = w_maps > p->w_maps ? w_maps : p->w_maps;
    }
}

/* a b 2^-16, low by < 1: a < 2^16, b <= 2^31. */
GLINT_INLINE uint32_t linear_product(uint32_t a, uint32_t b)
{
    return a * (b >> 16) + (a * (b & 0xffff) >> 16);
}

/* V of channel k for a run: set, or added as so many parts of 256 of what is held to 1.0. V <= 3.03 65535 2^14 < 2^32 - 2^26. */
static void linear_sum(uint32_t *v, const struct glint_prepared *p, int k, const struct glint_run *run,
                       const struct glint_sample *sample, unsigned count, uint32_t part)
{
    const uint32_t a = p->p[k], d = p->q[k], s = p->r[k], one = LINEAR_ONE << LINEAR_BITS;
    const uint8_t *map = run->albedo ? run->albedo + k : NULL, *gloss = run->gloss;
    uint32_t albedo = p->ambient[k];
    for (const struct glint_sample *end = sample + count; sample != end; sample++, v++) {
        uint32_t f = sample->f_q16;
        if (gloss)
            f = glint_by_255(f * *gloss++);
        if (map) {
            albedo = glint_srgb_decode(*map);
            map += 3;
        }
        const uint32_t lit = a + (d * sample->nl_q16 >> 2), shine = s * f; /* Q30, <= 2^31; Q31 */
        /* 65535/65536 of shine in Q30: high by < 1 */
        const uint32_t sum = linear_product(albedo, lit) + ((shine - (shine >> 16)) >> 1);
        if (part)
            *v = (k ? *v : 0) + part * (glint_levels_hold(sum, one) >> 8);
        else
            *v = sum;
    }
}

/* Steps 7 and 8 for a run: levels; the bits of those that are open. The encoding rises by at most 13 a unit; z / 65535 for
 * z < 2^25 without a division. */
static uint32_t linear_encode(uint8_t *level, const uint32_t *v, unsigned count, uint32_t w, uint32_t max,
                              const uint32_t threshold[4])
{
    const uint32_t half = ((uint32_t)1 << (LINEAR_BITS - 1)) - 2;
    uint32_t open = 0;
    for (unsigned i = 0; i < count; i++) {
        const uint32_t at = v[i] + half, low = at >> LINEAR_BITS, high = (at + w) >> LINEAR_BITS;
        if (low >= LINEAR_ONE) {
            level[i] = (uint8_t)max;
            continue;
        }
        const uint32_t z = glint_srgb_encode((uint16_t)low) * max + threshold[i & 3];
        const uint32_t found = (z + (z >> 16) + 1) >> 16, room = (found + 1) * LINEAR_ONE - z;
        level[i] = (uint8_t)found;
        if ((high - low) * 13 * max < room)
            continue;
        const uint32_t most = high < LINEAR_ONE ? high : LINEAR_ONE;
        if (glint_srgb_encode((uint16_t)most) * max + threshold[i & 3] >= (found + 1) * LINEAR_ONE)
            open |= (uint32_t)1 << i;
    }
    return open;
}

static uint32_t linear_levels(const struct glint_prepared *p, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count)
{
    static const uint8_t luma[3] GLINT_FLASH = {GLINT_LUMA_RED, GLINT_LUMA_GREEN, GLINT_LUMA_BLUE};
    const uint8_t *max = glint_exact_max[p->shader.format];
    const bool grey = p->shader.format >= GLINT_GREY8;
    const uint32_t w = run->gloss ? p->w_maps : p->w;
    uint32_t v[GLINT_RUN], threshold[4], open = 0;
    uint8_t level[3][GLINT_RUN];
    for (unsigned i = 0; i < 4; i++)
        threshold[i] = LINEAR_ONE * glint_exact_weight(&p->shader, run->left + run->x + i, run->y) >> 5;
    for (int k = 0; k < 3; k++) {
        linear_sum(v, p, k, run, samples, count, grey ? GLINT_FLASH_U8(luma[k]) : 0);
        if (!grey)
            open |= linear_encode(level[k], v, count, w, GLINT_FLASH_U8(max[k]), threshold);
    }
    if (grey)
        open = linear_encode(level[0], v, count, w, GLINT_FLASH_U8(max[0]), threshold);
    for (unsigned i = 0; i < count; i++) {
        const uint8_t green = level[grey ? 0 : 1][i], blue = level[grey ? 0 : 2][i];
        const uint8_t levels[3] = {level[0][i], green, blue};
        if (!(open >> i & 1))
            glint_exact_store(p->shader.format, run->line, run->x + i, levels);
    }
    return open;
}

static void linear_exact(const struct glint_shader *shader, const struct glint_run *run, unsigned i, uint32_t nl_q16,
                         uint32_t f_q16)
{
    const struct glint_surface surface = {run->line, 0, (uint16_t)run->left, (uint16_t)run->y};
    glint_pixel_store(shader, &surface, (uint16_t)(run->x + i), 0, nl_q16, f_q16,
                      run->albedo ? run->albedo + 3 * i : shader->material.albedo, run->gloss ? run->gloss[i] : 255);
}

const struct glint_shade_format glint_shade_linear GLINT_FLASH = {linear_draws, linear_fold, linear_levels,
                                                                  linear_exact};
