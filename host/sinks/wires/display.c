/* SPDX-License-Identifier: MIT */
#include "sinks/wires/display.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/stop.h"
#include "sinks/panel/options.h"
#include "sinks/wires/bus.h"

/* For choosing what to send, and for predictions: calls of the kernel a second, as measured on a Raspberry Pi 5; what a
 * window takes beside its bytes through the SPI device: its calls. */
static const double line_sets_per_s = 1.25e6, spidev_window_s = 150e-6;
enum { WINDOW_BYTES = 11, CHUNK = 1024 };

struct display {
    struct sink sink;
    struct gpio_bus *bus;
    struct panel_bus panel_bus;
    struct panel panel;
    bool shown; /* dark until the first picture is complete */
};

static struct sink_cost cost_of(const struct gpio_options *options)
{
    static const double sets_a_byte[] = {[GPIO_BUS_SPI] = 16, [GPIO_BUS_8080] = 2};
    const bool device = options->kind == GPIO_BUS_SPIDEV;
    const double bytes_per_s = device ? options->spi_hz / 8.0 : line_sets_per_s / sets_a_byte[options->kind];
    return (struct sink_cost){WINDOW_BYTES / bytes_per_s + (device ? spidev_window_s : 0), bytes_per_s};
}

static _Noreturn void fail_bus(const struct display *display)
{
    const int reason = gpio_bus_error(display->bus);
    if (reason == ENODEV || reason == ENXIO || reason == ESHUTDOWN) /* as spidev says it */
        fail("%s: it was removed while in use; plug it in or load its driver, then start again", display->sink.name);
    fail("%s: writing to the panel failed: %s", display->sink.name, strerror(reason));
}

struct sink *gpio_display_open(const struct gpio_options *options, const struct sink_wish *wish)
{
    struct display *display = allocate(1, sizeof *display);
    panel_of_options(&display->panel, wish, false);
    display->bus = gpio_bus_open(options);
    display->panel_bus = gpio_bus_panel(display->bus);
    display->panel.bus = &display->panel_bus;
    display->sink = (struct sink){.width = display->panel.width,
                                  .height = display->panel.height,
                                  .format = panel_is_paged(&display->panel) ? GLINT_MONO : GLINT_RGB565_SWAPPED,
                                  .align_x = 1,
                                  .max_bytes = SIZE_MAX,
                                  .cost = cost_of(options),
                                  .name = gpio_bus_name(display->bus)};
    if (!panel_start(&display->panel))
        fail_bus(display);
    if (!stream_stopped())
        return &display->sink;
    gpio_display_close(&display->sink);
    return NULL;
}

static enum sink_result send_piece(struct display *display, const struct frame *frame, const struct piece *piece)
{
    const struct glint_box *box = &piece->box;
    if (panel_is_paged(&display->panel)) { /* whole pages, 1 KB at most */
        if (stream_stopped())
            return SINK_INTERRUPTED;
        if (!panel_mono(&display->panel, frame->pixels, frame->line_bytes, box->x, box->y, box->w, box->h))
            fail_bus(display);
        return SINK_SENT;
    }
    if (!panel_window(&display->panel, box->x, box->y, box->w, box->h))
        fail_bus(display);
    for (size_t done = 0; done < piece->bytes; done += CHUNK) {
        if (stream_stopped())
            return SINK_INTERRUPTED;
        const size_t left = piece->bytes - done;
        if (!display->panel_bus.data(display->bus, piece->data + done, left < CHUNK ? left : CHUNK))
            fail_bus(display);
    }
    return SINK_SENT;
}

enum sink_result gpio_display_send(struct sink *sink, const struct frame *frame, const struct piece *pieces,
                                   size_t count)
{
    struct display *display = (struct display *)sink;
    for (size_t i = 0; i < count; i++)
        if (send_piece(display, frame, &pieces[i]) != SINK_SENT)
            return SINK_INTERRUPTED;
    if (!display->shown && !panel_show(&display->panel, PANEL_BRIGHTEST))
        fail_bus(display);
    display->shown = true;
    return SINK_SENT;
}

void gpio_display_close(struct sink *sink)
{
    struct display *display = (struct display *)sink;
    if (!gpio_bus_error(display->bus) && !panel_stop(&display->panel))
        warn("%s: the panel could not be switched off: %s", sink->name, strerror(gpio_bus_error(display->bus)));
    gpio_bus_close(display->bus);
    free(display);
}
