/* SPDX-License-Identifier: MIT
 * Sink gpio: a panel whose every wire is a GPIO line. */
#include <stdlib.h>

#include "gpio_chip.h"
#include "gpio_display.h"
#include "gpio_lines.h"
#include "host.h"

static struct sink *open_gpio(const struct sink_wish *wish)
{
    return gpio_display_open(&sink_gpio, gpio_options_ready(false), wish);
}

static char *library(void)
{
    char *text;
    if (asprintf(&text, "libgpiod %s", gpio_library_version()) < 0)
        fail("out of memory");
    return text;
}

const struct sink_kind sink_gpio = {
    .name = "gpio",
    .summary = "a panel (ST7789, ILI9341) on GPIO lines, SPI or 8080",
    .nature = SINK_DEVICE,
    .options = &gpio_options_argp,
    .open = open_gpio,
    .send = gpio_display_send,
    .close = gpio_display_close,
    .list = gpio_lines_list,
    .list_print = gpio_lines_print,
    .library = library,
};
