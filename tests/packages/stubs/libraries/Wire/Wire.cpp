/* SPDX-License-Identifier: MIT */
#include "Wire.h"

TwoWire Wire;

enum { ADDRESS = 0x68, PWR_MGMT_1 = 0x6b, ACCEL_XOUT_H = 0x3b };

size_t TwoWire::write(uint8_t byte)
{
    if (_count++ == 0)
        _register = byte;
    else if (_register == PWR_MGMT_1)
        _power = byte;
    return 1;
}

uint8_t TwoWire::endTransmission(bool)
{
    return _address == ADDRESS ? 0 : 2; /* 2: the address was not answered */
}

uint8_t TwoWire::requestFrom(uint8_t address, uint8_t count)
{
    if (address != ADDRESS)
        return 0;
    _readings += _register == ACCEL_XOUT_H;
    _at = 0;
    return count;
}

int TwoWire::read()
{
    static const int16_t flat[3] = {0, 0, 16384}, tilted[3] = {-8192, 0, 14189};
    const unsigned at = _register + _at++ - (unsigned)ACCEL_XOUT_H;
    if (at > 5 || _power & 0x40)
        return 0;
    const int noise = (int)((_readings * 37 + at / 2 * 11) % 61) - 30;
    const unsigned value = (unsigned)((_readings > 20 ? tilted : flat)[at / 2] + noise);
    return (int)(at % 2 ? value & 255 : value >> 8 & 255);
}
