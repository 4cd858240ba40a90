/* SPDX-License-Identifier: MIT */
#include "unit.h"

#include "lab.h"

size_t decode_spi(const struct capture *capture, bus_byte *bytes, size_t room)
{
    const struct chip *chip = capture->chip;
    const unsigned sck = chip_line(chip, "SCK"), mosi = chip_line(chip, "MOSI"), cs = chip_line(chip, "CS"),
                   dc = chip_line(chip, "DC");
    bool high[LAB_LINES_MAX];
    capture_levels(capture, high);
    size_t count = 0;
    unsigned bits = 0, value = 0, data = 0;
    for (size_t i = 0; i < capture->count; i++) {
        const unsigned line = capture->sets[i] & CAPTURE_LINE;
        const bool before = high[line];
        high[line] = capture->sets[i] & CAPTURE_HIGH;
        if (line == cs && high[cs] && bits)
            fail_msg("chip select ends %u bits into byte %zu", bits, count);
        if (line != sck || before || !high[sck] || high[cs])
            continue;
        value = (value << 1 | high[mosi]) & 0xff;
        if (bits == 0)
            data = high[dc];
        else if (data != high[dc])
            fail_msg("D/C changes %u bits into byte %zu", bits, count);
        if (++bits == 8) {
            assert_true(count < room);
            bytes[count++] = (bus_byte)(data * BUS_DATA | value);
            bits = 0;
        }
    }
    assert_int_equal(bits, 0);
    return count;
}

bool clock_at_rest(const struct capture *capture)
{
    const unsigned sck = chip_line(capture->chip, "SCK"), cs = chip_line(capture->chip, "CS");
    bool high[LAB_LINES_MAX];
    capture_levels(capture, high);
    unsigned rests[2] = {0}; /* low, high */
    for (size_t i = 0; i < capture->count; i++) {
        const unsigned line = capture->sets[i] & CAPTURE_LINE;
        const bool before = high[line];
        high[line] = capture->sets[i] & CAPTURE_HIGH;
        rests[high[sck]] += line == cs && before != high[cs];
    }
    assert_true((rests[0] == 0) != (rests[1] == 0));
    return rests[1];
}

size_t decode_i80(const struct capture *capture, bus_byte *bytes, size_t room)
{
    static const char *const DATA[8] = {"D0", "D1", "D2", "D3", "D4", "D5", "D6", "D7"};
    const struct chip *chip = capture->chip;
    const unsigned wr = chip_line(chip, "WR"), cs = chip_line(chip, "CS"), dc = chip_line(chip, "DC");
    unsigned bit[LAB_LINES_MAX] = {0}; /* of the byte */
    for (unsigned i = 0; i < 8; i++)
        bit[chip_line(chip, DATA[i])] = 1u << i;
    bool high[LAB_LINES_MAX];
    capture_levels(capture, high);
    size_t count = 0;
    unsigned value = 0; /* every line is set when it is asked for */
    for (size_t i = 0; i < capture->count; i++) {
        const unsigned line = capture->sets[i] & CAPTURE_LINE;
        const bool before = high[line];
        high[line] = capture->sets[i] & CAPTURE_HIGH;
        value = high[line] ? value | bit[line] : value & ~bit[line];
        if (line != wr || before || !high[wr] || high[cs])
            continue;
        assert_true(count < room);
        bytes[count++] = (bus_byte)(high[dc] * BUS_DATA | value);
    }
    return count;
}
