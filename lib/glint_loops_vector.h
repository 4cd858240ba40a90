/* SPDX-License-Identifier: MIT
 * Internal. t and nl of a normal, modulo 2^32: right for unit normals (t <= 2, |nl| < 1 + 2^-14), harmless for others. */
#ifndef GLINT_LOOPS_VECTOR_H
#define GLINT_LOOPS_VECTOR_H

#include "glint.h"

static inline uint32_t glint_fast_t(const struct glint_vec *n, const struct glint_vec *h)
{
    const uint32_t x = (uint32_t)((int32_t)n->x - h->x), y = (uint32_t)((int32_t)n->y - h->y),
                   z = (uint32_t)((int32_t)n->z - h->z);
    return (x * x + y * y + z * z) >> 1;
}
static inline int32_t glint_fast_nl(const struct glint_vec *n, const struct glint_vec *l)
{
    return (int32_t)((uint32_t)(n->x * (int32_t)l->x) + (uint32_t)(n->y * (int32_t)l->y) +
                     (uint32_t)(n->z * (int32_t)l->z));
}

#endif
