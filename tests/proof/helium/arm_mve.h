/* SPDX-License-Identifier: MIT
 * Stands for a compiler's arm_mve.h on any computer: those of its functions that lib/helium.c calls, lane by lane, as the Armv8-M manual has the
 * instructions. So tests run helium.c itself, for all of what is finite and under the sanitizers; that the instructions do the same, the emulated
 * board shows. */
#ifndef ARM_MVE_H
#define ARM_MVE_H

#include <stdint.h>

typedef int16_t int16x8_t __attribute__((vector_size(16)));
typedef int32_t int32x4_t __attribute__((vector_size(16)));
typedef uint8_t uint8x16_t __attribute__((vector_size(16)));
typedef uint16_t uint16x8_t __attribute__((vector_size(16)));
typedef uint32_t uint32x4_t __attribute__((vector_size(16)));
typedef struct {
    uint32x4_t val[2];
} uint32x4x2_t;
typedef uint16_t mve_pred16_t; /* a bit a byte */

#define MVE static inline __attribute__((always_inline, unused))
#define MVE_EACH(lanes) for (unsigned i = 0; i < (lanes); i++)
/* A function whose lane i is EXPRESSION. */
#define MVE_LANES(type, lanes, name, parameters, expression)                                                           \
    MVE type name parameters                                                                                           \
    {                                                                                                                  \
        type result;                                                                                                   \
        MVE_EACH(lanes)                                                                                                \
        result[i] = (expression);                                                                                      \
        return result;                                                                                                 \
    }
/* A predicate. */
#define MVE_ASKS(lanes, name, parameters, expression)                                                                  \
    MVE mve_pred16_t name parameters                                                                                   \
    {                                                                                                                  \
        uint32_t result = 0;                                                                                           \
        MVE_EACH(lanes)                                                                                                \
        result |= (expression) ? (0xffffu >> (16 - 16 / (lanes))) << (16 / (lanes)*i) : 0;                             \
        return (mve_pred16_t)result;                                                                                   \
    }
#define MVE_REINTERPRETS(name, to, from)                                                                               \
    MVE to name(from a)                                                                                                \
    {                                                                                                                  \
        return (to)a;                                                                                                  \
    }

MVE int32_t mve_hold(int64_t x)
{
    return (int32_t)(x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : x);
}
/* VSHL by a lane or a register: its low byte, signed. */
MVE uint32_t mve_shift(uint32_t a, int32_t by)
{
    const int8_t n = (int8_t)by;
    return n >= 32 || n <= -32 ? 0 : n < 0 ? a >> -n : a << n;
}
MVE int32_t mve_shift_signed(int32_t a, int32_t by)
{
    const int8_t n = (int8_t)by;
    return n >= 32 ? 0 : n <= -32 ? a >> 31 : n < 0 ? a >> -n : (int32_t)((uint32_t)a << n);
}
MVE uint16_t mve_narrow(uint32_t a, unsigned by) /* rounds, holds */
{
    const uint64_t x = ((uint64_t)a + ((uint64_t)1 << (by - 1))) >> by;
    return (uint16_t)(x > UINT16_MAX ? UINT16_MAX : x);
}

MVE_REINTERPRETS(vreinterpretq_u32_s32, uint32x4_t, int32x4_t)
MVE_REINTERPRETS(vreinterpretq_s32_u32, int32x4_t, uint32x4_t)
MVE_REINTERPRETS(vreinterpretq_s16_u32, int16x8_t, uint32x4_t)
MVE_REINTERPRETS(vreinterpretq_s16_u16, int16x8_t, uint16x8_t)
MVE_REINTERPRETS(vreinterpretq_u16_u32, uint16x8_t, uint32x4_t)
MVE_REINTERPRETS(vreinterpretq_u16_u8, uint16x8_t, uint8x16_t)
MVE_REINTERPRETS(vreinterpretq_u8_u16, uint8x16_t, uint16x8_t)

