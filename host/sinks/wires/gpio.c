/* SPDX-License-Identifier: MIT
 * Sink gpio: a panel whose every wire is a GPIO line. */
#include <stdlib.h>

#include "base/memory.h"
#include "sinks/panel/options.h"
#include "sinks/wires/chip.h"
#include "sinks/wires/display.h"
#include "sinks/wires/lines.h"

static struct sink *open_gpio(const struct sink_wish *wish)
{
    return gpio_display_open(gpio_options_ready(false), wish);
}

static char *library(void)
{
    return formatted("libgpiod %s", gpio_library_version());
}

static const struct argp *const options[] = {&panel_options_argp, &gpio_options_argp, &gpio_line_options_argp, NULL};

static const char help[] =
    "A bus's file (--bus-config) has the long options' names, without dashes, and size; then the lines, each with its "
    "own:\n"
    "\n"
    "  # a 240x240 module on a Raspberry Pi\n"
    "  bus = spi\n"
    "  panel = st7789\n"
    "  size = 240x240\n"
    "  rotation = 90\n"
    "  [lines]\n"
    "  sck = GPIO11\n"
    "  mosi = GPIO10\n"
    "  dc = GPIO25\n"
    "  reset = GPIO27\n"
    "  backlight = GPIO18\n";

const struct sink_kind sink_gpio = {
    .name = "gpio",
    .summary = "a panel (see --panel) on GPIO lines, SPI or 8080",
    .paced = true,
    .options = options,
    .help = help,
    .examples = "  glint stream watchface --to gpio --bus-config pins.ini\n"
                "  glint stream coin --to gpio --bus 8080 --panel ili9341 --size 320x240 \\\n"
                "      --chip gpiochip0 --lines d0=0,d1=1,d2=2,d3=3,d4=4,d5=5,d6=6,d7=7 \\\n"
                "      --lines wr=8,dc=9,cs=10,reset=11\n",
    .pixels = {.open = open_gpio, .send = gpio_display_send, .close = gpio_display_close},
    .list = gpio_lines_list,
    .list_print = gpio_lines_print,
    .library = library,
};
