/* SPDX-License-Identifier: MIT
 * Internal. Gauss, quickly. */
#ifndef GLINT_LOBE_GAUSS_H
#define GLINT_LOBE_GAUSS_H

#include <stdint.h>

enum { GLINT_GAUSS_LOW = 7, GLINT_GAUSS_HIGH = 9 };

/* f with f - HIGH < 2^28 F < f + LOW for 0 < n <= 1000, 0 < t < 1; or 0 where 2^28 F < 31.
 *
 * F = 2^-X, X = n t b. Errors, each in units of its value's last place, and what they make of 2^28 F, L = -ln F:
 *   b       2^-28 (-15 .. 13.5) of it: of X as much  high < 15 F L, low < 13.5 F L
 *   n t     Q28, low by <= 3/4: of X by < 0.67       high < 0.93 F
 *   X       Q27, low by < 3                          high < 4.16 F
 *   2^-x    2^-32 (-34 .. 24) of it                  high < 1.5 F, low < 2.13 F
 *   shifts  low by < 1                               low < 1
 * High: F (15 L + 6.6) <= 8.6, where L = 0.56. Low: F (13.5 L + 2.13) + 1 <= 6.9, where L = 0.84. Proved: tests/proof. */
uint32_t glint_gauss_near_t(uint32_t n, uint32_t t_q30);

#endif
