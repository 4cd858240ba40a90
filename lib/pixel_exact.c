/* SPDX-License-Identifier: MIT */
#include "glint_pixel_exact.h"

#define ONE ((uint64_t)65535 << 32) /* a value of 1.0 */

const uint16_t glint_pixel_bayer_rows[4] GLINT_FLASH = {0xa280, 0x6e4c, 0x91b3, 0x5d7f};

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

static void exact_store_565(uint8_t *low, uint8_t *high, const uint8_t *levels, unsigned count, uint32_t open)
{
    for (const uint8_t *end = levels + 4 * count; levels != end; levels += 4, low += 2, high += 2, open >>= 1) {
        const uint32_t pixel = (uint32_t)levels[0] << 11 | (uint32_t)levels[1] << 5 | levels[2];
        if (!(open & 1)) {
            *low = (uint8_t)pixel;
            *high = (uint8_t)(pixel >> 8);
        }
    }
}

static void exact_store_rgb(uint8_t *red, int blue, unsigned bytes, const uint8_t *levels, unsigned count,
                            uint32_t open)
{
    for (const uint8_t *end = levels + 4 * count; levels != end; levels += 4, red += bytes, open >>= 1) {
        if (!(open & 1)) {
            red[0] = levels[0];
            red[blue / 2] = levels[1];
            red[blue] = levels[2];
        }
    }
}

static void exact_store_mono(uint8_t *line, uint32_t x, const uint8_t *levels, unsigned count, uint32_t open)
{
    for (; count--; levels++, x++, open >>= 1) {
        const uint8_t bit = (uint8_t)(0x80 >> (x & 7));
        if (!(open & 1))
            line[x >> 3] = (uint8_t)(*levels ? line[x >> 3] | bit : line[x >> 3] & ~bit);
    }
}

void glint_exact_store_run(uint8_t format, uint8_t *line, uint32_t x, const uint8_t *levels, unsigned count,
                           uint32_t open)
{
    const unsigned bytes = GLINT_FLASH_U8(glint_exact_formats[format].bytes);
    uint8_t *out = line + bytes * x;
    if (bytes == 2) {
        const bool swapped = format == GLINT_RGB565_SWAPPED;
        exact_store_565(out + swapped, out + !swapped, levels, count, open);
    } else if (bytes > 2) {
        const bool blue_first = glint_format_is_blue_first(format);
        exact_store_rgb(blue_first ? out + 2 : out, blue_first ? -2 : 2, bytes, levels, count, open);
    } else if (bytes) {
        for (; count--; out++, levels++, open >>= 1)
            if (!(open & 1))
                *out = *levels;
    } else {
        exact_store_mono(line, x, levels, count, open);
    }
}

void glint_exact_store(uint8_t format, uint8_t *line, uint32_t x, const uint8_t levels[4])
{
    glint_exact_store_run(format, line, x, levels, 1, 0);
}

void glint_exact_alpha(uint8_t format, uint8_t *line, uint32_t x, unsigned count, const uint8_t *mask)
{
    if (format != GLINT_XRGB8888 && format != GLINT_ARGB8888)
        return;
    mask = mask && format == GLINT_ARGB8888 ? mask + x : NULL;
    for (line += 4 * x + 3; count--; line += 4)
        *line = mask ? *mask++ : 255;
}
