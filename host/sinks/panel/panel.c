/* SPDX-License-Identifier: MIT
 * Sink panel: a virtual panel. Frames go through the panel's driver and its bytes; what the glass would show goes
 * into PNG files. */
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "image/picture.h"
#include "image/write.h"
#include "sinks/frames.h"
#include "sinks/outputs.h"
#include "sinks/panel/options.h"
#include "sinks/panel/virtual_panel.h"

struct display {
    struct sink sink;
    struct virtual_panel glass;
    struct panel_bus bus;
    struct panel panel;
    bool shown;
    const char *pattern;
    unsigned long next;
};

/* A panel on a 62.5 MHz SPI bus, as boards have it. */
static const struct sink_cost usual_cost = {.rectangle_s = 11 / 7.8e6, .bytes_per_s = 7.8e6};

static struct sink *open_panel(const struct sink_wish *wish)
{
    struct display *display = allocate(1, sizeof *display);
    panel_of_options(&display->panel, wish, true);
    const struct virtual_glass glass = virtual_glass_of(&display->panel);
    virtual_panel_init(&display->glass, &glass);
    display->bus = virtual_panel_bus(&display->glass);
    display->panel.bus = &display->bus;
    display->pattern = wish->output;
    display->sink = (struct sink){.width = display->panel.width,
                                  .height = display->panel.height,
                                  .format = panel_is_paged(&display->panel) ? GLINT_MONO : GLINT_RGB565_SWAPPED,
                                  .align_x = 1,
                                  .max_bytes = SIZE_MAX,
                                  .cost = usual_cost,
                                  .name = "the virtual panel"};
    if (!panel_start(&display->panel))
        fail("%s: did not start", display->sink.name);
    return &display->sink;
}

static void write_picture(struct display *display)
{
    const struct sink *sink = &display->sink;
    uint8_t *rgb = allocate((size_t)sink->width * sink->height, 3);
    virtual_panel_look(&display->glass, display->panel.rotation, rgb);
    const struct picture picture = {.width = sink->width, .height = sink->height, .channels = 3, .samples = rgb};
    char *name = frame_name(display->pattern, display->next++);
    struct output *output = output_open(name);
    picture_write(&picture, output, IMAGE_PNG);
    output_close(output);
    free(name);
    free(rgb);
}

static enum sink_result send_frame(struct sink *sink, const struct frame *frame, const struct piece *pieces,
                                   size_t count)
{
    struct display *display = (struct display *)sink;
    for (size_t i = 0; i < count; i++) {
        const struct glint_box *box = &pieces[i].box;
        if (panel_is_paged(&display->panel)) {
            if (!panel_mono(&display->panel, frame->pixels, frame->line_bytes, box->x, box->y, box->w, box->h))
                fail("%s: %ux%u pixels at %u,%u do not fit on it", sink->name, box->w, box->h, box->x, box->y);
            continue;
        }
        if (!panel_window(&display->panel, box->x, box->y, box->w, box->h))
            fail("%s: %ux%u pixels at %u,%u do not fit on it", sink->name, box->w, box->h, box->x, box->y);
        virtual_panel_data(&display->glass, pieces[i].data, pieces[i].bytes);
    }
    display->shown = display->shown || panel_show(&display->panel, PANEL_BRIGHTEST);
    write_picture(display);
    return SINK_SENT;
}

static void close_panel(struct sink *sink)
{
    panel_stop(&((struct display *)sink)->panel);
    free(sink);
}

static const struct argp *const options[] = {&panel_options_argp, NULL};

const struct sink_kind sink_panel = {
    .name = "panel",
    .summary = "a virtual panel: what it shows goes to PNG files",
    .output = &output_file_a_frame,
    .usual_output = "panel.png",
    .every_frame = true,
    .options = options,
    .examples = "  glint stream watchface --frames 1\n"
                "  glint stream coin --panel ili9341 --size 240x320 -o coin-%02d.png\n"
                "  glint stream watchface --panel ssd1306 --dither --frames 1\n",
    .pixels = {.open = open_panel, .send = send_frame, .close = close_panel},
};
