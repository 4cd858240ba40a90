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

static uint32_t mirror_t(struct glint_vec n, const struct glint_light *light)
{
    const struct glint_vec l = light->l, v = light->v;
    const int64_t p = dot(n, l);
    const int64_t x = off_mirror(l.x, v.x, p, n.x), y = off_mirror(l.y, v.y, p, n.y), z = off_mirror(l.z, v.z, p, n.z);
    const int64_t sum = x * x + y * y + z * z;
    return sum >> 50 ? UINT32_C(1) << 31 : (uint32_t)(sum >> 19);
}

static uint32_t nl_of(int64_t nl_q30)
{
    const int64_t nl = (nl_q30 + (1 << 13)) >> 14;
    return nl < 0 ? 0 : nl > 65536 ? 65536 : (uint32_t)nl;
}

static uint64_t held(uint32_t q16)
{
    return q16 > 65536 ? 65536 : q16;
}

static uint32_t level(const struct glint_shader *s, uint64_t x, uint32_t max, uint32_t weight)
{
    if (s->space == GLINT_LINEAR)
        x = (uint64_t)glint_srgb_encode((uint16_t)((x + (UINT64_C(1) << 31)) >> 32)) << 32;
    return (uint32_t)((x * max + (UINT64_C(65535) << 27) * weight) >> 32) / 65535;
}

/* Step 3. */
static uint32_t lobe(const struct glint_shader *s, uint32_t t, uint32_t nl)
{
    const uint32_t f = nl && t <= s->lobe.t_max_q30 ? glint_eval_t((enum glint_model)s->lobe.model, s->lobe.n, t) : 0;
    return s->clamp_peak && f > 65536 ? 65536 : f;
}

