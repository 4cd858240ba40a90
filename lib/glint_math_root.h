/* SPDX-License-Identifier: MIT
 * Internal. */
#ifndef GLINT_MATH_ROOT_H
#define GLINT_MATH_ROOT_H

#include <stdint.h>

/* The square root of x < 2^62, rounded down. */
uint32_t glint_root(uint64_t x);

#endif
