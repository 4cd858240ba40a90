/* SPDX-License-Identifier: MIT */
#include "plan/changes.h"

#include <string.h>

#include "base/memory.h"
#include "image/format.h"

void changes_init(struct changes *changes, uint16_t width, uint16_t height)
{
    *changes = (struct changes){.width = width, .height = height, .marks = allocate((size_t)width * height, 1)};
}

/* Of pixels that share a byte: their bits. */
static bool differs(const uint8_t *a, const uint8_t *b, size_t x, size_t bytes, size_t shared)
{
    const size_t bits = 8 / shared, down = 8 - bits - x % shared * bits;
    return shared == 1 ? memcmp(&a[x * bytes], &b[x * bytes], bytes) != 0
                       : ((unsigned)(a[x / shared] ^ b[x / shared]) >> down & ((1u << bits) - 1)) != 0;
}

/* Marks each pixel that differs and grows a box around the marks. A line that is equal as a whole, as most are, costs one
 * memcmp; without a frame before, every pixel counts as changed. */
void changes_find(struct changes *changes, const uint8_t *last, const struct frame *now)
{
    const size_t bytes = format_line_bytes(now->format, 1), shared = format_byte_pixels(now->format);
    unsigned left = now->width, right = 0, top = now->height, bottom = 0;
    changes->count = 0;
    for (unsigned y = 0; y < now->height; y++) {
        const uint8_t *a = last ? &last[y * now->line_bytes] : NULL, *b = &now->pixels[y * now->line_bytes];
        uint8_t *marks = &changes->marks[(size_t)y * now->width];
        memset(marks, !last, now->width);
        if (last && memcmp(a, b, now->line_bytes) == 0)
            continue;
        unsigned first = now->width, end = 0;
        for (unsigned x = 0; x < now->width; x++) {
            if (last && !differs(a, b, x, bytes, shared))
                continue;
            marks[x] = 1;
            changes->count++;
            end = x + 1;
            if (first > x)
                first = x;
        }
        if (!end)
            continue;
        left = first < left ? first : left;
        right = end > right ? end : right;
        top = y < top ? y : top;
        bottom = y + 1;
    }
    changes->bounds = (struct glint_box){0, 0, 0, 0};
    if (changes->count)
        changes->bounds =
            (struct glint_box){(uint16_t)left, (uint16_t)top, (uint16_t)(right - left), (uint16_t)(bottom - top)};
}
