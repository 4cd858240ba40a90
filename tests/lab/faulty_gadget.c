/* SPDX-License-Identifier: MIT
 * glint-gadget with faults, for tests of hosts: the same device, and what is between it and the bus goes wrong. */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "configfs.h"
#include "display.h"

static const char *const faults[] = {"none",         /* */
                                     "unplug",       /* off the bus in the middle of bulk */
                                     "die",          /* the program is gone in the middle of bulk */
                                     "stall",        /* the endpoint stalls in the middle of bulk, once */
                                     "nak",          /* nothing more is read from the middle of bulk on */
                                     "busy",         /* the first rectangles are refused */
                                     "magic",        /* of the descriptor */
                                     "version",      /* of the descriptor */
                                     "zero",         /* the descriptor tells of a display of 0 x 0 */
                                     "huge",         /* ...of a buffer of 4 GB */
                                     "small",        /* ...of a buffer of one byte */
                                     "short",        /* the descriptor is cut short */
                                     "no-formats",   /* none offered */
                                     "no-modes",     /* none offered */
                                     "no-answer",    /* the descriptor's request is stalled */
                                     "disconnected", /* the connector says so */
                                     NULL};
enum fault {
    NONE,
    UNPLUG,
    DIE,
    STALL,
    NAK,
    BUSY,
    MAGIC,
    VERSION,
    ZERO,
    HUGE,
    SMALL,
    SHORT,
    NO_FORMATS,
    NO_MODES,
    NO_ANSWER,
    DISCONNECTED
};

enum { KEY_FAULT = 0x1000, KEY_AFTER, KEY_BACK, KEY_TIMES };
static const struct argp_option list[] = {
    {0, 0, 0, 0, "Faults", 9},
    {"fault", KEY_FAULT, "NAME", 0, "See faulty_gadget.c", 0},
    {"after", KEY_AFTER, "BYTES", 0, "Of bulk, where the fault is in the middle of it (default 1024)", 0},
    {"back", KEY_BACK, "MS", 0, "Plugged in again after this time (default: never)", 0},
    {"times", KEY_TIMES, "N", 0, "How often it happens (default 1)", 0},
    {0}};

static struct {
    enum fault fault;
    unsigned long after, back_ms, times;
    struct usb_function good;
    unsigned long bytes; /* of bulk since the last fault */
    bool mute;
} faulty = {.after = 1024, .times = 1};

static error_t parse(int key, char *text, struct argp_state *state)
{
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = state->input;
        return 0;
    case KEY_FAULT:
        for (unsigned i = 0; faults[i]; i++)
            if (strcmp(text, faults[i]) == 0)
                return faulty.fault = (enum fault)i, 0;
        argp_error(state, "--fault: no '%s'", text);
        return EINVAL;
    case KEY_AFTER:
        faulty.after = strtoul(text, NULL, 10);
        return 0;
    case KEY_BACK:
        faulty.back_ms = strtoul(text, NULL, 10);
        return 0;
    case KEY_TIMES:
        faulty.times = strtoul(text, NULL, 10);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static bool in_bulk(void)
{
    return faulty.fault >= UNPLUG && faulty.fault <= NAK && faulty.times;
}

static void *plug_later(void *nothing)
{
    usleep((useconds_t)(1000 * faulty.back_ms));
    configfs_plug();
    return nothing;
}

static void happen(void)
{
    pthread_t thread;
    faulty.times--;
    faulty.bytes = 0;
    switch (faulty.fault) {
    case UNPLUG:
        configfs_unplug();
        if (faulty.back_ms)
            pthread_create(&thread, NULL, plug_later, NULL);
        break;
    case DIE:
        _exit(3);
    case STALL:
        functionfs_halt();
        break;
    case NAK:
        faulty.mute = true;
        break;
    default:
        break;
    }
}

static uint32_t expects(void *context)
{
    const uint32_t expected = faulty.good.expects(context);
    if (faulty.mute)
        return 0;
    return in_bulk() && expected > faulty.after - faulty.bytes ? (uint32_t)(faulty.after - faulty.bytes) : expected;
}

static void bulk(void *context, const uint8_t *bytes, size_t count)
{
    faulty.good.bulk(context, bytes, count);
    faulty.bytes += count;
    if (in_bulk() && faulty.bytes >= faulty.after)
        happen();
}

static int lie(const struct gud_setup *setup, uint8_t *reply, int length)
{
    if (setup->request == GUD_GET_FORMATS && faulty.fault == NO_FORMATS)
        return 0;
    if (setup->request == GUD_GET_CONNECTOR_MODES && faulty.fault == NO_MODES)
        return 0;
    if (setup->request == GUD_GET_CONNECTOR_STATUS && faulty.fault == DISCONNECTED)
        reply[0] = GUD_DISCONNECTED;
    if (setup->request != GUD_GET_DESCRIPTOR || length != GUD_DESCRIPTOR_BYTES)
        return length;
    enum { AT_VERSION = 4, AT_MAX_BUFFER = 10, AT_SIZES = 14 };
    switch (faulty.fault) {
    case MAGIC:
        reply[0] ^= 1;
        return length;
    case VERSION:
        reply[AT_VERSION] = GUD_VERSION + 1;
        return length;
    case ZERO:
        memset(reply + AT_SIZES, 0, GUD_DESCRIPTOR_BYTES - AT_SIZES);
        return length;
    case HUGE:
        memset(reply + AT_MAX_BUFFER, 0xff, 4);
        return length;
    case SMALL:
        memcpy(reply + AT_MAX_BUFFER, "\1\0\0", 4);
        return length;
    case SHORT:
        return length / 2;
    case NO_ANSWER:
        return GUD_STALL;
    default:
        return length;
    }
}

static int setup(void *context, const struct gud_setup *setup, uint8_t *reply)
{
    if (setup->request == GUD_SET_BUFFER && faulty.fault == BUSY && faulty.times && faulty.times--)
        return GUD_STALL;
    return lie(setup, reply, faulty.good.setup(context, setup, reply));
}

static bool set(void *context, const struct gud_setup *setup, const uint8_t *data)
{
    return faulty.good.set(context, setup, data);
}

static void event(void *context, enum usb_event event)
{
    faulty.good.event(context, event);
}

int main(int argc, char **argv)
{
    const struct argp_child children[] = {{&gadget_argp, 0, NULL, 0}, {0}};
    const struct argp argp = {.options = list, .parser = parse, .children = children};
    struct options options;
    options_default(&options);
    argp_err_exit_status = 2;
    argp_parse(&argp, argc, argv, 0, NULL, &options);
    static struct display display;
    display_open(&display, &options);
    faulty.good = display_function(&display);
    const struct usb_function function = {setup, set, expects, bulk, event, faulty.good.context};
    display_run(&display, &options, &function);
    return 0;
}
