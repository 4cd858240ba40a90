/* SPDX-License-Identifier: MIT
 *
 * LZ4 block decoder for input that arrives in pieces of any size. The output goes through a window that the caller owns and
 * that is also the history for matches: no other memory, and none for compressed input. Strict: what the format
 * forbids is refused, the rules for the end of a block included. */
#ifndef LZ4_BLOCK_H
#define LZ4_BLOCK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The farthest that a match reaches back is one less. */
enum { LZ4_BLOCK_REACH = 65536 };

struct lz4_block {
    /* Config, set by you: at least as many bytes as the output has, or LZ4_BLOCK_REACH. */
    uint8_t *window;
    uint32_t window_bytes;
    /* State, ours. */
    uint32_t missing; /* output still to come */
    uint32_t at;      /* where in the window the next byte goes */
    uint32_t history; /* bytes behind it that may be read */
    uint32_t length;  /* of literals or match, still to come */
    uint16_t offset;
    uint8_t token, step;
};

/* A block that yields exactly `output_bytes`, at least 1 and below 2^31. */
void lz4_block_begin(struct lz4_block *block, uint32_t output_bytes);
/* Takes input from *in (advanced, at most to `end`) until it has a run of output: its length is returned, *run points into
 * the window, valid until the next call. 0: all input is taken, or the block is wrong. */
size_t lz4_block_next(struct lz4_block *block, const uint8_t **in, const uint8_t *end, const uint8_t **run);
/* Has the block ended, with all its output? Input after that makes it wrong. */
bool lz4_block_complete(const struct lz4_block *block);

#endif
