/* SPDX-License-Identifier: MIT */
#include "lines.h"

#include <gpiod.h>
#include <stdlib.h>

struct lines {
    struct gpiod_chip *chip;
    struct gpiod_line_bulk bulk;
};

struct lines *lines_open(const char *chip_path, const int *values, size_t count)
{
    unsigned offsets[LINES_MAX];
    for (unsigned i = 0; i < count; i++)
        offsets[i] = i;
    struct lines *lines = calloc(1, sizeof *lines);
    if (lines && (lines->chip = gpiod_chip_open(chip_path)) &&
        gpiod_chip_get_lines(lines->chip, offsets, (unsigned)count, &lines->bulk) == 0 &&
        gpiod_line_request_bulk_output(&lines->bulk, "bitbang", values) == 0)
        return lines;
    if (lines)
        lines_close(lines);
    return NULL;
}

int lines_set(struct lines *lines, const int *values)
{
    return gpiod_line_set_value_bulk(&lines->bulk, values);
}

void lines_close(struct lines *lines)
{
    if (lines->chip)
        gpiod_chip_close(lines->chip); /* releases the lines */
    free(lines);
}
