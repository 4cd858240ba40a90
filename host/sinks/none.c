/* SPDX-License-Identifier: MIT
 * Sink none: no device; what would be sent to a USB display, for --stats. */
#include <stdlib.h>

#include "base/memory.h"
#include "base/parse.h"
#include "sinks/sink.h"

enum key { KEY_RATE = 256, KEY_RECTANGLE, KEY_RAW };

static struct sink_cost link_cost;
static bool raw;

static const struct argp_option argp_options[] = {
    {NULL, 0, NULL, 0, "The link that --to none models:", 10},
    {"link-rate", KEY_RATE, "KB/S", 0, "Its speed (default 1000, USB at full speed)", 10},
    {"link-rectangle", KEY_RECTANGLE, "MS", 0, "The time to announce a rectangle (default 0.4)", 10},
    {"link-raw", KEY_RAW, NULL, 0, "It takes no LZ4 data", 10},
    {NULL, 0, NULL, 0, NULL, 0}};

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    switch (key) {
    case ARGP_KEY_INIT:
        link_cost = usb_costs[USB_RATES - 1];
        raw = false;
        return 0;
    case KEY_RATE:
        link_cost.bytes_per_s = 1e3 * parse_real(state, "--link-rate", text, .001, 1e9);
        return 0;
    case KEY_RECTANGLE:
        link_cost.rectangle_s = 1e-3 * parse_real(state, "--link-rectangle", text, 0, 1e6);
        return 0;
    case KEY_RAW:
        raw = true;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp argp = {argp_options, parse_option, NULL, NULL, NULL, NULL, NULL};

static struct sink *open_none(const struct sink_wish *wish)
{
    struct sink *sink = allocate(1, sizeof *sink);
    *sink = (struct sink){.format = wish->format < 0 ? GLINT_RGB565 : (enum glint_format)wish->format,
                          .align_x = 1,
                          .lz4 = !raw,
                          .max_bytes = SIZE_MAX,
                          .cost = link_cost,
                          .name = "no device"};
    sink_size(sink, wish);
    return sink;
}

static enum sink_result send_none(struct sink *sink, const struct frame *frame, const struct piece *pieces,
                                  size_t count)
{
    (void)sink;
    (void)frame;
    (void)pieces;
    (void)count;
    return SINK_SENT;
}

static void close_none(struct sink *sink)
{
    free(sink);
}

static const struct argp *const options[] = {&argp, NULL};

const struct sink_kind sink_none = {
    .name = "none",
    .summary = "nowhere: --stats tells what a USB display would be sent",
    .options = options,
    .examples = "  glint stream dial --to none --json --link-rate 600\n",
    .pixels = {.open = open_none, .send = send_none, .close = close_none},
};
