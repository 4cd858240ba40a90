/* SPDX-License-Identifier: MIT
 * What tests draw with, random scenes, and what their pixels must be by the definition, written another way than in lib/: 128-bit
 * fractions in gamma space, double precision in linear space. */
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

/* ---- Directions, as lib/sequence.md has them ---- */

/* In Q2.30; false for one of length 0. */
static inline bool unit_of(const int64_t v[3], int64_t out[3])
{
    int64_t size[3], largest = 0;
    for (int k = 0; k < 3; k++) {
        size[k] = llabs(v[k]);
        largest = size[k] > largest ? size[k] : largest;
    }
    if (largest == 0)
        return false;
    uint64_t squares = 0;
    for (; largest >= 1 << 30; largest /= 2)
        for (int k = 0; k < 3; k++)
            size[k] /= 2;
    for (; largest < 1 << 29; largest *= 2)
        for (int k = 0; k < 3; k++)
            size[k] *= 2;
    for (int k = 0; k < 3; k++)
        squares += (uint64_t)(size[k] * size[k]);
    const int64_t root = (int64_t)root_of(squares);
    for (int k = 0; k < 3; k++)
        out[k] = (v[k] < 0 ? -1 : 1) * (((size[k] << 30) + root / 2) / root);
    return true;
}

static inline struct glint_vec q15_of(const int64_t v[3])
{
    int16_t c[3];
    for (int k = 0; k < 3; k++)
        c[k] = (int16_t)fmin(floor((double)v[k] / 32768 + .5), 32767);
    return (struct glint_vec){c[0], c[1], c[2]};
}

/* H of unit vectors; false where the light is straight behind. */
static inline bool half_of(const int64_t l[3], const int64_t v[3], struct glint_vec *h)
{
    int64_t half[3], unit[3];
    bool is_behind = true;
    for (int k = 0; k < 3; k++) {
        is_behind = is_behind && llabs(l[k] + v[k]) <= 8;
        half[k] = (int64_t)floor((double)(l[k] + v[k]) / 2);
    }
    if (is_behind || !unit_of(half, unit))
        return false;
    *h = q15_of(unit);
    return true;
}

/* ---- What is drawn with ---- */

/* What a paint is made of, and one directional light. l, v, h: what light and viewer come to. */
struct look {
    struct glint_material material;
    struct glint_output output;
    struct glint_light light;
    int32_t to_viewer[3];
    struct glint_vec l, v, h;
};

static const int32_t in_front[3] = {0, 0, 1};

/* White light. GLINT_ERR_VECTOR where the directions are none, and *look stays as it was. */
static inline enum glint_err look_light(struct look *look, const int32_t to_light[3], const int32_t to_viewer[3])
{
    const int64_t wide_l[3] = {to_light[0], to_light[1], to_light[2]},
                  wide_v[3] = {to_viewer[0], to_viewer[1], to_viewer[2]};
    int64_t l[3], v[3];
    struct glint_vec h;
    if (!unit_of(wide_l, l) || !unit_of(wide_v, v) || !half_of(l, v, &h))
        return GLINT_ERR_VECTOR;
    assert_int_equal(glint_light_directional(&look->light, to_light), GLINT_OK);
    memcpy(look->to_viewer, to_viewer, sizeof look->to_viewer);
    look->l = q15_of(l);
    look->v = q15_of(v);
    look->h = h;
    return GLINT_OK;
}

static inline void look_any_light(struct look *look)
{
    int32_t to_light[3];
    do {
        for (int i = 0; i < 3; i++)
            to_light[i] = (int32_t)below(201) - (i < 2 ? 100 : 20);
    } while (look_light(look, to_light, in_front) != GLINT_OK);
}

static inline void set_model(struct look *look, enum glint_model model, uint16_t n, uint8_t q)
{
    look->material.model = (uint8_t)model;
    look->material.n = n;
    look->material.q = q;
}

static inline struct look random_look(enum glint_format format, enum glint_space space)
{
    struct look s;
    memset(&s, 0, sizeof s);
    static const uint16_t shininess[] = {1, 3, 10, 60, 200, 1000};
    set_model(&s, (enum glint_model)below(GLINT_MODEL_COUNT), shininess[below(6)], (uint8_t)below(17));
    look_any_light(&s);
    for (int k = 0; k < 3; k++) {
        s.material.ambient_q16[k] = below(20000);
        s.material.diffuse_q16[k] = below(65537);
        s.material.specular_q16[k] = below(90000); /* some above 1.0: they count as 1.0 */
        s.material.albedo[k] = (uint8_t)below(256);
    }
    s.material.clamp_peak = below(2);
    s.output.format = (uint8_t)format;
    s.output.space = (uint8_t)space;
    s.output.dither = below(2);
    return s;
}

