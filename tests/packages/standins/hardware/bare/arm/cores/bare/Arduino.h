/* SPDX-License-Identifier: MIT
 * What the examples call of Arduino, with its signatures: on the host's standard output, or on a bare Cortex-M's semihosting. For tests. */
#ifndef STUB_ARDUINO_H
#define STUB_ARDUINO_H

#include <stddef.h>
#include <stdint.h>

#define DEC 10
#define HEX 16

class Stub_Serial
{
  public:
    void begin(unsigned long)
    {
    }
    void print(char c);
    void print(const char *text);
    void print(unsigned long value, int base = DEC);
    void print(long value, int base = DEC);
    void print(unsigned value, int base = DEC)
    {
        print((unsigned long)value, base);
    }
    void print(int value, int base = DEC)
    {
        print((long)value, base);
    }
    template <class Value> void println(Value value)
    {
        print(value);
        print('\n');
    }
    template <class Value> void println(Value value, int base)
    {
        print(value, base);
        print('\n');
    }
};
extern Stub_Serial Serial;

inline void delayMicroseconds(unsigned)
{
}

void setup();
void loop();

#endif
