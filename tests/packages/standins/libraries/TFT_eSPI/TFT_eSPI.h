/* SPDX-License-Identifier: MIT
 * The part of TFT_eSPI 2.5.44 that the examples call, with its signatures. As the library does, pushImage sends the bytes of its pixels in the order
 * that they have in memory while setSwapBytes is false, and swaps them otherwise; the host's stand-in prints what a panel gets. */
#ifndef STUB_TFT_ESPI_H
#define STUB_TFT_ESPI_H

#include <stdint.h>

#define TFT_BLACK 0x0000

class TFT_eSPI
{
  public:
    void init(uint8_t tc = 0)
    {
        (void)tc;
    }
    void fillScreen(uint32_t color)
    {
        (void)color;
    }
    void setSwapBytes(bool swap)
    {
        _swapBytes = swap;
    }
    void pushImage(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t *data);

  private:
    bool _swapBytes = false;
};

#endif
