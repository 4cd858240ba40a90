/* SPDX-License-Identifier: MIT
 * Microsoft's UF2, which the boot loaders of RP2040 and RP2350 take. */
#ifndef GLINT_UF2_H
#define GLINT_UF2_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum uf2_family { UF2_RP2040, UF2_RP2350, UF2_RP2350_RISCV }; /* the second: its Arm cores */

/* Bytes for the flash from an address on, which is a multiple of 256. Errors stay with the stream. */
void uf2_write(const uint8_t *bytes, size_t len, uint32_t address, enum uf2_family family, FILE *out);

#endif
