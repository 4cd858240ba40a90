/* SPDX-License-Identifier: MIT */
#include "glint_pixel.h"
#include "glint_pixel_exact.h"

enum glint_err glint_pixel_check(const struct glint_shader *shader)
{
    return shader->format < GLINT_FORMAT_COUNT && shader->space <= GLINT_LINEAR ? GLINT_OK : GLINT_ERR_FORMAT;
}

/* One component of L + V - 2(N.L)N = V - R in Q24. |p| <= 3 * 2^30, so |2pN| < 2^48. */
static int64_t off_mirror(int16_t l, int16_t v, int64_t p, int16_t n)
{
    return (((int64_t)l + v) * ((int64_t)1 << 30) - 2 * p * n + INT64_C(1048576)) >> 21;
}

/* Step 1, Phong: t = |V - R|^2 / 2, R = 2(N.L)N - L. */
uint32_t glint_phong_t(const struct glint_vec *n, const struct glint_light *light)
{
    const int64_t p = glint_dot(n, &light->l);
    const int64_t x = off_mirror(light->l.x, light->v.x, p, n->x), y = off_mirror(light->l.y, light->v.y, p, n->y);
    const int64_t z = off_mirror(light->l.z, light->v.z, p, n->z);
    const uint64_t sum = (uint64_t)(x * x) + (uint64_t)(y * y) + (uint64_t)(z * z); /* < 2^58 */
    return sum >> 50 ? (uint32_t)1 << 31 : (uint32_t)(sum >> 19);
}

uint64_t glint_pixel_value(const struct glint_shader *shader, int k, uint8_t albedo, uint32_t nl_q16, uint64_t shine)
{
    const uint32_t a = shader->space == GLINT_LINEAR ? glint_srgb_decode(albedo) : albedo * 257u;
    return glint_exact_value(&shader->material, k, a, nl_q16, shine);
}

uint8_t glint_pixel_level(const struct glint_shader *shader, uint64_t x, int k, uint32_t weight)
{
    const uint32_t max = GLINT_FLASH_U8(glint_exact_formats[shader->format].max[k]);
    if (shader->space == GLINT_LINEAR)
        x = (uint64_t)glint_srgb_encode((uint16_t)((x + ((uint64_t)1 << 31)) >> 32)) << 32;
    return (uint8_t)glint_exact_level(x, max, weight);
}

uint32_t glint_pixel_nl(int64_t nl_q30)
{
    const int64_t nl = (nl_q30 + (1 << 13)) >> 14;
    return nl < 0 ? 0 : nl > 65536 ? 65536 : (uint32_t)nl;
}

uint32_t glint_pixel_lobe(const struct glint_shader *shader, uint32_t t_q30)
{
    return glint_pixel_peak(shader, glint_lobe_eval_t(&shader->lobe, t_q30));
}

void glint_pixel_put(const struct glint_shader *shader, const struct glint_surface *surface, uint16_t x, uint16_t y,
                     const uint64_t v[3])
{
    const uint32_t weight = glint_exact_weight(shader, surface->x + (uint32_t)x, surface->y + (uint32_t)y);
    const bool grey = glint_format_is_grey(shader->format);
    uint8_t levels[4];
    for (int k = 0; k < 3; k++) {
        const uint64_t value =
            grey ? (GLINT_LUMA_RED * v[0] + GLINT_LUMA_GREEN * v[1] + GLINT_LUMA_BLUE * v[2]) >> 8 : v[k];
        levels[k] = glint_pixel_level(shader, value, k, weight);
    }
    uint8_t *line = (uint8_t *)surface->pixels + surface->stride * (ptrdiff_t)y;
    glint_exact_store(shader->format, line, x, levels);
    glint_exact_alpha(shader->format, line, x, 1, NULL);
}

void glint_pixel_store(const struct glint_shader *shader, const struct glint_surface *surface, uint16_t x, uint16_t y,
                       uint32_t nl_q16, uint32_t f, const uint8_t albedo[3], uint8_t gloss)
{
    const uint64_t shine = (uint64_t)(gloss * 257u) * f;
    uint64_t v[3];
    for (int k = 0; k < 3; k++)
        v[k] = glint_pixel_value(shader, k, albedo[k], nl_q16, shine);
    glint_pixel_put(shader, surface, x, y, v);
}
