/* SPDX-License-Identifier: MIT
 * PNG files of any kind, made for a test. */
#ifndef GLINT_MADE_PNG_H
#define GLINT_MADE_PNG_H

#include <png.h>
#include <stdio.h>
#include <stdlib.h>

#include "unit.h"

struct made_png {
    uint32_t width, height;
    int bits, color_type;    /* PNG_COLOR_TYPE_... */
    int interlace;           /* PNG_INTERLACE_... */
    const uint16_t *samples; /* in the file's own range, all channels of a pixel together */
    const png_color *palette;
    int palette_count;
};

static inline unsigned made_channels(int color_type)
{
    switch (color_type) {
    case PNG_COLOR_TYPE_GRAY_ALPHA:
        return 2;
    case PNG_COLOR_TYPE_RGB:
        return 3;
    case PNG_COLOR_TYPE_RGB_ALPHA:
        return 4;
    default:
        return 1;
    }
}

static inline void make_png(const char *path, const struct made_png *made)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    assert_non_null(info);
    png_init_io(png, file);
    png_set_IHDR(png, info, made->width, made->height, made->bits, made->color_type, made->interlace,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (made->palette)
        png_set_PLTE(png, info, made->palette, made->palette_count);
    png_write_info(png, info);
    if (made->bits < 8)
        png_set_packing(png);
    const size_t samples = made->width * made_channels(made->color_type);
    const size_t bytes = samples * (made->bits == 16 ? 2 : 1);
    png_bytep all = malloc(bytes * made->height);
    png_bytep *lines = malloc(made->height * sizeof *lines);
    assert_true(all && lines);
    for (size_t i = 0; i < samples * made->height; i++) {
        if (made->bits == 16) {
            all[2 * i] = (png_byte)(made->samples[i] >> 8);
            all[2 * i + 1] = (png_byte)(made->samples[i] & 255);
        } else {
            all[i] = (png_byte)made->samples[i];
        }
    }
    for (size_t y = 0; y < made->height; y++)
        lines[y] = all + y * bytes;
    png_write_image(png, lines);
    png_write_end(png, NULL);
    png_destroy_write_struct(&png, &info);
    free(lines);
    free(all);
    assert_int_equal(fclose(file), 0);
}

#endif
