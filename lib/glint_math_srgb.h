/* SPDX-License-Identifier: MIT
 * Internal. The sRGB encoding in pieces: chords of one width from an entry of a table to the next. */
#ifndef GLINT_MATH_SRGB_H
#define GLINT_MATH_SRGB_H

#include "glint.h"
#include "glint_math_flash.h"

/* The 32 chords of an octave: v with 32 <= v >> bits < 64 lies beyond entry[(v >> bits) - 32]. */
struct glint_chords {
    const uint16_t *entry;
    uint32_t bits;
};

/* Those of v; below 128, where there is none, the first. */
void glint_srgb_chords(struct glint_chords *chords, uint32_t v);

/* Below 128 the curve is a line of slope 12.92. */
static inline uint32_t glint_srgb_dark(uint32_t v)
{
    return (v * 3308 + 128) >> 8;
}

/* On the chord from an entry to the next: (rise rest + 2^(bits - 1)) >> bits above the entry, rise rest < 2^19. */
static inline uint32_t glint_srgb_bright(const uint16_t entry[2], uint32_t rest, uint32_t bits)
{
    const uint32_t start = GLINT_FLASH_U16(entry[0]), rise = GLINT_FLASH_U16(entry[1]) - start;
    return start + (((rise * rest * 2 >> bits) + 1) >> 1);
}

/* The encoding of v, < 2^16, by its chords. */
static inline uint32_t glint_srgb_by(const struct glint_chords *chords, uint32_t v)
{
    if (v < 128)
        return glint_srgb_dark(v);
    const uint32_t chord = v >> chords->bits;
    return glint_srgb_bright(chords->entry + chord - 32, v - (chord << chords->bits), chords->bits);
}

#endif
