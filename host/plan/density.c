/* SPDX-License-Identifier: MIT */
#include "plan/density.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "plan/plan.h"

struct density {
    unsigned width, height;
    float *sums; /* of all pixels above and left of a corner: (width + 1) x (height + 1) */
};

struct density *density_new(unsigned width, unsigned height)
{
    struct density *density = allocate(1, sizeof *density);
    *density = (struct density){width, height, allocate((size_t)(width + 1) * (height + 1), sizeof(float))};
    return density;
}

void density_free(struct density *density)
{
    if (!density)
        return;
    free(density->sums);
    free(density);
}

/* A walk through an LZ4 block: each literal or match counts its own bytes in the block, spread evenly over the pixels that
 * it stands for. */
struct spread {
    const struct density *density;
    const struct piece *piece;
    double pixels_a_byte; /* of the uncompressed form */
    size_t at;            /* in it */
};

static void spread(struct spread *s, size_t length, double bytes)
{
    const struct glint_box *box = &s->piece->box;
    const size_t pixels = (size_t)box->w * box->h, from = (size_t)((double)s->at * s->pixels_a_byte);
    s->at += length;
    size_t end = (size_t)((double)s->at * s->pixels_a_byte);
    if (end <= from)
        end = from + 1;
    for (size_t i = from; i < end && i < pixels; i++) {
        const size_t x = box->x + i % box->w, y = box->y + i / box->w;
        s->density->sums[(y + 1) * (s->density->width + 1) + x + 1] += (float)(bytes / (double)(end - from));
    }
}

/* The rest of a length whose nibble is 15: bytes are added until one is below 255. */
static size_t rest_of_length(const struct piece *piece, size_t *at)
{
    size_t length = 0;
    while (*at < piece->bytes) {
        const uint8_t byte = piece->data[(*at)++];
        length += byte;
        if (byte < 255)
            break;
    }
    return length;
}

/* Sequences as in lz4_Block_format.md: token, more literal length, literals, offset, more match length. Literals cost one
 * byte each; token, lengths and offset are the price of the match. */
static void add_block(struct spread *s)
{
    const struct piece *piece = s->piece;
    for (size_t at = 0; at < piece->bytes;) {
        const size_t start = at;
        const uint8_t token = piece->data[at++];
        size_t literals = token >> 4, match = token & 15;
        if (literals == 15)
            literals += rest_of_length(piece, &at);
        const size_t head = at - start;
        at += literals;
        spread(s, literals, (double)literals);
        if (at >= piece->bytes)
            return;
        const size_t tail = at;
        at += 2;
        if (match == 15)
            match += rest_of_length(piece, &at);
        spread(s, match + 4, (double)(head + at - tail));
    }
}

/* Spreads the bytes over the pixels, then turns them into sums of all pixels above and left, so that any box takes four
 * look-ups. */
void density_measure(struct density *density, const struct piece *pieces, size_t count)
{
    const size_t stride = density->width + 1;
    memset(density->sums, 0, stride * (density->height + 1) * sizeof *density->sums);
    for (size_t i = 0; i < count; i++) {
        const struct piece *piece = &pieces[i];
        struct spread s = {density, piece, (double)piece->box.w * piece->box.h / (double)piece->length, 0};
        if (piece->lz4)
            add_block(&s);
        else
            spread(&s, piece->length, (double)piece->length);
    }
    for (size_t y = 1; y <= density->height; y++) {
        float line = 0;
        for (size_t x = 1; x <= density->width; x++) {
            line += density->sums[y * stride + x];
            density->sums[y * stride + x] = density->sums[(y - 1) * stride + x] + line;
        }
    }
}

double density_bytes(const struct density *density, const struct glint_box *box)
{
    const size_t stride = density->width + 1, left = box->x, right = left + box->w;
    const float *top = &density->sums[box->y * stride], *bottom = &density->sums[(size_t)(box->y + box->h) * stride];
    return (double)bottom[right] - (double)bottom[left] - (double)top[right] + (double)top[left];
}
