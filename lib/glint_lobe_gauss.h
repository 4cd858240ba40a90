/* SPDX-License-Identifier: MIT
 * Internal. Gauss, quickly. */
#ifndef GLINT_LOBE_GAUSS_H
#define GLINT_LOBE_GAUSS_H

#include <stdint.h>

enum { GLINT_GAUSS_LOW = 8, GLINT_GAUSS_HIGH = 12 };

/* f with f - HIGH < 2^28 F < f + LOW for 0 < n <= 1000, 0 < t < 1; or 0 where 2^28 F < 31.
 *
 * F = 2^-X, X = n t b. Errors, each in units of its value's last place, and what they make of 2^28 F (X 2^-X ln 2 < 0.368):
 *   b       2^-28 (-14 .. 13) of it: of X as much    high < 0.368 * 14, low < 0.368 * 13
 *   n t     Q28, low by < 1: of X by < 0.89          high < 1.24
 *   X       Q27, low by < 3                          high < 4.16
 *   2^-x    2^-32 (-32 .. 20)                        high < 1.25, low < 2
 *   shifts  low by < 1                               low < 1 */
uint32_t glint_gauss_near_t(uint32_t n, uint32_t t_q30);

#endif
