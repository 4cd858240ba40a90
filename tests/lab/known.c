/* SPDX-License-Identifier: MIT */
#include "known.h"

#include <stdlib.h>

const char *const SPI_NAMES[SPI_LINES] = {"SCK", "MOSI", "CS", "DC", "RST"};
const char *const I80_NAMES[I80_LINES] = {"D0", "D1", "D2", "D3", "D4", "D5", "D6", "D7", "WR", "CS", "DC", "RST"};

uint16_t known_pixel(size_t index)
{
    return (uint16_t)((uint32_t)index * 40503 + 0x1234);
}

static bus_byte *put(bus_byte *at, unsigned command, const uint8_t *data, size_t count)
{
    *at++ = (bus_byte)command;
    for (size_t i = 0; i < count; i++)
        *at++ = (bus_byte)(BUS_DATA | data[i]);
    return at;
}

static bus_byte *put_window(bus_byte *at, unsigned command, unsigned size)
{
    const uint8_t data[] = {0, 0, (uint8_t)((size - 1) >> 8), (uint8_t)(size - 1)};
    return put(at, command, data, sizeof data);
}

bus_byte *known_bytes(unsigned width, unsigned height, size_t *count)
{
    bus_byte *bytes = malloc((40 + 2 * (size_t)width * height) * sizeof *bytes), *at = bytes;
    if (!bytes)
        abort();
    at = put(at, 0x11, NULL, 0);
    at = put(at, 0x36, &(uint8_t){0x60}, 1);
    at = put(at, 0x3a, &(uint8_t){0x55}, 1);
    at = put_window(at, 0x2a, width);
    at = put_window(at, 0x2b, height);
    at = put(at, 0x29, NULL, 0);
    at = put(at, 0x2c, NULL, 0);
    for (size_t i = 0; i < (size_t)width * height; i++) {
        *at++ = (bus_byte)(BUS_DATA | known_pixel(i) >> 8);
        *at++ = (bus_byte)(BUS_DATA | (known_pixel(i) & 0xff));
    }
    at = put(at, 0x00, NULL, 0); /* no operation: sigrok tells a command when the next one comes */
    *count = (size_t)(at - bytes);
    return bytes;
}