/* The exact paint, lit. */
static inline void paint_of(struct glint_paint *paint, const struct look *look)
{
    assert_int_equal(glint_paint_exact(paint, &look->material, &look->output), GLINT_OK);
    assert_int_equal(glint_paint_light(paint, &look->light, 1, look->to_viewer), GLINT_OK);
}

/* A rectangle by it. */
static inline enum glint_err draw_rect(const struct look *look, const struct glint_maps *maps, uint16_t w, uint16_t h,
                                       const struct glint_surface *target, struct glint_box *highlight)
{
    struct glint_paint paint;
    paint_of(&paint, look);
    return glint_draw_rect(&paint, maps, w, h, target, highlight);
}

static inline enum glint_err draw_span(const struct look *look, const struct glint_span *span,
                                       const struct glint_surface *target, struct glint_box *highlight)
{
    struct glint_paint paint;
    paint_of(&paint, look);
    return glint_draw_span(&paint, span, NULL, target, highlight);
}

static inline unsigned max_of(enum glint_format format, unsigned k)
{
#define FORMAT_MAX(number, name, bits, channels, red, green, blue) {red, green, blue},
    static const uint8_t max[][3] = {GLINT_FORMATS(FORMAT_MAX)};
#undef FORMAT_MAX
    return max[format][k];
}

static inline bool is_grey(enum glint_format format)
{
    return format == GLINT_GREY8 || format == GLINT_GREY4 || format == GLINT_GREY2 || format == GLINT_MONO;
}

/* The cutoff of a material: where it names none, its output's. And its last t. */
static inline unsigned q_of(const struct look *look)
{
    if (look->material.q)
        return look->material.q;
    if (look->output.space == GLINT_LINEAR)
        return 12;
    const bool is_coarse = max_of((enum glint_format)look->output.format, 0) < 255;
    return is_coarse && !look->output.dither ? 6 : 8;
}

static inline uint32_t last_t_of(const struct look *look)
{
    return glint_cutoff_t((enum glint_model)look->material.model, look->material.n, q_of(look));
}

static inline uint32_t f_at(const struct look *look, int64_t t)
{
    const uint32_t f = t > (int64_t)last_t_of(look)
                           ? 0
                           : glint_eval_t((enum glint_model)look->material.model, look->material.n, (uint32_t)t);
    return look->material.clamp_peak && f > 65536 ? 65536 : f;
}

static inline struct glint_vec random_normal(const struct look *look)
{
    if (below(8) == 0) { /* garbage is legal, and may be up to 1.7 long */
        const struct glint_vec any = {(int16_t)(below(65536) - 32768), (int16_t)(below(65536) - 32768),
                                      (int16_t)(below(65536) - 32768)};
        return any;
    }
    int32_t v[3] = {(int32_t)below(2001) - 1000, (int32_t)below(2001) - 1000, (int32_t)below(1000)};
    if (below(2)) { /* in the highlight */
        v[0] = look->h.x + (int32_t)below(8001) - 4000;
        v[1] = look->h.y + (int32_t)below(8001) - 4000;
        v[2] = look->h.z;
    }
    struct glint_vec n = {0, 0, 32767};
    (void)glint_vec_normalize(&n, v);
    return n;
}

/* |N - H|^2 / 2 */
static inline int64_t t_of(struct glint_vec n, struct glint_vec h)
{
    const int64_t x = n.x - h.x, y = n.y - h.y, z = n.z - h.z;
    return (x * x + y * y + z * z) / 2;
}

/* Steps 1 and 3 for Blinn's geometry and Phong's; *nl in Q16. */
static inline uint32_t lobe_at(const struct look *s, struct glint_vec n, uint32_t *nl)
{
    const int64_t p = dot(n, s->l);
    *nl = p < -8192 ? 0 : (uint32_t)((p + 8192) / 16384 > 65536 ? 65536 : (p + 8192) / 16384);
    if (*nl == 0)
        return 0;
    int64_t t = t_of(n, s->h);
    if (s->material.model == GLINT_PHONG) {
        const int16_t nn[3] = {n.x, n.y, n.z}, l[3] = {s->l.x, s->l.y, s->l.z};
        const int16_t v[3] = {s->v.x, s->v.y, s->v.z};
        double sum = 0; /* exact: each term is a 27-bit integer squared */
        for (int i = 0; i < 3; i++) {
            const double w = floor((((double)l[i] + v[i]) * 1073741824.0 - 2.0 * (double)p * nn[i]) / 2097152 + 0.5);
            sum += w * w;
        }
        t = (int64_t)fmin(floor(sum / 524288), 2147483648.0);
    }
    return f_at(s, t);
}

