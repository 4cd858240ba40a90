/* SPDX-License-Identifier: MIT */
#include "lines.h"

#include <gpiod.h>
#include <stdlib.h>

struct lines {
    struct gpiod_chip *chip;
    struct gpiod_line_request *request;
    size_t count;
};

static struct gpiod_line_request *request_outputs(struct gpiod_chip *chip, const int *values, size_t count)
{
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    struct gpiod_line_config *lines = gpiod_line_config_new();
    struct gpiod_request_config *request = gpiod_request_config_new();
    if (!settings || !lines || !request)
        abort();
    gpiod_request_config_set_consumer(request, "bitbang");
    gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_OUTPUT);
    int failed = 0;
    for (unsigned i = 0; i < count; i++) {
        gpiod_line_settings_set_output_value(settings, values[i] ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE);
        failed |= gpiod_line_config_add_line_settings(lines, &i, 1, settings);
    }
    struct gpiod_line_request *made = failed ? NULL : gpiod_chip_request_lines(chip, request, lines);
    gpiod_request_config_free(request);
    gpiod_line_config_free(lines);
    gpiod_line_settings_free(settings);
    return made;
}

struct lines *lines_open(const char *chip_path, const int *values, size_t count)
{
    struct lines *lines = calloc(1, sizeof *lines);
    if (!lines)
        return NULL;
    lines->count = count;
    lines->chip = gpiod_chip_open(chip_path);
    if (lines->chip && (lines->request = request_outputs(lines->chip, values, count)))
        return lines;
    lines_close(lines);
    return NULL;
}

int lines_set(struct lines *lines, const int *values)
{
    enum gpiod_line_value all[LINES_MAX];
    for (size_t i = 0; i < lines->count; i++)
        all[i] = values[i] ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
    return gpiod_line_request_set_values(lines->request, all);
}

void lines_close(struct lines *lines)
{
    if (lines->request)
        gpiod_line_request_release(lines->request);
    if (lines->chip)
        gpiod_chip_close(lines->chip);
    free(lines);
}