MVE_LANES(int32x4_t, 4, vdupq_n_s32, (int32_t b), b)
MVE_LANES(uint32x4_t, 4, vdupq_n_u32, (uint32_t b), b)
MVE_LANES(uint16x8_t, 8, vdupq_n_u16, (uint16_t b), b)
MVE_LANES(uint32x4_t, 4, vidupq_n_u32, (uint32_t b, uint32_t step), b + i * step)
#define vuninitializedq_u16() vdupq_n_u16(0x5a5a)

MVE_LANES(int32x4_t, 4, vaddq_s32, (int32x4_t a, int32x4_t b), (int32_t)((uint32_t)a[i] + (uint32_t)b[i]))
MVE_LANES(uint32x4_t, 4, vaddq_u32, (uint32x4_t a, uint32x4_t b), a[i] + b[i])
MVE_LANES(uint32x4_t, 4, vaddq_n_u32, (uint32x4_t a, uint32_t b), a[i] + b)
MVE_LANES(uint16x8_t, 8, vaddq_u16, (uint16x8_t a, uint16x8_t b), (uint16_t)(a[i] + b[i]))
MVE_LANES(int32x4_t, 4, vsubq_s32, (int32x4_t a, int32x4_t b), (int32_t)((uint32_t)a[i] - (uint32_t)b[i]))
MVE_LANES(uint32x4_t, 4, vsubq_u32, (uint32x4_t a, uint32x4_t b), a[i] - b[i])
MVE_LANES(int32x4_t, 4, vsubq_n_s32, (int32x4_t a, int32_t b), (int32_t)((uint32_t)a[i] - (uint32_t)b))
MVE_LANES(uint32x4_t, 4, vsubq_n_u32, (uint32x4_t a, uint32_t b), a[i] - b)
MVE_LANES(uint32x4_t, 4, vqaddq_u32, (uint32x4_t a, uint32x4_t b), a[i] > UINT32_MAX - b[i] ? UINT32_MAX : a[i] + b[i])
MVE_LANES(int32x4_t, 4, vqsubq_n_s32, (int32x4_t a, int32_t b), mve_hold((int64_t)a[i] - b))
MVE_LANES(uint16x8_t, 8, vqaddq_n_u16, (uint16x8_t a, uint16_t b),
          (uint16_t)(a[i] + b > UINT16_MAX ? UINT16_MAX : a[i] + b))
MVE_LANES(int32x4_t, 4, vmaxq_s32, (int32x4_t a, int32x4_t b), a[i] > b[i] ? a[i] : b[i])
MVE_LANES(uint16x8_t, 8, vminq_u16, (uint16x8_t a, uint16x8_t b), a[i] < b[i] ? a[i] : b[i])
MVE_LANES(uint16x8_t, 8, vmvnq_u16, (uint16x8_t a), (uint16_t)~a[i])
MVE_LANES(uint16x8_t, 8, vbicq_n_u16, (uint16x8_t a, uint16_t b), (uint16_t)(a[i] & ~b))

MVE_LANES(int32x4_t, 4, vmulq_s32, (int32x4_t a, int32x4_t b), (int32_t)((uint32_t)a[i] * (uint32_t)b[i]))
MVE_LANES(uint32x4_t, 4, vmulq_u32, (uint32x4_t a, uint32x4_t b), a[i] * b[i])
MVE_LANES(int32x4_t, 4, vmulq_n_s32, (int32x4_t a, int32_t b), (int32_t)((uint32_t)a[i] * (uint32_t)b))
MVE_LANES(uint32x4_t, 4, vmulq_n_u32, (uint32x4_t a, uint32_t b), a[i] * b)
MVE_LANES(int32x4_t, 4, vmlaq_n_s32, (int32x4_t a, int32x4_t b, int32_t c),
          (int32_t)((uint32_t)a[i] + (uint32_t)b[i] * (uint32_t)c))
