/* SPDX-License-Identifier: MIT
 * Baked normals as bytes, low ones first, and as UF2 blocks. */
#include "bake/write.h"

#include <stdlib.h>

#include "bake/uf2.h"
#include "base/memory.h"

static uint8_t *put(uint8_t *at, uint32_t value, unsigned bytes)
{
    for (unsigned i = 0; i < bytes; i++)
        *at++ = (uint8_t)(value >> 8 * i);
    return at;
}

static uint8_t *to_bytes(const struct baked *baked)
{
    const size_t pixels = (size_t)baked->width * baked->height;
    const size_t normals = baked->format == BAKE_INT16 ? pixels : baked->entries; /* 0 for words */
    uint8_t *bytes = allocate(baked_bytes(baked), 1), *at = bytes;
    for (size_t i = 0; i < normals; i++) {
        at = put(at, (uint16_t)baked->normals[i].x, 2);
        at = put(at, (uint16_t)baked->normals[i].y, 2);
        at = put(at, (uint16_t)baked->normals[i].z, 2);
    }
    for (size_t i = 0; i < pixels && baked->words; i++)
        at = put(at, baked->words[i], 4);
    for (size_t i = 0; i < pixels && baked->offsets; i++)
        at = put(at, baked->offsets[i], 2);
    for (size_t i = 0; i < pixels && baked->albedo; i++)
        at = put(at, baked->albedo[i], 2);
    for (unsigned k = 0; k < BAKED_MAPS; k++)
        for (size_t i = 0; i < pixels && baked->maps[k]; i++)
            at = put(at, baked->maps[k][i], 1);
    return bytes;
}

void bake_write_raw(const struct baked *baked, FILE *out)
{
    uint8_t *bytes = to_bytes(baked);
    fwrite(bytes, 1, baked_bytes(baked), out); /* output_close looks whether it could */
    free(bytes);
}

void bake_write_uf2(const struct baked *baked, uint32_t address, FILE *out)
{
    uint8_t *bytes = to_bytes(baked);
    uf2_write(bytes, baked_bytes(baked), address, UF2_RP2040, out);
    free(bytes);
}
