/* SPDX-License-Identifier: MIT */
#include "sinks/wires/chips.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "sinks/wires/device.h"

struct gpio_chips gpio_chips_open(void)
{
    struct gpio_chips chips;
    chips.count = device_names("gpiochip", &chips.names);
    chips.open = allocate(chips.count + 1, sizeof(struct gpio_chip *));
    chips.reasons = allocate(chips.count + 1, sizeof(int));
    for (unsigned i = 0; i < chips.count; i++) {
        char path[PATH_ROOM];
        snprintf(path, sizeof path, "/dev/%s", chips.names[i]);
        chips.open[i] = gpio_chip_open(path);
        chips.reasons[i] = chips.open[i] ? 0 : errno;
    }
    return chips;
}

void gpio_chips_close(struct gpio_chips *chips, const struct gpio_chip *kept)
{
    for (unsigned i = 0; i < chips->count; i++)
        if (chips->open[i] && chips->open[i] != kept)
            gpio_chip_close(chips->open[i]);
    free(chips->open);
    free(chips->reasons);
    device_names_free(chips->names, chips->count);
}

bool gpio_chips_is_again(const struct gpio_chips *chips, unsigned i)
{
    for (unsigned k = 0; k < i && chips->open[i]; k++)
        if (chips->open[k] && strcmp(gpio_chip_name(chips->open[k]), gpio_chip_name(chips->open[i])) == 0)
            return true;
    return false;
}