MVE_LANES(uint32x4_t, 4, vmlaq_n_u32, (uint32x4_t a, uint32x4_t b, uint32_t c), a[i] + b[i] * c)
MVE_LANES(int32x4_t, 4, vmullbq_int_s16, (int16x8_t a, int16x8_t b), a[2 * i] * b[2 * i])
MVE_LANES(int32x4_t, 4, vmulltq_int_s16, (int16x8_t a, int16x8_t b), a[2 * i + 1] * b[2 * i + 1])
/* Doubled, the upper half; all at once with what is added, then held: 2 a b + 2^32 c, below 2^64 as halves of it. */
MVE_LANES(int32x4_t, 4, vqdmulhq_s32, (int32x4_t a, int32x4_t b), mve_hold((int64_t)a[i] * b[i] >> 31))
MVE_LANES(int32x4_t, 4, vqdmlahq_n_s32, (int32x4_t a, int32x4_t b, int32_t c),
          mve_hold(((int64_t)b[i] * c >> 31) + a[i]))
MVE_LANES(int32x4_t, 4, vqrdmlahq_n_s32, (int32x4_t a, int32x4_t b, int32_t c),
          mve_hold((((int64_t)b[i] * c + (1 << 30)) >> 31) + a[i]))
MVE_LANES(int32x4_t, 4, vqdmlahq_m_n_s32, (int32x4_t a, int32x4_t b, int32_t c, mve_pred16_t p),
          p >> 4 * i & 1 ? mve_hold(((int64_t)b[i] * c >> 31) + a[i]) : a[i])

MVE_LANES(uint32x4_t, 4, vshlq_n_u32, (uint32x4_t a, unsigned n), a[i] << n)
MVE_LANES(uint32x4_t, 4, vshrq_n_u32, (uint32x4_t a, unsigned n), n > 31 ? 0 : a[i] >> n)
MVE_LANES(uint16x8_t, 8, vshrq_n_u16, (uint16x8_t a, unsigned n), (uint16_t)(a[i] >> n))
MVE_LANES(uint32x4_t, 4, vrshrq_n_u32, (uint32x4_t a, unsigned n), (uint32_t)((a[i] + ((uint64_t)1 << (n - 1))) >> n))
MVE_LANES(uint32x4_t, 4, vqshluq_n_s32, (int32x4_t a, unsigned n),
          a[i]<0 ? 0 : (uint64_t)a[i] << n> UINT32_MAX ? UINT32_MAX : (uint32_t)a[i] << n)
MVE_LANES(int32x4_t, 4, vqshlq_n_s32, (int32x4_t a, unsigned n), mve_hold((int64_t)a[i] * (1 << n)))
MVE_LANES(int32x4_t, 4, vqshlq_r_s32, (int32x4_t a, int32_t b),
          mve_hold((int64_t)a[i] * ((int64_t)1 << b))) /* b >= 0 */
MVE_LANES(int32x4_t, 4, vshlq_s32, (int32x4_t a, int32x4_t b), mve_shift_signed(a[i], b[i]))
MVE_LANES(uint32x4_t, 4, vshlq_u32, (uint32x4_t a, int32x4_t b), mve_shift(a[i], b[i]))
MVE_LANES(int32x4_t, 4, vshlq_r_s32, (int32x4_t a, int32_t b), mve_shift_signed(a[i], b))
MVE_LANES(uint32x4_t, 4, vshlq_r_u32, (uint32x4_t a, int32_t b), mve_shift(a[i], b))
MVE_LANES(int32x4_t, 4, vclsq_s32, (int32x4_t a), __builtin_clrsb(a[i]))
MVE_LANES(uint16x8_t, 8, vsriq_n_u16, (uint16x8_t a, uint16x8_t b, unsigned n),
          (uint16_t)((a[i] & ~(0xffffu >> n)) | b[i] >> n))
MVE_LANES(uint32x4_t, 4, vsriq_n_u32, (uint32x4_t a, uint32x4_t b, unsigned n), (a[i] & ~(UINT32_MAX >> n)) | b[i] >> n)
MVE_LANES(uint16x8_t, 8, vqrshrnbq_n_u32, (uint16x8_t a, uint32x4_t b, unsigned n),
          i % 2 == 0 ? mve_narrow(b[i / 2], n) : a[i])
