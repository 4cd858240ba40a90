/* SPDX-License-Identifier: MIT */
#include "Wire.h"

TwoWire Wire;

#ifndef WIRE_QMI8658
#define WIRE_QMI8658 0
#endif
#ifndef WIRE_NEVER_NEW
#define WIRE_NEVER_NEW 0
#endif

#if WIRE_QMI8658 /* its address, 0x6a or 0x6b */
enum { ADDRESS = WIRE_QMI8658, WHO = 0x00, IS = 0x05, STATUS = 0x2e, FIRST = 0x35, HIGH = 1 };
/* On, +-2 g, addresses that count up. */
bool TwoWire::is_set_up() const
{
    return (_registers[0x08] & 1) && (_registers[0x03] & 0x70) == 0 && (_registers[0x02] & 0x41) == 0x40;
}
#else
enum { ADDRESS = 0x68, WHO = 0x75, IS = 0x68, STATUS = 0xff, FIRST = 0x3b, HIGH = 0 };
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
    _is_mixed = _register == FIRST && WIRE_QMI8658 != 0 && !WIRE_NEVER_NEW && !_is_new;
    _is_new = _register == STATUS && !WIRE_NEVER_NEW && ++_looks % 3 == 0;
    return count;
}

static unsigned value_of(unsigned reading, unsigned axis)
{
    static const int16_t flat[3] = {0, 0, 16384}, tilted[3] = {-8192, 0, 14189};
    const int noise = (int)((reading * 37 + axis * 11) % 61) - 30;
    return (unsigned)((reading > 20 ? tilted : flat)[axis] + noise);
}

int TwoWire::read()
{
    const unsigned at = _register + _at++ - (unsigned)FIRST;
    if (_register == WHO && _at == 1)
        return IS;
    if (_register == STATUS)
        return _is_new && is_set_up();
    if (at > 5 || !is_set_up())
        return 0;
    const bool is_high = at % 2 == HIGH;
    const unsigned value = value_of(_readings + (_is_mixed && is_high), at / 2);
    return (int)(is_high ? value >> 8 & 255 : value & 255);
}
