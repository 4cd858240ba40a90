/* SPDX-License-Identifier: MIT
 * The part of Arduino's Wire that the examples call, with its signatures, and an MPU-6050 or a QMI8658 (WIRE_QMI8658) on it: zeros until it is set up, flat for 20
 * readings, then tilted to the right by 30 degrees, with the noise of a few codes. A
 * QMI8658 has a new sample at every third look at its STATUS0; read at another time its high bytes are of the next one. WIRE_NEVER_NEW: it never says so. */
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
    unsigned _readings = 0, _looks = 0;
    bool _is_new = false, _is_mixed = false;
};
extern TwoWire Wire;

#endif
