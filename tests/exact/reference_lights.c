/* SPDX-License-Identifier: MIT
 * Several lights as sequence.md has them, in 64 bits, a pixel after the other. */
#include "reference_lights.h"

#include "reference_pixel.h"

static int64_t root_of(uint64_t x)
{
    uint64_t root = 0;
    for (uint64_t bit = UINT64_C(1) << 31; bit; bit >>= 1)
        if ((root + bit) * (root + bit) <= x)
            root += bit;
    return (int64_t)root;
}

bool reference_unit(int64_t out[3], const int64_t v[3])
{
    int64_t size[3], largest = 0;
    uint64_t sum = 0;
    for (int i = 0; i < 3; i++) {
        size[i] = v[i] < 0 ? -v[i] : v[i];
        largest = size[i] > largest ? size[i] : largest;
    }
    if (largest == 0)
        return false;
    unsigned up = 0, down = 0;
    while (largest << up < 1 << 29)
        up++;
    while (largest >> down >= 1 << 30)
        down++;
    for (int i = 0; i < 3; i++) {
        size[i] = size[i] << up >> down;
        sum += (uint64_t)(size[i] * size[i]);
    }
    const int64_t length = root_of(sum);
    for (int i = 0; i < 3; i++) {
        const int64_t part = (size[i] * (INT64_C(1) << 30) + length / 2) / length;
        out[i] = v[i] < 0 ? -part : part;
    }
    return true;
}

static int16_t q15(int64_t x)
{
    const int64_t rounded = (x + (1 << 14)) >> 15;
    return (int16_t)(rounded > 32767 ? 32767 : rounded);
}

static struct glint_vec vec(const int64_t v[3])
{
    const struct glint_vec to = {q15(v[0]), q15(v[1]), q15(v[2])};
    return to;
}

/* Steps 1a and 1b. */
static uint64_t reach(const struct glint_lamp *lamp, int64_t x, int64_t y, const int64_t v[3],
                      struct glint_light *light)
{
    const int64_t e[3] = {lamp->position[0] - 16 * x - 8, 16 * y + 8 - lamp->position[1], lamp->position[2]};
    const uint64_t d2 = (uint64_t)(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]), r2 = (uint64_t)lamp->range * lamp->range;
    int64_t l[3], h[3], half[3];
    if (d2 >= r2 || !reference_unit(l, e))
        return 0;
    const uint64_t u = (65536 * d2 + r2 / 2) / r2;
    uint64_t att = ((65536 - u) * (65536 - u) + 32768) >> 16;
    if (lamp->kind == GLINT_SPOT) {
        int64_t c = 1 << 29, inner = lamp->cos_inner_q30, outer = lamp->cos_outer_q30;
        for (int i = 0; i < 3; i++)
            c -= l[i] * lamp->axis_q30[i];
        c >>= 30;
        const uint64_t p = c >= inner ? 65536 : c <= outer ? 0 : (uint64_t)((c - outer) * 65536 / (inner - outer));
        att = (att * (p * p * (196608 - 2 * p) >> 32) + 32768) >> 16;
    }
    bool behind = true;
    for (int i = 0; i < 3; i++) {
        behind = behind && l[i] + v[i] <= 8 && l[i] + v[i] >= -8;
        half[i] = (l[i] + v[i]) >> 1;
    }
    if (att == 0 || behind || !reference_unit(h, half))
        return 0;
    light->l = vec(l);
    light->v = vec(v);
    light->h = vec(h);
    return att;
}

void reference_lights(const struct glint_shader *s, const struct glint_lamp *lamps, unsigned count,
                      const struct glint_source *source, uint16_t w, uint16_t h, const struct glint_surface *surface,
                      struct glint_box *highlight)
{
    const int64_t viewer[3] = {s->light.v.x, s->light.v.y, s->light.v.z};
    int64_t v[3] = {0, 0, 0};
    (void)reference_unit(v, viewer);
    struct reference_rect rect = {s, source, surface, {0, 0, 0, 0}, 0};
    for (uint32_t y = 0; y < h; y++)
        for (uint32_t x = 0; x < w; x++) {
            const struct glint_vec *normal = reference_at(&rect, x, y);
            uint64_t lit[3] = {0, 0, 0}, shine[3] = {0, 0, 0};
            if (!normal)
                continue;
            for (unsigned i = 0; i < count; i++) {
                struct glint_light light = lamps[i].light;
                const uint64_t att = lamps[i].kind == GLINT_DIRECTIONAL
                                         ? 65536
                                         : reach(&lamps[i], surface->x + x, surface->y + y, v, &light);
                const uint64_t nl = att ? reference_nl(*normal, &light) : 0;
                const uint64_t f = nl ? reference_f(s, *normal, &light) : 0;
                for (int k = 0; k < 3; k++) {
                    const uint64_t color = lamps[i].color_q16[k] < 1 << 20 ? lamps[i].color_q16[k] : 1 << 20;
                    lit[k] += (color * att * nl + (UINT64_C(1) << 31)) >> 32;
                    shine[k] += (color * att * f + (UINT64_C(1) << 31)) >> 32;
                }
            }
            reference_put(&rect, x, y, lit, shine);
        }
    if (highlight)
        *highlight = rect.box;
}
