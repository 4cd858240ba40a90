/* SPDX-License-Identifier: MIT
 * The options that describe the wires to a panel: from the command line, from a file, checked. */
#ifndef GLINT_GPIO_OPTIONS_H
#define GLINT_GPIO_OPTIONS_H

#include <argp.h>
#include <stdbool.h>
#include <stdint.h>

enum gpio_bus_kind {
    GPIO_BUS_SPI,   /* 4-wire, by lines */
    GPIO_BUS_8080,  /* 8 data lines and a strobe, by lines */
    GPIO_BUS_SPIDEV /* the kernel's SPI device; lines only for what it has not */
};

/* What lines are for. Some chips set lines one after the other, in this order: the clock falls before what it clocks changes,
 * and D/C stands before WR falls. */
enum gpio_role {
    ROLE_D0,
    ROLE_D7 = ROLE_D0 + 7,
    ROLE_SCK,
    ROLE_MOSI,
    ROLE_DC,
    ROLE_CS,
    ROLE_RD,
    ROLE_RESET,
    ROLE_BACKLIGHT,
    ROLE_WR,
    ROLES
};

struct gpio_options {
    enum gpio_bus_kind kind;
    const char *chip; /* NULL: any */
    struct {
        const char *origin, *text; /* text NULL: not wired */
    } lines[ROLES];
    const char *spidev;
    uint32_t spi_hz;
    bool clock_rests_high; /* SPI in mode 3, else 0 */
};

/* What both sinks take, what only sink gpio does, and what only sink spi does. */
extern const struct argp gpio_options_argp, gpio_line_options_argp, gpio_spidev_options_argp;
extern const char *const gpio_role_names[ROLES];

/* Checks that the bus has the lines it needs and no others: ends the program through
 * fail() where not. `spidev`: the kind that --bus cannot choose. */
const struct gpio_options *gpio_options_ready(bool spidev);

#endif
