/* SPDX-License-Identifier: MIT */
/* bitbang spi|i80 CHIP WIDTH HEIGHT: sends the known bytes to a display, as simply as libgpiod allows. It proves the
 * lab's capture and decoders without the code that they are there to test. */
#include "known.h"
#include "lines.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static _Noreturn void give_up(const char *what)
{
    fprintf(stderr, "bitbang: %s: %s\n", what, strerror(errno));
    exit(1);
}

static void set(struct lines *lines, const int *values)
{
    if (lines_set(lines, values) != 0)
        give_up("lines");
}

static void send_spi(struct lines *lines, int *values, bus_byte byte)
{
    values[SPI_DC] = (byte & BUS_DATA) != 0;
    for (int bit = 7; bit >= 0; bit--) {
        values[SPI_MOSI] = byte >> bit & 1;
        values[SPI_SCK] = 0;
        set(lines, values);
        values[SPI_SCK] = 1;
        set(lines, values);
    }
}

static void send_i80(struct lines *lines, int *values, bus_byte byte)
{
    values[I80_DC] = (byte & BUS_DATA) != 0;
    for (int bit = 0; bit < 8; bit++)
        values[I80_D0 + bit] = byte >> bit & 1;
    values[I80_WR] = 0;
    set(lines, values);
    values[I80_WR] = 1;
    set(lines, values);
}

static const struct bus {
    size_t lines;
    unsigned reset, select;
    int idle[LINES_MAX];
    void (*send)(struct lines *lines, int *values, bus_byte byte);
} SPI = {SPI_LINES, SPI_RST, SPI_CS, {[SPI_CS] = 1, [SPI_RST] = 1}, send_spi},
  I80 = {I80_LINES, I80_RST, I80_CS, {[I80_WR] = 1, [I80_CS] = 1, [I80_RST] = 1}, send_i80};

int main(int argc, char **argv)
{
    if (argc != 5) {
        fputs("usage: bitbang spi|i80 CHIP WIDTH HEIGHT\n", stderr);
        return 2;
    }
    const struct bus *bus = strcmp(argv[1], "spi") == 0 ? &SPI : &I80;
    int values[LINES_MAX];
    memcpy(values, bus->idle, sizeof values);
    struct lines *lines = lines_open(argv[2], values, bus->lines);
    if (!lines)
        give_up(argv[2]);
    values[bus->reset] = 0;
    set(lines, values);
    values[bus->reset] = 1;
    set(lines, values);
    values[bus->select] = 0;
    set(lines, values);
    size_t count;
    bus_byte *bytes = known_bytes((unsigned)atoi(argv[3]), (unsigned)atoi(argv[4]), &count);
    for (size_t i = 0; i < count; i++)
        bus->send(lines, values, bytes[i]);
    set(lines, bus->idle);
    lines_close(lines);
    free(bytes);
    return 0;
}
