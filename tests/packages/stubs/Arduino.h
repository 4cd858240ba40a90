/* SPDX-License-Identifier: MIT
 * What the examples call of Arduino, on standard output: for tests. */
#ifndef STUB_ARDUINO_H
#define STUB_ARDUINO_H

#include <stdint.h>
#include <stdlib.h>

#define HEX 16

class Stub_Serial
{
  public:
    void begin(unsigned long)
    {
    }
    void print(long value);
    void print(char c);
    void println(long value, int base = 10);
    void println(const char *text);
};
extern Stub_Serial Serial;

void setup();
void loop();

#endif
