/* SPDX-License-Identifier: MIT
 * Sink spi: a panel on the kernel's SPI device, with GPIO lines for D/C, reset and backlight. */
#include "sinks/panel/options.h"
#include "sinks/wires/display.h"
#include "sinks/wires/spidev.h"

static struct sink *open_spi(const struct sink_wish *wish)
{
    return gpio_display_open(gpio_options_ready(true), wish);
}

static const struct argp *const options[] = {&panel_options_argp, &gpio_options_argp, &gpio_spidev_options_argp, NULL};

const struct sink_kind sink_spi = {
    .name = "spi",
    .summary = "the same on the kernel's SPI device, D/C on a GPIO line",
    .paced = true,
    .options = options,
    .examples = "  glint stream coin --to spi --spidev /dev/spidev0.0 --spi-hz 40000000 \\\n"
                "      --lines dc=GPIO25,reset=GPIO27\n",
    .pixels = {.open = open_spi, .send = gpio_display_send, .close = gpio_display_close},
    .list = spidev_list,
    .list_print = spidev_print,
};
