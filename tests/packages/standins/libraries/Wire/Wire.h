/* SPDX-License-Identifier: MIT
 * The part of Arduino's Wire that the examples call, with its signatures, and an MPU-6050 or a QMI8658 (WIRE_QMI8658) on it: zeros until it is set up, flat for 20
 * readings, then tilted to the right by 30 degrees, with the noise of a few codes. */
#ifndef STUB_WIRE_H
#define STUB_WIRE_H

#include <stddef.h>
#include <stdint.h>

class TwoWire
{
  public:
    void begin()
    {
    }
    void beginTransmission(uint8_t address)
    {
        _address = address;
        _count = 0;
    }
    size_t write(uint8_t byte);
    uint8_t endTransmission(bool stop = true);
    uint8_t requestFrom(uint8_t address, uint8_t count);
    int read();

  private:
    bool is_set_up() const;
    uint8_t _address = 0, _register = 0, _count = 0, _at = 0;
    uint16_t _registers[128] = {}; /* 0x100 and what was written */
    unsigned _readings = 0;
};
extern TwoWire Wire;

#endif
