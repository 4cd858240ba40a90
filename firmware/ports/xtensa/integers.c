/* SPDX-License-Identifier: MIT
 * Products and quotients that the lx106 has no instruction for and that Debian's libgcc for it lacks. GCC calls them by
 * these names. Only 32-bit products and shifts may stand here: anything wider would be a call to the function itself. */
#include <stdint.h>

uint64_t __muldi3(uint64_t a, uint64_t b);
uint32_t __udivsi3(uint32_t a, uint32_t b);
uint32_t __umodsi3(uint32_t a, uint32_t b);
int32_t __divsi3(int32_t a, int32_t b);
uint64_t __udivdi3(uint64_t a, uint64_t b);
uint64_t __umoddi3(uint64_t a, uint64_t b);
int64_t __divdi3(int64_t a, int64_t b);

/* The low words in halves of 16 bits, four products that fit 32 bits; of the high words only what is below 2^64. */
uint64_t __muldi3(uint64_t a, uint64_t b)
{
    const uint32_t a_low = (uint32_t)a, b_low = (uint32_t)b;
    const uint32_t a0 = a_low & 0xffff, a1 = a_low >> 16, b0 = b_low & 0xffff, b1 = b_low >> 16;
    const uint32_t p00 = a0 * b0, p01 = a0 * b1, p10 = a1 * b0;
    const uint32_t middle = (p00 >> 16) + (p01 & 0xffff) + (p10 & 0xffff); /* < 3 * 2^16 */
    const uint32_t low = middle << 16 | (p00 & 0xffff);
    const uint32_t high = a1 * b1 + (p01 >> 16) + (p10 >> 16) + (middle >> 16);
    return (uint64_t)(high + a_low * (uint32_t)(b >> 32) + (uint32_t)(a >> 32) * b_low) << 32 | low;
}

/* By hand: the divisor shifted up to the dividend's highest bit, then one bit of the quotient a step. A divisor of 0 gives 0
 * and leaves the dividend. */
static uint32_t divide(uint32_t a, uint32_t b, uint32_t *rest)
{
    uint32_t quotient = 0;
    if (b && a >= b)
        for (int shift = __builtin_clz(b) - __builtin_clz(a); shift >= 0; shift--)
            if (a >= b << shift) {
                a -= b << shift;
                quotient |= UINT32_C(1) << shift;
            }
    *rest = a;
    return quotient;
}

uint32_t __udivsi3(uint32_t a, uint32_t b)
{
    uint32_t rest;
    return divide(a, b, &rest);
}

uint32_t __umodsi3(uint32_t a, uint32_t b)
{
    uint32_t rest;
    (void)divide(a, b, &rest);
    return rest;
}

int32_t __divsi3(int32_t a, int32_t b)
{
    uint32_t rest;
    const uint32_t quotient =
        divide(a < 0 ? 0 - (uint32_t)a : (uint32_t)a, b < 0 ? 0 - (uint32_t)b : (uint32_t)b, &rest);
    return (int32_t)((a < 0) != (b < 0) ? 0 - quotient : quotient);
}

static int bits(uint64_t value)
{
    const uint32_t high = (uint32_t)(value >> 32);
    return high ? 64 - __builtin_clz(high) : 32 - __builtin_clz((uint32_t)value);
}

uint64_t __udivdi3(uint64_t a, uint64_t b)
{
    uint64_t quotient = 0;
    if (b == 0 || a < b)
        return 0;
    const int shift = bits(a) - bits(b);
    b <<= shift;
    for (int i = 0; i <= shift; i++) {
        quotient <<= 1;
        if (a >= b) {
            a -= b;
            quotient |= 1;
        }
        b >>= 1;
    }
    return quotient;
}

uint64_t __umoddi3(uint64_t a, uint64_t b)
{
    return a - __udivdi3(a, b) * b;
}

int64_t __divdi3(int64_t a, int64_t b)
{
    const uint64_t high = (uint64_t)a, low = (uint64_t)b;
    const uint64_t quotient = __udivdi3(a < 0 ? 0 - high : high, b < 0 ? 0 - low : low);
    return (int64_t)((a < 0) != (b < 0) ? 0 - quotient : quotient);
}
