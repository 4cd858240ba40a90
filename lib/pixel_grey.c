/* SPDX-License-Identifier: MIT
 * GREY8 and MONO in gamma space. A level is the sum of three parts, each held to its channel's share. */
#include "glint_pixel_levels.h"

enum { GREY_RED = 54, GREY_GREEN = 183, GREY_BLUE = 19 }; /* of 256: step 6 */

static bool grey_draws(const struct glint_shader *shader)
{
    return glint_format_is_grey(shader->format) && shader->space == GLINT_GAMMA;
}

static uint32_t grey_max(const struct glint_shader *shader)
{
    return shader->format == GLINT_GREY8 ? 255 : 1;
}

static void grey_fold(struct glint_prepared *prepared)
{
    const uint8_t max = (uint8_t)grey_max(&prepared->shader);
    const struct glint_levels_kind kind = {{max, max, max}, {GREY_RED, GREY_GREEN, GREY_BLUE}};
    glint_levels_fold(prepared, kind, false);
}

GLINT_INLINE uint32_t grey_loop(const struct glint_prepared *p, const struct glint_run *run,
                                const struct glint_sample *sample, unsigned count, bool maps)
{
    const unsigned shift = (unsigned)p->shift;
    const uint32_t w = maps ? p->w_maps : p->w, max = grey_max(&p->shader), most = max << shift;
    /* The shares of 1.0: low by < 1 */
    const uint32_t red = (most >> 8) * GREY_RED, green = (most >> 8) * GREY_GREEN, blue = (most >> 8) * GREY_BLUE;
    const uint8_t *albedo = maps && run->albedo ? run->albedo : p->shader.material.albedo, *gloss = run->gloss;
    const unsigned step = maps && run->albedo ? 3 : 0;
    uint32_t bias[4], open = 0;
    uint8_t levels[GLINT_RUN];
    glint_levels_bias(bias, p, run);
    for (unsigned i = 0; i < count; i++, sample++, albedo += maps ? step : 0) {
        uint32_t v[3];
        glint_levels_sum(v, p, p->p, sample, albedo, gloss ? gloss + i : gloss, maps);
        /* Step 6 rounds down: by less than 1 here, which is taken off */
        const uint32_t sum = bias[i & 3] - 1 + glint_levels_hold(v[0], red) + glint_levels_hold(v[1], green) +
                             glint_levels_hold(v[2], blue);
        const uint32_t held = glint_levels_hold(sum, most);
        levels[i] = (uint8_t)(held >> shift);
        if ((held ^ (held + w)) >> shift)
            open |= (uint32_t)1 << i;
    }
    glint_exact_store_run(p->shader.format, run->line, run->x, levels, count, open);
    return open;
}

static uint32_t grey_plain(const struct glint_prepared *prepared, const struct glint_run *run,
                           const struct glint_sample *samples, unsigned count)
{
    return grey_loop(prepared, run, samples, count, false);
}

static uint32_t grey_mapped(const struct glint_prepared *prepared, const struct glint_run *run,
                            const struct glint_sample *samples, unsigned count)
{
    return grey_loop(prepared, run, samples, count, true);
}

static uint32_t grey_levels(const struct glint_prepared *prepared, const struct glint_run *run,
                            const struct glint_sample *samples, unsigned count)
{
    return run->albedo || run->gloss ? grey_mapped(prepared, run, samples, count)
                                     : grey_plain(prepared, run, samples, count);
}

static void grey_exact(const struct glint_shader *shader, const struct glint_run *run, unsigned i, uint32_t nl_q16,
                       uint32_t f_q16)
{
    const uint32_t x = run->x + i, weight = glint_exact_weight(shader, run->left + x, run->y);
    uint64_t v[3];
    glint_levels_exact(v, shader, run, i, nl_q16, f_q16);
    const uint64_t sum = (GREY_RED * v[0] + GREY_GREEN * v[1] + GREY_BLUE * v[2]) >> 8;
    const uint8_t levels[4] = {(uint8_t)glint_exact_level(sum, grey_max(shader), weight), 0, 0, 0};
    glint_exact_store(shader->format, run->line, x, levels);
}

const struct glint_shade_format glint_shade_grey GLINT_FLASH = {grey_draws, grey_fold, grey_levels, grey_exact, NULL};
