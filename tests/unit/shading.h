/* SPDX-License-Identifier: MIT
 * Random scenes, and what their pixels must be by the definition, written another way than in lib/: 128-bit fractions in
 * gamma space, double precision in linear space. */
#ifndef GLINT_UNIT_SHADING_H
#define GLINT_UNIT_SHADING_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "unit.h"

#include "glint.h"

typedef unsigned __int128 u128;

static uint64_t seed = 7;
static inline uint32_t below(uint32_t limit)
{
    seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)((seed >> 32) * limit >> 32);
}

static inline struct glint_vec random_normal(const struct glint_light *light)
{
    if (below(8) == 0) { /* garbage is legal, and may be up to 1.7 long */
        const struct glint_vec any = {(int16_t)(below(65536) - 32768), (int16_t)(below(65536) - 32768),
                                      (int16_t)(below(65536) - 32768)};
        return any;
    }
    int32_t v[3] = {(int32_t)below(2001) - 1000, (int32_t)below(2001) - 1000, (int32_t)below(1000)};
    if (below(2)) { /* in the highlight */
        v[0] = light->h.x + (int32_t)below(8001) - 4000;
        v[1] = light->h.y + (int32_t)below(8001) - 4000;
        v[2] = light->h.z;
    }
    struct glint_vec n = {0, 0, 32767};
    (void)glint_vec_normalize(&n, v);
    return n;
}

static inline struct glint_shader random_shader(enum glint_format format, enum glint_space space)
{
    struct glint_shader s;
    memset(&s, 0, sizeof s);
    static const uint32_t shininess[] = {1, 3, 10, 60, 200, 1000};
    glint_lobe_init(&s.lobe, (enum glint_model)below(GLINT_MODEL_COUNT), shininess[below(6)], below(17));
    const int32_t view[3] = {0, 0, 1};
    int32_t l[3];
    do {
        for (int i = 0; i < 3; i++)
            l[i] = (int32_t)below(201) - (i < 2 ? 100 : 20);
    } while (glint_light_init(&s.light, l, view) != GLINT_OK);
    for (int k = 0; k < 3; k++) {
        s.material.ambient_q16[k] = below(20000);
        s.material.diffuse_q16[k] = below(65537);
        s.material.specular_q16[k] = below(90000); /* some above 1.0: they count as 1.0 */
        s.material.albedo[k] = (uint8_t)below(256);
    }
    s.format = (uint8_t)format;
    s.space = (uint8_t)space;
    s.dither = below(2);
    s.clamp_peak = below(2);
    return s;
}

static inline int64_t dot(struct glint_vec a, struct glint_vec b)
{
    return (int64_t)a.x * b.x + (int64_t)a.y * b.y + (int64_t)a.z * b.z;
}

/* floor(sqrt(x)), x < 2^62 */
static inline uint64_t root_of(uint64_t x)
{
    uint64_t root = (uint64_t)sqrt((double)x);
    while (root * root > x)
        root--;
    while ((root + 1) * (root + 1) <= x)
        root++;
    return root;
}

/* Steps 1 and 3 for Blinn's geometry and Phong's; *nl in Q16. */
static inline uint32_t lobe_at(const struct glint_shader *s, struct glint_vec n, uint32_t *nl)
{
    const int64_t p = dot(n, s->light.l);
    *nl = p < -8192 ? 0 : (uint32_t)((p + 8192) / 16384 > 65536 ? 65536 : (p + 8192) / 16384);
    if (*nl == 0)
        return 0;
    int64_t t;
    if (s->lobe.model == GLINT_PHONG) {
        const int16_t nn[3] = {n.x, n.y, n.z}, l[3] = {s->light.l.x, s->light.l.y, s->light.l.z};
        const int16_t v[3] = {s->light.v.x, s->light.v.y, s->light.v.z};
        double sum = 0; /* exact: each term is a 27-bit integer squared */
        for (int i = 0; i < 3; i++) {
            const double w = floor((((double)l[i] + v[i]) * 1073741824.0 - 2.0 * (double)p * nn[i]) / 2097152 + 0.5);
            sum += w * w;
        }
        t = (int64_t)fmin(floor(sum / 524288), 2147483648.0);
    } else {
        const struct glint_vec h = s->light.h;
        const int64_t x = n.x - h.x, y = n.y - h.y, z = n.z - h.z;
        t = (x * x + y * y + z * z) / 2;
    }
    uint32_t f =
        t > (int64_t)s->lobe.t_max_q30 ? 0 : glint_eval_t((enum glint_model)s->lobe.model, s->lobe.n, (uint32_t)t);
    return s->clamp_peak && f > 65536 ? 65536 : f;
}

