/* SPDX-License-Identifier: MIT */
#include "Wire.h"

TwoWire Wire;

#ifndef WIRE_QMI8658
#define WIRE_QMI8658 0
#endif

#if WIRE_QMI8658 /* its address, 0x6a or 0x6b */
enum { ADDRESS = WIRE_QMI8658, WHO = 0x00, IS = 0x05, FIRST = 0x35, HIGH = 1 };
/* On, +-2 g, addresses that count up. */
bool TwoWire::is_set_up() const
{
    return (_registers[0x08] & 1) && (_registers[0x03] & 0x70) == 0 && (_registers[0x02] & 0x41) == 0x40;
}
#else
enum { ADDRESS = 0x68, WHO = 0x75, IS = 0x68, FIRST = 0x3b, HIGH = 0 };
/* Awake, +-2 g. */
bool TwoWire::is_set_up() const
{
    return _registers[0x6b] && !(_registers[0x6b] & 0x40) && (_registers[0x1c] & 0x18) == 0;
}
#endif

size_t TwoWire::write(uint8_t byte)
{
    if (_count++ == 0)
        _register = byte;
    else if (_address == ADDRESS)
        _registers[_register++ & 127] = (uint16_t)(0x100 | byte);
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
    _readings += _register == FIRST;
    _at = 0;
    return count;
}

int TwoWire::read()
{
    static const int16_t flat[3] = {0, 0, 16384}, tilted[3] = {-8192, 0, 14189};
    const unsigned at = _register + _at++ - (unsigned)FIRST;
    if (_register == WHO && _at == 1)
        return IS;
    if (at > 5 || !is_set_up())
        return 0;
    const int noise = (int)((_readings * 37 + at / 2 * 11) % 61) - 30;
    const unsigned value = (unsigned)((_readings > 20 ? tilted : flat)[at / 2] + noise);
    return (int)(at % 2 == HIGH ? value >> 8 & 255 : value & 255);
}
