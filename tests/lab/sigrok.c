/* SPDX-License-Identifier: MIT */
#include "unit.h"

#include "lab.h"

#include <stdio.h>
#include <stdlib.h>

/* The decoder parallel gives away a reference of Python's True (libsigrokdecode 0.5.3), so that Python aborts when all is
 * written. It writes byte by byte: to a file, as the reader of a pipe would be woken as often. */
char *sigrok(const struct capture *capture, const char *clock, size_t *size, const char *arguments)
{
    char path[256];
    snprintf(path, sizeof path, "%s/capture.vcd", getenv("TMPDIR"));
    capture_write_vcd(capture, path, clock);
    return run_for_output(size,
                          "{ sigrok-cli -I vcd -i '%s' %s >\"$TMPDIR/found\" 2>\"$TMPDIR/errors\" || grep -q "
                          "bool_dealloc \"$TMPDIR/errors\"; } && "
                          "cat \"$TMPDIR/found\"",
                          path, arguments);
}

static void agrees(const struct capture *capture, const bus_byte *bytes, size_t count, const char *decoder)
{
    size_t size;
    char *found = sigrok(capture, "SCK", &size, decoder);
    assert_int_equal(size, count);
    for (size_t i = 0; i < count; i++)
        if ((uint8_t)found[i] != (bytes[i] & 0xff))
            fail_msg("byte %zu is not %02x but %02x", i, bytes[i] & 0xff, (uint8_t)found[i]);
    free(found);
}

void sigrok_agrees_on_spi(const struct capture *capture, const bus_byte *bytes, size_t count)
{
    agrees(capture, bytes, count, "-P spi:clk=SCK:mosi=MOSI:cs=CS -B spi=mosi");
}

void sigrok_agrees_on_spi_mode_3(const struct capture *capture, const bus_byte *bytes, size_t count)
{
    agrees(capture, bytes, count, "-P spi:clk=SCK:mosi=MOSI:cs=CS:cpol=1:cpha=1 -B spi=mosi");
}

void sigrok_agrees_on_i80(const struct capture *capture, const bus_byte *bytes, size_t count)
{
    size_t size;
    char *found = sigrok(capture, "WR", &size,
                         "-P parallel:clk=WR:clock_edge=rising:d0=D0:d1=D1:d2=D2:d3=D3:d4=D4:d5=D5:d6=D6:d7=D7"
                         " -A parallel=items");
    FILE *lines = fmemopen(found, size, "r");
    assert_non_null(lines);
    for (size_t i = 0; i < count; i++) {
        unsigned byte;
        if (fscanf(lines, " parallel-1: %x", &byte) != 1 || byte != (bytes[i] & 0xff))
            fail_msg("byte %zu is not %02x but %02x", i, bytes[i] & 0xff, byte);
    }
    char more;
    assert_int_equal(fscanf(lines, " %c", &more), EOF);
    fclose(lines);
    free(found);
}
