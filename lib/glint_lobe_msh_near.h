/* SPDX-License-Identifier: MIT
 * Internal. What MSH from below shares with its assembly. Macros only: assembly includes it. */
#ifndef GLINT_LOBE_MSH_NEAR_H
#define GLINT_LOBE_MSH_NEAR_H

/* Of glint_near's k. */
#define GLINT_MSH_FACTOR 0
#define GLINT_MSH_ADDEND 1
#define GLINT_MSH_SHIFT 2

/* The quotient is high by at most 2400, and by 26 for each unit that m is low: < 2^8, as E >= 2^18.3 is doubled 9 times
 * at most, and once before the cut. (n = 1: E >= 2^18 > E / 2: once after.) It is low by at most 2400 + 101 (u): together less than
 * 2^14, the smallest step of F, so F is this or 1 more. */
#define GLINT_MSH_HIGH (2400 + 26 * 256)

#endif