static const int bayer[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};

static inline uint32_t clamped(uint32_t q16)
{
    return q16 > 65536 ? 65536 : q16;
}

/* floor(min(1, value) max + threshold), value a fraction over 255 * 2^32 */
static inline unsigned gamma_level(u128 value, unsigned max, unsigned threshold_32nds)
{
    const u128 one = (u128)255 << 32;
    if (value > one)
        value = one;
    return (unsigned)((value * max * 32 + one * threshold_32nds) / (one * 32));
}

static inline void expected_levels(const struct glint_shader *s, struct glint_vec n, const uint8_t albedo[3],
                                   uint8_t gloss, unsigned x, unsigned y, unsigned levels[3], double real[3])
{
    uint32_t nl;
    const uint32_t f = lobe_at(s, n, &nl);
    const bool grey = s->format == GLINT_GREY8 || s->format == GLINT_MONO;
    const unsigned threshold = s->dither ? 2 * (unsigned)bayer[(y & 3) * 4 + (x & 3)] + 1 : 16;
    u128 v[3], mixed = 0;
    double mixed_real = 0;
    for (int k = 0; k < 3; k++) {
        const u128 a = clamped(s->material.ambient_q16[k]), d = clamped(s->material.diffuse_q16[k]);
        const u128 shine = (u128)clamped(s->material.specular_q16[k]) * gloss * f;
        v[k] = albedo[k] * ((a << 16) + d * nl) + shine; /* over 255 * 2^32 */
        if (v[k] > (u128)255 << 32)
            v[k] = (u128)255 << 32;
        const double e = albedo[k] / 255.0, linear = e <= 0.04045 ? e / 12.92 : pow((e + 0.055) / 1.055, 2.4);
        real[k] = linear * ((double)a / 65536 + (double)d / 65536 * nl / 65536) + (double)shine / 255 / 4294967296.0;
        real[k] = fmin(real[k], 1);
        static const unsigned weight[3] = {54, 183, 19};
        mixed += v[k] * weight[k];
        mixed_real += real[k] * weight[k] / 256;
    }
    static const unsigned max565[3] = {31, 63, 31};
    for (int k = 0; k < 3; k++) {
        const unsigned max = s->format == GLINT_MONO ? 1 : s->format <= GLINT_RGB565_SWAPPED ? max565[k] : 255;
        levels[k] = gamma_level(grey ? mixed / 256 : v[k], max, threshold);
        const double value = grey ? mixed_real : real[k];
        const double encoded = value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 1 / 2.4) - 0.055;
        real[k] = encoded * max + threshold / 32.0; /* its floor is the level */
    }
}

static inline void stored_levels(enum glint_format format, const uint8_t *line, unsigned x, unsigned levels[3])
{
    unsigned word;
    switch (format) {
    case GLINT_RGB565:
    case GLINT_RGB565_SWAPPED:
        word = format == GLINT_RGB565 ? line[2 * x] + line[2 * x + 1] * 256u : line[2 * x] * 256u + line[2 * x + 1];
        levels[0] = word >> 11;
        levels[1] = word >> 5 & 63;
        levels[2] = word & 31;
        return;
    case GLINT_RGB888:
        for (int k = 0; k < 3; k++)
            levels[k] = line[3 * x + (unsigned)k];
        return;
    case GLINT_BGR888:
    case GLINT_XRGB8888:
    case GLINT_ARGB8888:
        for (unsigned k = 0; k < 3; k++)
            levels[k] = line[(format == GLINT_BGR888 ? 3 : 4) * x + 2 - k];
        return;
    case GLINT_GREY8:
        levels[0] = levels[1] = levels[2] = line[x];
        return;
    case GLINT_MONO:
        levels[0] = levels[1] = levels[2] = line[x / 8] >> (7 - x % 8) & 1;
    }
}

enum { W = 37, H = 5, LINE = 4 * W + 8, GUARD = 0xa5 };