/* What a light of a colour sends of nl or F. */
static inline uint32_t colored(uint32_t color_q16, uint32_t x)
{
    const uint32_t color = color_q16 < GLINT_LIGHT_COLOR_MAX ? color_q16 : GLINT_LIGHT_COLOR_MAX;
    return (uint32_t)(((uint64_t)color * x + 32768) / 65536);
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

/* Steps 4 to 8 of sums of nl and F, each over 2^16. */
static inline void levels_of(const struct look *s, const uint64_t lit[3], const uint64_t shine[3],
                             const uint8_t albedo[3], uint8_t gloss, unsigned x, unsigned y, unsigned levels[3],
                             double real[3])
{
    const bool grey = is_grey((enum glint_format)s->output.format);
    const unsigned threshold = s->output.dither ? 2 * (unsigned)bayer[(y & 3) * 4 + (x & 3)] + 1 : 16;
    u128 v[3], mixed = 0;
    double mixed_real = 0;
    for (int k = 0; k < 3; k++) {
        const u128 a = clamped(s->material.ambient_q16[k]), d = clamped(s->material.diffuse_q16[k]);
        const u128 light = (a << 16) + d * lit[k];
        const u128 highlight = (u128)clamped(s->material.specular_q16[k]) * gloss * shine[k];
        v[k] = albedo[k] * light + highlight; /* over 255 * 2^32 */
        if (v[k] > (u128)255 << 32)
            v[k] = (u128)255 << 32;
        const double e = albedo[k] / 255.0, linear = e <= 0.04045 ? e / 12.92 : pow((e + 0.055) / 1.055, 2.4);
        real[k] = fmin(linear * (double)light / 4294967296.0 + (double)highlight / 255 / 4294967296.0, 1);
        static const unsigned weight[3] = {54, 183, 19};
        mixed += v[k] * weight[k];
        mixed_real += real[k] * weight[k] / 256;
    }
    for (int k = 0; k < 3; k++) {
        const unsigned max = max_of((enum glint_format)s->output.format, (unsigned)k);
        levels[k] = gamma_level(grey ? mixed / 256 : v[k], max, threshold);
        const double value = grey ? mixed_real : real[k];
        const double encoded = value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 1 / 2.4) - 0.055;
        real[k] = encoded * max + threshold / 32.0; /* its floor is the level */
    }
}

/* Of the look's own light. */
static inline void expected_levels(const struct look *s, struct glint_vec n, const uint8_t albedo[3], uint8_t gloss,
                                   unsigned x, unsigned y, unsigned levels[3], double real[3])
{
    uint32_t nl;
    const uint32_t f = lobe_at(s, n, &nl);
    uint64_t lit[3], shine[3];
    for (int k = 0; k < 3; k++) {
        lit[k] = colored(s->light.color_q16[k], nl);
        shine[k] = colored(s->light.color_q16[k], f);
    }
    levels_of(s, lit, shine, albedo, gloss, x, y, levels, real);
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
    case GLINT_GREY4:
        levels[0] = levels[1] = levels[2] = line[x / 2] >> (x % 2 ? 0 : 4) & 15;
        return;
    case GLINT_GREY2:
        levels[0] = levels[1] = levels[2] = line[x / 4] >> (6 - 2 * (x % 4)) & 3;
        return;
    case GLINT_MONO:
        levels[0] = levels[1] = levels[2] = line[x / 8] >> (7 - x % 8) & 1;
    }
}

enum { W = 37, H = 5, LINE = 4 * W + 8, GUARD = 0xa5 };

struct scene {
    struct glint_vec normals[W * H];
    uint8_t albedo[3 * W * H], gloss[W * H], coverage[W * H], out[LINE * (H + 2)];
    struct glint_maps maps;
    struct glint_surface surface;
    struct look look;
};

/* Its maps, which lie in it, all of them. */
static inline struct glint_maps scene_maps(const struct scene *s)
{
    const struct glint_maps maps = {.normals = s->normals,
                                    .normals_stride = W * sizeof *s->normals,
                                    .normals_format = GLINT_NORMALS_INT16,
                                    .albedo = s->albedo,
                                    .albedo_stride = 3 * W,
                                    .albedo_format = GLINT_RGB888,
                                    .gloss = s->gloss,
                                    .gloss_stride = W,
                                    .coverage = s->coverage,
                                    .coverage_stride = W};
    return maps;
}

static inline void scene_init(struct scene *s, enum glint_format format, enum glint_space space)
{
    s->look = random_look(format, space);
    for (int i = 0; i < W * H; i++) {
        s->normals[i] = random_normal(&s->look);
        s->gloss[i] = (uint8_t)(below(3) ? 255 : below(256));
        s->coverage[i] = (uint8_t)(below(4) ? below(3) ? 255 : 1 + below(255) : 0);
        for (int k = 0; k < 3; k++)
            s->albedo[3 * i + k] = (uint8_t)below(256);
    }
    memset(s->out, GUARD, sizeof s->out);
    s->maps = scene_maps(s);
    s->surface = (struct glint_surface){s->out + LINE, LINE, (uint16_t)below(5), (uint16_t)below(5)};
}

