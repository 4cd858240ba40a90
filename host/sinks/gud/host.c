/* SPDX-License-Identifier: MIT
 * What a GUD display says of itself, read in the kernel driver's order and checked. */
#include "sinks/gud/host.h"

#include "sinks/gud/choose.h"

/* It answers, but the answer makes no sense. */
#define lies(problem, ...) gud_problem_is(problem, GUD_LINK_ERROR, __VA_ARGS__)

static const char *status_words(uint8_t status)
{
    static const char *const words[] = {"no reason",         "busy",    "unsupported", "protocol error",
                                        "invalid parameter", "an error"};
    return status < sizeof words / sizeof words[0] ? words[status] : "an unknown status";
}

static const char *request_name(uint8_t request)
{
    switch (request) {
    case GUD_GET_DESCRIPTOR:
        return "its descriptor";
    case GUD_GET_FORMATS:
        return "its formats";
    case GUD_GET_CONNECTORS:
        return "its connectors";
    case GUD_SET_CONNECTOR_FORCE_DETECT:
        return "looking for a panel";
    case GUD_GET_CONNECTOR_STATUS:
        return "a connector's status";
    case GUD_GET_CONNECTOR_MODES:
        return "its modes";
    case GUD_SET_BUFFER:
        return "a rectangle";
    case GUD_SET_STATE_CHECK:
        return "the mode and format";
    case GUD_SET_STATE_COMMIT:
        return "the mode's commit";
    case GUD_SET_CONTROLLER_ENABLE:
        return "the controller's switch";
    case GUD_SET_DISPLAY_ENABLE:
        return "the display's switch";
    default:
        return "a request";
    }
}

static bool refused_by_status(uint8_t request, const char *how, uint8_t status, struct gud_problem *problem)
{
    gud_problem_is(problem, GUD_LINK_STALL, "%s: it refuses (%sstatus %u: %s)", request_name(request), how, status,
                   status_words(status));
    problem->busy = status == GUD_BUSY;
    return false;
}

/* A STALL says nothing yet: the status that is read after it does. */
static bool refused(struct gud_link *link, uint8_t request, int result, struct gud_problem *problem)
{
    const enum gud_link_fault fault = (enum gud_link_fault)result;
    uint8_t status = GUD_OK;
    if (fault == GUD_LINK_STALL && request != GUD_GET_STATUS &&
        link->control(link->context, true, GUD_GET_STATUS, 0, &status, 1) == 1)
        return refused_by_status(request, "STALL; ", status, problem);
    return gud_problem_is(problem, fault, "%s: %s", request_name(request), gud_fault_words(fault));
}

/* The bytes it sent, or -1. */
static int get(struct gud_link *link, uint8_t request, uint16_t value, uint8_t *data, uint16_t bytes,
               struct gud_problem *problem)
{
    const int result = link->control(link->context, true, request, value, data, bytes);
    if (result >= 0)
        return result;
    refused(link, request, result, problem);
    return -1;
}

static bool set(struct gud_link *link, uint8_t request, uint16_t value, uint8_t *data, uint16_t bytes,
                struct gud_problem *problem)
{
    const int result = link->control(link->context, false, request, value, data, bytes);
    if (result < 0)
        return refused(link, request, result, problem);
    if (result != bytes)
        return gud_problem_is(problem, GUD_LINK_ERROR, "%s: it took %d of %u bytes", request_name(request), result,
                              bytes);
    uint8_t status = GUD_OK;
    if (link->status_wanted && get(link, GUD_GET_STATUS, 0, &status, 1, problem) < 0)
        return false;
    return status == GUD_OK || refused_by_status(request, "", status, problem);
}

