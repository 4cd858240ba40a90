/* SPDX-License-Identifier: MIT
 * The hash of a check, and its random numbers. */
#ifndef CONFORMANCE_RANDOM_H
#define CONFORMANCE_RANDOM_H

#include <stdint.h>

void conform_begin(void); /* of each check */
uint64_t conform_hash(void);

/* Into the hash. */
void conform_add_bytes(const uint8_t *bytes, uint16_t count);
void conform_add(uint32_t value);

/* One call a statement everywhere: within one, the compiler chooses the order. */
uint32_t conform_random_bits(void);
int32_t conform_random_within(int32_t limit); /* -limit..limit */
void conform_random_vector(int32_t v[3], int32_t limit);

#endif
