/* SPDX-License-Identifier: MIT
 * A pixel of a smaller picture is the mean, in linear light, of the area that it covers in the larger one. */
#include "mesh/texture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"

enum { TEXTURE_SIDE_MAX = 2048, LEVELS_MAX = 12 };

double texture_decode(double encoded)
{
    return encoded <= .04045 ? encoded / 12.92 : pow((encoded + .055) / 1.055, 2.4);
}

double texture_encode(double linear)
{
    return linear <= .0031308 ? linear * 12.92 : 1.055 * pow(linear, 1 / 2.4) - .055;
}

/* ---- sizes ---- */

static uint32_t half(uint32_t side)
{
    return side > 1 ? side / 2 : 1;
}

static unsigned levels_of(uint32_t w, uint32_t h)
{
    unsigned levels = 1;
    for (; (w > 1 || h > 1) && levels < LEVELS_MAX; levels++) {
        w = half(w);
        h = half(h);
    }
    return levels;
}

static size_t chain_pixels(uint32_t w, uint32_t h)
{
    size_t sum = 0;
    for (unsigned level = levels_of(w, h); level; level--) {
        sum += (size_t)w * h;
        w = half(w);
        h = half(h);
    }
    return sum;
}

static size_t chain_bytes(uint32_t w, uint32_t h, bool palette)
{
    return palette ? chain_pixels(w, h) + TEXTURE_COLORS * sizeof(uint16_t) : 2 * chain_pixels(w, h);
}

static bool is_power(uint32_t side)
{
    return (side & (side - 1)) == 0;
}

/* A size of a picture: powers of two stay such, others come closer to what there is room for. */
struct size {
    uint32_t w, h;
    double part;
};

static void reduce(const struct mesh_picture *picture, struct size *size)
{
    if (is_power(picture->width) && is_power(picture->height)) {
        size->w = half(size->w);
        size->h = half(size->h);
        return;
    }
    size->part *= .97;
    size->w = (uint32_t)fmax(1, round(picture->width * size->part));
    size->h = (uint32_t)fmax(1, round(picture->height * size->part));
}

/* The one that takes most is made smaller until they all fit. */
static struct size *sizes_of(const struct mesh *mesh, const bool *is_used)
{
    const struct texture_wish *wish = &mesh->wish;
    struct size *sizes = allocate(mesh->picture_count, sizeof *sizes);
    for (unsigned i = 0; i < mesh->picture_count; i++) {
        const struct mesh_picture *picture = &mesh->pictures[i];
        sizes[i] = (struct size){picture->width, picture->height, 1};
        while (sizes[i].w > TEXTURE_SIDE_MAX || sizes[i].h > TEXTURE_SIDE_MAX)
            reduce(picture, &sizes[i]);
    }
    for (;;) {
        size_t sum = 0, most = 0;
        unsigned largest = 0;
        for (unsigned i = 0; i < mesh->picture_count; i++) {
            const size_t bytes = is_used[i] ? chain_bytes(sizes[i].w, sizes[i].h, wish->palette) : 0;
            sum += bytes;
            if (bytes > most) {
                most = bytes;
                largest = i;
            }
        }
        if (sum <= wish->bytes)
            return sizes;
        if (sizes[largest].w == 1 && sizes[largest].h == 1)
            fail("%s: its textures do not fit in %zu bytes; give more by --texture-bytes, or --no-textures", mesh->name,
                 wish->bytes);
        reduce(&mesh->pictures[largest], &sizes[largest]);
    }
}

/* ---- pixels ---- */

/* A line of n pixels, `step` apart, into one of m <= n. */
static void shrink_line(const float *from, size_t n, size_t step, float *to, size_t m, size_t to_step)
{
    const double width = (double)n / (double)m;
    for (size_t i = 0; i < m; i++) {
        const double begin = (double)i * width, end = (double)(i + 1) * width;
        double sum[3] = {0};
        for (size_t j = (size_t)begin; j < n && (double)j < end; j++) {
            const double share = fmin(end, (double)(j + 1)) - fmax(begin, (double)j);
            for (size_t k = 0; k < 3; k++)
                sum[k] += share * (double)from[step * j + k];
        }
        for (size_t k = 0; k < 3; k++)
            to[to_step * i + k] = (float)(sum[k] / width);
    }
}

/* Of lines that are as wide as they will be. */
static float *shrink_columns(const float *from, uint32_t w, uint32_t from_h, uint32_t h)
{
    float *to = allocate((size_t)w * h, 3 * sizeof *to);
    for (size_t x = 0; x < w; x++)
        shrink_line(from + 3 * x, from_h, (size_t)3 * w, to + 3 * x, h, (size_t)3 * w);
    return to;
}

static float *shrink(const float *from, uint32_t from_w, uint32_t from_h, uint32_t w, uint32_t h)
{
    float *lines = allocate((size_t)w * from_h, 3 * sizeof *lines);
    for (size_t y = 0; y < from_h; y++)
        shrink_line(from + 3 * y * from_w, from_w, 3, lines + 3 * y * w, w, 3);
    float *to = shrink_columns(lines, w, from_h, h);
    free(lines);
    return to;
}