/* Steps 4 to 8; true where it shines. */
static bool pixel(const struct glint_shader *s, uint8_t *line, uint32_t x, uint32_t left, uint32_t y,
                  const uint64_t lit[3], const uint64_t shine[3], const uint8_t *albedo, uint8_t gloss, uint8_t mask)
{
    static const uint8_t bayer[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    const uint32_t weight = s->dither ? 2 * bayer[y & 3][(left + x) & 3] + 1u : 16;
    const bool shines = (shine[0] | shine[1] | shine[2]) && gloss; /* first: gloss may be the output */
    uint64_t v[3];
    for (int k = 0; k < 3; k++) {
        const uint64_t a = s->space == GLINT_LINEAR ? glint_srgb_decode(albedo[k]) : albedo[k] * 257u;
        const uint64_t light = (held(s->material.ambient_q16[k]) << 16) + held(s->material.diffuse_q16[k]) * lit[k];
        const uint64_t sum = a * light + held(s->material.specular_q16[k]) * (uint64_t)(gloss * 257u) * shine[k];
        v[k] = sum < ONE ? sum : ONE;
    }
    const uint64_t grey = (54 * v[0] + 183 * v[1] + 19 * v[2]) >> 8;
    switch ((enum glint_format)s->format) {
    case GLINT_RGB565:
    case GLINT_RGB565_SWAPPED: {
        const uint32_t rgb =
            level(s, v[0], 31, weight) << 11 | level(s, v[1], 63, weight) << 5 | level(s, v[2], 31, weight);
        const bool swapped = s->format == GLINT_RGB565_SWAPPED;
        line[2 * x + swapped] = (uint8_t)rgb;
        line[2 * x + !swapped] = (uint8_t)(rgb >> 8);
        break;
    }
    case GLINT_RGB888:
        for (uint32_t k = 0; k < 3; k++)
            line[3 * x + k] = (uint8_t)level(s, v[k], 255, weight);
        break;
    case GLINT_BGR888:
        for (uint32_t k = 0; k < 3; k++)
            line[3 * x + 2 - k] = (uint8_t)level(s, v[k], 255, weight);
        break;
    case GLINT_XRGB8888:
    case GLINT_ARGB8888:
        for (uint32_t k = 0; k < 3; k++)
            line[4 * x + 2 - k] = (uint8_t)level(s, v[k], 255, weight);
        line[4 * x + 3] = s->format == GLINT_ARGB8888 ? mask : 255;
        break;
    case GLINT_GREY8:
        line[x] = (uint8_t)level(s, grey, 255, weight);
        break;
    case GLINT_MONO: {
        const uint8_t bit = (uint8_t)(0x80 >> (x & 7));
        line[x >> 3] = (uint8_t)(level(s, grey, 1, weight) ? line[x >> 3] | bit : line[x >> 3] & ~bit);
    }
    }
    return shines;
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

const struct glint_vec *reference_at(const struct reference_rect *rect, uint32_t x, uint32_t y)
{
    const struct glint_source *source = rect->source;
    const uint8_t *normals = row((const uint8_t *)source->normals, source->normals_stride, y);
    const uint8_t *mask = row(source->mask, source->mask_stride, y);
    return mask && !mask[x] ? NULL : (const struct glint_vec *)(const void *)normals + x;
}

uint32_t reference_nl(struct glint_vec n, const struct glint_light *light)
{
    return nl_of(dot(n, light->l));
}

uint32_t reference_f(const struct glint_shader *s, struct glint_vec n, const struct glint_light *light)
{
    return lobe(s, s->lobe.model == GLINT_PHONG ? mirror_t(n, light) : half_t(n, light->h), reference_nl(n, light));
}

void reference_put(struct reference_rect *rect, uint32_t x, uint32_t y, const uint64_t lit[3], const uint64_t shine[3])
{
    const struct glint_source *source = rect->source;
    const struct glint_surface *surface = rect->surface;
    const uint8_t *albedo = row(source->albedo, source->albedo_stride, y);
    const uint8_t *gloss = row(source->gloss, source->gloss_stride, y);
    const uint8_t *mask = row(source->mask, source->mask_stride, y);
    uint8_t *line = (uint8_t *)surface->pixels + surface->stride * (ptrdiff_t)y;
    if (pixel(rect->shader, line, x, surface->x, surface->y + y, lit, shine,
              albedo ? albedo + 3 * x : rect->shader->material.albedo, gloss ? gloss[x] : 255, mask ? mask[x] : 255))
        add(&rect->box, &rect->right, x, y);
}

void reference_rect(const struct glint_shader *s, const struct glint_source *source, uint16_t w, uint16_t h,
                    const struct glint_surface *surface, struct glint_box *highlight)
{
    struct reference_rect rect = {s, source, surface, {0, 0, 0, 0}, 0};
    for (uint32_t y = 0; y < h; y++)
        for (uint32_t x = 0; x < w; x++) {
            const struct glint_vec *n = reference_at(&rect, x, y);
            if (!n)
                continue;
            const uint64_t nl = reference_nl(*n, &s->light), f = reference_f(s, *n, &s->light);
            reference_put(&rect, x, y, (const uint64_t[3]){nl, nl, nl}, (const uint64_t[3]){f, f, f});
        }
    if (highlight)
        *highlight = rect.box;
}

void reference_span(const struct glint_shader *s, const struct glint_span *span, const struct glint_surface *surface,
                    struct glint_box *highlight)
{
    struct glint_box box = {0, 0, 0, 0};
    uint32_t right = 0, t = span->t_q30, dt = span->dt_q30, nl = (uint32_t)span->nl_q30;
    for (uint32_t x = 0; x < span->w; x++) {
        const uint64_t lit = nl_of((int32_t)nl), f = lobe(s, t >= UINT32_C(0xf8000000) ? 0 : t, (uint32_t)lit);
        if (pixel(s, (uint8_t *)surface->pixels, x, surface->x, surface->y, (const uint64_t[3]){lit, lit, lit},
                  (const uint64_t[3]){f, f, f}, s->material.albedo, 255, 255))
            add(&box, &right, x, 0);
        t += dt;
        dt += span->ddt_q30;
        nl += (uint32_t)span->dnl_q30;
    }
    if (highlight)
        *highlight = box;
}
