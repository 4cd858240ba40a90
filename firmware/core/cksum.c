/* SPDX-License-Identifier: MIT */
#include "cksum.h"

/* What four bits leave: x^32 + ... of Ethernet's polynomial, 0x04c11db7, highest bit first. */
static const uint32_t remainders[16] = {0x00000000, 0x04c11db7, 0x09823b6e, 0x0d4326d9, 0x130476dc, 0x17c56b6b,
                                        0x1a864db2, 0x1e475005, 0x2608edb8, 0x22c9f00f, 0x2f8ad6d6, 0x2b4bcb61,
                                        0x350c9b64, 0x31cd86d3, 0x3c8ea00a, 0x384fbdbd};

static uint32_t add(uint32_t sum, unsigned byte)
{
    sum = sum << 4 ^ remainders[sum >> 28 ^ byte >> 4];
    return sum << 4 ^ remainders[sum >> 28 ^ (byte & 15)];
}

uint32_t cksum_add(uint32_t sum, const void *bytes, size_t count)
{
    const uint8_t *const at = bytes;
    for (size_t i = 0; i < count; i++)
        sum = add(sum, at[i]);
    return sum;
}

uint32_t cksum_end(uint32_t sum, size_t count)
{
    for (; count; count >>= 8) /* as the standard has it, the length follows */
        sum = add(sum, count & 255);
    return ~sum;
}

uint32_t cksum(const void *bytes, size_t count)
{
    return cksum_end(cksum_add(0, bytes, count), count);
}
