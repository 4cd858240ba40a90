/* SPDX-License-Identifier: MIT
 * Internal. */
#ifndef GLINT_LOBE_LARGEST_T_H
#define GLINT_LOBE_LARGEST_T_H

#include <stdbool.h>
#include <stdint.h>

/* The largest t in 0..2^30 for which reaches() holds; it holds at 0 and stops holding once. n and q are clamped first. */
uint32_t glint_largest_t(bool (*reaches)(uint32_t n, uint32_t t_q30, unsigned q), uint32_t n, unsigned q);

#endif
