/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PALETTE_H
#define GLINT_PALETTE_H

#include <stddef.h>
#include <stdint.h>

#include "glint.h"

/* The first entry of a palette stands for no surface, and its offsets count two bytes an entry. */
enum { PALETTE_MIN = 2, PALETTE_MAX = 32767, PALETTE_DEFAULT = 4096 };

/* At most `entries` normals, chosen for `count` given ones so that the largest error of a highlight is small; places[i]
 * becomes the entry for given[i]. Returns how many there are: no more than there are different ones given. */
uint32_t palette_choose(const struct glint_vec *given, size_t count, uint32_t entries, struct glint_vec *palette,
                        uint16_t *places);

#endif
