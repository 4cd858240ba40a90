/* SPDX-License-Identifier: MIT
 * SMALL tables: pixels one by one, of any format, at any address. Two words, one by nl and one by t, hold three channels
 * each with room between them; their sum is the pixel, to which the threshold of the dither is added before the upper bits
 * are taken. */
#include "glint_loops_small.h"
#include "glint_loops_vector.h"
#include "glint_pixel.h"
#include "glint_tables_field.h"
#include "glint_tables_geometry.h"
#include "glint_tables_normals.h"

static uint32_t clamp_sum(uint32_t sum, uint8_t format) /* a field whose guard is set is full */
{
    for (int k = 0; k < 3; k++) {
        const struct glint_field field = glint_field_of(format, k);
        if (sum >> field.guard & 1)
            sum |= ((uint32_t)1 << field.guard) - ((uint32_t)1 << field.at);
    }
    return sum;
}

static uint32_t sum_field(uint32_t sum, uint8_t format, int k)
{
    const struct glint_field field = glint_field_of(format, k);
    return sum >> field.at & (((uint32_t)1 << (field.guard - field.at)) - 1);
}

/* The threshold, in each field: b of 16 parts, and half a part of rounding is in the table already. */
static uint32_t weights(const struct glint_tables *tables, uint32_t b)
{
    uint32_t word = 0;
    for (int k = 0; k < 3; k++)
        word |= (glint_format_is_565(tables->format) ? b : b >> 3) << glint_field_of(tables->format, k).at;
    return word;
}

static void small_pixel(const struct glint_tables *tables, const struct glint_surface *surface, uint16_t x, uint16_t y,
                        uint32_t t_q30, int32_t nl_q30)
{
    const uint32_t *diffuse = tables->colour.sums, *specular = diffuse + GLINT_SMALL_DIFFUSE;
    const uint32_t last = GLINT_SMALL_DIFFUSE - 2, step = (uint32_t)nl_q30 >> GLINT_COLOUR_ROW_SHIFT;
    const uint32_t row = nl_q30 <= 0 ? 0 : 1 + (step < last ? step : last);
    uint32_t column = 0;
    if (nl_q30 > 0 && t_q30 <= tables->t_max_q30)
        column = glint_small_column(tables, t_q30);
    const uint32_t b = tables->dither ? glint_pixel_bayer(surface->x + (uint32_t)x, surface->y + (uint32_t)y) : 8;
    const uint32_t raw = diffuse[row] + specular[column];
    uint8_t *line = (uint8_t *)surface->pixels + surface->stride * (ptrdiff_t)y;
    const uint8_t format = tables->format;
    if (glint_format_is_565(format)) {
        const uint32_t sum = clamp_sum(raw + weights(tables, b), format);
        const uint32_t rgb = (sum_field(sum, format, 0) >> 4) << 11 | (sum_field(sum, format, 1) >> 4) << 5 |
                             sum_field(sum, format, 2) >> 4;
        const bool swapped = format == GLINT_RGB565_SWAPPED;
        line[2 * (ptrdiff_t)x + swapped] = (uint8_t)rgb;
        line[2 * (ptrdiff_t)x + !swapped] = (uint8_t)(rgb >> 8);
    } else if (!glint_format_is_grey(format)) {
        const uint32_t sum = clamp_sum(raw + weights(tables, b), format);
        const bool blue_first = glint_format_is_blue_first(format);
        uint8_t *out = line + GLINT_FLASH_U8(glint_exact_formats[format].bytes) * (ptrdiff_t)x;
        for (int k = 0; k < 3; k++)
            out[blue_first ? 2 - k : k] = (uint8_t)(sum_field(sum, format, k) >> 1);
        if (blue_first)
            glint_exact_alpha(format, line, x, 1, NULL);
    } else {
        uint32_t grey = 0; /* 255 * 2 * 256 = 1.0 */
        static const uint8_t luma[3] GLINT_FLASH = {GLINT_LUMA_RED, GLINT_LUMA_GREEN, GLINT_LUMA_BLUE};
        const uint32_t sum = clamp_sum(raw, format);
        for (int k = 0; k < 3; k++) {
            const uint32_t level = sum_field(sum, format, k);
            grey += GLINT_FLASH_U8(luma[k]) * (level < 510 ? level : 510);
        }
        if (format == GLINT_GREY8) {
            const uint32_t shade = (grey + 32 * b + (tables->dither ? 16 : 0)) >> 9;
            line[x] = (uint8_t)(shade < 255 ? shade : 255);
        } else {
            const uint8_t bit = (uint8_t)(0x80 >> (x & 7));
            const bool on = 2 * grey + 16320 * b + (tables->dither ? 8160 : 0) >= 261120;
            line[x >> 3] = (uint8_t)(on ? line[x >> 3] | bit : line[x >> 3] & ~bit);
        }
    }
}

/* A line of normals through SMALL tables. */
static void small_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                       enum glint_normals format, const void *normals, uint16_t w, uint16_t y,
                       const struct glint_surface *surface)
{
    for (uint16_t x = 0; x < w; x++) {
        const struct glint_vec n = glint_normal_at(format, normals, x);
        if (n.x | n.y | n.z)
            small_pixel(tables, surface, x, y, glint_fast_t(&n, &light->h), glint_fast_nl(&n, &light->l));
    }
}

void glint_small_rect(const struct glint_tables *tables, const struct glint_tables_light *light,
                      enum glint_normals format, const void *normals, ptrdiff_t stride, uint16_t w, uint16_t h,
                      const struct glint_surface *surface)
{
    for (uint16_t y = 0; y < h; y++)
        small_line(tables, light, format, (const uint8_t *)normals + stride * (ptrdiff_t)y, w, y, surface);
}

void glint_small_span(const struct glint_tables *tables, const struct glint_span *span,
                      const struct glint_surface *surface)
{
    struct glint_span at = *span;
    for (uint16_t x = 0; x < at.w; x++) {
        small_pixel(tables, surface, x, 0, at.t_q30 >= GLINT_NEGATIVE_T ? 0 : at.t_q30, at.nl_q30);
        at.t_q30 += at.dt_q30;
        at.dt_q30 += at.ddt_q30;
        at.nl_q30 = (int32_t)((uint32_t)at.nl_q30 + (uint32_t)at.dnl_q30);
    }
}
