/* SPDX-License-Identifier: MIT
 * GPIO lines as users name them, found on whichever chip has them and driven together. */
#ifndef GLINT_GPIO_LINES_H
#define GLINT_GPIO_LINES_H

#include <jansson.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

struct gpio_line_wish {
    const char *origin; /* where it was asked for: "--lines", "pins.ini:7" */
    const char *role;   /* what for: "sck" */
    const char *text;   /* NAME, CHIP:OFFSET or CHIP:NAME; OFFSET where a chip is given. A ! before it: active low */
    bool high;          /* its level at first */
    bool busy;          /* it changes with every byte: the kernel is not to set the others each time, too */
};

/* All as outputs, held by "glint". `chip` (a name, a label, a path or a number): where lines are that name none; NULL:
 * anywhere. Ends the program through fail() with one line where one cannot be had. */
struct gpio_lines *gpio_lines_open(const char *chip, const struct gpio_line_wish *wishes, unsigned count);
/* Bit i of levels is wish i: one call of the kernel for each chip where something changes. 0 or an errno. */
int gpio_lines_set(struct gpio_lines *lines, uint32_t levels);
void gpio_lines_close(struct gpio_lines *lines);
const char *gpio_lines_chip(const struct gpio_lines *lines, unsigned i); /* "gpiochip0" */

/* For `glint list`. */
json_t *gpio_lines_list(void);
void gpio_lines_print(const json_t *chips, FILE *stream);

#endif
