/* SPDX-License-Identifier: MIT
 * PNG files into 16-bit samples. libpng's errors come out as one line of ours; fail() does not return, so that libpng's
 * error function needs no longjmp. */
#include <errno.h>
#include <png.h>
#include <stdlib.h>
#include <string.h>

#include "base/host.h"
#include "image/image.h"

struct source {
    const char *name; /* for messages */
    FILE *stream;
};

void *allocate(size_t count, size_t size)
{
    void *memory = calloc(count ? count : 1, size);
    if (!memory)
        fail("out of memory: %zu bytes are wanted", count * size);
    return memory;
}

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
    fail("%s: truncated: the file ends within the picture; fetch or save it again", source->name);
}

/* What people hand over in place of a PNG. */
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
    {"<svg", "an SVG"},
    {"P1", "a PBM"},
    {"P2", "a PGM"},
    {"P3", "a PPM"},
    {"P4", "a PBM"},
    {"P5", "a PGM"},
    {"P6", "a PPM"},
    {"8BPS", "a PSD"},
};

static void check_signature(const struct source *source)
{
    png_byte head[8] = {0};
    const size_t got = fread(head, 1, sizeof head, source->stream);
    if (ferror(source->stream))
        fail("%s: could not be read: %s", source->name, strerror(errno));
    if (got == 0)
        fail("%s: is empty; a PNG picture is wanted", source->name);
    if (got == sizeof head && png_sig_cmp(head, 0, sizeof head) == 0)
        return;
    if (got < sizeof head && png_sig_cmp(head, 0, got) == 0)
        fail("%s: truncated: the file ends within the picture; fetch or save it again", source->name);
    for (size_t i = 0; i < sizeof other_files / sizeof *other_files; i++)
        if (memcmp(head, other_files[i].magic, strlen(other_files[i].magic)) == 0)
            fail("%s: is %s, not a PNG; convert it to PNG", source->name, other_files[i].what);
    fail("%s: is not a PNG picture; a PNG is wanted", source->name);
}

static void check_size(const struct image *image)
{
    if (image->width > SIDE_MAX || image->height > SIDE_MAX || (uint64_t)image->width * image->height > PIXELS_MAX)
        fail("%s: is %ux%u pixels; at most %d a side and %d in all are allowed", image->name, image->width,
             image->height, SIDE_MAX, PIXELS_MAX);
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

struct image *image_read(const char *path)
{
    const bool standard = strcmp(path, "-") == 0;
    struct source source = {standard ? "standard input" : path, standard ? stdin : fopen(path, "rb")};
    if (!source.stream)
        fail("%s: %s", path, strerror(errno));
    check_signature(&source);

    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, on_error, on_warning);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info)
        fail("out of memory");
    png_set_read_fn(png, &source, read_bytes);
    png_set_sig_bytes(png, 8);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX); /* check_size says it better */
    png_read_info(png, info);

    struct image *image = allocate(1, sizeof *image);
    if (!(image->name = strdup(source.name)))
        fail("out of memory");
    image->width = png_get_image_width(png, info);
    image->height = png_get_image_height(png, info);
    image->bits = png_get_bit_depth(png, info);
    image->palette = png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE;
    check_size(image);
    read_samples(png, info, image);
    png_destroy_read_struct(&png, &info, NULL);
    if (!standard)
        fclose(source.stream);
    return image;
}

void image_free(struct image *image)
{
    if (!image)
        return;
    free(image->name);
    free(image->samples);
    free(image);
}

static uint8_t to_8_bits(uint32_t sample)
{
    return (uint8_t)((sample + 128) / 257);
}

/* The pixel's colour as 0..65535: grey is repeated. */
static void color_at(const struct image *image, size_t pixel, uint16_t rgb[3])
{
    const uint16_t *sample = &image->samples[pixel * image->channels];
    for (unsigned k = 0; k < 3; k++)
        rgb[k] = sample[image->channels < 3 ? 0 : k];
}

static uint32_t weighted_at(const struct image *image, size_t pixel) /* 0..65535 * 256 */
{
    uint16_t rgb[3];
    color_at(image, pixel, rgb);
    return (uint32_t)GREY_RED * rgb[0] + (uint32_t)GREY_GREEN * rgb[1] + (uint32_t)GREY_BLUE * rgb[2];
}

uint8_t *image_rgb8(const struct image *image)
{
    const size_t pixels = (size_t)image->width * image->height;
    uint8_t *out = allocate(pixels, 3);
    for (size_t i = 0; i < pixels; i++) {
        uint16_t rgb[3];
        color_at(image, i, rgb);
        for (unsigned k = 0; k < 3; k++)
            out[3 * i + k] = to_8_bits(rgb[k]);
    }
    return out;
}

uint8_t *image_grey8(const struct image *image)
{
    const size_t pixels = (size_t)image->width * image->height;
    uint8_t *out = allocate(pixels, 1);
    for (size_t i = 0; i < pixels; i++)
        out[i] = to_8_bits((weighted_at(image, i) + 128) / 256);
    return out;
}

double *image_grey(const struct image *image)
{
    const size_t pixels = (size_t)image->width * image->height;
    double *out = allocate(pixels, sizeof *out);
    for (size_t i = 0; i < pixels; i++)
        out[i] = weighted_at(image, i) / (65535.0 * 256);
    return out;
}

bool image_is_grey(const struct image *image)
{
    const size_t pixels = (size_t)image->width * image->height;
    for (size_t i = 0; i < pixels; i++) {
        uint16_t rgb[3];
        color_at(image, i, rgb);
        if (rgb[0] != rgb[1] || rgb[1] != rgb[2])
            return false;
    }
    return true;
}
