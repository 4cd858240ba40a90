/* SPDX-License-Identifier: MIT */
#include "glint_lights_apart.h"
#include "glint_pixel.h"
#include "glint_pixel_levels.h"

/* V as with maps, and so W, a channel after the other. In grey the sum of the channels' shares is the level; step 6 rounds it down,
 * by less than 1 here, which is taken off. */
uint32_t glint_apart_levels(const struct glint_prepared *p, const struct glint_run *run,
                            const struct glint_sample *samples, unsigned count)
{
    static const uint8_t luma[3] GLINT_FLASH = {GLINT_LUMA_RED, GLINT_LUMA_GREEN, GLINT_LUMA_BLUE};
    const unsigned shift = (unsigned)p->shift;
    const bool grey = glint_format_is_grey(p->shader.format);
    const uint8_t *albedo = run->albedo ? run->albedo : p->shader.material.albedo;
    uint32_t bias[4], open = 0;
    glint_levels_bias(bias, p, run);
    glint_levels_alpha(p->shader.format, run, 0, count);
    for (unsigned i = 0; i < count; i++, albedo += run->albedo ? 3 : 0) {
        const struct glint_sample *sample = samples + i;
        uint32_t sum = bias[i & 3] - grey, undecided = 0;
        uint8_t levels[4];
        for (unsigned k = 0; k < 3; k++, sample += p->apart) {
            const uint32_t most = (uint32_t)GLINT_FLASH_U8(glint_exact_formats[p->shader.format].max[k]) << shift;
            const uint32_t f = run->gloss ? glint_by_255(sample->f_q16 * run->gloss[i]) : sample->f_q16;
            uint32_t v = (albedo[k] * ((p->ambient[k] + p->diffuse[k] * sample->nl_q16) >> 7)) + p->r[k] * f;
            if (grey)
                v = sum += glint_levels_hold(v, (most >> 8) * GLINT_FLASH_U8(luma[k]));
            else
                v += sum;
            v = glint_levels_hold(v, most);
            if (!grey || k == 2)
                undecided |= v ^ (v + p->w_maps);
            levels[k] = (uint8_t)(v >> shift);
        }
        levels[0] = levels[grey ? 2 : 0];
        if (undecided >> shift)
            open |= (uint32_t)1 << i;
        else
            glint_exact_store(p->shader.format, run->line, run->x + i, levels);
    }
    return open;
}
