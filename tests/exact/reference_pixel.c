/* SPDX-License-Identifier: MIT */
#include "reference_pixel.h"

#include <math.h>
#include <stdlib.h>

#include "glint_grain.h"
#include "glint_math.h"

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
    switch ((enum glint_format)s->output.format) {
    case GLINT_RGB565:
    case GLINT_RGB565_SWAPPED:
    case GLINT_GREY4:
    case GLINT_GREY2:
    case GLINT_MONO:
        return s->output.dither ? 8 : 6;
    default:
        return 8;
    }
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

/* ---- Step 2a: m, of grain or of a map of shininess ---- */

static uint32_t across_of(const struct glint_material *m)
{
    const uint32_t n = m->n < 1000 ? m->n : 1000, across = m->n_across < 1000 ? m->n_across : 1000;
    return across == n ? 0 : across;
}

bool reference_is_grained(const struct reference_lines *lines)
{
    return across_of(&lines->look->material) || (lines->maps && lines->maps->shininess);
}

/* Upper halves, as the sequence has them. */
static uint64_t upper_square(uint64_t a)
{
    const uint64_t high = a >> 16, low = a & 0xffff;
    return high * high + (high * low >> 15);
}

static uint64_t upper_product(uint64_t a, uint64_t b)
{
    const uint64_t a1 = a >> 16, a0 = a & 0xffff, b1 = b >> 16, b0 = b & 0xffff;
    return a1 * b1 + (a1 * b0 >> 16) + (a0 * b1 >> 16);
}

/* w of step 2a. */
static uint64_t half_square(uint64_t off, uint64_t d, uint64_t s)
{
    int down = 11;
    const uint64_t size = off & UINT64_C(0x80000000) ? UINT64_C(0x100000000) - off : off;
    if (d == 0)
        return s / 2;
    if (size >= 1 << 30)
        return s;
    if (d >= 1 << 28)
        d = (1 << 28) - 1;
    for (; d < 1 << 27; d *= 2)
        down--;
    const int64_t y = glint_reciprocals[(d >> 21) - 64], e = (int64_t)d * y - (INT64_C(1) << 35), r = e >> 14;
    const int64_t inverse = ((y << 23) + (y * ((r * r >> 13) - (e >> 6)) >> 6) + 16384) >> 15;
    const uint64_t square = upper_square(4 * size),
                   w = (square >> 16) * (uint64_t)inverse + ((square & 0xffff) * (uint64_t)inverse >> 16);
    const uint64_t scaled = down >= 0 ? w >> down : w << -down;
    return scaled < s ? scaled : s;
}

static uint32_t turned(int64_t along, int64_t h, uint32_t t)
{
    return (uint32_t)((int64_t)((t + 8192) >> 14) * ((along + 32768) >> 16) - along + h);
}

/* t as m takes it, Q22. */
static uint32_t t_of_m(const struct reference_lines *lines, uint32_t t)
{
    if (lines->look->material.model == GLINT_GGX)
        t -= (uint32_t)upper_square(2 * (uint64_t)t) >> 1;
    return t >> 8;
}

static uint32_t grained(const struct reference_lines *lines, uint32_t t, uint32_t nl, uint64_t m)
{
    const struct glint_material *material = &lines->look->material;
    struct glint_paint paint;
    if (!nl || t > GLINT_T_ONE || glint_paint_exact(&paint, material, &lines->look->output))
        return 0;
    const struct glint_use_grain *use = paint.model->grain;
    const unsigned q = q_of(lines->look);
    const uint32_t f = use->reaches((uint32_t)m, t, q < 16 ? q : 16) ? use->exact((uint32_t)m, t) : 0;
    return material->clamp_peak && f > 65536 ? 65536 : f;
}

static uint64_t m_of(const struct reference_lines *lines, uint64_t s, uint64_t w)
{
    const uint64_t n = lines->look->material.n < 1000 ? lines->look->material.n : 1000;
    const uint64_t across = across_of(&lines->look->material);
    return across * s + n * w - across * w;
}

static void axis(const struct glint_maps *maps, int64_t u[2])
{
    const int64_t at[3] = {maps ? maps->grain_at[0] : 0, maps ? maps->grain_at[1] : 0, 0};
    int64_t unit[3];
    u[0] = 32767;
    u[1] = 0;
    for (int k = 0; k < 2 && reference_unit(unit, at); k++) {
        const int64_t rounded = (unit[k] + 16384) >> 15;
        u[k] = rounded < 32767 ? rounded : 32767;
    }
}

