/* SPDX-License-Identifier: MIT */
#include "lz4_block.h"

enum step { TOKEN, LITERAL_LENGTH, LITERALS, OFFSET_LOW, OFFSET_HIGH, MATCH_LENGTH, MATCH, COMPLETE, WRONG };
enum {
    LENGTH_GOES_ON = 15,  /* in a token's nibble */
    MATCH_LEAST = 4,      /* bytes */
    LAST_MATCH_FROM = 12, /* a match starts at least as many bytes before the end of the output... */
    LAST_LITERALS = 5     /* ...and leaves at least as many to literals */
};

void lz4_block_begin(struct lz4_block *b, uint32_t output_bytes)
{
    b->missing = output_bytes;
    b->at = b->history = b->length = 0;
    b->step = TOKEN;
}

bool lz4_block_complete(const struct lz4_block *b)
{
    return b->step == COMPLETE;
}

static uint8_t after_literals(const struct lz4_block *b)
{
    if (b->missing == 0)
        return COMPLETE;
    return b->missing < LAST_MATCH_FROM ? WRONG : OFFSET_LOW;
}

/* `goes_on`: another byte of the length follows. It is checked early, so that it cannot overflow. */
static uint8_t with_literal_length(const struct lz4_block *b, bool goes_on)
{
    if (b->length > b->missing)
        return WRONG;
    if (goes_on)
        return LITERAL_LENGTH;
    return b->length ? LITERALS : after_literals(b);
}

static uint8_t with_match_length(const struct lz4_block *b, bool goes_on)
{
    if (b->length > b->missing - LAST_LITERALS) /* missing >= 12 */
        return WRONG;
    return goes_on ? MATCH_LENGTH : MATCH;
}

static uint8_t take(struct lz4_block *b, uint8_t byte)
{
    switch (b->step) {
    case TOKEN:
        b->token = byte & 15;
        b->length = byte >> 4;
        return with_literal_length(b, b->length == LENGTH_GOES_ON);
    case LITERAL_LENGTH:
        b->length += byte;
        return with_literal_length(b, byte == 255);
    case OFFSET_LOW:
        b->offset = byte;
        return OFFSET_HIGH;
    case OFFSET_HIGH:
        b->offset = (uint16_t)(b->offset | byte << 8);
        if (b->offset == 0 || b->offset > b->history)
            return WRONG;
        b->length = (uint32_t)b->token + MATCH_LEAST;
        return with_match_length(b, b->token == LENGTH_GOES_ON);
    case MATCH_LENGTH:
        b->length += byte;
        return with_match_length(b, byte == 255);
    default: /* input after the end */
        return WRONG;
    }
}

static uint32_t least(uint32_t a, size_t b)
{
    return a < b ? a : (uint32_t)b;
}

/* As much of the literals or match as lies in one piece; a match that overlaps itself repeats: byte by byte, upwards. */
static uint32_t copy(struct lz4_block *b, const uint8_t **in, const uint8_t *end)
{
    uint32_t count = least(b->length, b->window_bytes - b->at);
    uint8_t *to = b->window + b->at;
    if (b->step == LITERALS) {
        count = least(count, (size_t)(end - *in));
        for (uint32_t i = 0; i < count; i++)
            to[i] = (*in)[i];
        *in += count;
    } else {
        const uint32_t from = b->at >= b->offset ? b->at - b->offset : b->at + b->window_bytes - b->offset;
        count = least(count, b->window_bytes - from);
        for (uint32_t i = 0; i < count; i++)
            to[i] = b->window[from + i];
    }
    return count;
}

size_t lz4_block_next(struct lz4_block *b, const uint8_t **in, const uint8_t *end, const uint8_t **run)
{
    while (b->step == MATCH || *in != end) {
        if (b->step == WRONG)
            return *in = end, 0;
        if (b->step != LITERALS && b->step != MATCH) {
            b->step = take(b, *(*in)++);
            continue;
        }
        const uint32_t count = copy(b, in, end);
        *run = b->window + b->at;
        b->at = b->at + count == b->window_bytes ? 0 : b->at + count;
        b->history = least(b->history + count, b->window_bytes);
        b->missing -= count;
        b->length -= count;
        if (b->length == 0)
            b->step = b->step == MATCH ? TOKEN : after_literals(b);
        return count;
    }
    return 0;
}