/* In linear light; a line at a time, since what is read may be far larger than what is made. */
static float *shrink_picture(const struct mesh_picture *picture, uint32_t w, uint32_t h)
{
    float decoded[256];
    for (int i = 0; i < 256; i++)
        decoded[i] = (float)texture_decode(i / 255.);
    float *line = allocate(picture->width, 3 * sizeof *line),
          *lines = allocate((size_t)w * picture->height, 3 * sizeof *lines);
    for (size_t y = 0; y < picture->height; y++) {
        for (size_t i = 0; i < (size_t)3 * picture->width; i++)
            line[i] = decoded[picture->rgb[3 * y * picture->width + i]];
        shrink_line(line, picture->width, 3, lines + 3 * y * w, w, 3);
    }
    float *to = shrink_columns(lines, w, picture->height, h);
    free(line);
    free(lines);
    return to;
}

static uint16_t to_565(const float rgb[3])
{
    unsigned level[3];
    for (int k = 0; k < 3; k++)
        level[k] = (unsigned)lround(fmin(1, texture_encode((double)rgb[k])) * (k == 1 ? 63 : 31));
    return (uint16_t)(level[0] << 11 | level[1] << 5 | level[2]);
}

static uint16_t *chain_of(const struct mesh_picture *picture, uint32_t w, uint32_t h, unsigned levels)
{
    uint16_t *pixels = allocate(chain_pixels(w, h), sizeof *pixels), *to = pixels;
    float *now = shrink_picture(picture, w, h);
    for (unsigned level = 0; level < levels; level++) {
        for (size_t i = 0; i < (size_t)w * h; i++)
            *to++ = to_565(&now[3 * i]);
        float *next = shrink(now, w, h, half(w), half(h));
        free(now);
        now = next;
        w = half(w);
        h = half(h);
    }
    free(now);
    return pixels;
}

static void make(struct texture *texture, const struct mesh_picture *picture, const struct size *size, bool palette)
{
    const unsigned levels = levels_of(size->w, size->h);
    uint16_t *pixels = chain_of(picture, size->w, size->h, levels);
    texture->name = picture->name;
    texture->texture = (struct glint_texture){
        .pixels = pixels, .w = (uint16_t)size->w, .h = (uint16_t)size->h, .levels = (uint8_t)levels};
    if (!palette) {
        texture->pixels = pixels;
        return;
    }
    const size_t count = texture_pixels(texture);
    texture->indices = allocate(count, 1);
    texture->colors = texture_palette(pixels, count, texture->palette, texture->indices);
    texture->texture.pixels = texture->indices;
    texture->texture.palette = texture->palette;
    free(pixels);
}

struct texture *textures_of(const struct mesh *mesh, const bool *is_used)
{
    struct texture *textures = allocate(mesh->picture_count, sizeof *textures);
    struct size *sizes = sizes_of(mesh, is_used);
    for (unsigned i = 0; i < mesh->picture_count; i++)
        if (is_used[i])
            make(&textures[i], &mesh->pictures[i], &sizes[i], mesh->wish.palette);
    free(sizes);
    return textures;
}

void textures_free(struct texture *textures, unsigned count)
{
    for (unsigned i = 0; textures && i < count; i++) {
        free(textures[i].pixels);
        free(textures[i].indices);
    }
    free(textures);
}

/* ---- made ones ---- */

size_t texture_pixels(const struct texture *texture)
{
    return chain_pixels(texture->texture.w, texture->texture.h);
}

size_t texture_bytes(const struct texture *texture)
{
    return texture_pixels(texture) * (texture->colors ? 1 : 2) + texture->colors * sizeof *texture->palette;
}

void texture_size(const struct glint_texture *texture, unsigned level, uint32_t size[2])
{
    size[0] = texture->w;
    size[1] = texture->h;
    for (; level; level--) {
        size[0] = half(size[0]);
        size[1] = half(size[1]);
    }
}

void texture_color(const struct glint_texture *texture, unsigned level, long x, long y, double rgb[3])
{
    size_t at = 0;
    uint32_t size[2];
    for (unsigned i = 0; i < level; i++) {
        texture_size(texture, i, size);
        at += (size_t)size[0] * size[1];
    }
    texture_size(texture, level, size);
    const long w = (long)size[0], h = (long)size[1];
    at += (size_t)(((y % h + h) % h) * w + (x % w + w) % w);
    const uint16_t color = texture->palette ? texture->palette[((const uint8_t *)texture->pixels)[at]]
                                            : ((const uint16_t *)texture->pixels)[at];
    rgb[0] = (color >> 11) * (255. / 31);
    rgb[1] = (color >> 5 & 63) * (255. / 63);
    rgb[2] = (color & 31) * (255. / 31);
}
