/* SPDX-License-Identifier: MIT
 * A USB display that speaks GUD, driven by libusb: which one, its frames, and what goes wrong on the way. */
#include <stdlib.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/stop.h"
#include "light_protocol.h"
#include "sinks/gud/choose.h"
#include "sinks/gud/pack.h"
#include "sinks/usb/bulk.h"
#include "sinks/usb/choose.h"
#include "sinks/usb/light.h"
#include "sinks/usb/list.h"

struct usb_sink {
    struct sink sink;
    struct usb_port port;
    struct gud_link link;
    struct gud_display display;
    struct gud_choice choice;
    struct frame last; /* what was sent last, until the stream ends */
    bool full_update, detached, gone;
    char name[48];
};

enum { WAIT_MS = 250 };

static struct sink_cost cost_of(libusb_device *device)
{
    switch (libusb_get_device_speed(device)) {
    case LIBUSB_SPEED_SUPER:
    case LIBUSB_SPEED_SUPER_PLUS:
        return usb_super_speed_cost;
    case LIBUSB_SPEED_HIGH:
        return usb_high_speed_cost;
    default:
        return usb_full_speed_cost;
    }
}

/* The display off, the interface released, the kernel's driver in its place. */
static void leave(struct usb_sink *usb, bool tell)
{
    struct gud_problem problem;
    usb->port.stoppable = false; /* a signal does not keep the display from being switched off */
    if (usb->port.handle && !usb->gone && usb->choice.max_bytes && !gud_stop(&usb->link, &problem) &&
        problem.fault != GUD_LINK_GONE && tell)
        warn("%s: it was not switched off: %s", usb->name, problem.text);
    usb_bulk_free(&usb->port);
    usb_port_close(&usb->port, usb->detached);
    if (usb->port.libusb)
        libusb_exit(usb->port.libusb);
    free(usb);
}

static bool configure(struct usb_sink *usb, const struct sink_wish *wish, struct gud_problem *problem)
{
    if (!gud_display_read(&usb->link, &usb->display, true, problem) ||
        !gud_choose(&usb->display, wish, &usb->choice, problem) ||
        !gud_start(&usb->link, &usb->display, &usb->choice, problem))
        return false;
    if (usb_bulk_prepare(&usb->port))
        return gud_problem_is(problem, GUD_LINK_ERROR, "out of memory");
    usb->full_update = usb->display.descriptor.flags & GUD_FLAG_FULL_UPDATE;
    usb->sink.width = usb->choice.mode.hdisplay;
    usb->sink.height = usb->choice.mode.vdisplay;
    usb->sink.format = usb->choice.pixels;
    usb->sink.align_x = usb->choice.format == GUD_R1 ? 8 : 1;
    usb->sink.whole_frames = usb->full_update;
    usb->sink.lz4 = usb->choice.lz4;
    usb->sink.max_bytes = usb->choice.max_bytes;
    usb->sink.cost = cost_of(libusb_get_device(usb->port.handle));
    return true;
}

/* Opens the chosen device; `line` gets the reason where not. */
static enum usb_attempt connect_display(struct usb_sink *usb, const struct usb_device *device,
                                        const struct sink_wish *wish, char *line, size_t size)
{
    struct gud_problem problem = {.fault = GUD_LINK_ERROR, .text = "the kernel's driver has taken it"};
    const char *name = usb_name(device, usb->name, sizeof usb->name);
    const enum usb_opened opened = usb_port_open(&usb->port, device->device, device->interface,
                                                 usb_options.detach ? &usb->detached : NULL, &problem);
    if (opened == USB_OPENED) {
        usb->port.bulk_out = device->bulk_out;
        if (configure(usb, wish, &problem))
            return USB_TRY_OPENED;
    }
    usb->gone = problem.fault == GUD_LINK_GONE;
    snprintf(line, size, "%s: %s", name, problem.text);
    return usb->gone ? USB_TRY_AGAIN : opened == USB_OPEN_IN_USE ? USB_TRY_SOON : USB_TRY_NO_GOOD;
}

/* ---- the sink's functions ---- */

static struct usb_sink *new_sink(void)
{
    struct usb_sink *usb = allocate(1, sizeof *usb);
    const int error = libusb_init(&usb->port.libusb);
    if (error) {
        free(usb);
        fail("USB: libusb cannot start: %s; is /dev/bus/usb there?", libusb_strerror(error));
    }
    usb->sink = (struct sink){.name = usb->name};
    usb->link = (struct gud_link){.context = &usb->port, .control = usb_control};
    usb->port.stoppable = true;
    return usb;
}

