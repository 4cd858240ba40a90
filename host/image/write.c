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

/* A file whose lines come in parts. */
struct picture_file {
    struct output *output;
    enum image_kind kind;
    uint32_t width, height;
    unsigned channels;
    bool mono;
    png_structp png;
    png_infop info;
    struct qoi {
        uint32_t seen[64]; /* by qoi_place; red, green, blue, alpha from the highest byte down */
        uint32_t last;
        unsigned run;
    } qoi;
};

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

static void begin_png(struct picture_file *file)
{
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, file->output, png_on_error, png_on_warning);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info)
        fail("out of memory");
    png_set_write_fn(png, file->output, png_put, png_flush_later);
    png_set_IHDR(png, info, file->width, file->height, file->mono ? 1 : 8,
                 file->channels == 4   ? PNG_COLOR_TYPE_RGB_ALPHA
                 : file->channels == 3 ? PNG_COLOR_TYPE_RGB
                                       : PNG_COLOR_TYPE_GRAY,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    if (file->mono)
        png_set_packing(png); /* whatever is not 0 becomes 1 */
    file->png = png;
    file->info = info;
}

static void add_png(struct picture_file *file, const struct picture *lines)
{
    for (size_t y = 0; y < lines->height; y++)
        png_write_row(file->png, &lines->samples[y * lines->width * lines->channels]);
}

static void end_png(struct picture_file *file)
{
    png_write_end(file->png, NULL);
    png_destroy_write_struct(&file->png, &file->info);
}

/* ---- PPM ---- */

static void begin_ppm(struct picture_file *file)
{
    char head[64];
    const int kind = file->mono ? '4' : file->channels == 1 ? '5' : '6';
    const int len =
        snprintf(head, sizeof head, "P%c\n%u %u\n%s", kind, file->width, file->height, file->mono ? "" : "255\n");
    put(file->output, head, (size_t)len);
}

static void add_pbm(struct picture_file *file, const struct picture *lines)
{
    const size_t len_bytes = (lines->width + 7u) / 8;
    uint8_t *line = allocate(len_bytes, 1);
    for (size_t y = 0; y < lines->height; y++) {
        memset(line, 0, len_bytes);
        for (size_t x = 0; x < lines->width; x++)
            if (!lines->samples[y * lines->width + x]) /* 1 is black */
                line[x / 8] |= (uint8_t)(0x80u >> x % 8);
        put(file->output, line, len_bytes);
    }
    free(line);
}

static void add_ppm(struct picture_file *file, const struct picture *lines)
{
    if (file->mono)
        add_pbm(file, lines);
    else
        put(file->output, lines->samples, (size_t)lines->width * lines->height * lines->channels);
}

static void end_ppm(struct picture_file *file)
{
    (void)file;
}

/* ---- QOI: qoiformat.org. Its library wants the whole picture in memory; here a line is enough. ---- */

enum { QOI_RUN_MAX = 62 };

static void begin_qoi(struct picture_file *file)
{
    const uint32_t w = file->width, h = file->height;
    const uint8_t head[14] = {'q',
                              'o',
                              'i',
                              'f',
                              (uint8_t)(w >> 24),
                              (uint8_t)(w >> 16),
                              (uint8_t)(w >> 8),
                              (uint8_t)w,
                              (uint8_t)(h >> 24),
                              (uint8_t)(h >> 16),
                              (uint8_t)(h >> 8),
                              (uint8_t)h,
                              file->channels == 4 ? 4 : 3,
                              0};
    put(file->output, head, sizeof head);
    file->qoi.last = 255; /* black */
}

static unsigned qoi_place(uint32_t pixel)
{
    return ((pixel >> 24) * 3 + (pixel >> 16 & 255) * 5 + (pixel >> 8 & 255) * 7 + (pixel & 255) * 11) % 64;
}

static size_t end_run(struct qoi *qoi, uint8_t *out)
{
    if (!qoi->run)
        return 0;
    *out = (uint8_t)(0xc0 | (qoi->run - 1));
    qoi->run = 0;
    return 1;
}

