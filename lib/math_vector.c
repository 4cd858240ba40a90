/* SPDX-License-Identifier: MIT */
#include "glint_math.h"
#include "glint_math_vector.h"

#if GLINT_WIDE

/* 15 digits more of *rest / length, for *rest <= length, 2^29 <= length < 2^31. The divisor is high by 2^-14 at most: the quotient, <= 2^15,
 * comes low by less than 3. */
static inline uint32_t vector_digits(uint32_t *rest, uint32_t length)
{
    uint32_t digits = *rest / ((length >> 15) + 1);
    uint64_t left = ((uint64_t)*rest << 15) - (uint64_t)digits * length;
    for (; left >= length; left -= length)
        digits++;
    *rest = (uint32_t)left;
    return digits;
}

/* size 2^30 / length to nearest, at most 2^30, for size <= length. */
static inline uint32_t vector_part(uint32_t size, uint32_t length)
{
    const uint32_t upper = vector_digits(&size, length) << 15;
    return upper + vector_digits(&size, length) + (2 * size >= length);
}

#else

/* A digit more of a quotient: *size is what is left, times 2. */
static inline void vector_digit(uint32_t *part, uint32_t *size, uint32_t length)
{
    *part <<= 1;
    if (*size >= length) {
        *size -= length;
        ++*part;
    }
    *size <<= 1;
}

/* size 2^30 / length to nearest, at most 2^30, for size <= length < 2^31: digit by digit, as a call of a division takes more
 * stack. */
static inline uint32_t vector_part(uint32_t size, uint32_t length)
{
    uint32_t part = 0;
    for (int digit = 30; digit >= 0; digit--)
        vector_digit(&part, &size, length);
    return part + (size >= length); /* twice the remainder */
}

#endif

static inline uint32_t vector_size(int32_t v)
{
    return v < 0 ? 0 - (uint32_t)v : (uint32_t)v;
}

bool glint_unit_q30(int32_t out[3], const int32_t v[3])
{
    uint32_t largest = 0;
    for (int i = 0; i < 3; i++)
        largest = vector_size(v[i]) > largest ? vector_size(v[i]) : largest;
    if (largest == 0)
        return false;
    unsigned up = 0, down = 0; /* bring the largest to 2^29 .. 2^30: the squares then sum to less than 2^62 */
#if GLINT_WIDE
    const unsigned zeros = (unsigned)__builtin_clz(largest);
    up = zeros > 2 ? zeros - 2 : 0;
    down = zeros < 2 ? 2 - zeros : 0;
#else
    while (largest << up < (uint32_t)1 << 29)
        up++;
    while (largest >> down >= (uint32_t)1 << 30)
        down++;
#endif
    uint64_t sum = 0;
    for (int i = 0; i < 3; i++) {
        const uint32_t size = vector_size(v[i]) << up >> down;
        sum += (uint64_t)size * size;
        out[i] = v[i] < 0 ? -(int32_t)size : (int32_t)size;
    }
    const uint32_t length = glint_root(sum); /* >= every size */
    for (int i = 0; i < 3; i++) {
        const int32_t part = (int32_t)vector_part(vector_size(out[i]), length);
        out[i] = out[i] < 0 ? -part : part;
    }
    return true;
}

bool glint_vec_of_q30(struct glint_vec *out, const int32_t v[3], int32_t slack)
{
    return glint_vec_near(out, v, slack);
}

enum glint_err glint_vec_normalize(struct glint_vec *out, const int32_t v[3])
{
    if (!out || !v)
        return GLINT_ERR_ARG;
    int32_t unit[3];
    if (!glint_unit_q30(unit, v))
        return GLINT_ERR_VECTOR;
    (void)glint_vec_of_q30(out, unit, 0);
    return GLINT_OK;
}

bool glint_half_q30(int32_t half[3], const int32_t l_q30[3], const int32_t v_q30[3])
{
    bool behind = true;
    for (int i = 0; i < 3; i++) {
        const int32_t l = l_q30[i], v = v_q30[i];
        const uint32_t sum = (uint32_t)l + (uint32_t)v + 8; /* modulo 2^32: sizes are about 2^30 at most */
        behind = behind && sum <= 16;                       /* what the rounding of l and v leaves of 0, and more */
        half[i] = glint_half_sum(l, v);
    }
    return !behind;
}

/* ---- nearly ---- */

static inline uint32_t unit_size(int32_t v)
{
    const uint32_t sign = (uint32_t)(v >> 31);
    return ((uint32_t)v ^ sign) - sign;
}

#if GLINT_WIDE

bool glint_unit_near(struct glint_unit *out, const int32_t v[3])
{
    return (unit_size(v[0]) | unit_size(v[1]) | unit_size(v[2])) >> 30 == 0 && glint_wide_unit(out, v);
}

void glint_unit_front(int32_t h[3], const int32_t l[3])
{
    glint_wide_front(h, l);
}

#else

/* r, nearly 2^46 / sqrt(a), 2^30 <= r <= 2^31, for an a whose floor is given, 2^30 <= a < 2^32. With y^2 a = 2^62 (1 - e),
 * 2^46 / sqrt(a) = 2^15 y (1 + e/2 + 3/8 e^2 + ..); 5/16 e^3 < 2^-37 is left out. Low by < 2.2. */