/* libusb learns of new devices from udev's daemon, which not every system runs; a new context lists them by itself. */
static enum usb_attempt try_open(const struct sink_wish *wish, struct usb_sink **out, char *line, size_t size)
{
    static struct usb_found found;
    static bool was_detached; /* the kernel's driver gets the display back even if it was replugged meanwhile */
    struct usb_sink *usb = new_sink();
    enum usb_attempt attempt;
    usb_find(usb->port.libusb, &usb_options, 0, &found);
    const struct usb_device *device = usb_choose(&found, &usb_options, line, size, &attempt);
    if (device)
        attempt = connect_display(usb, device, wish, line, size);
    if (attempt == USB_TRY_OPENED)
        usb_remember(device);
    usb_found_free(&found);
    usb->detached = was_detached |= usb->detached;
    if (attempt == USB_TRY_OPENED)
        *out = usb;
    else
        leave(usb, false);
    return attempt;
}

static struct sink *usb_open(const struct sink_wish *wish)
{
    char line[400];
    struct usb_sink *usb = NULL;
    for (unsigned moments = 0;;) {
        const enum usb_attempt attempt = try_open(wish, &usb, line, sizeof line);
        if (attempt == USB_TRY_OPENED)
            break;
        if (stream_stopped())
            return NULL;
        if (!usb_options.wait || !usb_may_pass(attempt, &moments))
            fail("%s", line);
        progress("waiting for a USB display; Ctrl-C ends it");
        usb_pause_ms(WAIT_MS);
        if (stream_stopped())
            return NULL;
    }
    progress_end();
    return &usb->sink;
}

static struct usb_sink *of(const struct sink *sink)
{
    return (struct usb_sink *)sink; /* its first member */
}

static size_t usb_box_bytes(const struct sink *sink, const struct glint_box *box)
{
    return gud_box_bytes(of(sink)->choice.format, box);
}

static void usb_pack(const struct sink *sink, const struct frame *frame, const struct glint_box *box, uint8_t *out)
{
    gud_box_pack(of(sink)->choice.format, frame, box, out);
}

/* A piece is announced when the one before has arrived: GUD has no other order, and the data of two would run together.
 * The last one is left under way. */
static int send_pieces(struct usb_sink *usb, const struct piece *pieces, size_t count, bool announce,
                       struct gud_problem *problem)
{
    for (size_t i = 0; i < count; i++) {
        int fault = usb_bulk_wait(&usb->port);
        if (!fault && announce && !gud_rectangle_announce(&usb->link, &pieces[i], problem))
            return problem->fault;
        if (!fault)
            fault = usb_bulk_start(&usb->port, pieces[i].data, pieces[i].bytes);
        if (fault) {
            const enum gud_link_fault why = (enum gud_link_fault)fault;
            gud_problem_is(problem, why, "the picture's data: %s", gud_fault_words(why));
            return fault;
        }
    }
    return 0;
}

/* The whole picture, uncompressed, until it has arrived. */
static int send_whole(struct usb_sink *usb, const struct frame *frame, struct gud_problem *problem)
{
    const size_t line = gud_line_bytes(usb->choice.format, frame->width);
    const uint16_t lines = (uint16_t)(usb->choice.max_bytes / line);
    uint8_t *data = allocate(usb->choice.max_bytes, 1);
    int fault = 0;
    for (unsigned y = 0; y < frame->height && !fault; y += lines) { /* y + lines may be more than 16 bits hold */
        const uint16_t left = (uint16_t)(frame->height - y);
        const struct glint_box box = {0, (uint16_t)y, frame->width, left < lines ? left : lines};
        const size_t bytes = gud_box_bytes(usb->choice.format, &box);
        gud_box_pack(usb->choice.format, frame, &box, data);
        fault = send_pieces(usb, &(struct piece){box, false, bytes, bytes, data}, 1, !usb->full_update, problem);
        if (!fault) {
            fault = usb_bulk_wait(&usb->port);
            if (fault)
                gud_problem_is(problem, (enum gud_link_fault)fault, "the picture's data: %s",
                               gud_fault_words((enum gud_link_fault)fault));
        }
    }
    free(data);
    return fault;
}

/* What the display shows is unknown: sets the mode again and sends everything. */
static int restart(struct usb_sink *usb, const struct frame *frame, struct gud_problem *problem)
{
    usb->port.fault = 0;
    if (!usb_port_claim_again(&usb->port, usb_options.detach ? &usb->detached : NULL, problem) ||
        !gud_start(&usb->link, &usb->display, &usb->choice, problem))
        return problem->fault;
    return send_whole(usb, frame, problem);
}

