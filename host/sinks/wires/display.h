/* SPDX-License-Identifier: MIT
 * What the sinks gpio and spi have in common: a panel on wires. */
#ifndef GLINT_GPIO_DISPLAY_H
#define GLINT_GPIO_DISPLAY_H

#include "sinks/wires/options.h"
#include "sinks/sink.h"

struct sink *gpio_display_open(const struct gpio_options *options, const struct sink_wish *wish);
enum sink_result gpio_display_send(struct sink *sink, const struct frame *frame, const struct piece *pieces,
                                   size_t count);
void gpio_display_close(struct sink *sink);

#endif
