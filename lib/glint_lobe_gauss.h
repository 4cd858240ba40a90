/* SPDX-License-Identifier: MIT
 * Internal. Gauss, quickly. */
#ifndef GLINT_LOBE_GAUSS_H
#define GLINT_LOBE_GAUSS_H

#include <stdint.h>

enum { GLINT_GAUSS_LOW = 7, GLINT_GAUSS_HIGH = 9 };

/* f with f - HIGH < 2^28 F < f + LOW for 0 < n <= 1000, 0 < t < 1; or 0 where 2^28 F < 31.
 *
 * F = 2^-X, X = n t b. Errors, each in units of its value's last place, and what they make of 2^28 F, L = -ln F:
 *   b       2^-28 (-14 .. 13) of it: of X as much    high < 14 F L, low < 13 F L
 *   n t     Q28, low by < 1: of X by < 0.89          high < 1.24 F
 *   X       Q27, low by < 3                          high < 4.16 F
 *   2^-x    2^-32 (-32 .. 20) before the shift       high < 1.25 F, low < 2 F
 *   shifts  low by < 1                               low < 1
 * High: F (14 L + 6.65) <= 8.3, where L = 0.53. Low: F (13 L + 2) + 1 <= 6.6, where L = 0.85. */
uint32_t glint_gauss_near_t(uint32_t n, uint32_t t_q30);

#endif
