/* SPDX-License-Identifier: MIT
 * Fuzzes rectangles and spans: any material, lights, maps and pixel format are drawn within their memory or refused with nothing drawn, and
 * in windows as at once. Input: see next_paint, next_maps and draw_windows, whose windows are x, y, w, h (1 each). */
#include <string.h>

#include "fuzz.h"
#include "glint.h"

enum { WIDTH_MAX = 40, HEIGHT_MAX = 12, LIGHTS_MAX = GLINT_LIGHTS_MAX };
static const int32_t to_viewer[3] = {0, 0, 1};

struct drawn {
    struct glint_paint paint;
    struct glint_light lights[LIGHTS_MAX];
    uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];
    struct glint_maps maps;
    uint16_t w, h;
    uint8_t ground;
};

static void *block(size_t bytes)
{
    void *memory = calloc(1, bytes ? bytes : 1);
    check(memory);
    return memory;
}

static unsigned pixel_bits(unsigned format)
{
#define FORMAT_BITS(number, name, bits, channels, red, green, blue) bits,
    static const uint8_t bits[] = {GLINT_FORMATS(FORMAT_BITS)};
#undef FORMAT_BITS
    return bits[format];
}

static size_t line_bytes(const struct drawn *d, unsigned w)
{
    return (pixel_bits(d->paint.output.format) * w + 7) / 8;
}

/* Towards 0, or of a length that counts. */
static void next_vector(int32_t v[3], struct input *input)
{
    for (int k = 0; k < 3; k++)
        v[k] = (int16_t)next_word(input);
}

static enum glint_err next_light(struct glint_light *light, struct input *input)
{
    const unsigned kind = next_byte(input);
    int32_t at[3], target[3];
    enum glint_err error;
    next_vector(at, input);
    if (kind % 4 == 0) {
        error = glint_light_directional(light, at);
    } else {
        const uint32_t range = 1 + next_word(input);
        next_vector(target, input);
        const int32_t inner = (int16_t)next_word(input) * 32768, outer = (int16_t)next_word(input) * 32768;
        error = kind % 4 == 1 ? glint_light_point(light, at, range)
                              : glint_light_spot(light, at, target, range, inner, outer);
    }
    for (int k = 0; error == GLINT_OK && kind / 4 % 2 && k < 3; k++)
        light->color_q16[k] = next_word(input) << 5;
    return error;
}

/* false: refused. */
static bool next_paint(struct drawn *d, struct input *input)
{
    const unsigned how = next_byte(input), kind = next_byte(input) % 4, format = next_byte(input);
    struct glint_material material = {.model = (uint8_t)(how % 16), .clamp_peak = how / 16 % 2};
    const struct glint_output output = {(uint8_t)(format % 16), how / 32 % 2, how / 64 % 2};
    unsigned lights = 0;
    material.n = (uint16_t)(next_word(input) % 1010);
    material.n_across = (uint16_t)(how / 128 ? next_word(input) % 1010 : 0);
    material.q = (uint8_t)(next_byte(input) % 20);
    for (int k = 0; k < 3; k++) {
        material.ambient_q16[k] = kind == 2 && k ? material.ambient_q16[0] : next_word(input);
        material.diffuse_q16[k] = kind == 2 && k ? material.diffuse_q16[0] : next_word(input) * 2u;
        material.specular_q16[k] = next_word(input) * 2u;
        material.albedo[k] = (uint8_t)next_byte(input);
    }
    if (kind == 0 || kind == 3 ? glint_paint_exact(&d->paint, &material, &output)
                               : glint_paint_tables(&d->paint, kind == 1 ? GLINT_TABLES_COLOUR : GLINT_TABLES_ALBEDO,
                                                    &material, &output, d->memory, sizeof d->memory))
        return false;
    const unsigned count = next_byte(input) % (LIGHTS_MAX + 1);
    while (lights < count && next_light(&d->lights[lights], input) == GLINT_OK)
        lights++;
    return glint_paint_light(&d->paint, d->lights, lights, to_viewer) == GLINT_OK;
}

