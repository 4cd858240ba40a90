/* SPDX-License-Identifier: MIT
 * Which line a user means. */
#ifndef GLINT_GPIO_FIND_H
#define GLINT_GPIO_FIND_H

#include "sinks/wires/chip.h"
#include "sinks/wires/lines.h"

struct gpio_found {
    struct gpio_chip *chip; /* open, yours */
    unsigned offset;
};
/* Ends the program through fail() where there is none, or more than one. */
struct gpio_found gpio_find(const char *chip, const struct gpio_line_wish *wish);

/* How many letters must be changed, added, removed or exchanged with their neighbour to make b of a, upper and lower case
 * alike. */
unsigned letters_apart(const char *a, const char *b);

#endif
