/* SPDX-License-Identifier: MIT
 * Internal. Numbers: products of 32 x 32 bits from products of 32 bits, as small cores have no others; a reciprocal without a division;
 * root, power, and the sRGB encoding. */
#ifndef GLINT_MATH_H
#define GLINT_MATH_H

#include "glint.h"
#include "glint_port.h"

/* ---- products ---- */

/* a b / 2^32, low by less than 3: each shift cuts less than 1, and the product of the lower halves is left out. */
static inline uint32_t glint_mulhi_near(uint32_t a, uint32_t b)
{
    const uint32_t a1 = a >> 16, a0 = a & 0xffff, b1 = b >> 16, b0 = b & 0xffff;
    return a1 * b1 + (a1 * b0 >> 16) + (a0 * b1 >> 16);
}

/* a a / 2^32, low by less than 2. */
static inline uint32_t glint_squarehi_near(uint32_t a)
{
    const uint32_t a1 = a >> 16;
    return a1 * a1 + (a1 * (a & 0xffff) >> 15);
}

/* All 64 bits. Each partial sum is at most (2^16 - 1)^2 + 2^16 - 1 < 2^32. */
static inline uint64_t glint_multiply(uint32_t a, uint32_t b)
{
    const uint32_t a1 = a >> 16, a0 = a & 0xffff, b1 = b >> 16, b0 = b & 0xffff;
    const uint32_t middle = a1 * b0 + (a0 * b0 >> 16);
    const uint32_t other = a0 * b1 + (middle & 0xffff);
    return (uint64_t)(a1 * b1 + (middle >> 16) + (other >> 16)) << 32 | a * b;
}

/* ---- 1 / m ---- */

/* y, nearly 2^35 / m, for 2^27 <= m < 2^28 by m's upper bits: |y m / 2^35 - 1| < 0.00904. */
extern const uint8_t glint_reciprocals[64]; /* GLINT_FLASH */

/* Y = 2^58 / m (1 + d) for a number m whose floor is given, 2^27 <= m < 2^28; -2^-30 16.1 < d < 2^-30 16.4, and <= 2^31 + 15.
 * With y m = 2^35 (1 + e), |e| < 2^-6.78: 2^35 / m = y (1 - e + e^2 - e^3 + ..); e^4, the first term left out, makes d
 * lower by up to 2^-30 7.2, and the fraction that m lacks makes it higher by up to 2^-30 8. */
static inline uint32_t glint_reciprocal(uint32_t m)
{
    const uint32_t y = GLINT_FLASH_U8(glint_reciprocals[(m >> 21) - 64]);
    const int32_t e = (int32_t)(m * y);                               /* Q35: 2^35 is 0 modulo 2^32 */
    const int32_t r = e >> 14, rr = r * r;                            /* Q21, |r| < 18960; Q42 */
    const int32_t c = (rr >> 13) - (e >> 6) - ((rr >> 14) * r >> 20); /* Q29, |c| < 0.0092: y c < 2^31 */
    return (y << 23) + (uint32_t)((int32_t)y * c >> 6);
}

/* ---- roots and powers ---- */

/* The square root of x < 2^62, rounded down. */
uint32_t glint_root(uint64_t x);

/* x^n in Q0.64, x < 1: in (x^n - n 2^-64, x^n]; monotone in x; the exact floor for n <= 4 where x has 30 bits. */
uint64_t glint_power(uint64_t x, uint32_t n);

/* f with f <= 2^-32 glint_power(2^32 x, n) <= f + GLINT_POWER_LOW(n), and the same of 2^32 (2^-32 x)^n. */
uint32_t glint_power_near(uint32_t x, uint32_t n);
#define GLINT_POWER_LOW(n) (3 * (n)-2)

static inline uint32_t glint_power_round(uint64_t power)
{
    return (uint32_t)(((power >> 47) + 1) >> 1); /* Q0.64 -> Q16.16, nearest, ties up */
}

/* p^n in Q0.64 of a polynomial p, 0 <= p < 1, of 0 < t <= 1: coefficients in Q1.62, the constant first. */
enum { GLINT_SERIES_DEGREE = 20 };
uint64_t glint_series_power(const int64_t coefficient[GLINT_SERIES_DEGREE + 1], uint32_t n, uint32_t t_q30);

extern const uint32_t glint_exp2_fractions[32]; /* GLINT_FLASH */

/* 2^-(x / 2^27) in Q32 for x < 2^27, off by -32 .. 20: e^-z by three terms, z < 0.0217, and the third a little smaller, for
 * the fourth. Its product is low by < 3; z^2 / 2, from 16 bits of z, is off by < 23. */
static inline uint32_t glint_exp2_near(uint32_t x)
{
    const uint32_t d = x & 0x3fffff;
    const uint32_t z = (d >> 6) * 45426 + ((d & 63) * 45426 >> 6) + (3 * d >> 11); /* d ln 2 in Q37 */
    const uint32_t h = (z + 32768) >> 16, square = h * h;                          /* Q21, Q42 */
    const uint32_t cube = (square >> 16) * (h * 10880 >> 16);                      /* a sixth of it, Q47 */
    const uint32_t f = GLINT_FLASH_U32(glint_exp2_fractions[x >> 22]);
    return f - glint_mulhi_near(f, (z >> 5) - (square >> 11) + (cube >> 15));
}

/* ---- the sRGB encoding in pieces: chords of one width from an entry of a table to the next ---- */

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