struct scene {
    struct glint_vec normals[W * H];
    uint8_t albedo[3 * W * H], gloss[W * H], mask[W * H], out[LINE * (H + 2)];
    struct glint_source source;
    struct glint_surface surface;
    struct glint_shader shader;
};

static inline void scene_init(struct scene *s, enum glint_format format, enum glint_space space)
{
    s->shader = random_shader(format, space);
    for (int i = 0; i < W * H; i++) {
        s->normals[i] = random_normal(&s->shader.light);
        s->gloss[i] = (uint8_t)(below(3) ? 255 : below(256));
        s->mask[i] = below(4) != 0;
        for (int k = 0; k < 3; k++)
            s->albedo[3 * i + k] = (uint8_t)below(256);
    }
    memset(s->out, GUARD, sizeof s->out);
    s->source = (struct glint_source){s->normals, W * sizeof *s->normals, s->albedo, 3 * W, s->gloss, W, s->mask, W};
    s->surface = (struct glint_surface){s->out + LINE, LINE, (uint16_t)below(5), (uint16_t)below(5)};
}

static inline unsigned bytes_of(enum glint_format format, unsigned w)
{
#define FORMAT_BYTES(number, name, bytes, channels, red, green, blue) bytes,
    static const uint8_t bytes[] = {GLINT_FORMATS(FORMAT_BYTES)};
#undef FORMAT_BYTES
    return format == GLINT_MONO ? (w + 7) / 8 : bytes[format] * w;
}

/* All of them, mono last: its lines start on bytes. */
static inline enum glint_format format_number(int64_t i)
{
    const int64_t format = i % GLINT_FORMAT_COUNT;
    return (enum glint_format)(format == GLINT_FORMAT_COUNT - 1 ? GLINT_MONO : format + (format >= GLINT_MONO));
}

/* All other bytes are GUARD still, of mono the bits past a line's last pixel, too. */
static inline void assert_only_the_rectangle_is_written(const uint8_t *out, size_t size, size_t start, ptrdiff_t stride,
                                                        enum glint_format format, uint16_t w, uint16_t h)
{
    for (size_t b = 0; b < size; b++) {
        const ptrdiff_t at = (ptrdiff_t)b - (ptrdiff_t)start;
        const bool inside = at >= 0 && at < stride * h && at % stride < (ptrdiff_t)bytes_of(format, w);
        if (!inside)
            assert_int_equal(out[b], GUARD);
        else if (format == GLINT_MONO && w % 8 && at % stride == w / 8)
            assert_int_equal(out[b] & (0xff >> w % 8), GUARD & (0xff >> w % 8));
    }
}

/* Draws w x h pixels over `normals` with the shader: GLINT_OK. */
typedef enum glint_err draw_rectangle(const struct glint_shader *shader, const struct glint_source *source, uint16_t w,
                                      uint16_t h, const struct glint_surface *surface);

/* Draws into memory with guards around, at any alignment, lines from the top or from the bottom. */
static inline void assert_draws_within(draw_rectangle *draw, enum glint_format format, enum glint_space space,
                                       uint16_t w, uint16_t h, uint16_t x, uint16_t y)
{
    const struct glint_shader shader = random_shader(format, space);
    const unsigned need = bytes_of(format, w);
    const ptrdiff_t stride = (ptrdiff_t)need + (ptrdiff_t)below(6);
    const size_t size = (size_t)stride * h + 64;
    struct glint_vec *normals = malloc(((size_t)w * h + 1) * sizeof *normals); /* exact, for the sanitizer */
    uint8_t *out = malloc(size);
    assert_true(normals && out);
    for (int p = 0; p < w * h; p++)
        normals[p] = random_normal(&shader.light);
    memset(out, GUARD, size);
    const bool upside_down = below(2) && h > 0;
    const unsigned start = 1 + below(8);
    uint8_t *first = out + start + (upside_down ? stride * (h - 1) : 0);
    const struct glint_surface surface = {first, upside_down ? -stride : stride, x, y};
    const struct glint_source source = {.normals = normals, .normals_stride = w * (ptrdiff_t)sizeof *normals};
    assert_int_equal(draw(&shader, &source, w, h, &surface), GLINT_OK);
    assert_only_the_rectangle_is_written(out, size, start, stride, format, w, h);
    free(normals);
    free(out);
}

#endif
