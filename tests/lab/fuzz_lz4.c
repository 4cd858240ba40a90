/* SPDX-License-Identifier: MIT
 * Fuzzes the LZ4 decoder: it takes exactly what the format allows, and then gives what liblz4 does, whatever the pieces.
 * Input: bytes of output (2; below 9: what the block seems to yield, or up to 4 more or fewer), window beyond what is needed
 * (1), size of the pieces (1), the block. */
#include <lz4.h>
#include <string.h>

#include "fuzz.h"
#include "lz4_block.h"

enum { GUARD = 32, FRESH = 0xa5, OUTPUT_MAX = 200000 };

/* A length that goes on in further bytes; SIZE_MAX where they end too early. */
static size_t length_of(const uint8_t **at, const uint8_t *end, unsigned nibble)
{
    size_t length = nibble;
    for (unsigned byte = nibble == 15 ? 255 : 0; byte == 255; length += byte) {
        if (*at == end)
            return SIZE_MAX;
        byte = *(*at)++;
    }
    return length;
}

/* By the format's description: sequences, the rules for the end, no offset of 0 or before the start. */
static bool conforms(const uint8_t *at, size_t count, size_t output)
{
    const uint8_t *const end = at + count;
    for (size_t made = 0; at != end;) {
        const unsigned token = *at++;
        const size_t literals = length_of(&at, end, token >> 4);
        if (literals > (size_t)(end - at) || literals > output - made)
            return false;
        at += literals;
        made += literals;
        if (at == end)
            return made == output;
        if (end - at < 2)
            return false;
        const unsigned offset = at[0] | (unsigned)at[1] << 8;
        at += 2;
        const size_t match = length_of(&at, end, token & 15);
        if (match == SIZE_MAX || offset == 0 || offset > made || output - made < 12 || match + 4 > output - made - 5)
            return false;
        made += match + 4;
    }
    return false;
}

/* What the sequences add up to, right or wrong; at least 1. */
static uint32_t yield_of(const uint8_t *at, size_t count)
{
    const uint8_t *const end = at + count;
    size_t made = 0;
    while (at != end && made < OUTPUT_MAX) {
        const unsigned token = *at++;
        const size_t literals = length_of(&at, end, token >> 4);
        if (literals > (size_t)(end - at))
            break;
        at += literals;
        made += literals;
        if (end - at < 2)
            break;
        at += 2;
        const size_t match = length_of(&at, end, token & 15);
        if (match == SIZE_MAX)
            break;
        made += match + 4;
    }
    return made == 0 ? 1 : made < OUTPUT_MAX ? (uint32_t)made : OUTPUT_MAX;
}

static uint32_t output_of(unsigned word, const uint8_t *block, size_t count)
{
    const uint32_t yield = yield_of(block, count);
    if (word > 8)
        return word;
    return yield + word > 4 ? yield + word - 4 : 1;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, data + size};
    const unsigned word = next_word(&input), spare = next_byte(&input);
    const size_t piece = 1 + next_byte(&input);
    size_t count = size;
    uint8_t *const block = next_bytes(&input, &count);
    const uint32_t output = output_of(word, block, count);
    const uint32_t window = (output < LZ4_BLOCK_REACH ? output : LZ4_BLOCK_REACH) + spare;
    uint8_t *const memory = malloc(window + 2 * GUARD);
    uint8_t *const made = malloc(output), *const wanted = malloc(output);
    memset(memory, FRESH, window + 2 * GUARD);

    struct lz4_block decoder = {.window = memory + GUARD, .window_bytes = window};
    lz4_block_begin(&decoder, output);
    uint32_t length = 0;
    for (size_t at = 0; at < count; at += piece) {
        const uint8_t *from = block + at, *const end = block + (count - at < piece ? count : at + piece), *run;
        for (size_t n; (n = lz4_block_next(&decoder, &from, end, &run)) != 0; length += (uint32_t)n) {
            check(n <= output - length);
            check(run >= decoder.window && run + n <= decoder.window + window);
            memcpy(made + length, run, n);
        }
        check(from == end);
    }
    for (unsigned i = 0; i < GUARD; i++)
        check(memory[i] == FRESH && memory[GUARD + window + i] == FRESH);
    const bool taken = lz4_block_complete(&decoder);
    check(taken == conforms(block, count, output));
    if (taken) {
        check(length == output);
        check(LZ4_decompress_safe((char *)block, (char *)wanted, (int)count, (int)output) == (int)output);
        check(memcmp(made, wanted, output) == 0);
    }
    free(block);
    free(memory);
    free(made);
    free(wanted);
    return 0;
}
