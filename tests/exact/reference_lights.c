/* SPDX-License-Identifier: MIT
 * Lights as sequence.md has them, in 64 bits, a pixel after the other. */
#include "reference_lights.h"

#include <string.h>

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

enum reference_kind reference_kind(const struct glint_light *light)
{
    static const int32_t above[3] = {0, 0, 1};
    struct glint_light directional, point;
    (void)glint_light_directional(&directional, above);
    (void)glint_light_point(&point, above, 1);
    return light->kind == directional.kind ? REFERENCE_DIRECTIONAL
           : light->kind == point.kind     ? REFERENCE_POINT
                                           : REFERENCE_SPOT;
}

/* H, and L and V with it, of unit vectors; false where it does not exist. */
static bool directions(const int64_t l[3], const int64_t v[3], struct glint_vec lvh[3])
{
    int64_t half[3], h[3];
    bool behind = true;
    for (int i = 0; i < 3; i++) {
        behind = behind && l[i] + v[i] <= 8 && l[i] + v[i] >= -8;
        half[i] = (l[i] + v[i]) >> 1;
    }
    if (behind || !reference_unit(h, half))
        return false;
    lvh[0] = vec(l);
    lvh[1] = vec(v);
    lvh[2] = vec(h);
    return true;
}

static bool viewer(const struct reference *look, int64_t v[3])
{
    const int64_t wide[3] = {look->to_viewer[0], look->to_viewer[1], look->to_viewer[2]};
    return reference_unit(v, wide);
}

bool reference_directions(const struct reference *look, const struct glint_light *light, struct glint_vec lvh[3])
{
    const int64_t l[3] = {light->direction_q30[0], light->direction_q30[1], light->direction_q30[2]};
    int64_t v[3];
    return viewer(look, v) && directions(l, v, lvh);
}

enum glint_err reference_paint(struct glint_paint *paint, const struct reference *look)
{
    const enum glint_err err = glint_paint_exact(paint, &look->material, &look->output);
    return err ? err : glint_paint_light(paint, look->lights, look->count, look->to_viewer);
}

/* Steps 1a and 1b of a light that has a place. */
static uint64_t reach(const struct glint_light *light, enum reference_kind kind, int64_t x, int64_t y,
                      const int64_t v[3], struct glint_vec lvh[3])
{
    const int64_t e[3] = {light->position[0] - 16 * x - 8, 16 * y + 8 - light->position[1], light->position[2]};
    const uint64_t d2 = (uint64_t)(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
    const uint64_t r2 = (uint64_t)light->range * light->range;
    int64_t l[3];
    if (d2 >= r2 || !reference_unit(l, e))
        return 0;
    const uint64_t u = (65536 * d2 + r2 / 2) / r2;
    uint64_t att = ((65536 - u) * (65536 - u) + 32768) >> 16;
    if (kind == REFERENCE_SPOT) {
        int64_t c = 1 << 29, inner = light->cos_inner_q30, outer = light->cos_outer_q30;
        for (int i = 0; i < 3; i++)
            c -= l[i] * light->direction_q30[i];
        c >>= 30;
        const uint64_t p = c >= inner ? 65536 : c <= outer ? 0 : (uint64_t)((c - outer) * 65536 / (inner - outer));
        att = (att * (p * p * (196608 - 2 * p) >> 32) + 32768) >> 16;
    }
    return att && directions(l, v, lvh) ? att : 0;
}

/* What a light sends of nl and F. */
static void send(const struct glint_light *light, uint64_t att, uint64_t nl, uint64_t f, uint64_t lit[3],
                 uint64_t shine[3])
{
    for (int k = 0; k < 3; k++) {
        const uint64_t color = light->color_q16[k] < 1 << 20 ? light->color_q16[k] : 1 << 20;
        lit[k] += (color * att * nl + (UINT64_C(1) << 31)) >> 32;
        shine[k] += (color * att * f + (UINT64_C(1) << 31)) >> 32;
    }
}

void reference_rect(const struct reference *s, const struct glint_maps *maps, uint16_t w, uint16_t h,
                    const struct glint_surface *target, struct glint_box *highlight)
{
    struct glint_vec of[GLINT_LIGHTS_MAX][3];
    enum reference_kind kinds[GLINT_LIGHTS_MAX];
    int64_t q30[3] = {0, 0, 0}, v[3] = {0, 0, 0};
    (void)viewer(s, q30);
    const struct glint_vec v_q15 = vec(q30);
    const int64_t rounded[3] = {v_q15.x, v_q15.y, v_q15.z}; /* V is held in Q1.15 */
    (void)reference_unit(v, rounded);
    for (unsigned i = 0; i < s->count; i++) {
        kinds[i] = reference_kind(&s->lights[i]);
        (void)reference_directions(s, &s->lights[i], of[i]);
    }
    struct reference_lines lines = {
        s, maps, target, s->count == 1 && kinds[0] == REFERENCE_DIRECTIONAL, reference_t_last(s), {0, 0, 0, 0}, 0};
    for (uint32_t y = 0; y < h; y++)
        for (uint32_t x = 0; x < w; x++) {
            struct glint_vec normal;
            uint64_t lit[3] = {0, 0, 0}, shine[3] = {0, 0, 0}, any = 0;
            if (!reference_at(&lines, x, y, &normal))
                continue;
            for (unsigned i = 0; i < s->count; i++) {
                const uint64_t att = kinds[i] == REFERENCE_DIRECTIONAL
                                         ? 65536
                                         : reach(&s->lights[i], kinds[i], target->x + x, target->y + y, v, of[i]);
                const uint64_t nl = att ? reference_nl(normal, of[i]) : 0;
                const uint64_t f = nl ? reference_f(&lines, x, y, normal, of[i]) : 0;
                send(&s->lights[i], att, nl, f, lit, shine);
                any |= f;
            }
            reference_put(&lines, x, y, lit, shine, any);
        }
    if (highlight)
        *highlight = lines.box;
}

void reference_span(const struct reference *s, const struct glint_span *span, const struct glint_maps *maps,
                    const struct glint_surface *target, struct glint_box *highlight)
{
    struct reference_lines lines = {s, maps, target, true, reference_t_last(s), {0, 0, 0, 0}, 0};
    uint32_t t = span->t_q30, dt = span->dt_q30, nl = (uint32_t)span->nl_q30;
    struct glint_vec lvh[3];
    memset(lvh, 0, sizeof lvh);
    if (s->count)
        (void)reference_directions(s, &s->lights[0], lvh);
    for (uint32_t x = 0; x < span->w; x++) {
        const uint32_t nl_q16 = s->count ? reference_nl_of((int32_t)nl) : 0;
        const uint32_t used = t >= UINT32_C(0xf8000000) ? 0 : t;
        const uint32_t f = reference_is_grained(&lines) ? reference_span_f(&lines, span, x, used, nl_q16, lvh[2])
                                                        : reference_lobe(&lines, used, nl_q16);
        uint64_t lit[3] = {0, 0, 0}, shine[3] = {0, 0, 0};
        if (s->count)
            send(&s->lights[0], 65536, nl_q16, f, lit, shine);
        if (reference_is_covered(&lines, x, 0))
            reference_put(&lines, x, 0, lit, shine, f);
        t += dt;
        dt += span->ddt_q30;
        nl += (uint32_t)span->dnl_q30;
    }
    if (highlight)
        *highlight = lines.box;
}