static uint32_t first_u32(const uint8_t *bytes)
{
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

bool gud_descriptor_read(struct gud_link *link, struct gud_descriptor *d, struct gud_problem *problem)
{
    uint8_t bytes[GUD_DESCRIPTOR_BYTES] = {0};
    const int count = get(link, GUD_GET_DESCRIPTOR, 0, bytes, sizeof bytes, problem);
    if (count < 0)
        return false;
    if (count >= 5 && first_u32(bytes) == GUD_MAGIC && bytes[4] != GUD_VERSION)
        return lies(problem, "it speaks GUD version %u; this glint knows version %d", bytes[4], GUD_VERSION);
    if (count >= 4 && first_u32(bytes) != GUD_MAGIC)
        return lies(problem, "it is not a GUD display: its descriptor begins with %08x, not %08x", first_u32(bytes),
                    GUD_MAGIC);
    if (count != sizeof bytes)
        return lies(problem, "it is not a GUD display: its descriptor has %d bytes, not %d", count,
                    GUD_DESCRIPTOR_BYTES);
    gud_descriptor_unpack(d, bytes);
    return true;
}

static bool check_sizes(const struct gud_descriptor *d, struct gud_problem *problem)
{
    if (!d->max_width || !d->max_height)
        return lies(problem, "its descriptor says that it is at most %ux%u pixels", d->max_width, d->max_height);
    if (d->min_width > d->max_width || d->min_height > d->max_height)
        return lies(problem, "its descriptor says at least %ux%u and at most %ux%u pixels", d->min_width, d->min_height,
                    d->max_width, d->max_height);
    return true;
}

static bool read_formats(struct gud_link *link, struct gud_display *display, struct gud_problem *problem)
{
    const int count = get(link, GUD_GET_FORMATS, 0, display->formats, GUD_HOST_FORMATS_MAX, problem);
    if (count < 0)
        return false;
    if (count == 0)
        return lies(problem, "it offers no pixel format");
    display->format_count = (size_t)count;
    return true;
}

/* The first that is connected, else the first that does not know. */
static bool choose_connector(struct gud_link *link, struct gud_display *display, bool detect,
                             struct gud_problem *problem)
{
    int unknown = -1;
    for (uint8_t i = 0; i < display->connector_count; i++) {
        uint8_t status = 0;
        if (detect && !set(link, GUD_SET_CONNECTOR_FORCE_DETECT, i, NULL, 0, problem) &&
            problem->fault != GUD_LINK_STALL) /* the kernel's driver asks for it only by hand: some do not know it */
            return false;
        const int count = get(link, GUD_GET_CONNECTOR_STATUS, i, &status, 1, problem);
        if (count < 0)
            return false;
        if (count != 1)
            return lies(problem, "connector %u has a status of no bytes", i);
        display->connector = i;
        if ((status & GUD_STATUS_MASK) == GUD_CONNECTED)
            return true;
        if ((status & GUD_STATUS_MASK) != GUD_DISCONNECTED && unknown < 0)
            unknown = i;
    }
    display->connector = (uint8_t)unknown;
    return unknown >= 0 || lies(problem, "no panel is connected to it (%u connector%s asked)", display->connector_count,
                                display->connector_count == 1 ? "" : "s");
}

static bool read_connectors(struct gud_link *link, struct gud_display *display, bool detect,
                            struct gud_problem *problem)
{
    uint8_t bytes[GUD_HOST_CONNECTORS_MAX * GUD_CONNECTOR_BYTES];
    const int count = get(link, GUD_GET_CONNECTORS, 0, bytes, sizeof bytes, problem);
    if (count < 0)
        return false;
    if (count == 0)
        return lies(problem, "it has no connector");
    if (count % GUD_CONNECTOR_BYTES)
        return lies(problem, "its connectors take %d bytes, which is not a multiple of %d", count, GUD_CONNECTOR_BYTES);
    display->connector_count = (uint8_t)(count / GUD_CONNECTOR_BYTES);
    return choose_connector(link, display, detect, problem);
}

static bool mode_fits(const struct gud_mode *mode, const struct gud_descriptor *d)
{
    return mode->hdisplay && mode->vdisplay && mode->hdisplay >= d->min_width && mode->hdisplay <= d->max_width &&
           mode->vdisplay >= d->min_height && mode->vdisplay <= d->max_height;
}

static bool read_modes(struct gud_link *link, struct gud_display *display, struct gud_problem *problem)
{
    const struct gud_descriptor *d = &display->descriptor;
    uint8_t bytes[GUD_HOST_MODES_MAX * GUD_MODE_BYTES];
    const int count = get(link, GUD_GET_CONNECTOR_MODES, display->connector, bytes, sizeof bytes, problem);
    if (count < 0)
        return false;
    if (count == 0)
        return lies(problem, "it has no mode (glint reads no EDID)");
    if (count % GUD_MODE_BYTES)
        return lies(problem, "its modes take %d bytes, which is not a multiple of %d", count, GUD_MODE_BYTES);
    struct gud_mode mode = {0};
    for (int at = 0; at < count; at += GUD_MODE_BYTES) {
        gud_mode_unpack(&mode, bytes + at);
        if (mode_fits(&mode, d))
            display->modes[display->mode_count++] = mode;
    }
    return display->mode_count ||
           lies(problem, "its mode %ux%u is not within its descriptor's %ux%u to %ux%u pixels", mode.hdisplay,
                mode.vdisplay, d->min_width, d->min_height, d->max_width, d->max_height);
}

bool gud_display_read(struct gud_link *link, struct gud_display *display, bool detect, struct gud_problem *problem)
{
    *display = (struct gud_display){0};
    link->status_wanted = false;
    if (!gud_descriptor_read(link, &display->descriptor, problem) || !check_sizes(&display->descriptor, problem))
        return false;
    link->status_wanted = display->descriptor.flags & GUD_FLAG_STATUS;
    return read_formats(link, display, problem) && read_connectors(link, display, detect, problem) &&
           read_modes(link, display, problem);
}

/* ---- state ---- */

bool gud_start(struct gud_link *link, const struct gud_display *display, const struct gud_choice *choice,
               struct gud_problem *problem)
{
    uint8_t state[GUD_STATE_BYTES], on = 1;
    gud_mode_pack(state, &choice->mode);
    state[GUD_MODE_BYTES] = (uint8_t)choice->format;
    state[GUD_MODE_BYTES + 1] = display->connector;
    return set(link, GUD_SET_STATE_CHECK, 0, state, sizeof state, problem) &&
           set(link, GUD_SET_CONTROLLER_ENABLE, 0, &on, 1, problem) &&
           set(link, GUD_SET_STATE_COMMIT, 0, NULL, 0, problem) &&
           set(link, GUD_SET_DISPLAY_ENABLE, 0, &on, 1, problem);
}

bool gud_stop(struct gud_link *link, struct gud_problem *problem)
{
    uint8_t off = 0;
    return set(link, GUD_SET_DISPLAY_ENABLE, 0, &off, 1, problem) &&
           set(link, GUD_SET_CONTROLLER_ENABLE, 0, &off, 1, problem);
}

bool gud_rectangle_announce(struct gud_link *link, const struct piece *piece, struct gud_problem *problem)
{
    uint8_t bytes[GUD_RECTANGLE_BYTES];
    gud_rectangle_pack(bytes, &(struct gud_rectangle){.x = piece->box.x,
                                                      .y = piece->box.y,
                                                      .width = piece->box.w,
                                                      .height = piece->box.h,
                                                      .length = (uint32_t)piece->length,
                                                      .compression = piece->lz4 ? GUD_COMPRESSION_LZ4 : 0,
                                                      .compressed_length = piece->lz4 ? (uint32_t)piece->bytes : 0});
    return set(link, GUD_SET_BUFFER, 0, bytes, sizeof bytes, problem);
}
