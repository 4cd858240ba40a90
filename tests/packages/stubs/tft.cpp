/* SPDX-License-Identifier: MIT
 * A panel of RGB565, high byte first: prints a checksum of a picture, and its pixel at the highlight. */
#include "TFT_eSPI.h"

#include <stdio.h>

void TFT_eSPI::pushImage(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t *data)
{
    const uint8_t *bytes = (const uint8_t *)data;
    uint32_t sum = 0;
    for (int32_t i = 0; i < w * h; i++) {
        const unsigned first = bytes[2 * i + _swapBytes], second = bytes[2 * i + !_swapBytes];
        const unsigned pixel = first << 8 | second;
        sum = sum * 31 + pixel;
        if (i == 20 * 64 + 20)
            printf("%d,%d %04x ", (int)x, (int)y, pixel);
    }
    printf("%08x\n", (unsigned)sum);
}