/* Bytes that begin as the input says and go on by themselves, so that some is left for windows. */
struct run {
    unsigned value, left;
};
static unsigned run_next(struct run *run, struct input *input)
{
    run->value = run->left && input->at < input->end ? next_byte(input) : (run->value * 77 + 31) & 255;
    run->left -= run->left != 0;
    return run->value;
}

/* In a block of its own; NULL where there is none. */
static uint8_t *next_map(struct input *input, bool is_there, size_t bytes)
{
    uint8_t *const map = is_there ? block(bytes) : NULL;
    struct run run = {0, 24};
    for (size_t i = 0; map && i < bytes; i++)
        map[i] = (uint8_t)run_next(&run, input);
    return map;
}

/* About the viewer's direction, or of any bits. */
static void *next_normals(struct input *input, enum glint_normals format, size_t pixels)
{
    const bool is_any = next_byte(input) % 4 == 3;
    struct glint_vec *const vec = block(pixels * sizeof *vec);
    uint32_t *const word = format == GLINT_NORMALS_INT8 ? block(pixels * sizeof *word) : NULL;
    struct run run = {0, 48};
    for (size_t i = 0; i < pixels; i++) {
        const int x = (int)run_next(&run, input) - 128, y = (int)run_next(&run, input) - 128,
                  z = 255 - (x * x + y * y) / 256;
        vec[i] = (struct glint_vec){(int16_t)(x * 160), (int16_t)(y * 160), (int16_t)(z * 128)};
        if (is_any)
            vec[i].z = (int16_t)(z * 77 + x * 16384);
        if (word)
            word[i] = is_any ? (uint32_t)vec[i].z << 16 | (uint16_t)vec[i].x : glint_normals_pack(format, &vec[i]);
    }
    if (!word)
        return vec;
    free(vec);
    return word;
}

static void next_maps(struct drawn *d, struct input *input)
{
    const unsigned how = next_byte(input), more = next_byte(input);
    struct glint_maps *const maps = &d->maps;
    memset(maps, 0, sizeof *maps);
    d->w = (uint16_t)(1 + next_byte(input) % WIDTH_MAX);
    d->h = (uint16_t)(1 + next_byte(input) % HEIGHT_MAX);
    d->ground = (uint8_t)next_byte(input);
    maps->normals_format = how % 4 ? GLINT_NORMALS_INT16 : GLINT_NORMALS_INT8;
    maps->albedo_format = how / 4 % 2 ? GLINT_RGB565 : GLINT_RGB888;
    maps->grain_kind = (uint8_t)(more % 4);
    maps->grain_at[0] = (int16_t)next_word(input);
    maps->grain_at[1] = (int16_t)next_word(input);
    maps->normals_stride = d->w * (maps->normals_format == GLINT_NORMALS_INT16 ? 6 : 4);
    maps->albedo_stride = d->w * (how / 4 % 2 ? 2 : 3);
    maps->gloss_stride = maps->coverage_stride = maps->grain_stride = maps->shininess_stride = d->w;
    const size_t pixels = (size_t)d->w * d->h;
    maps->normals = next_normals(input, (enum glint_normals)maps->normals_format, pixels);
    maps->albedo = next_map(input, how / 8 % 2, (size_t)maps->albedo_stride * d->h);
    maps->gloss = next_map(input, how / 16 % 2, pixels);
    maps->coverage = next_map(input, how / 32 % 2, pixels);
    maps->grain = next_map(input, how / 64 % 2, pixels);
    maps->shininess = next_map(input, how / 128 % 2, pixels);
}

static void maps_free(const struct glint_maps *maps)
{
    free((void *)(uintptr_t)maps->normals);
    free((void *)(uintptr_t)maps->albedo);
    free((void *)(uintptr_t)maps->gloss);
    free((void *)(uintptr_t)maps->coverage);
    free((void *)(uintptr_t)maps->grain);
    free((void *)(uintptr_t)maps->shininess);
}

