/* SPDX-License-Identifier: MIT
 * Steps 5 and 8 of the pixel's sequence (sequence.md) as they are written there, in 64 bits; not for users. */
#ifndef GLINT_PIXEL_EXACT_H
#define GLINT_PIXEL_EXACT_H

#include "glint.h"
#include "glint_math_flash.h"

/* Step 5: albedo of step 4, 65535 = 1.0; nl < 2^23, shine = g F < 2^39: what several lights may sum to. */
uint64_t glint_exact_value(const struct glint_material *material, int k, uint32_t albedo, uint32_t nl_q16,
                           uint64_t shine);
/* Step 8. weight / 32 is the threshold: 2b + 1, or 16. */
uint32_t glint_exact_level(uint64_t x, uint32_t max, uint32_t weight);
/* What GLINT_FORMATS says of a format. */
struct glint_format_traits {
    uint8_t bytes, channels, max[3];
};
extern const struct glint_format_traits glint_exact_formats[GLINT_FORMAT_COUNT]; /* GLINT_FLASH */
/* The same where the loops ask for it, without a load. */
static inline bool glint_format_is_565(uint8_t format)
{
    return format == GLINT_RGB565 || format == GLINT_RGB565_SWAPPED;
}
static inline bool glint_format_is_grey(uint8_t format)
{
    return format == GLINT_GREY8 || format == GLINT_MONO;
}
static inline bool glint_format_is_blue_first(uint8_t format)
{
    return format >= GLINT_BGR888 && format <= GLINT_ARGB8888;
}
/* Stores the levels of pixel x of a line; all are the same in grey. Not alpha. */
void glint_exact_store(uint8_t format, uint8_t *line, uint32_t x, const uint8_t levels[4]);
/* Those of pixels x..: 4 bytes a pixel, in grey 1; not of those whose bits are set in open, the first pixel's the lowest. */
void glint_exact_store_run(uint8_t format, uint8_t *line, uint32_t x, const uint8_t *levels, unsigned count,
                           uint32_t open);
/* Alpha or X of pixels x.. of a line, where the format has one; mask: the line's, or NULL. */
void glint_exact_alpha(uint8_t format, uint8_t *line, uint32_t x, unsigned count, const uint8_t *mask);
/* The Bayer matrix's rows, 4 bits an entry, the first one the lowest. */
extern const uint16_t glint_pixel_bayer_rows[4];
/* The ordered dither's weights b, 0..15, of four or more places on the screen from x to the right, 4 bits each, the first the lowest. */
static inline uint32_t glint_pixel_bayer_row(uint32_t x, uint32_t y)
{
    const uint32_t row = GLINT_FLASH_U16(glint_pixel_bayer_rows[y & 3]);
    return (row | row << 16) >> 4 * (x & 3);
}
static inline uint32_t glint_pixel_bayer(uint32_t x, uint32_t y)
{
    return glint_pixel_bayer_row(x, y) & 15;
}
/* That of a shader: 2b + 1, or 16. */
uint32_t glint_exact_weight(const struct glint_shader *shader, uint32_t x, uint32_t y);

static inline uint32_t glint_coefficient(uint32_t q16)
{
    return q16 > 65536 ? 65536 : q16;
}

#endif