static inline __attribute__((always_inline)) uint32_t unit_inverse(uint32_t a)
{
    const uint32_t y = glint_root_inverse(a >> 16), yy = y * y;
    const uint32_t a1 = a >> 16, a0 = a & 0xffff, b1 = yy >> 16, b0 = yy & 0xffff;
    /* Q40, where 1 is 0 modulo 2^32; |e| < 0.95 2^28. High by < 2^10 + 2, as a0 b0 is left out, and by < 2^10, as a is a floor:
     * r is high by less than 2^-30 r */
    const int32_t e = -(int32_t)((a1 * b1 << 10) + (a1 * b0 >> 6) + (a0 * b1 >> 6));
    const int32_t s = e >> 14;                        /* Q26, |s| < 2^14 */
    const int32_t c = (e >> 6) + (3 * (s * s) >> 20); /* Q35, |c| < 0.96 2^22; low by < 3, which r is by < 0.2 */
    /* |c >> 7| < 2^15, products < 2^31. Low by < 2 */
    return (y << 15) + (uint32_t)((int32_t)y * (c >> 7) >> 13) + (y * ((uint32_t)c & 0x7f) >> 20);
}

/* Squares of sizes 2^15 x + w: 2^30 ones + 2^16 mixed + rests, three of each < 3 2^30. */
struct unit_squares {
    uint32_t ones, mixed, rests;
};

static inline void unit_squares_begin(struct unit_squares *squares)
{
    squares->ones = squares->mixed = squares->rests = 0;
}

static inline void unit_square(struct unit_squares *squares, uint32_t size)
{
    const uint32_t x = size >> 15, w = size & 0x7fff;
    squares->ones += x * x;
    squares->mixed += x * w;
    squares->rests += w * w;
}

/* The mantissa of what they sum to, 2^28 of that where it is small, else 2^30: rounded down, 2^30 or more where a size is 2^29 or
 * more. */
static inline uint32_t unit_mantissa(const struct unit_squares *sum, bool *small)
{
    const uint32_t mixed = sum->mixed + (sum->rests >> 16); /* < 2^32; what is left out is less than 1 */
    *small = !((sum->ones + (mixed >> 14)) >> 30);
    return *small ? (sum->ones << 2) + (mixed >> 12) : sum->ones + (mixed >> 14);
}

/* size r 2^-30, with the sign of v. x r0 < 2^30, w r1 < 2^31; low by < 2. With r's errors, of which size / 2^30 <= 1 arrives, it is
 * -4.2 .. 2 from the true one before 2 are added. glint_unit_q30 is -0.5 .. 2.5 from it, as its length is low by < 1 of 2^29.
 * Whole numbers that differ by -4.7 .. 4.5 differ by at most 4. */
static inline int32_t unit_part(int32_t v, uint32_t size, uint32_t r)
{
    const uint32_t x = size >> 15, w = size & 0x7fff, r1 = r >> 15, r0 = r & 0x7fff;
    const int32_t part = (int32_t)(x * r1 + ((x * r0 + w * r1) >> 15)) + 2;
    return (part ^ v >> 31) - (v >> 31);
}

bool glint_unit_near(struct glint_unit *out, const int32_t v[3])
{
    uint32_t x = unit_size(v[0]), y = unit_size(v[1]), z = unit_size(v[2]);
    const uint32_t any = x | y | z;
    if (any == 0 || any >> 30)
        return false;
    unsigned up = 0;
    if (!(any >> 14))
        up = 16;
    if (!(any << up >> 22))
        up += 8;
    while (!(any << up >> 29))
        up++;
    x <<= up;
    y <<= up;
    z <<= up;
    struct unit_squares sum;
    unit_squares_begin(&sum);
    unit_square(&sum, x);
    unit_square(&sum, y);
    unit_square(&sum, z);
    bool small;
    const uint32_t square = unit_mantissa(&sum, &small);
    out->up = up;
    out->square = square;
    out->exponent = (small ? 28 : 30) - 2 * (int32_t)up;
    const uint32_t r = unit_inverse(square) >> (small ? 0 : 1); /* low by < 2.2, also where shifted */
    out->unit_q30[0] = unit_part(v[0], x, r);
    out->unit_q30[1] = unit_part(v[1], y, r);
    out->unit_q30[2] = unit_part(v[2], z, r);
    return true;
}

/* As l is of length 1, |l + (0, 0, 1)|^2 / 4 = (1 + l_z) / 2, which is the mantissa: h = (l + (0, 0, 1)) / 2 over its root r.
 * In units of 2^-30, from the h of the true l: l is off by up to 4, so its half over the root by 4.26, and 1 + l_z over it by 4.61 (an
 * l_z above 1 counts as 1). A part is off that by -3.3 .. 4.1, as r is -1.6 .. 1 from the true one and the size < 2^31 + 8. The sequence
 * turns h by up to 6.75 with what it rounds before, and rounds a part by -.5 .. 2.5. In all at most 17: tests/proof. */
void glint_unit_front(int32_t h[3], const int32_t l[3])
{
    const uint32_t z = (uint32_t)l[2], one = (uint32_t)1 << 30;
    const uint32_t r = unit_inverse(z < one ? 2 * (one + z) : UINT32_MAX) >> 1;
    h[0] = unit_part(l[0], unit_size(l[0]), r);
    h[1] = unit_part(l[1], unit_size(l[1]), r);
    h[2] = unit_part(0, one + z, r);
}

#endif
