/* SPDX-License-Identifier: MIT
 * All GPIO chips that there are. */
#ifndef GLINT_WIRES_CHIPS_H
#define GLINT_WIRES_CHIPS_H

#include "sinks/wires/chip.h"

enum { PATH_ROOM = 300 };

struct gpio_chips {
    struct gpio_chip **open; /* NULL where it could not be */
    int *reasons;            /* the errno, where it could not */
    char **names;            /* in /dev, in order */
    unsigned count;
};
struct gpio_chips gpio_chips_open(void);
/* All but `kept`. */
void gpio_chips_close(struct gpio_chips *chips, const struct gpio_chip *kept);
/* A link in /dev to one before it, as Raspberry Pi OS has gpiochip4 for the Pi 5's gpiochip0. */
bool gpio_chips_is_again(const struct gpio_chips *chips, unsigned i);

#endif
