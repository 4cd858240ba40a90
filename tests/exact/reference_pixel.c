/* SPDX-License-Identifier: MIT */
#include "reference_pixel.h"

#define ONE ((uint64_t)65535 << 32) /* a value of 1.0 */

static int64_t dot(struct glint_vec a, struct glint_vec b)
{
    return (int64_t)a.x * b.x + (int64_t)a.y * b.y + (int64_t)a.z * b.z;
}

static uint32_t half_t(struct glint_vec n, struct glint_vec h)
{
    const int64_t x = n.x - h.x, y = n.y - h.y, z = n.z - h.z, sum = x * x + y * y + z * z;
    return sum >> 32 ? UINT32_C(1) << 31 : (uint32_t)(sum >> 1);
}

static int64_t off_mirror(int16_t l, int16_t v, int64_t p, int16_t n)
{
    return (((int64_t)l + v) * (INT64_C(1) << 30) - 2 * p * n + (1 << 20)) >> 21;
}

static uint32_t mirror_t(struct glint_vec n, struct glint_vec l, struct glint_vec v)
{
    const int64_t p = dot(n, l);
    const int64_t x = off_mirror(l.x, v.x, p, n.x), y = off_mirror(l.y, v.y, p, n.y), z = off_mirror(l.z, v.z, p, n.z);
    const int64_t sum = x * x + y * y + z * z;
    return sum >> 50 ? UINT32_C(1) << 31 : (uint32_t)(sum >> 19);
}

uint32_t reference_nl_of(int64_t nl_q30)
{
    const int64_t nl = (nl_q30 + (1 << 13)) >> 14;
    return nl < 0 ? 0 : nl > 65536 ? 65536 : (uint32_t)nl;
}

static uint64_t held(uint32_t q16)
{
    return q16 > 65536 ? 65536 : q16;
}

/* Over a level that is there, where not all is covered. */
static uint32_t level(const struct reference *s, uint64_t x, uint32_t max, uint32_t weight, uint32_t coverage,
                      uint32_t there)
{
    if (s->output.space == GLINT_LINEAR)
        x = (uint64_t)glint_srgb_encode((uint16_t)((x + (UINT64_C(1) << 31)) >> 32)) << 32;
    if (s->output.format == GLINT_ARGB8888)
        coverage = 255;
    const unsigned __int128 over = (unsigned __int128)x * max * coverage,
                            under = (255 - coverage) * there * (unsigned __int128)ONE;
    return (uint32_t)((over + under + (unsigned __int128)(255 * ONE / 32) * weight) / (255 * ONE));
}

/* A channel of a byte. */
static void put(const struct reference *s, uint8_t *out, uint64_t x, uint32_t weight, uint8_t coverage)
{
    *out = (uint8_t)level(s, x, 255, weight, coverage, *out);
}

/* 0 is what the output needs. */
static unsigned q_of(const struct reference *s)
{
    if (s->material.q)
        return s->material.q;
    if (s->output.space == GLINT_LINEAR)
        return 12;
    const bool is_coarse =
        s->output.format == GLINT_RGB565 || s->output.format == GLINT_RGB565_SWAPPED || s->output.format == GLINT_MONO;
    return is_coarse && !s->output.dither ? 6 : 8;
}

uint32_t reference_t_last(const struct reference *s)
{
    return glint_cutoff_t((enum glint_model)s->material.model, s->material.n, q_of(s));
}

uint32_t reference_lobe(const struct reference_lines *lines, uint32_t t, uint32_t nl)
{
    const struct glint_material *m = &lines->look->material;
    const uint32_t f = nl && t <= lines->t_last ? glint_eval_t((enum glint_model)m->model, m->n, t) : 0;
    return m->clamp_peak && f > 65536 ? 65536 : f;
}

