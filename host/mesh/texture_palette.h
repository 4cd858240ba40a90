/* SPDX-License-Identifier: MIT
 * A texture's colours into a palette. */
#ifndef GLINT_MESH_TEXTURE_PALETTE_H
#define GLINT_MESH_TEXTURE_PALETTE_H

#include <stddef.h>
#include <stdint.h>

enum { TEXTURE_COLORS = 256 };

/* Colours of RGB565 into at most TEXTURE_COLORS; returns how many. As many or fewer stay as they are. */
unsigned texture_palette(const uint16_t *pixels, size_t count, uint16_t *palette, uint8_t *indices);

#endif
