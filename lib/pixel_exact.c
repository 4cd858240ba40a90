/* SPDX-License-Identifier: MIT */
#include "glint_pixel_exact.h"

#define ONE ((uint64_t)65535 << 32) /* a value of 1.0 */

static const uint8_t bayer[4][4] GLINT_FLASH = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

uint32_t glint_pixel_bayer(uint32_t x, uint32_t y)
{
    return GLINT_FLASH_U8(bayer[y & 3][x & 3]);
}

uint32_t glint_exact_weight(const struct glint_shader *shader, uint32_t x, uint32_t y)
{
    return shader->dither ? 2 * glint_pixel_bayer(x, y) + 1 : 16;
}

uint64_t glint_exact_value(const struct glint_material *m, int k, uint32_t albedo, uint32_t nl_q16, uint64_t shine)
{
    const uint64_t lit = ((uint64_t)glint_coefficient(m->ambient_q16[k]) << 16) +
                         (uint64_t)glint_coefficient(m->diffuse_q16[k]) * nl_q16;
    const uint64_t x = albedo * lit + glint_coefficient(m->specular_q16[k]) * shine;
    return x < ONE ? x : ONE;
}

uint32_t glint_exact_level(uint64_t x, uint32_t max, uint32_t weight)
{
    const uint32_t z = (uint32_t)((x * max + ((uint64_t)65535 << 27) * weight) >> 32);
    /* z / 65535 for z = 65535 q + r = 65536 q + r - q, q <= 256: z >> 16 is q, or q - 1 where r < q */
    return (z + (z >> 16) + 1) >> 16;
}

#define EXACT_TRAITS(number, name, bytes, channels, red, green, blue) {bytes, channels, {red, green, blue}},
const struct glint_format_traits glint_exact_formats[GLINT_FORMAT_COUNT] GLINT_FLASH = {GLINT_FORMATS(EXACT_TRAITS)};

void glint_exact_store(uint8_t format, uint8_t *line, uint32_t x, const uint8_t levels[3])
{
    if (glint_format_is_565(format)) {
        const uint32_t pixel = (uint32_t)levels[0] << 11 | (uint32_t)levels[1] << 5 | levels[2];
        const bool swapped = format == GLINT_RGB565_SWAPPED;
        line[2 * x + swapped] = (uint8_t)pixel;
        line[2 * x + !swapped] = (uint8_t)(pixel >> 8);
    } else if (format == GLINT_RGB888) {
        line[3 * x] = levels[0];
        line[3 * x + 1] = levels[1];
        line[3 * x + 2] = levels[2];
    } else if (format == GLINT_GREY8) {
        line[x] = levels[0];
    } else if (format == GLINT_MONO) {
        const uint8_t bit = (uint8_t)(0x80 >> (x & 7));
        line[x >> 3] = (uint8_t)(levels[0] ? line[x >> 3] | bit : line[x >> 3] & ~bit);
    } else { /* blue first */
        line += (format == GLINT_BGR888 ? 3 : 4) * x;
        line[0] = levels[2];
        line[1] = levels[1];
        line[2] = levels[0];
    }
}

void glint_exact_alpha(uint8_t format, uint8_t *line, uint32_t x, unsigned count, const uint8_t *mask)
{
    if (format != GLINT_XRGB8888 && format != GLINT_ARGB8888)
        return;
    mask = mask && format == GLINT_ARGB8888 ? mask + x : NULL;
    for (line += 4 * x + 3; count--; line += 4)
        *line = mask ? *mask++ : 255;
}
