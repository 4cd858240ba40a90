/* SPDX-License-Identifier: MIT
 * The exact rectangle path under several lights. */
#include "glint_math_vector.h"
#include "glint_lamp.h"
#include "glint_pixel.h"
#include "glint_rect.h"

/* What a surface that scatters all, and one that mirrors all, would send, Q16.16, < 2^23. */
struct sums {
    uint32_t lit[3], shine[3];
};

static uint64_t color(const struct glint_lamp *lamp, int k)
{
    return lamp->color_q16[k] < GLINT_LAMP_COLOR_MAX ? lamp->color_q16[k] : GLINT_LAMP_COLOR_MAX;
}

/* What one lamp adds at pixel x, y of the screen. */
static void add_lamp(struct sums *sums, const struct glint_shader *shader, const struct glint_lamp *lamp,
                     const struct glint_reach *reach, int32_t x, int32_t y, const int32_t v_q30[3],
                     const struct glint_vec *normal)
{
    struct glint_light here;
    const struct glint_light *light = &lamp->light;
    uint32_t att = 65536;
    if (lamp->kind != GLINT_DIRECTIONAL) {
        (void)glint_vec_of_q30(&here.v, v_q30, 0);
        att = glint_reach_at(reach, lamp, x, y, v_q30, &here);
        if (att == 0)
            return;
        light = &here;
    }
    const uint32_t nl = glint_pixel_nl(glint_dot(normal, &light->l));
    if (nl == 0)
        return;
    const uint32_t f = glint_pixel_lobe(shader, glint_pixel_t(&shader->lobe, light, normal));
    for (int k = 0; k < 3; k++) {
        const uint64_t c = color(lamp, k) * att;
        sums->lit[k] += (uint32_t)((c * nl + ((uint64_t)1 << 31)) >> 32); /* c nl, c f < 2^53 */
        sums->shine[k] += (uint32_t)((c * f + ((uint64_t)1 << 31)) >> 32);
    }
}

/* Shades one pixel; true where the highlight and gloss are not 0. */
static bool pixel(const struct glint_shader *shader, const struct glint_surface *surface, uint16_t x, uint16_t y,
                  const struct sums *sums, const uint8_t albedo[3], uint8_t gloss)
{
    uint64_t v[3];
    for (int k = 0; k < 3; k++)
        v[k] = glint_pixel_value(shader, k, albedo[k], sums->lit[k], (uint64_t)(gloss * 257u) * sums->shine[k]);
    glint_pixel_put(shader, surface, x, y, v);
    return (sums->shine[0] | sums->shine[1] | sums->shine[2]) && gloss;
}

/* Is all in order? The viewer, for lamps that have a place, to v_q30. */
static enum glint_err check(const struct glint_shader *shader, const struct glint_lamp *lamps, unsigned count,
                            int32_t v_q30[3])
{
    const struct glint_vec v = shader->light.v;
    const int32_t viewer[3] = {v.x, v.y, v.z};
    const bool seen = glint_unit_q30(v_q30, viewer);
    if (count > GLINT_LAMPS_MAX || (count && !lamps))
        return GLINT_ERR_ARG;
    for (unsigned i = 0; i < count; i++) {
        const enum glint_err err = glint_lamp_check(&lamps[i]);
        if (err)
            return err;
        if (lamps[i].kind != GLINT_DIRECTIONAL && !seen)
            return GLINT_ERR_VECTOR;
    }
    return GLINT_OK;
}

enum glint_err glint_shade_lights(const struct glint_shader *shader, const struct glint_lamp *lamps, unsigned count,
                                  const struct glint_source *source, uint16_t w, uint16_t h,
                                  const struct glint_surface *surface, struct glint_box *highlight)
{
    int32_t v_q30[3];
    enum glint_err err = glint_rect_check(shader, source, surface);
    if (!err)
        err = check(shader, lamps, count, v_q30);
    if (err)
        return err;
    struct glint_reach reach[GLINT_LAMPS_MAX];
    for (unsigned i = 0; i < count; i++)
        glint_reach_init(&reach[i], &lamps[i]);
    struct glint_bounds bounds = {0, 0, 0, 0, false};
    for (uint16_t y = 0; y < h; y++) {
        const struct glint_line line = glint_line_at(source, y);
        for (uint16_t x = 0; x < w; x++) {
            if (line.mask && !line.mask[x])
                continue;
            struct sums sums = {{0, 0, 0}, {0, 0, 0}};
            for (unsigned i = 0; i < count; i++)
                add_lamp(&sums, shader, &lamps[i], &reach[i], (int32_t)surface->x + x, (int32_t)surface->y + y, v_q30,
                         &line.normals[x]);
            if (pixel(shader, surface, x, y, &sums,
                      line.albedo ? line.albedo + 3 * (ptrdiff_t)x : shader->material.albedo,
                      line.gloss ? line.gloss[x] : 255))
                glint_bounds_add(&bounds, x, y);
        }
    }
    glint_bounds_box(&bounds, highlight);
    return GLINT_OK;
}