/* Step 2a's U and |U|^2. */
static int64_t direction(const struct reference_lines *lines, uint32_t x, uint32_t y, int64_t u[2])
{
    const struct glint_maps *maps = lines->maps;
    if (maps->grain) {
        const double angle = maps->grain[maps->grain_stride * (ptrdiff_t)y + x] * 3.14159265358979323846 / 256;
        u[0] = lrint(32768 * cos(angle));
        u[1] = lrint(32768 * sin(angle));
    } else if (maps->grain_kind == GLINT_GRAIN_BRUSHED) {
        axis(maps, u);
    } else {
        const int64_t right = 16 * (int64_t)(lines->target->x + x) + 8 - maps->grain_at[0];
        const int64_t up = maps->grain_at[1] - 16 * (int64_t)(lines->target->y + y) - 8;
        const bool is_spun = maps->grain_kind == GLINT_GRAIN_SPUN;
        u[0] = is_spun ? -up : right;
        u[1] = is_spun ? right : up;
        const int64_t size = llabs(u[0]) + llabs(u[1]);
        unsigned shift = 0;
        while (size && size << shift < 1 << 30)
            shift++;
        u[0] = (u[0] * (INT64_C(1) << shift)) >> 16;
        u[1] = (u[1] * (INT64_C(1) << shift)) >> 16;
        return u[0] * u[0] + u[1] * u[1];
    }
    return 0; /* of length 1 */
}

static uint32_t grain_f(const struct reference_lines *lines, uint32_t x, uint32_t y, struct glint_vec n,
                        const struct glint_vec lvh[3])
{
    const struct glint_maps *maps = lines->maps;
    const uint32_t t = half_t(n, lvh[2]), nl = reference_nl(n, lvh), s = t_of_m(lines, t);
    int64_t u[2];
    if (maps->shininess)
        return grained(lines, t, nl,
                       (uint64_t)glint_shininess_n(maps->shininess[maps->shininess_stride * (ptrdiff_t)y + x]) * s);
    if (t > GLINT_T_ONE)
        return 0;
    const int64_t square = direction(lines, x, y, u), along = n.x * u[0] + n.y * u[1];
    const int64_t h = lvh[2].x * u[0] + lvh[2].y * u[1], across = (n.y * u[0] - n.x * u[1]) >> 15;
    uint64_t d = (uint64_t)(n.z * n.z);
    if (!maps->grain && maps->grain_kind != GLINT_GRAIN_BRUSHED)
        d = upper_product(2 * d, 2 * (uint64_t)square);
    d = (d + (uint64_t)(across * across)) >> 3;
    return grained(lines, t, nl, m_of(lines, s, half_square(turned(along, h, t), d, s)));
}

uint32_t reference_span_f(const struct reference_lines *lines, const struct glint_span *span, uint32_t x, uint32_t t,
                          uint32_t nl, struct glint_vec h)
{
    const uint32_t s = t_of_m(lines, t);
    int64_t u[2];
    if (lines->maps && lines->maps->shininess)
        return grained(lines, t, nl, (uint64_t)glint_shininess_n(lines->maps->shininess[x]) * s);
    if (t > GLINT_T_ONE)
        return 0;
    axis(lines->maps, u);
    const int64_t first = span->ends[0][0] * u[0] + span->ends[0][1] * u[1];
    const int64_t last = span->ends[1][0] * u[0] + span->ends[1][1] * u[1], steps = span->w > 1 ? span->w - 1 : 1;
    const int64_t along = first + 2 * ((last / 2 - first / 2) / steps) * x, p = along >> 15;
    const uint64_t d = p * p < 1 << 30 ? (uint64_t)((1 << 30) - p * p) >> 3 : 0;
    return grained(lines, t, nl, m_of(lines, s, half_square(turned(along, h.x * u[0] + h.y * u[1], t), d, s)));
}

/* Bits of a byte, from bit `at` on. */
static void put_bits(const struct reference *s, uint8_t *out, uint32_t at, uint32_t max, uint64_t x, uint32_t weight,
                     uint8_t coverage)
{
    const uint32_t there = (uint32_t)*out >> at & max;
    *out = (uint8_t)(*out - (there << at) + (level(s, x, max, weight, coverage, there) << at));
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
    case GLINT_GREY4:
        put_bits(s, line + x / 2, 4 * (1 - x % 2), 15, grey, weight, coverage);
        break;
    case GLINT_GREY2:
        put_bits(s, line + x / 4, 2 * (3 - x % 4), 3, grey, weight, coverage);
        break;
    case GLINT_MONO:
        put_bits(s, line + x / 8, 7 - x % 8, 1, grey, weight, coverage);
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

uint32_t reference_f(const struct reference_lines *lines, uint32_t x, uint32_t y, struct glint_vec n,
                     const struct glint_vec lvh[3])
{
    if (reference_is_grained(lines))
        return grain_f(lines, x, y, n, lvh);
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
