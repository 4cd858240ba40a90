/* SPDX-License-Identifier: MIT
 * Microsoft's UF2, which an RP2040's boot loader takes. */
#ifndef GLINT_UF2_H
#define GLINT_UF2_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Bytes for the RP2040's flash from an address on, which is a multiple of 256. Errors stay with the stream. */
void uf2_write(const uint8_t *bytes, size_t len, uint32_t address, FILE *out);

#endif
