/* SPDX-License-Identifier: MIT
 * Table loops as lib/sequence.md writes them down, written another way than in lib/: channel by channel and without short cuts. */
#ifndef UNIT_TABLES_MODEL_H
#define UNIT_TABLES_MODEL_H

#include "shading.h"

/* ---- Fill ---- */

static inline unsigned column_of(const struct look *s, uint32_t t)
{
    const uint64_t f0 = f_at(s, 0);
    return (unsigned)((63 * (uint64_t)f_at(s, t) + f0 / 2) / f0);
}

static inline uint32_t f_of(const struct look *s, unsigned column)
{
    return (column * f_at(s, 0) + 31) / 63;
}

/* The largest t for which it holds; it holds at 0 and stops holding once. */
static inline uint32_t last_t(const struct look *s, bool (*holds)(const struct look *s, uint32_t t))
{
    uint32_t good = 0, bad = last_t_of(s) + 1;
    while (bad - good > 1) {
        const uint32_t t = good + (bad - good) / 2;
        if (holds(s, t))
            good = t;
        else
            bad = t;
    }
    return good;
}

static inline unsigned least_shift(uint32_t u, uint32_t limit)
{
    unsigned s = 0;
    while ((u >> s) + (65536u >> s) >= limit)
        s++;
    return s;
}

/* t in the middle of column i, counted from u down. */
static inline uint32_t middle(uint32_t u, unsigned shift, uint32_t i)
{
    const int64_t t = (int64_t)u - ((int64_t)i << shift) - ((INT64_C(1) << shift) >> 1);
    return t < 0 ? 0 : (uint32_t)t;
}

/* A channel's value over 255 * 2^32, at most 1. */
static inline u128 value_of(const struct look *s, int k, unsigned albedo, uint32_t nl, uint32_t f)
{
    const u128 lit = ((u128)clamped(s->material.ambient_q16[k]) << 16) + (u128)clamped(s->material.diffuse_q16[k]) * nl;
    const u128 sum = albedo * lit + (u128)clamped(s->material.specular_q16[k]) * 255 * f, one = (u128)255 << 32;
    return sum < one ? sum : one;
}

static inline unsigned nearest_level(u128 value, unsigned max)
{
    return gamma_level(value, max, 16);
}

/* As in memory. */
static inline uint16_t in_order(const struct look *s, unsigned rgb)
{
    const uint8_t low = (uint8_t)rgb, high = (uint8_t)(rgb >> 8);
    const uint8_t bytes[2] = {s->output.format == GLINT_RGB565 ? low : high,
                              s->output.format == GLINT_RGB565 ? high : low};
    uint16_t pixel;
    memcpy(&pixel, bytes, 2);
    return pixel;
}

/* Steps 4 to 8 with the material's albedo. */
static inline uint16_t pixel_565(const struct look *s, uint32_t nl, uint32_t f)
{
    unsigned level[3];
    for (int k = 0; k < 3; k++)
        level[k] = nearest_level(value_of(s, k, s->material.albedo[k], nl, f), k == 1 ? 63 : 31);
    return in_order(s, level[0] << 11 | level[1] << 5 | level[2]);
}

static inline uint64_t square(int64_t x)
{
    return (uint64_t)(x * x);
}

/* ---- Paints ---- */

static inline void paint_of_tables(struct glint_paint *paint, enum glint_tables_kind kind, const struct look *look,
                                   void *memory)
{
    assert_int_equal(glint_paint_tables(paint, kind, &look->material, &look->output, memory,
                                        glint_tables_bytes(kind, look->output.dither)),
                     GLINT_OK);
    assert_int_equal(glint_paint_light(paint, &look->light, 1, look->to_viewer), GLINT_OK);
}

/* ---- A scene: normals about the light's, some along it or across, some of any bits, some runs without surface. None so long that its
 * t is 2 and more: those get some colour or other. ---- */

enum { WIDE = 43, LINES = 3 };
struct surface_normals {
    struct glint_vec vec[WIDE * LINES]; /* as the loops read them */
    uint32_t word[WIDE * LINES];
};

static inline struct glint_vec near_normal(const struct look *look)
{
    const struct glint_vec across = {look->l.y, (int16_t)(look->l.x > INT16_MIN ? -look->l.x : 0), 0};
    struct glint_vec n;
    do /* along the light a normal may be longer than 1; across N.L is 0, mostly */
        n = below(6) ? random_normal(look) : below(2) ? look->l : across;
    while (t_of(n, look->h) >> 31);
    return n;
}

static inline void random_surface(struct surface_normals *s, enum glint_normals format, const struct look *look)
{
    const bool is_8 = format == GLINT_NORMALS_INT8;
    uint32_t none = 0;
    for (int p = 0; p < WIDE * LINES; p++) {
        struct glint_vec *n = &s->vec[p];
        *n = near_normal(look);
        s->word[p] = 0;
        if (is_8)
            do {
                s->word[p] = below(9) ? glint_normals_pack(format, n) : below(65536) << 16 | below(65536);
                *n = glint_normals_unpack(format, s->word[p]);
            } while (s->word[p] >> 16 == 0 || t_of(*n, look->h) >> 31);
        if (none == 0 && below(20) == 0)
            none = 1 + below(WIDE);
        if (none) {
            s->word[p] = none;
            *n = (struct glint_vec){0, 0, 0};
            none--;
        }
    }
}

/* As maps, in a format. */
static inline struct glint_maps maps_of(const struct surface_normals *s, enum glint_normals format)
{
    const bool is_8 = format == GLINT_NORMALS_INT8;
    const struct glint_maps maps = {.normals = is_8 ? (const void *)s->word : s->vec,
                                    .normals_stride = WIDE * (is_8 ? 4 : 6),
                                    .normals_format = (uint8_t)format};
    return maps;
}

static inline bool is_surface(struct glint_vec n)
{
    return n.x | n.y | n.z;
}

/* Seen from the front, a light from anywhere, also from behind and grazing. */
static inline struct look tables_look(enum glint_format format)
{
    struct look s = random_look(format, GLINT_GAMMA);
    s.output.dither = false;
    for (int k = 0, grey = below(4) == 0; k < 3 && grey; k++) { /* sums that are alike, and a half */
        s.material.diffuse_q16[k] = s.material.diffuse_q16[0];
        s.material.ambient_q16[k] = s.material.ambient_q16[0];
        s.material.specular_q16[k] = s.material.specular_q16[0];
        s.material.albedo[k] = 255;
    }
    static const uint16_t shininess[] = {1, 2, 5, 10, 60, 200, 1000};
    enum glint_model model;
    do
        model = (enum glint_model)below(GLINT_MODEL_COUNT);
    while (model == GLINT_PHONG); /* its geometry is not |N - H|^2 */
    set_model(&s, model, shininess[below(7)], (uint8_t)(below(3) ? 6 + below(3) : below(17)));
    static const int32_t tricky[][3] = {{1, 1, 1},   {0, 0, 1},    {1, 0, 0},  {0, -1, 0},
                                        {3, 1, -20}, {0, 1, -300}, {-1, -1, 1}};
    if (below(3) == 0)
        assert_int_equal(look_light(&s, tricky[below(7)], in_front), GLINT_OK);
    return s;
}

/* Of ALBEDO tables: grey light, at most 1. */
static inline void make_grey(struct look *look, uint32_t ambient, uint32_t diffuse)
{
    for (int k = 0; k < 3; k++) {
        look->material.ambient_q16[k] = ambient;
        look->material.diffuse_q16[k] = diffuse;
    }
}

#endif
