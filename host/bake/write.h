/* SPDX-License-Identifier: MIT
 * Baked normals as binary files. */
#ifndef GLINT_BAKE_WRITE_H
#define GLINT_BAKE_WRITE_H

#include <stdio.h>

#include "bake/bake.h"

enum bake_kind { BAKE_C, BAKE_RAW, BAKE_UF2, BAKE_KINDS };
enum { FLASH_BASE = 0x10000000, FLASH_END = 0x11000000, FLASH_SECTOR = 4096, FLASH_DEFAULT = 0x10100000 };

void bake_write_raw(const struct baked *baked, FILE *out);
void bake_write_uf2(const struct baked *baked, uint32_t address, FILE *out);

#endif
