/* SPDX-License-Identifier: MIT
 * libgpiod 2. */
#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "sinks/wires/chip.h"

struct gpio_chip {
    struct gpiod_chip *gpiod;
    struct gpiod_chip_info *info;
};

struct gpio_chip *gpio_chip_open(const char *path)
{
    struct gpiod_chip *gpiod = gpiod_chip_open(path);
    struct gpiod_chip_info *info = gpiod ? gpiod_chip_get_info(gpiod) : NULL;
    if (!info) {
        const int reason = errno;
        if (gpiod)
            gpiod_chip_close(gpiod);
        errno = reason;
        return NULL;
    }
    struct gpio_chip *chip = allocate(1, sizeof *chip);
    chip->gpiod = gpiod;
    chip->info = info;
    return chip;
}

void gpio_chip_close(struct gpio_chip *chip)
{
    gpiod_chip_info_free(chip->info);
    gpiod_chip_close(chip->gpiod);
    free(chip);
}

const char *gpio_chip_name(const struct gpio_chip *chip)
{
    return gpiod_chip_info_get_name(chip->info);
}

const char *gpio_chip_label(const struct gpio_chip *chip)
{
    return gpiod_chip_info_get_label(chip->info);
}

unsigned gpio_chip_lines(const struct gpio_chip *chip)
{
    return (unsigned)gpiod_chip_info_get_num_lines(chip->info);
}

static void copy(char out[GPIO_NAME_MAX], const char *text)
{
    snprintf(out, GPIO_NAME_MAX, "%s", text ? text : "");
}

bool gpio_chip_line(struct gpio_chip *chip, unsigned offset, struct gpio_line *line)
{
    struct gpiod_line_info *info = gpiod_chip_get_line_info(chip->gpiod, offset);
    if (!info)
        return false;
    copy(line->name, gpiod_line_info_get_name(info));
    copy(line->consumer, gpiod_line_info_get_consumer(info));
    line->used = gpiod_line_info_is_used(info);
    gpiod_line_info_free(info);
    return true;
}

struct gpio_request {
    struct gpiod_line_request *gpiod;
    unsigned count;
};

static void spread(enum gpiod_line_value *values, unsigned count, uint32_t levels)
{
    for (unsigned i = 0; i < count; i++)
        values[i] = levels >> i & 1 ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
}

/* The three objects that a request is made of; any may be NULL. */
static struct gpiod_line_request *ask(struct gpiod_chip *chip, const unsigned *offsets, unsigned count, uint32_t levels,
                                      struct gpiod_line_settings *settings, struct gpiod_line_config *lines,
                                      struct gpiod_request_config *config)
{
    enum gpiod_line_value values[GPIO_REQUEST_MAX];
    spread(values, count, levels);
    if (!settings || !lines || !config ||
        gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_OUTPUT) != 0 ||
        gpiod_line_config_add_line_settings(lines, offsets, count, settings) != 0 ||
        gpiod_line_config_set_output_values(lines, values, count) != 0)
        return NULL;
    gpiod_request_config_set_consumer(config, "glint");
    return gpiod_chip_request_lines(chip, config, lines);
}

struct gpio_request *gpio_request_outputs(struct gpio_chip *chip, const unsigned *offsets, unsigned count,
                                          uint32_t levels)
{
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    struct gpiod_line_config *lines = gpiod_line_config_new();
    struct gpiod_request_config *config = gpiod_request_config_new();
    struct gpiod_line_request *gpiod = ask(chip->gpiod, offsets, count, levels, settings, lines, config);
    const int reason = errno;
    gpiod_line_settings_free(settings);
    gpiod_line_config_free(lines);
    gpiod_request_config_free(config);
    errno = reason;
    if (!gpiod)
        return NULL;
    struct gpio_request *request = allocate(1, sizeof *request);
    request->gpiod = gpiod;
    request->count = count;
    return request;
}

int gpio_request_set(struct gpio_request *request, uint32_t levels)
{
    enum gpiod_line_value values[GPIO_REQUEST_MAX];
    spread(values, request->count, levels);
    return gpiod_line_request_set_values(request->gpiod, values) == 0 ? 0 : errno;
}

void gpio_request_release(struct gpio_request *request)
{
    gpiod_line_request_release(request->gpiod);
    free(request);
}

const char *gpio_library_version(void)
{
    return gpiod_api_version();
}
