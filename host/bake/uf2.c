/* SPDX-License-Identifier: MIT
 * Blocks of 512 bytes with a header of eight words, the data in 476 bytes, and a last word. */
#include "bake/uf2.h"

#include <string.h>

enum { BLOCK = 512, PAYLOAD = 256, HEADER = 32, FAMILY_PRESENT = 0x2000 };
static const uint32_t start[2] = {0x0a324655, 0x9e5d5157}, end = 0x0ab16f30,
                      families[] = {0xe48bff56, 0xe48bff59, 0xe48bff5a};

static void put(uint8_t *at, uint32_t word) /* low byte first */
{
    for (unsigned i = 0; i < 4; i++)
        at[i] = (uint8_t)(word >> 8 * i);
}

void uf2_write(const uint8_t *bytes, size_t len, uint32_t address, enum uf2_family family, FILE *out)
{
    const uint32_t count = (uint32_t)((len + PAYLOAD - 1) / PAYLOAD);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t from = i * PAYLOAD;
        const uint32_t header[HEADER / 4] = {start[0], start[1], FAMILY_PRESENT, address + from,
                                             PAYLOAD,  i,        count,          families[family]};
        uint8_t block[BLOCK] = {0};
        for (unsigned k = 0; k < HEADER / 4; k++)
            put(block + sizeof header[k] * k, header[k]);
        memcpy(block + HEADER, bytes + from, len - from < PAYLOAD ? len - from : PAYLOAD);
        put(block + BLOCK - 4, end);
        fwrite(block, 1, sizeof block, out);
    }
}
