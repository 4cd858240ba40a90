/* SPDX-License-Identifier: MIT
 * Pictures into PNG, PPM and QOI files. */
#include <errno.h>
#include <png.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "base/stop.h"
#include "image/picture.h"
#include "image/write.h"

/* The header is the library: this file holds its code. We use only the encoder. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#define QOI_IMPLEMENTATION
#define QOI_NO_STDIO
#include <qoi.h>
#pragma GCC diagnostic pop

const char *const image_kind_names[] = {"png", "ppm", "qoi", NULL};

enum image_kind image_kind_by_name(const char *name)
{
    unsigned kind = 0;
    while (kind < IMAGE_KINDS && strcasecmp(name, image_kind_names[kind]) != 0)
        kind++;
    return (enum image_kind)kind;
}

enum image_kind image_kind_by_ending(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *name = slash ? slash + 1 : path;
    const char *dot = strrchr(name, '.');
    return dot && dot != name && dot[1] ? image_kind_by_name(dot + 1) : IMAGE_PNG; /* ".hidden" and ".." have none */
}

static _Noreturn void fail_write(const struct output *output, const char *why)
{
    fail("%s: could not be written: %s", output->stream == stdout ? "standard output" : output->path, why);
}

static void put(struct output *output, const void *bytes, size_t len_bytes)
{
    if (fwrite(bytes, 1, len_bytes, output->stream) == len_bytes)
        return;
    stop_if_interrupted(errno);
    fail_write(output, strerror(errno));
}

static void flush(struct output *output)
{
    if (fflush(output->stream) == 0)
        return;
    stop_if_interrupted(errno);
    fail_write(output, strerror(errno));
}

static size_t samples_of(const struct picture *picture)
{
    return (size_t)picture->width * picture->height * picture->channels;
}

/* ---- PNG ---- */

static void png_put(png_structp png, png_bytep bytes, size_t len_bytes)
{
    put(png_get_io_ptr(png), bytes, len_bytes);
}

static void png_flush_later(png_structp png)
{
    (void)png; /* output_close flushes */
}

static void png_on_error(png_structp png, png_const_charp message)
{
    fail_write(png_get_error_ptr(png), message);
}

static void png_on_warning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void write_png(const struct picture *picture, struct output *output)
{
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, output, png_on_error, png_on_warning);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info)
        fail("out of memory");
    png_set_write_fn(png, output, png_put, png_flush_later);
    png_set_IHDR(png, info, picture->width, picture->height, picture->mono ? 1 : 8,
                 picture->channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    if (picture->mono)
        png_set_packing(png); /* whatever is not 0 becomes 1 */
    for (size_t y = 0; y < picture->height; y++)
        png_write_row(png, &picture->samples[y * picture->width * picture->channels]);
    png_write_end(png, NULL);
    png_destroy_write_struct(&png, &info);
}

/* ---- PPM ---- */

static void write_pbm_lines(const struct picture *picture, struct output *output)
{
    const size_t len_bytes = (picture->width + 7u) / 8;
    uint8_t *line = allocate(len_bytes, 1);
    for (size_t y = 0; y < picture->height; y++) {
        memset(line, 0, len_bytes);
        for (size_t x = 0; x < picture->width; x++)
            if (!picture->samples[y * picture->width + x]) /* 1 is black */
                line[x / 8] |= (uint8_t)(0x80u >> x % 8);
        put(output, line, len_bytes);
    }
    free(line);
}

static void write_ppm(const struct picture *picture, struct output *output)
{
    char head[64];
    const int kind = picture->mono ? '4' : picture->channels == 1 ? '5' : '6';
    const int len = snprintf(head, sizeof head, "P%c\n%u %u\n%s", kind, picture->width, picture->height,
                             picture->mono ? "" : "255\n");
    put(output, head, (size_t)len);
    if (picture->mono)
        write_pbm_lines(picture, output);
    else
        put(output, picture->samples, samples_of(picture));
}

/* ---- QOI ---- */

static void write_qoi(const struct picture *picture, struct output *output)
{
    uint8_t *rgb = picture_rgb(picture);
    const qoi_desc description = {picture->width, picture->height, 3, QOI_SRGB};
    int len_bytes;
    void *bytes = qoi_encode(rgb, &description, &len_bytes);
    if (!bytes)
        fail("out of memory");
    put(output, bytes, (size_t)len_bytes);
    free(bytes);
    free(rgb);
}

void picture_write(const struct picture *picture, struct output *output, enum image_kind kind)
{
    static void (*const writers[])(const struct picture *, struct output *) = {write_png, write_ppm, write_qoi};
    writers[kind](picture, output);
    flush(output);
}

void pixels_write(const void *pixels, size_t len_bytes, struct output *output)
{
    put(output, pixels, len_bytes);
    flush(output);
}
