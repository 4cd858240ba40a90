/* SPDX-License-Identifier: MIT
 * Internal. Lines whose 2-byte pixels lie at odd addresses: loops draw into a piece on the stack, copied back and forth. */
#ifndef GLINT_LOOPS_PIECE_H
#define GLINT_LOOPS_PIECE_H

#include <stdint.h>

enum { GLINT_PIECE = 32 }; /* pixels: 64 bytes of stack */

/* How many of so many pixels are one piece. */
static inline uint16_t glint_piece(uint32_t left)
{
    const uint16_t piece = GLINT_PIECE;
    return left < piece ? (uint16_t)left : piece;
}

void glint_get_pixels(uint16_t *to, const uint8_t *from, uint16_t w);
void glint_put_pixels(uint8_t *to, const uint16_t *from, uint16_t w);

#endif