/* Steps 4 to 9. */
static void pixel(const struct reference *s, uint8_t *line, uint32_t x, uint32_t left, uint32_t y,
                  const uint64_t lit[3], const uint64_t shine[3], const uint8_t *albedo, uint8_t gloss,
                  uint8_t coverage)
{
    static const uint8_t bayer[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    const uint32_t weight = s->output.dither ? 2 * bayer[y & 3][(left + x) & 3] + 1u : 16;
    uint64_t v[3];
    for (int k = 0; k < 3; k++) {
        const uint64_t a = s->output.space == GLINT_LINEAR ? glint_srgb_decode(albedo[k]) : albedo[k] * 257u;
        const uint64_t light = (held(s->material.ambient_q16[k]) << 16) + held(s->material.diffuse_q16[k]) * lit[k];
        const uint64_t sum = a * light + held(s->material.specular_q16[k]) * (uint64_t)(gloss * 257u) * shine[k];
        v[k] = sum < ONE ? sum : ONE;
    }
    const uint64_t grey = (54 * v[0] + 183 * v[1] + 19 * v[2]) >> 8;
    switch ((enum glint_format)s->output.format) {
    case GLINT_RGB565:
    case GLINT_RGB565_SWAPPED: {
        const bool swapped = s->output.format == GLINT_RGB565_SWAPPED;
        const uint32_t there = (uint32_t)line[2 * x + !swapped] << 8 | line[2 * x + swapped];
        const uint32_t rgb = level(s, v[0], 31, weight, coverage, there >> 11) << 11 |
                             level(s, v[1], 63, weight, coverage, there >> 5 & 63) << 5 |
                             level(s, v[2], 31, weight, coverage, there & 31);
        line[2 * x + swapped] = (uint8_t)rgb;
        line[2 * x + !swapped] = (uint8_t)(rgb >> 8);
        break;
    }
    case GLINT_RGB888:
        for (uint32_t k = 0; k < 3; k++)
            put(s, line + 3 * x + k, v[k], weight, coverage);
        break;
    case GLINT_BGR888:
        for (uint32_t k = 0; k < 3; k++)
            put(s, line + 3 * x + 2 - k, v[k], weight, coverage);
        break;
    case GLINT_XRGB8888:
    case GLINT_ARGB8888:
        for (uint32_t k = 0; k < 3; k++)
            put(s, line + 4 * x + 2 - k, v[k], weight, coverage);
        line[4 * x + 3] = s->output.format == GLINT_ARGB8888 ? coverage : 255;
        break;
    case GLINT_GREY8:
        put(s, line + x, grey, weight, coverage);
        break;
    case GLINT_MONO: {
        const uint8_t bit = (uint8_t)(0x80 >> (x & 7));
        line[x >> 3] = (uint8_t)(level(s, grey, 1, weight, coverage, line[x >> 3] & bit ? 1 : 0) ? line[x >> 3] | bit
                                                                                                 : line[x >> 3] & ~bit);
    }
    }
}

static void add(struct glint_box *box, uint32_t *right, uint32_t x, uint32_t y)
{
    if (!box->w) {
        box->x = (uint16_t)x;
        *right = x;
        box->y = (uint16_t)y;
        box->w = 1;
    }
    box->x = x < box->x ? (uint16_t)x : box->x;
    *right = x > *right ? x : *right;
    box->w = (uint16_t)(*right + 1 - box->x);
    box->h = (uint16_t)(y + 1 - box->y);
}

static const uint8_t *row(const uint8_t *map, ptrdiff_t stride, uint32_t y)
{
    return map ? map + stride * (ptrdiff_t)y : NULL;
}

bool reference_is_covered(const struct reference_lines *lines, uint32_t x, uint32_t y)
{
    const struct glint_maps *maps = lines->maps;
    const uint8_t *coverage = maps ? row(maps->coverage, maps->coverage_stride, y) : NULL;
    return !coverage || coverage[x];
}

bool reference_at(const struct reference_lines *lines, uint32_t x, uint32_t y, struct glint_vec *normal)
{
    const uint8_t *normals = row((const uint8_t *)lines->maps->normals, lines->maps->normals_stride, y);
    if (lines->maps->normals_format == GLINT_NORMALS_INT16) {
        *normal = ((const struct glint_vec *)(const void *)normals)[x];
    } else {
        const uint32_t word = ((const uint32_t *)(const void *)normals)[x];
        const int32_t low = (int16_t)word, nx = (int8_t)word, ny = (low - nx) / 256; /* 256 y + x */
        if (word >> 16 == 0)
            return false;
        *normal = (struct glint_vec){(int16_t)(256 * nx), (int16_t)(256 * ny), (int16_t)(word >> 16)};
    }
    return reference_is_covered(lines, x, y);
}

uint32_t reference_nl(struct glint_vec n, const struct glint_vec *l)
{
    return reference_nl_of(dot(n, *l));
}

uint32_t reference_f(const struct reference_lines *lines, struct glint_vec n, const struct glint_vec lvh[3])
{
    const bool is_phong = lines->look->material.model == GLINT_PHONG;
    return reference_lobe(lines, is_phong ? mirror_t(n, lvh[0], lvh[1]) : half_t(n, lvh[2]), reference_nl(n, lvh));
}

void reference_put(struct reference_lines *lines, uint32_t x, uint32_t y, const uint64_t lit[3],
                   const uint64_t shine[3], bool f)
{
    static const struct glint_maps none;
    const struct glint_maps *maps = lines->maps ? lines->maps : &none;
    const struct glint_surface *target = lines->target;
    const uint8_t *albedo = row(maps->albedo, maps->albedo_stride, y);
    const uint8_t *gloss = row(maps->gloss, maps->gloss_stride, y);
    const uint8_t *coverage = row(maps->coverage, maps->coverage_stride, y);
    const uint8_t shiny = gloss ? gloss[x] : 255; /* now: it may be the output */
    pixel(lines->look, (uint8_t *)target->pixels + target->stride * (ptrdiff_t)y, x, target->x, target->y + y, lit,
          shine, albedo ? albedo + 3 * x : lines->look->material.albedo, shiny, coverage ? coverage[x] : 255);
    if (shiny && (lines->any_f ? f : (shine[0] | shine[1] | shine[2]) != 0))
        add(&lines->box, &lines->right, x, y);
}