/* The same scene, whose maps and pixels are its own. */
static inline void scene_copy(struct scene *to, const struct scene *from)
{
    *to = *from;
    const struct glint_maps all = scene_maps(to);
    to->maps.normals = all.normals;
    to->maps.albedo = from->maps.albedo ? all.albedo : NULL;
    to->maps.gloss = from->maps.gloss ? all.gloss : NULL;
    to->maps.coverage = from->maps.coverage ? all.coverage : NULL;
    to->surface.pixels = to->out + LINE;
}

static inline enum glint_err draw_scene(struct scene *s, struct glint_box *highlight)
{
    return draw_rect(&s->look, &s->maps, W, H, &s->surface, highlight);
}

static inline bool same_box(const struct glint_box *a, const struct glint_box *b)
{
    return a->x == b->x && a->y == b->y && a->w == b->w && a->h == b->h;
}

static inline unsigned pixel_bits(enum glint_format format)
{
#define FORMAT_BITS(number, name, bits, channels, red, green, blue) bits,
    static const uint8_t bits[] = {GLINT_FORMATS(FORMAT_BITS)};
#undef FORMAT_BITS
    return bits[format];
}

static inline unsigned bytes_of(enum glint_format format, unsigned w)
{
    return (pixel_bits(format) * w + 7) / 8;
}

/* All of them, those last whose lines start on bytes. */
enum { WHOLE_FORMATS = GLINT_FORMAT_COUNT - 3 };
static inline enum glint_format format_number(int64_t i)
{
    static const enum glint_format last[] = {GLINT_GREY4, GLINT_GREY2, GLINT_MONO};
    const int64_t format = i % GLINT_FORMAT_COUNT;
    return format >= WHOLE_FORMATS ? last[format - WHOLE_FORMATS]
                                   : (enum glint_format)(format + (format >= GLINT_MONO));
}

/* All other bytes are GUARD still, and so are the bits past a line's last pixel. */
static inline void assert_only_the_rectangle_is_written(const uint8_t *out, size_t size, size_t start, ptrdiff_t stride,
                                                        enum glint_format format, uint16_t w, uint16_t h)
{
    const unsigned bits = pixel_bits(format);
    for (size_t b = 0; b < size; b++) {
        const ptrdiff_t at = (ptrdiff_t)b - (ptrdiff_t)start;
        const bool inside = at >= 0 && at < stride * h && at % stride < (ptrdiff_t)bytes_of(format, w);
        if (!inside)
            assert_int_equal(out[b], GUARD);
        else if (bits * w % 8 && at % stride == (ptrdiff_t)(bits * w / 8))
            assert_int_equal(out[b] & (0xff >> bits * w % 8), GUARD & (0xff >> bits * w % 8));
    }
}

/* Draws w x h pixels over `normals` with the look: GLINT_OK. */
typedef enum glint_err draw_rectangle(const struct look *look, const struct glint_maps *maps, uint16_t w, uint16_t h,
                                      const struct glint_surface *surface);

/* Draws into memory with guards around, at any alignment, lines from the top or from the bottom. */
static inline void assert_draws_within(draw_rectangle *draw, enum glint_format format, enum glint_space space,
                                       uint16_t w, uint16_t h, uint16_t x, uint16_t y)
{
    const struct look look = random_look(format, space);
    const unsigned need = bytes_of(format, w);
    const ptrdiff_t stride = (ptrdiff_t)need + (ptrdiff_t)below(6);
    const size_t size = (size_t)stride * h + 64;
    struct glint_vec *normals = malloc(((size_t)w * h + 1) * sizeof *normals); /* exact, for the sanitizer */
    uint8_t *out = malloc(size);
    assert_true(normals && out);
    for (int p = 0; p < w * h; p++)
        normals[p] = random_normal(&look);
    memset(out, GUARD, size);
    const bool upside_down = below(2) && h > 0;
    const unsigned start = 1 + below(8);
    uint8_t *first = out + start + (upside_down ? stride * (h - 1) : 0);
    const struct glint_surface surface = {first, upside_down ? -stride : stride, x, y};
    const struct glint_maps maps = {.normals = normals, .normals_stride = w * (ptrdiff_t)sizeof *normals};
    assert_int_equal(draw(&look, &maps, w, h, &surface), GLINT_OK);
    assert_only_the_rectangle_is_written(out, size, start, stride, format, w, h);
    free(normals);
    free(out);
}

#endif