/* Also a reset ends what is under way as if the device were gone, so ask it. */
static bool is_gone(struct usb_sink *usb)
{
    enum { MOMENT_MS = 100 };
    uint8_t status;
    usb_pause_ms(MOMENT_MS);
    return usb_control(&usb->port, true, GUD_GET_STATUS, 0, &status, 1) == GUD_LINK_GONE;
}

/* After a fault: the whole picture, or why not. A board that shows its own picture under a computer's light is busy until that light
 * is LIGHT_HELD_MS old. */
static int recover(struct usb_sink *usb, const struct frame *frame, int fault, struct gud_problem *problem)
{
    enum { PAUSE_MS = 300 /* by then the system knows whether a device is gone */, TRIES = 3 };
    enum { BUSY_TRIES = LIGHT_HELD_MS / PAUSE_MS + TRIES };
    for (unsigned i = 0; fault && fault != GUD_LINK_STOPPED; i++) {
        if (fault == GUD_LINK_GONE && is_gone(usb))
            break;
        usb->port.fault = 0; /* it is told here */
        if (problem->busy ? i >= BUSY_TRIES : i >= TRIES)
            fail("%s: %s, and again after %u attempts to reinitialise it; %s", usb->name, problem->text, i,
                 problem->busy ? "end the program that gives it light" : "plug it in again");
        if (i == 0)
            warn("%s: %s; reinitialising it", usb->name, problem->text);
        usb_pause_ms(PAUSE_MS);
        fault = stream_stopped() ? GUD_LINK_STOPPED : restart(usb, frame, problem);
    }
    return fault;
}

static enum sink_result usb_send(struct sink *sink, const struct frame *frame, const struct piece *pieces, size_t count)
{
    struct usb_sink *usb = of(sink);
    struct gud_problem problem = {0};
    const int fault = recover(usb, frame, send_pieces(usb, pieces, count, !usb->full_update, &problem), &problem);
    usb->last = *frame;
    if (fault == GUD_LINK_STOPPED)
        return SINK_INTERRUPTED;
    usb->gone = fault == GUD_LINK_GONE;
    if (usb->gone && !usb_options.wait)
        fail("%s: unplugged; start again when it is back, or use --wait", usb->name);
    if (usb->gone)
        warn("%s: unplugged; waiting for its return", usb->name);
    return usb->gone ? SINK_GONE : SINK_SENT;
}

/* The last picture is still under way. */
static void usb_finish(struct sink *sink)
{
    struct usb_sink *usb = of(sink);
    struct gud_problem problem;
    int fault = usb->gone || stream_stopped() ? 0 : usb_bulk_wait(&usb->port);
    if (fault)
        gud_problem_is(&problem, (enum gud_link_fault)fault, "the picture's data: %s",
                       gud_fault_words((enum gud_link_fault)fault));
    fault = fault ? recover(usb, &usb->last, fault, &problem) : 0;
    usb->gone = usb->gone || fault == GUD_LINK_GONE;
    if (fault == GUD_LINK_GONE)
        fail("%s: unplugged before the last picture had arrived; start again when it is back", usb->name);
}

static void usb_close(struct sink *sink)
{
    struct usb_sink *usb = of(sink);
    const int fault = usb->gone ? 0 : usb_bulk_wait(&usb->port);
    if (fault == GUD_LINK_GONE)
        usb->gone = true;
    if (fault && fault != GUD_LINK_STOPPED)
        warn("%s: the last picture: %s", usb->name, gud_fault_words((enum gud_link_fault)fault));
    leave(usb, true);
}

static char *usb_library(void)
{
    const struct libusb_version *version = libusb_get_version();
    return formatted("libusb %u.%u.%u", version->major, version->minor, version->micro);
}

static const struct argp *const usb_argps[] = {&usb_options_argp, NULL};

const struct sink_kind sink_usb = {
    .name = "usb",
    .summary = "a USB display that speaks GUD, by libusb",
    .paced = true,
    .may_go = true,
    .options = usb_argps,
    .examples = "  glint stream dial --to usb --stats\n"
                "  glint stream --height wall.png --size 240x240 --to usb --shade device\n"
                "  glint stream --to usb --shade demo --light-from iio\n"
                "  glint stream coin --to usb --usb-path 1-3.1 --wait\n",
    .pixels = {.open = usb_open,
               .box_bytes = usb_box_bytes,
               .pack = usb_pack,
               .send = usb_send,
               .finish = usb_finish,
               .close = usb_close},
    .shader = &usb_shader,
    .list = usb_list,
    .list_print = usb_list_print,
    .library = usb_library,
};
