/* SPDX-License-Identifier: MIT
 * The pixel's sequence (sequence.md), as far as the paths share it; internal. */
#ifndef GLINT_PIXEL_H
#define GLINT_PIXEL_H

#include "glint_pixel_exact.h"

/* a.b in Q2.30; in magnitude at most 3 * 2^30. */
static inline int64_t glint_dot(const struct glint_vec *a, const struct glint_vec *b)
{
    return (int64_t)((int32_t)a->x * b->x) + (int32_t)a->y * b->y + (int32_t)a->z * b->z;
}

/* |a - b|^2 in Q2.30, < 2^34. */
static inline uint64_t glint_distance_squared(const struct glint_vec *a, const struct glint_vec *b)
{
    const int64_t x = a->x - (int32_t)b->x, y = a->y - (int32_t)b->y, z = a->z - (int32_t)b->z;
    return (uint64_t)(x * x + y * y + z * z);
}

/* Step 6, of 256: Rec. 709. */
enum { GLINT_LUMA_RED = 54, GLINT_LUMA_GREEN = 183, GLINT_LUMA_BLUE = 19 };

/* A span's t this large stands for one a little below 0, where rounding has led: 0 is meant. */
#define GLINT_NEGATIVE_T UINT32_C(0xf8000000)

/* Can this shader draw? GLINT_OK or GLINT_ERR_FORMAT. */
enum glint_err glint_pixel_check(const struct glint_shader *shader);

/* Step 1 in Phong's geometry. */
uint32_t glint_phong_t(const struct glint_vec *normal, const struct glint_light *light);

/* Step 3's last words. */
static inline uint32_t glint_pixel_peak(const struct glint_shader *shader, uint32_t f)
{
    return shader->clamp_peak && f > 65536 ? 65536 : f;
}

/* Steps 7 and 8 of channel k. */
uint8_t glint_pixel_level(const struct glint_shader *shader, uint64_t x, int k, uint32_t weight);

/* Its parts, from which tables are filled and lights summed. Steps 2, 3, 4 and 5 (nl < 2^23, shine = g F < 2^39: what
 * several lights may sum to), 6 to 8, and 4 to 8. */
uint32_t glint_pixel_nl(int64_t nl_q30);
uint32_t glint_pixel_lobe(const struct glint_shader *shader, uint32_t t_q30);
uint64_t glint_pixel_value(const struct glint_shader *shader, int k, uint8_t albedo, uint32_t nl_q16, uint64_t shine);
void glint_pixel_put(const struct glint_shader *shader, const struct glint_surface *surface, uint16_t x, uint16_t y,
                     const uint64_t v[3]);
void glint_pixel_store(const struct glint_shader *shader, const struct glint_surface *surface, uint16_t x, uint16_t y,
                       uint32_t nl_q16, uint32_t f, const uint8_t albedo[3], uint8_t gloss);

#endif
