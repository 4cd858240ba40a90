/* SPDX-License-Identifier: MIT
 * The bytes of a panel on wires: bit by bit or byte by byte on GPIO lines, or through the kernel's SPI device. */
#ifndef GLINT_GPIO_BUS_H
#define GLINT_GPIO_BUS_H

#include "sinks/wires/options.h"
#include "panel.h"

/* Takes the lines and the device; ends the program through fail() where it cannot. The options must outlive it. */
struct gpio_bus *gpio_bus_open(const struct gpio_options *options);
/* Its calls fail once the wires do: then this is the errno of the first failure. */
int gpio_bus_error(const struct gpio_bus *bus);
const char *gpio_bus_name(const struct gpio_bus *bus); /* "gpiochip0", "/dev/spidev0.0" */
struct panel_bus gpio_bus_panel(struct gpio_bus *bus);
void gpio_bus_close(struct gpio_bus *bus);

#endif
