/* SPDX-License-Identifier: MIT
 * The exact rectangle path. */
#include "pixel.h"

/* Step 1, Blinn: t = |N - H|^2 / 2. Unlike 1 - N.H it loses nothing near the peak. */
static uint32_t blinn_t(const struct glint_vec *n, const struct glint_vec *h)
{
    const uint64_t sum = glint_distance_squared(n, h);
    return sum >> 32 ? (uint32_t)1 << 31 : (uint32_t)(sum >> 1);
}

/* One component of L + V - 2(N.L)N = V - R in Q24. |p| <= 3 * 2^30, so |2pN| < 2^48. */
static int64_t off_mirror(int16_t l, int16_t v, int64_t p, int16_t n)
{
    return (((int64_t)l + v) * ((int64_t)1 << 30) - 2 * p * n + INT64_C(1048576)) >> 21;
}

/* Step 1, Phong: t = |V - R|^2 / 2, R = 2(N.L)N - L. */
static uint32_t phong_t(const struct glint_vec *n, const struct glint_light *light)
{
    const int64_t p = glint_dot(n, &light->l);
    const int64_t x = off_mirror(light->l.x, light->v.x, p, n->x), y = off_mirror(light->l.y, light->v.y, p, n->y);
    const int64_t z = off_mirror(light->l.z, light->v.z, p, n->z);
    const uint64_t sum = (uint64_t)(x * x) + (uint64_t)(y * y) + (uint64_t)(z * z); /* < 2^58 */
    return sum >> 50 ? (uint32_t)1 << 31 : (uint32_t)(sum >> 19);
}

/* What int16_t wants: 2, but 1 on 8-bit machines, whose compilers place normals anywhere. */
struct aligned {
    char before;
    int16_t component;
};

static bool misaligned(uintptr_t address_or_stride)
{
    return address_or_stride % offsetof(struct aligned, component) != 0;
}

static const uint8_t *line_of(const uint8_t *map, ptrdiff_t stride, uint16_t y)
{
    return map ? map + stride * (ptrdiff_t)y : NULL;
}

/* The smallest box that holds what has been added. */
struct bounds {
    uint16_t left, right, top, bottom;
    bool any;
};

static void bounds_add(struct bounds *b, uint16_t x, uint16_t y)
{
    if (!b->any) {
        b->left = b->right = x;
        b->top = y;
        b->any = true;
    }
    b->left = x < b->left ? x : b->left;
    b->right = x > b->right ? x : b->right;
    b->bottom = y;
}

enum glint_err glint_shade_rect(const struct glint_shader *shader, const struct glint_source *source, uint16_t w,
                                uint16_t h, const struct glint_surface *surface, struct glint_box *highlight)
{
    if (!shader || !source || !surface || !source->normals || !surface->pixels ||
        misaligned((uintptr_t)source->normals) || misaligned((uintptr_t)source->normals_stride))
        return GLINT_ERR_ARG;
    const enum glint_err err = glint_pixel_check(shader);
    if (err)
        return err;

    const bool phong = shader->lobe.model == GLINT_PHONG;
    struct bounds bounds = {0, 0, 0, 0, false};
    for (uint16_t y = 0; y < h; y++) {
        const uint8_t *normals = line_of((const uint8_t *)source->normals, source->normals_stride, y);
        const struct glint_vec *normal = (const struct glint_vec *)(const void *)normals;
        const uint8_t *albedo = line_of(source->albedo, source->albedo_stride, y);
        const uint8_t *gloss = line_of(source->gloss, source->gloss_stride, y);
        const uint8_t *mask = line_of(source->mask, source->mask_stride, y);
        for (uint16_t x = 0; x < w; x++) {
            if (mask && !mask[x])
                continue;
            const uint32_t t = phong ? phong_t(&normal[x], &shader->light) : blinn_t(&normal[x], &shader->light.h);
            if (glint_pixel(shader, surface, x, y, t, glint_dot(&normal[x], &shader->light.l),
                            albedo ? albedo + 3 * (ptrdiff_t)x : shader->material.albedo, gloss ? gloss[x] : 255))
                bounds_add(&bounds, x, y);
        }
    }
    if (highlight) {
        const struct glint_box none = {0, 0, 0, 0};
        *highlight = none;
        if (bounds.any) {
            highlight->x = bounds.left;
            highlight->y = bounds.top;
            highlight->w = (uint16_t)(bounds.right - bounds.left + 1);
            highlight->h = (uint16_t)(bounds.bottom - bounds.top + 1);
        }
    }
    return GLINT_OK;
}
