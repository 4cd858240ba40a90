/* SPDX-License-Identifier: MIT
 * libgpiod 1. */
#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "sinks/wires/chip.h"

struct gpio_chip {
    struct gpiod_chip *gpiod;
};

struct gpio_chip *gpio_chip_open(const char *path)
{
    struct gpiod_chip *gpiod = gpiod_chip_open(path);
    if (!gpiod)
        return NULL;
    struct gpio_chip *chip = allocate(1, sizeof *chip);
    chip->gpiod = gpiod;
    return chip;
}

void gpio_chip_close(struct gpio_chip *chip)
{
    gpiod_chip_close(chip->gpiod);
    free(chip);
}

const char *gpio_chip_name(const struct gpio_chip *chip)
{
    return gpiod_chip_name(chip->gpiod);
}

const char *gpio_chip_label(const struct gpio_chip *chip)
{
    return gpiod_chip_label(chip->gpiod);
}

unsigned gpio_chip_lines(const struct gpio_chip *chip)
{
    return gpiod_chip_num_lines(chip->gpiod);
}

static void copy(char out[GPIO_NAME_MAX], const char *text)
{
    snprintf(out, GPIO_NAME_MAX, "%s", text ? text : "");
}

bool gpio_chip_line(struct gpio_chip *chip, unsigned offset, struct gpio_line *line)
{
    struct gpiod_line *gpiod = gpiod_chip_get_line(chip->gpiod, offset);
    if (!gpiod || gpiod_line_update(gpiod) != 0)
        return false;
    copy(line->name, gpiod_line_name(gpiod));
    copy(line->consumer, gpiod_line_consumer(gpiod));
    line->used = gpiod_line_is_used(gpiod);
    return true;
}

struct gpio_request {
    struct gpiod_line_bulk bulk;
};

static void spread(int *values, unsigned count, uint32_t levels)
{
    for (unsigned i = 0; i < count; i++)
        values[i] = (int)(levels >> i & 1);
}

struct gpio_request *gpio_request_outputs(struct gpio_chip *chip, const unsigned *offsets, unsigned count,
                                          uint32_t levels)
{
    struct gpio_request *request = allocate(1, sizeof *request);
    int values[GPIO_REQUEST_MAX];
    spread(values, count, levels);
    gpiod_line_bulk_init(&request->bulk);
    bool good = true;
    for (unsigned i = 0; good && i < count; i++) {
        struct gpiod_line *line = gpiod_chip_get_line(chip->gpiod, offsets[i]);
        good = line != NULL;
        gpiod_line_bulk_add(&request->bulk, line);
    }
    if (good && gpiod_line_request_bulk_output(&request->bulk, "glint", values) == 0)
        return request;
    const int reason = errno;
    free(request);
    errno = reason;
    return NULL;
}

int gpio_request_set(struct gpio_request *request, uint32_t levels)
{
    int values[GPIO_REQUEST_MAX];
    spread(values, request->bulk.num_lines, levels);
    return gpiod_line_set_value_bulk(&request->bulk, values) == 0 ? 0 : errno;
}

void gpio_request_release(struct gpio_request *request)
{
    gpiod_line_release_bulk(&request->bulk);
    free(request);
}

const char *gpio_library_version(void)
{
    return gpiod_version_string();
}
