/* SPDX-License-Identifier: MIT
 * Fuzzes PNG and JPEG, as maps and as textures: a picture of a size that is allowed comes of it, or a reason. Input: how it is read (1: bit 0 a texture,
 * bit 1 made a PNG), then the file, or of a PNG the sides (2), depth and colour type (1), whether it is interlaced (1), how much of what follows is a palette (1)
 * and transparent colours (1), both, and lines. */
#include "fuzz_child.h"

#include "../../host/mesh/import_picture.c"
#include "image/image.h"
#include "image/read.h"
#include "image/svg.h"

struct file {
    uint8_t bytes[1 << 16];
    size_t len;
    bool texture;
};

static void put(struct file *file, const void *from, size_t len)
{
    for (size_t i = 0; i < len; i++)
        file->bytes[file->len++] = ((const uint8_t *)from)[i];
}

static void put_number(struct file *file, uint32_t number)
{
    const uint8_t bytes[4] = {(uint8_t)(number >> 24), (uint8_t)(number >> 16), (uint8_t)(number >> 8),
                              (uint8_t)number};
    put(file, bytes, sizeof bytes);
}

static void put_chunk(struct file *file, const char *name, const uint8_t *data, size_t len)
{
    uint8_t *const from = file->bytes + file->len + 4;
    put_number(file, (uint32_t)len);
    put(file, name, 4);
    put(file, data, len);
    uint32_t sum = UINT32_MAX;
    for (size_t i = 0; i < 8 * (len + 4); i++) {
        sum ^= i % 8 ? 0 : from[i / 8];
        sum = sum >> 1 ^ (sum & 1 ? 0xEDB88320 : 0);
    }
    put_number(file, ~sum);
}

/* A zlib stream that is not compressed. */
static void put_lines(struct file *file, const uint8_t *lines, size_t len)
{
    uint8_t data[8192] = {0x78, 1, 1, (uint8_t)len, (uint8_t)(len >> 8), (uint8_t)~len, (uint8_t)(~len >> 8)};
    uint32_t a = 1, b = 0;
    memcpy(data + 7, lines, len);
    for (size_t i = 0; i < len; i++) {
        a = (a + lines[i]) % 65521;
        b = (b + a) % 65521;
    }
    const uint8_t sum[4] = {(uint8_t)(b >> 8), (uint8_t)b, (uint8_t)(a >> 8), (uint8_t)a};
    memcpy(data + 7 + len, sum, sizeof sum);
    put_chunk(file, "IDAT", data, len + 11);
}

static void make_png(struct file *file, struct input *input)
{
    const uint8_t width = (uint8_t)next_byte(input), height = (uint8_t)next_byte(input),
                  kind = (uint8_t)next_byte(input);
    const uint8_t head[13] = {
        0, 0, 0, width, 0, 0, 0, height, (uint8_t)(1 << (kind >> 3 & 7)), kind & 7, 0, 0, next_byte(input) & 1};
    size_t palette = next_byte(input), alpha = next_byte(input), lines = 8000;
    uint8_t *const colors = next_bytes(input, &palette), *const alphas = next_bytes(input, &alpha),
                   *const rest = next_bytes(input, &lines);
    put(file, "\x89PNG\r\n\x1a\n", 8);
    put_chunk(file, "IHDR", head, sizeof head);
    if (palette)
        put_chunk(file, "PLTE", colors, palette);
    if (alpha)
        put_chunk(file, "tRNS", alphas, alpha);
    put_lines(file, rest, lines);
    put_chunk(file, "IEND", NULL, 0);
    free(colors);
    free(alphas);
    free(rest);
}

static void read_map(void)
{
    struct image *image = image_read("-");
    check(image->width && image->height && picture_size_fits(image->width, image->height));
    check(image->channels >= 1 && image->channels <= 4 && image->bits <= 16);
    free(image_rgb8(image));
    free(image_grey8(image));
    free(image_alpha8(image));
    free(image_grey(image));
    struct image *part = image_lines(image, -3, 7);
    image_free(part);
    image_free(image);
}

static void read_texture(const struct file *file)
{
    struct mesh_picture picture = {0};
    if (import_picture_decode(&picture, "a texture", file->bytes, file->len))
        return;
    check(picture.width && picture.height && picture_size_fits(picture.width, picture.height));
    unsigned sum = 0;
    for (size_t i = 0; i < (size_t)3 * picture.width * picture.height; i++)
        sum += picture.rgb[i];
    check(sum <= 255U * 3 * picture.width * picture.height);
}

static void read_file(void *of)
{
    const struct file *file = of;
    if (file->texture)
        read_texture(file);
    else
        read_map();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct file file;
    FILE *const before = stdin;
    struct input input = {data, data + size};
    const unsigned how = next_byte(&input);
    file.len = 0;
    file.texture = how & 1;
    if (how & 2)
        make_png(&file, &input);
    else
        put(&file, input.at, (size_t)(input.end - input.at));
    if (svg_begins(file.bytes, file.len < 8 ? file.len : 8))
        return 0; /* fuzz_svg.c's */
    stdin = unwind_stream(file.bytes, file.len);
    unwind_run(read_file, &file);
    child_forget();
    fclose(stdin);
    stdin = before;
    return 0;
}
