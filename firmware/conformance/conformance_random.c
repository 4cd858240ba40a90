/* SPDX-License-Identifier: MIT
 * A hash of what the library returned, and the random numbers that it was asked with: the same on every machine. */
#include "conformance_random.h"

static uint64_t hash;
static uint32_t state;

void conform_begin(void)
{
    hash = UINT64_C(0xcbf29ce484222325);
    state = 1;
}

uint64_t conform_hash(void)
{
    return hash;
}

static void mix(uint32_t value) /* FNV-1a */
{
    hash ^= value;
    hash *= UINT64_C(0x100000001b3);
}

void conform_add_bytes(const uint8_t *bytes, uint16_t count)
{
    while (count--)
        mix(*bytes++);
}

void conform_add(uint32_t value)
{
    mix(value);
}

uint32_t conform_random_bits(void)
{
    state = state * UINT32_C(1664525) + UINT32_C(1013904223);
    return state ^ state >> 16;
}

int32_t conform_random_within(int32_t limit)
{
    return (int32_t)(conform_random_bits() % (2 * (uint32_t)limit + 1)) - limit;
}

void conform_random_vector(int32_t v[3], int32_t limit)
{
    for (uint8_t i = 0; i < 3; i++)
        v[i] = conform_random_within(limit);
}
