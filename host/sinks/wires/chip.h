/* SPDX-License-Identifier: MIT
 * As much of libgpiod as glint uses: its versions 1 (gpio_chip_v1.c) and 2 (gpio_chip_v2.c), of which one is compiled in,
 * differ in every call. */
#ifndef GLINT_GPIO_CHIP_H
#define GLINT_GPIO_CHIP_H

#include <stdbool.h>
#include <stdint.h>

enum { GPIO_NAME_MAX = 32, GPIO_REQUEST_MAX = 32 };

struct gpio_chip;
struct gpio_chip *gpio_chip_open(const char *path); /* NULL: see errno */
void gpio_chip_close(struct gpio_chip *chip);
const char *gpio_chip_name(const struct gpio_chip *chip);  /* "gpiochip0" */
const char *gpio_chip_label(const struct gpio_chip *chip); /* what drives it: "pinctrl-bcm2711" */
unsigned gpio_chip_lines(const struct gpio_chip *chip);

struct gpio_line {
    char name[GPIO_NAME_MAX], consumer[GPIO_NAME_MAX]; /* empty where there is none */
    bool used;
};
bool gpio_chip_line(struct gpio_chip *chip, unsigned offset, struct gpio_line *line); /* false: see errno */

/* Lines of one chip as outputs, held until released; bit i of levels is the line at offsets[i]. They are always set all
 * together: version 1 mixes lines up that are set alone. */
struct gpio_request;
struct gpio_request *gpio_request_outputs(struct gpio_chip *chip, const unsigned *offsets, unsigned count,
                                          uint32_t levels);          /* NULL: see errno */
int gpio_request_set(struct gpio_request *request, uint32_t levels); /* 0 or an errno */
void gpio_request_release(struct gpio_request *request);

const char *gpio_library_version(void);

#endif