/* A pixel as the shortest of its chunks; at most 6 bytes. */
static size_t qoi_pixel(struct qoi *qoi, uint32_t pixel, uint8_t *out)
{
    if (pixel == qoi->last)
        return ++qoi->run == QOI_RUN_MAX ? end_run(qoi, out) : 0;
    size_t len = end_run(qoi, out);
    const unsigned place = qoi_place(pixel);
    const int8_t red = (int8_t)((pixel >> 24) - (qoi->last >> 24));
    const int8_t green = (int8_t)((pixel >> 16) - (qoi->last >> 16));
    const int8_t blue = (int8_t)((pixel >> 8) - (qoi->last >> 8));
    const int8_t red_green = (int8_t)(red - green), blue_green = (int8_t)(blue - green);
    if (qoi->seen[place] == pixel) {
        out[len++] = (uint8_t)place;
    } else if ((pixel ^ qoi->last) & 255) {
        out[len++] = 0xff;
        for (int shift = 24; shift >= 0; shift -= 8)
            out[len++] = (uint8_t)(pixel >> shift);
    } else if (red >= -2 && red <= 1 && green >= -2 && green <= 1 && blue >= -2 && blue <= 1) {
        out[len++] = (uint8_t)(0x40 | (red + 2) << 4 | (green + 2) << 2 | (blue + 2));
    } else if (red_green >= -8 && red_green <= 7 && green >= -32 && green <= 31 && blue_green >= -8 &&
               blue_green <= 7) {
        out[len++] = (uint8_t)(0x80 | (green + 32));
        out[len++] = (uint8_t)((red_green + 8) << 4 | (blue_green + 8));
    } else {
        out[len++] = 0xfe;
        for (int shift = 24; shift >= 8; shift -= 8)
            out[len++] = (uint8_t)(pixel >> shift);
    }
    qoi->seen[place] = qoi->last = pixel;
    return len;
}

static void add_qoi(struct picture_file *file, const struct picture *lines)
{
    const bool alpha = lines->channels == 4;
    uint8_t *rgb = picture_rgb(lines), *bytes = allocate(lines->width, 6);
    for (size_t y = 0; y < lines->height; y++) {
        size_t len = 0;
        for (size_t x = 0; x < lines->width; x++) {
            const size_t at = y * lines->width + x;
            const uint8_t *p = &rgb[3 * at];
            len += qoi_pixel(&file->qoi,
                             (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 |
                                 (alpha ? lines->samples[4 * at + 3] : 255u),
                             bytes + len);
        }
        put(file->output, bytes, len);
    }
    free(bytes);
    free(rgb);
}

static void end_qoi(struct picture_file *file)
{
    static const uint8_t end[8] = {0, 0, 0, 0, 0, 0, 0, 1};
    uint8_t run;
    const size_t len = end_run(&file->qoi, &run);
    put(file->output, &run, len);
    put(file->output, end, sizeof end);
}

/* ---- any of them ---- */

static const struct {
    void (*begin)(struct picture_file *file);
    void (*add)(struct picture_file *file, const struct picture *lines);
    void (*end)(struct picture_file *file);
} writers[] = {{begin_png, add_png, end_png}, {begin_ppm, add_ppm, end_ppm}, {begin_qoi, add_qoi, end_qoi}};

struct picture_file *picture_file_begin(struct output *output, enum image_kind kind, const struct picture *first,
                                        uint32_t height)
{
    struct picture_file *file = allocate(1, sizeof *file);
    *file = (struct picture_file){.output = output,
                                  .kind = kind,
                                  .width = first->width,
                                  .height = height,
                                  .channels = first->channels,
                                  .mono = first->mono};
    writers[kind].begin(file);
    return file;
}

void picture_file_add(struct picture_file *file, const struct picture *lines)
{
    writers[file->kind].add(file, lines);
}

void picture_file_end(struct picture_file *file)
{
    writers[file->kind].end(file);
    flush(file->output);
    free(file);
}

void picture_write(const struct picture *picture, struct output *output, enum image_kind kind)
{
    struct picture_file *file = picture_file_begin(output, kind, picture, picture->height);
    picture_file_add(file, picture);
    picture_file_end(file);
}

void pixels_write(const void *pixels, size_t len_bytes, struct output *output)
{
    put(output, pixels, len_bytes);
    flush(output);
}
