/* SPDX-License-Identifier: MIT
 * Sink spi: a panel on the kernel's SPI device, with GPIO lines for D/C, reset and backlight. Its options are with sink
 * gpio's. */
#include "gpio_display.h"
#include "gpio_spidev.h"

static struct sink *open_spi(const struct sink_wish *wish)
{
    return gpio_display_open(&sink_spi, gpio_options_ready(true), wish);
}

const struct sink_kind sink_spi = {
    .name = "spi",
    .summary = "the same on the kernel's SPI device, D/C on a GPIO line",
    .nature = SINK_DEVICE,
    .open = open_spi,
    .send = gpio_display_send,
    .close = gpio_display_close,
    .list = spidev_list,
    .list_print = spidev_print,
};
