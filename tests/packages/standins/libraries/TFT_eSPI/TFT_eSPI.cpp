/* SPDX-License-Identifier: MIT
 * A panel of RGB565, high byte first: prints a picture's place, its pixel at the highlight and a checksum. */
#include "TFT_eSPI.h"

#include <Arduino.h>

void TFT_eSPI::pushImage(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t *data)
{
    const uint8_t *bytes = (const uint8_t *)data;
    uint32_t sum = 0;
    unsigned marked = 0;
    for (int32_t i = 0; i < w * h; i++) {
        const unsigned first = bytes[2 * i + _swapBytes], second = bytes[2 * i + !_swapBytes];
        const unsigned pixel = first << 8 | second;
        sum = sum * 31 + pixel;
        if (i == 20 * 64 + 20)
            marked = pixel;
    }
    Serial.print((long)x);
    Serial.print(',');
    Serial.print((long)y);
    Serial.print(' ');
    Serial.print(marked, HEX);
    Serial.print(' ');
    Serial.println((unsigned long)sum, HEX);
}
