/* SPDX-License-Identifier: MIT
 * The pixel's sequence (glint.h), as far as rectangles and spans share it; not for users. */
#ifndef GLINT_PIXEL_H
#define GLINT_PIXEL_H

#include "glint.h"

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

/* Can this shader draw? GLINT_OK or GLINT_ERR_FORMAT. */
enum glint_err glint_pixel_check(const struct glint_shader *shader);

/* Steps 2 to 8: shades and stores pixel x of the surface's line y. True where F > 0 and gloss > 0. */
bool glint_pixel(const struct glint_shader *shader, const struct glint_surface *surface, uint16_t x, uint16_t y,
                 uint32_t t_q30, int64_t nl_q30, const uint8_t albedo[3], uint8_t gloss);

#endif
