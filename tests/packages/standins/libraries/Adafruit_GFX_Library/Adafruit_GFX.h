/* SPDX-License-Identifier: MIT
 * The part of Adafruit GFX 1.12.6 that the examples call, with its signatures. As in the library, the canvas lies on the heap, and
 * getBuffer is NULL where that had too little room. */
#ifndef STUB_ADAFRUIT_GFX_H
#define STUB_ADAFRUIT_GFX_H

#include <stdint.h>
#include <stdlib.h>

class GFXcanvas16
{
  public:
    GFXcanvas16(uint16_t w, uint16_t h) : buffer((uint16_t *)calloc((size_t)w * h, 2))
    {
    }
    uint16_t *getBuffer(void) const
    {
        return buffer;
    }

  private:
    uint16_t *buffer;
};

#endif
