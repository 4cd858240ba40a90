/* SPDX-License-Identifier: MIT
 * PNG files into 16-bit samples, SVG files by svg.c. libpng's errors come out as one line of ours; fail() does not return, so that libpng's
 * error function needs no longjmp. */
#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "image/image.h"
#include "image/picture.h"
#include "image/read.h"
#include "image/svg.h"

struct source {
    const char *name; /* for messages */
    FILE *stream;
};

static void on_error(png_structp png, png_const_charp message)
{
    const struct source *source = png_get_error_ptr(png);
    fail("%s: damaged PNG: %s; save it again", source->name, message);
}

static void on_warning(png_structp png, png_const_charp message)
{
    (void)png; /* libpng mended it, or left out what we do not use */
    (void)message;
}

static void read_bytes(png_structp png, png_bytep bytes, size_t len_bytes)
{
    const struct source *source = png_get_io_ptr(png);
    if (fread(bytes, 1, len_bytes, source->stream) == len_bytes)
        return;
    if (ferror(source->stream))
        fail("%s: could not be read: %s", source->name, strerror(errno));
    fail("%s: the file ends within the picture; fetch or save it again", source->name);
}

/* What people name instead of a PNG. */
static const struct {
    const char *magic;
    const char *what;
} other_files[] = {
    {"\xFF\xD8\xFF", "a JPEG"},
    {"GIF8", "a GIF"},
    {"BM", "a BMP"},
    {"RIFF", "a WebP or other RIFF file"},
    {"qoif", "a QOI"},
    {"II*", "a TIFF"},
    {"MM", "a TIFF"},
    {"DDS ", "a DDS texture"},
    {"\x76\x2F\x31\x01", "an OpenEXR"},
    {"\xABKTX", "a KTX texture"},
    {"P1", "a PBM"},
    {"P2", "a PGM"},
    {"P3", "a PPM"},
    {"P4", "a PBM"},
    {"P5", "a PGM"},
    {"P6", "a PPM"},
    {"8BPS", "a PSD"},
};

enum { HEAD = 8 };

/* Of the source's first bytes. */
static void check_signature(const struct source *source, const png_byte head[HEAD], size_t got)
{
    if (ferror(source->stream))
        fail("%s: could not be read: %s", source->name, strerror(errno));
    if (got == 0)
        fail("%s: this file is empty; name a PNG picture", source->name);
    if (got == HEAD && png_sig_cmp(head, 0, HEAD) == 0)
        return;
    if (got < HEAD && png_sig_cmp(head, 0, got) == 0)
        fail("%s: the file ends within the picture; fetch or save it again", source->name);
    for (size_t i = 0; i < sizeof other_files / sizeof *other_files; i++)
        if (memcmp(head, other_files[i].magic, strlen(other_files[i].magic)) == 0)
            fail("%s: this is %s, not a PNG; convert it to PNG", source->name, other_files[i].what);
    fail("%s: this is not a PNG picture; convert it to PNG", source->name);
}

static void check_size(const struct image *image)
{
    if (!picture_size_fits(image->width, image->height))
        fail("%s: %ux%u pixels; at most %d a side and %d in all are allowed", image->name, image->width, image->height,
             SIDE_MAX, PIXELS_MAX);
}

static void read_samples(png_structp png, png_infop info, struct image *image)
{
    png_set_expand_16(png); /* palettes, low depths and transparent colours with it */
    if (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)
        png_set_swap(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    image->channels = png_get_channels(png, info);
    image->samples = allocate((size_t)image->width * image->height * image->channels, sizeof *image->samples);
    png_bytep *lines = allocate(image->height, sizeof *lines);
    for (size_t y = 0; y < image->height; y++)
        lines[y] = (png_bytep)&image->samples[y * image->width * image->channels];
    png_read_image(png, lines);
    png_read_end(png, NULL);
    free(lines);
}

static struct image *read_png(struct source *source)
{
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, source, on_error, on_warning);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info)
        fail("out of memory");
    png_set_read_fn(png, source, read_bytes);
    png_set_sig_bytes(png, 8);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX); /* check_size has the clearer message */
    png_read_info(png, info);

    struct image *image = allocate(1, sizeof *image);
    image->name = copied(source->name);
    image->width = png_get_image_width(png, info);
    image->height = png_get_image_height(png, info);
    image->bits = png_get_bit_depth(png, info);
    image->palette = png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE;
    check_size(image);
    read_samples(png, info, image);
    png_destroy_read_struct(&png, &info, NULL);
    return image;
}

struct image *image_read(const char *path)
{
    return image_read_sized(path, 0, 0);
}

struct image *image_read_sized(const char *path, uint32_t width, uint32_t height)
{
    const bool standard = strcmp(path, "-") == 0;
    struct source source = {standard ? "standard input" : path, standard ? stdin : fopen(path, "rb")};
    if (!source.stream)
        fail("%s: %s", path, strerror(errno));
    output_never(source.stream);
    png_byte head[HEAD] = {0};
    const size_t got = fread(head, 1, HEAD, source.stream);
    const bool is_svg = svg_begins(head, got);
    if (!is_svg)
        check_signature(&source, head, got);
    struct image *image = is_svg ? svg_read(source.stream, source.name, head, got, width, height) : read_png(&source);
    if (!standard)
        fclose(source.stream);
    return image;
}
