/* SPDX-License-Identifier: MIT
 * Internal. Integers of 192 bits, for decisions that must be exact. */
#ifndef GLINT_MATH_WIDE_H
#define GLINT_MATH_WIDE_H

#include <stdbool.h>
#include <stdint.h>

struct glint_wide {
    uint32_t limb[6]; /* least significant first */
};
void glint_wide_set(struct glint_wide *a, uint64_t value);
void glint_wide_mul(struct glint_wide *a, uint64_t factor); /* modulo 2^192 */
bool glint_wide_ge(const struct glint_wide *a, const struct glint_wide *b);

#endif
