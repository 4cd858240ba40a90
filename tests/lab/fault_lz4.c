/* SPDX-License-Identifier: MIT
 * Faults that the fuzzer of the LZ4 decoder is to find. */
#include "fault.h"
#include "lz4_block.h"

void __real_lz4_block_begin(struct lz4_block *b, uint32_t output_bytes);
void __wrap_lz4_block_begin(struct lz4_block *b, uint32_t output_bytes);
size_t __real_lz4_block_next(struct lz4_block *b, const uint8_t **in, const uint8_t *end, const uint8_t **run);
size_t __wrap_lz4_block_next(struct lz4_block *b, const uint8_t **in, const uint8_t *end, const uint8_t **run);

/* Takes the window for written before it is. */
void __wrap_lz4_block_begin(struct lz4_block *b, uint32_t output_bytes)
{
    __real_lz4_block_begin(b, output_bytes);
    if (fault_is("lz4_block_begin"))
        b->history = b->window_bytes;
}

/* A wrong byte where a match is long: literals are as many bytes of input. */
size_t __wrap_lz4_block_next(struct lz4_block *b, const uint8_t **in, const uint8_t *end, const uint8_t **run)
{
    const uint8_t *const from = *in;
    const size_t count = __real_lz4_block_next(b, in, end, run);
    if (fault_is("lz4_block_next") && count > 9 && (size_t)(*in - from) < count)
        b->window[*run - b->window + 9] ^= 1;
    return count;
}