/* A window of the maps, in a block of its own. */
static uint8_t *window(const struct drawn *d, unsigned x, unsigned y, unsigned w, unsigned h, enum glint_err *error)
{
    const size_t line = line_bytes(d, w), at = (size_t)y * d->w + x;
    uint8_t *const pixels = block(line * h);
    struct glint_maps maps = d->maps;
    struct glint_box box;
    const struct glint_surface surface = {pixels, (ptrdiff_t)line, (uint16_t)(7 + x), (uint16_t)(3 + y)};
    memset(pixels, d->ground, line * h);
    maps.normals = (const uint8_t *)maps.normals + at * (size_t)maps.normals_stride / d->w;
    maps.albedo = maps.albedo ? maps.albedo + at * (size_t)maps.albedo_stride / d->w : NULL;
    maps.gloss = maps.gloss ? maps.gloss + at : NULL;
    maps.coverage = maps.coverage ? maps.coverage + at : NULL;
    maps.grain = maps.grain ? maps.grain + at : NULL;
    maps.shininess = maps.shininess ? maps.shininess + at : NULL;
    *error = glint_draw_rect(&d->paint, &maps, (uint16_t)w, (uint16_t)h, &surface, &box);
    check(*error != GLINT_OK || (box.x + box.w <= w && box.y + box.h <= h));
    for (size_t i = 0; *error != GLINT_OK && i < line * h; i++)
        check(pixels[i] == d->ground);
    return pixels;
}

/* Windows whose lines begin on bytes, and end on bytes or with the picture's. */
static void draw_windows(const struct drawn *d, struct input *input)
{
    enum glint_err whole, part;
    uint8_t *const all = window(d, 0, 0, d->w, d->h, &whole);
    while (input->at < input->end) {
        const unsigned x = next_byte(input) % d->w & ~7u, y = next_byte(input) % d->h,
                       wide = 8 * (1 + next_byte(input) % (WIDTH_MAX / 8)), high = 1 + next_byte(input) % d->h,
                       w = x + wide < d->w ? wide : d->w - x, h = y + high < d->h ? high : d->h - y;
        uint8_t *const pixels = window(d, x, y, w, h, &part);
        check(part == whole);
        for (unsigned i = 0; i < h; i++)
            check(memcmp(pixels + line_bytes(d, w) * i, all + line_bytes(d, d->w) * (y + i) + line_bytes(d, x),
                         line_bytes(d, w)) == 0);
        free(pixels);
    }
    free(all);
}

static void draw_span(struct drawn *d, struct input *input)
{
    struct glint_vec ends[2];
    struct glint_span span;
    for (int i = 0; i < 2; i++) {
        ends[i].x = (int16_t)next_word(input);
        ends[i].y = (int16_t)next_word(input);
        ends[i].z = (int16_t)next_word(input);
    }
    if (glint_span_init(&span, &d->paint, &ends[0], &ends[1], d->w) != GLINT_OK)
        return;
    const size_t line = line_bytes(d, d->w);
    uint8_t *const pixels = block(line);
    const struct glint_surface surface = {pixels, (ptrdiff_t)line, 7, 3};
    struct glint_maps maps = d->maps;
    struct glint_box box;
    maps.normals = NULL;
    memset(pixels, d->ground, line);
    const enum glint_err error = glint_draw_span(&d->paint, &span, &maps, &surface, &box);
    check(error != GLINT_OK || (box.x + box.w <= d->w && box.y + box.h <= 1));
    for (size_t i = 0; error != GLINT_OK && i < line; i++)
        check(pixels[i] == d->ground);
    free(pixels);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, data + size};
    static struct drawn d;
    if (!next_paint(&d, &input))
        return 0;
    next_maps(&d, &input);
    draw_span(&d, &input);
    draw_windows(&d, &input);
    maps_free(&d.maps);
    return 0;
}