MVE_LANES(uint16x8_t, 8, vqrshrntq_n_u32, (uint16x8_t a, uint32x4_t b, unsigned n),
          i % 2 == 1 ? mve_narrow(b[i / 2], n) : a[i])
MVE_LANES(uint8x16_t, 16, vrev16q_u8, (uint8x16_t a), a[i ^ 1])

MVE mve_pred16_t vctp8q(uint32_t count)
{
    return (mve_pred16_t)(count < 16 ? (1u << count) - 1 : 0xffff);
}
MVE mve_pred16_t vctp16q(uint32_t count)
{
    return vctp8q(count < 8 ? 2 * count : 16);
}
MVE_ASKS(16, vcmpeqq_m_n_u8, (uint8x16_t a, uint8_t b, mve_pred16_t p), p >> i & 1 && a[i] == b)
MVE_ASKS(16, vcmpneq_m_n_u8, (uint8x16_t a, uint8_t b, mve_pred16_t p), p >> i & 1 && a[i] != b)
MVE_ASKS(4, vcmpgtq_n_s32, (int32x4_t a, int32_t b), a[i] > b)
MVE_ASKS(4, vcmpltq_m_n_s32, (int32x4_t a, int32_t b, mve_pred16_t p), p >> 4 * i & 1 && a[i] < b)
MVE_ASKS(8, vcmpgeq_n_s16, (int16x8_t a, int16_t b), a[i] >= b)
MVE_ASKS(8, vcmpltq_n_s16, (int16x8_t a, int16_t b), a[i] < b)
MVE_ASKS(8, vcmpneq_u16, (uint16x8_t a, uint16x8_t b), a[i] != b[i])
MVE_ASKS(8, vcmpeqq_n_u16, (uint16x8_t a, uint16_t b), a[i] == b)
MVE_LANES(uint16x8_t, 8, vpselq_u16, (uint16x8_t a, uint16x8_t b, mve_pred16_t p), p >> 2 * i & 1 ? a[i] : b[i])

MVE_LANES(uint8x16_t, 16, vldrbq_z_u8, (const uint8_t *from, mve_pred16_t p), p >> i & 1 ? from[i] : 0)
/* Gathers: places in bytes. */
MVE const uint8_t *mve_at(const void *base, uint32_t bytes)
{
    return (const uint8_t *)base + bytes;
}
MVE_LANES(int32x4_t, 4, vldrhq_gather_offset_s32, (const int16_t *base, uint32x4_t at),
          *(const int16_t *)(const void *)mve_at(base, at[i]))
MVE_LANES(uint32x4_t, 4, vldrbq_gather_offset_z_u32, (const uint8_t *base, uint32x4_t at, mve_pred16_t p),
          p >> 4 * i & 1 ? *mve_at(base, at[i]) : 0)
MVE_LANES(uint16x8_t, 8, vldrbq_gather_offset_z_u16, (const uint8_t *base, uint16x8_t at, mve_pred16_t p),
          p >> 2 * i & 1 ? *mve_at(base, at[i]) : 0)
MVE_LANES(uint16x8_t, 8, vldrhq_gather_offset_z_u16, (const uint16_t *base, uint16x8_t at, mve_pred16_t p),
          p >> 2 * i & 1 ? *(const uint16_t *)(const void *)mve_at(base, at[i]) : 0)
MVE uint32x4x2_t vld2q_u32(const uint32_t *from)
{
    uint32x4x2_t two;
    MVE_EACH(8)
    two.val[i % 2][i / 2] = from[i];
    return two;
}
MVE void vstrhq_u16(uint16_t *out, uint16x8_t a)
{
    MVE_EACH(8)
    out[i] = a[i];
}
MVE void vstrhq_p_u16(uint16_t *out, uint16x8_t a, mve_pred16_t p)
{
    MVE_EACH(8)
    if (p >> 2 * i & 1)
        out[i] = a[i];
}

#endif
