/* SPDX-License-Identifier: MIT */
#include "sinks/usb/light.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/stop.h"
#include "gud_protocol.h"
#include "image/picture.h"
#include "sinks/usb/bulk.h"
#include "sinks/usb/choose.h"

struct light_sink {
    struct sink sink;
    struct usb_port port;
    struct gud_link link;
    bool gone;
    bool is_demo; /* the device shows its own; it is not enabled */
    uint32_t frames;
    uint8_t messages[2][LIGHT_POSE_BYTES]; /* one may be under way */
    char name[48];
};

enum { WAIT_MS = 250, LAST_FRAMES_MS = 2000, SENSOR_MS = 2500, ASK_MS = 10 };
enum { BUSY_MS = GUD_ABANDONED_MS + 500 }; /* by then a rectangle whose host was killed has ended */

static struct light_sink *of(const struct sink *sink)
{
    return (struct light_sink *)sink; /* its first member */
}

/* ---- opening ---- */

bool usb_light_fits(const struct light_descriptor *device, const struct sink_wish *wish, const char *name, char *line,
                    size_t size)
{
    const unsigned width = device->width, height = device->height;
    if (!picture_size_fits(width, height))
        snprintf(line, size, "%s: its %ux%u pixels are too many; the most is %d a side and %d in all", name, width,
                 height, SIDE_MAX, PIXELS_MAX);
    else if ((wish->width && (wish->width != width || wish->height != height)) ||
             (wish->format >= 0 && wish->format != GLINT_RGB565))
        snprintf(line, size, "%s: it shades %ux%u in rgb565; leave out --size and --format", name, width, height);
    else
        return true;
    return false;
}

/* Does the interface answer as one that shades? 1, and `line` gets the reason where it does not fit the wish; 0; or a fault. */
static int ask(struct light_sink *light, const struct sink_wish *wish, char *line, size_t size)
{
    uint8_t bytes[LIGHT_DESCRIPTOR_BYTES];
    struct light_descriptor descriptor;
    const int got = light->link.control(&light->port, true, LIGHT_GET_DESCRIPTOR, 0, bytes, sizeof bytes);
    if (got < 0 && got != GUD_LINK_STALL)
        return got;
    if (got != sizeof bytes || !light_descriptor_unpack(&descriptor, bytes) || !descriptor.width || !descriptor.height)
        return 0;
    if (usb_light_fits(&descriptor, wish, light->name, line, size)) {
        light->sink.width = descriptor.width;
        light->sink.height = descriptor.height;
    }
    return 1;
}

/* The interface that answers; else `line` says why none does, or why it does not fit. */
static enum usb_attempt find_interface(struct light_sink *light, const struct usb_device *device,
                                       const struct sink_wish *wish, char *line, size_t size)
{
    struct usb_device asked = *device; /* with the reason why one is not known to shade */
    asked.state = USB_DISPLAY;
    for (unsigned i = 0; i < device->interface_count; i++) {
        const uint8_t number = device->interfaces[i].number;
        const enum usb_opened opened = usb_port_open(&light->port, device->device, number, NULL, &asked.problem);
        if (opened == USB_OPEN_KERNEL) /* it keeps the display; what shades is no driver's */
            continue;
        if (opened != USB_OPENED) {
            asked.state = usb_state_unopened(opened, &asked.problem);
            continue;
        }
        light->port.bulk_out = device->interfaces[i].bulk_out;
        *line = '\0';
        const int answer = ask(light, wish, line, size);
        if (answer > 0)
            return *line ? USB_TRY_NO_GOOD : USB_TRY_OPENED;
        usb_port_close(&light->port, false);
        if (answer < 0) {
            const enum gud_link_fault fault = (enum gud_link_fault)answer;
            gud_problem_is(&asked.problem, fault, "asked whether it shades by itself: %s", gud_fault_words(fault));
            asked.state = fault == GUD_LINK_GONE ? USB_VANISHED : USB_NOT_DISPLAY;
        }
    }
    if (asked.state != USB_DISPLAY)
        return usb_unusable(&asked, line, size);
    snprintf(line, size, "%s: it does not shade by itself; leave out --shade", light->name);
    return USB_TRY_NO_GOOD;
}

static const char busy_words[] =
    "it waits for the rest of a picture; try again, or plug it in again if nothing sends it";

/* The display's own host may be drawing; that is soon done. A signal does not keep the panel from being given back. 0, or a fault. */
static int enable(struct light_sink *light, uint8_t value, const char **why)
{
    uint8_t status = GUD_BUSY;
    for (unsigned ms = 0; status == GUD_BUSY && ms < BUSY_MS; ms += ASK_MS) {
        int result = light->link.control(&light->port, false, LIGHT_SET_ENABLE, 0, &value, 1);
        if (result == 1)
            return 0;
        if (result == GUD_LINK_STALL)
            result = light->link.control(&light->port, true, LIGHT_GET_STATUS, 0, &status, 1);
        if (result >= 0 && light->port.stoppable && stream_stopped())
            result = GUD_LINK_STOPPED;
        if (result < 0) {
            *why = gud_fault_words((enum gud_link_fault)result);
            return result;
        }
        usb_pause_ms(ASK_MS);
    }
    *why = status == GUD_BUSY ? busy_words : "it refuses to hand its panel over; plug it in again";
    return GUD_LINK_STALL;
}

/* Opens the chosen device; `line` gets the reason where not. */
static enum usb_attempt connect_shader(struct light_sink *light, const struct usb_device *device,
                                       const struct sink_wish *wish, char *line, size_t size)
{
    usb_name(device, light->name, sizeof light->name);
    const enum usb_attempt attempt = find_interface(light, device, wish, line, size);
    if (attempt != USB_TRY_OPENED)
        return attempt;
    const char *why = "out of memory";
    const int fault = usb_bulk_prepare(&light->port) ? GUD_LINK_ERROR : wish->demo ? 0 : enable(light, 1, &why);
    if (!fault)
        return USB_TRY_OPENED;
    snprintf(line, size, "%s: %s", light->name, why);
    return fault == GUD_LINK_GONE ? USB_TRY_AGAIN : USB_TRY_NO_GOOD;
}

static void leave(struct light_sink *light)
{
    usb_bulk_free(&light->port);
    usb_port_close(&light->port, false);
    libusb_exit(light->port.libusb);
    free(light);
}

/* NULL: `line` and `*attempt` say why. */
static struct light_sink *try_open(const struct sink_wish *wish, char *line, size_t size, enum usb_attempt *attempt)
{
    static struct usb_found found;
    struct usb_options any = usb_options;
    struct light_sink *light = allocate(1, sizeof *light);
    const int error = libusb_init(&light->port.libusb);
    if (error)
        fail("USB: libusb cannot start: %s; is /dev/bus/usb there?", libusb_strerror(error));
    light->sink = (struct sink){.format = GLINT_RGB565, .align_x = 1, .cost = usb_full_speed_cost, .name = light->name};
    light->link = (struct gud_link){.context = &light->port, .control = usb_control};
    light->port.stoppable = true;
    any.detach = true; /* the kernel's driver may keep the display */
    usb_find(light->port.libusb, &any, 0, &found);
    const struct usb_device *device = usb_choose(&found, &any, line, size, attempt);
    if (device)
        *attempt = connect_shader(light, device, wish, line, size);
    if (*attempt == USB_TRY_OPENED)
        usb_remember(device);
    usb_found_free(&found);
    light->is_demo = wish->demo;
    if (*attempt == USB_TRY_OPENED)
        return light;
    leave(light);
    return NULL;
}

static struct sink *open_shader(const struct sink_wish *wish)
{
    char line[400];
    enum usb_attempt attempt;
    struct light_sink *light;
    for (unsigned moments = 0; !(light = try_open(wish, line, sizeof line, &attempt));) {
        if (stream_stopped())
            return NULL;
        if (!usb_options.wait || !usb_may_pass(attempt, &moments))
            fail("%s", line);
        progress("waiting for a USB display; Ctrl-C ends it");
        usb_pause_ms(WAIT_MS);
    }
    progress_end();
    return &light->sink;
}

/* ---- what is sent ---- */

/* What is unplugged in the middle of a transfer may fail in another way first; a moment later the system knows. */
static bool is_gone(struct light_sink *light, int fault)
{
    enum { MOMENT_MS = 300 };
    uint8_t status;
    if (fault != GUD_LINK_ERROR)
        return fault == GUD_LINK_GONE;
    usb_pause_ms(MOMENT_MS);
    return light->link.control(&light->port, true, LIGHT_GET_STATUS, 0, &status, 1) == GUD_LINK_GONE;
}

/* What a fault means for the stream. */
static enum sink_result result_of(struct light_sink *light, int fault, const char *what)
{
    if (!fault)
        return SINK_SENT;
    if (fault == GUD_LINK_STOPPED || stream_stopped())
        return SINK_INTERRUPTED;
    light->gone = is_gone(light, fault);
    if (!light->gone)
        fail("%s: %s: %s; plug it in again", light->name, what, gud_fault_words((enum gud_link_fault)fault));
    if (!usb_options.wait)
        fail("%s: unplugged; start again when it is back, or use --wait", light->name);
    warn("%s: unplugged; waiting for its return", light->name);
    return SINK_GONE;
}

static int send(struct light_sink *light, const uint8_t *data, size_t bytes)
{
    const int fault = usb_bulk_start(&light->port, data, bytes);
    return fault ? fault : usb_bulk_wait(&light->port);
}

static int send_material(struct light_sink *light, const struct light_material *material)
{
    uint8_t packed[LIGHT_MATERIAL_BYTES];
    light_material_pack(packed, material);
    return light->link.control(&light->port, false, LIGHT_SET_MATERIAL, 0, packed, sizeof packed);
}

static enum sink_result send_scene(struct sink *sink, const struct light_material *material, const uint32_t *normals)
{
    struct light_sink *light = of(sink);
    const size_t count = (size_t)sink->width * sink->height;
    uint8_t *map = allocate(count, 4);
    for (size_t i = 0; i < 4 * count; i++)
        map[i] = (uint8_t)(normals[i / 4] >> 8 * (i % 4));
    int fault = send_material(light, material);
    if (fault >= 0)
        fault = light->link.control(&light->port, false, LIGHT_SET_MAP, 0, NULL, 0);
    if (fault >= 0)
        fault = send(light, map, 4 * count);
    free(map);
    return result_of(light, fault, "the scene");
}

static enum sink_result send_message(struct light_sink *light, const uint8_t *message, size_t bytes, const char *what)
{
    int fault = usb_bulk_wait(&light->port); /* the device takes a light when it has room: it sets the pace */
    if (!fault)
        fault = usb_bulk_start(&light->port, message, bytes);
    return result_of(light, fault, what);
}

/* The display's own host may be drawing; that is soon done. */
static enum sink_result give_light(struct light_sink *light, const int32_t to_light[3])
{
    uint8_t message[LIGHT_MESSAGE_BYTES], status = GUD_OK;
    light_message_pack(message, 0, to_light);
    for (unsigned ms = 0;; ms += ASK_MS) {
        const int sent = light->link.control(&light->port, false, LIGHT_SET_LIGHT, 0, message, sizeof message);
        if (sent != GUD_LINK_STALL)
            return result_of(light, sent < 0 ? sent : 0, "the light");
        const int got = light->link.control(&light->port, true, LIGHT_GET_STATUS, 0, &status, 1);
        if (got < 0 || stream_stopped())
            return got < 0 ? result_of(light, got, "the light") : SINK_INTERRUPTED;
        const char *refusal = usb_demo_refusal(status);
        if (refusal || ms >= BUSY_MS)
            fail("%s: %s", light->name, refusal ? refusal : busy_words);
        usb_pause_ms(ASK_MS);
    }
}

static enum sink_result send_light(struct sink *sink, const int32_t to_light[3], size_t *bytes)
{
    struct light_sink *light = of(sink);
    uint8_t *message = light->messages[light->frames % 2];
    *bytes = LIGHT_MESSAGE_BYTES;
    if (light->is_demo)
        return give_light(light, to_light);
    light_message_pack(message, light->frames++, to_light);
    return send_message(light, message, LIGHT_MESSAGE_BYTES, "a light");
}

/* Those that hold none refuse to tell of it. */
static enum sink_result find_mesh(struct sink *sink, struct light_mesh *mesh, bool *holds_one)
{
    struct light_sink *light = of(sink);
    uint8_t bytes[LIGHT_MESH_BYTES];
    const int got = light->link.control(&light->port, true, LIGHT_GET_MESH, 0, bytes, sizeof bytes);
    *holds_one = got == sizeof bytes;
    if (*holds_one)
        light_mesh_unpack(mesh, bytes);
    return result_of(light, got < 0 && got != GUD_LINK_STALL ? got : 0, "its mesh");
}

static enum sink_result send_mesh(struct sink *sink, const struct light_material *material)
{
    struct light_sink *light = of(sink);
    int fault = send_material(light, material);
    if (fault >= 0)
        fault = light->link.control(&light->port, false, LIGHT_SET_MESH, 0, NULL, 0);
    return result_of(light, fault < 0 ? fault : 0, "the mesh");
}

static enum sink_result send_pose(struct sink *sink, const struct light_pose *pose, size_t *bytes)
{
    struct light_sink *light = of(sink);
    uint8_t *message = light->messages[light->frames % 2];
    light_pose_pack(message, light->frames++, pose);
    *bytes = LIGHT_POSE_BYTES;
    return send_message(light, message, LIGHT_POSE_BYTES, "a pose");
}

const char *usb_demo_refusal(uint8_t status)
{
    if (status == GUD_BUSY)
        return NULL;
    if (status == GUD_UNSUPPORTED)
        return "its firmware is too old to take a light for its own picture; load this version's";
    if (status == GUD_PROTOCOL)
        return "it shows what another program sends; end that";
    if (status == GUD_PARAMETER)
        return "it takes no light straight from behind; give another direction";
    return "it refuses the light";
}

const char *usb_light_refusal(int32_t to_light[3], int got, const uint8_t bytes[LIGHT_MESSAGE_BYTES])
{
    if (got != LIGHT_MESSAGE_BYTES)
        return "its firmware is too old to tell where the light is; load this version's, or leave out --lights board";
    const uint32_t sense = light_message_unpack(to_light, bytes);
    if (sense == LIGHT_NO_SENSOR)
        return "it has no accelerometer; leave out --lights board";
    if (sense == LIGHT_SENSED && (to_light[0] || to_light[1] || to_light[2]))
        return NULL;
    return "its accelerometer does not answer; plug it in again, or leave out --lights board";
}

static enum sink_result read_light(struct sink *sink, int32_t to_light[3])
{
    struct light_sink *light = of(sink);
    uint8_t bytes[LIGHT_MESSAGE_BYTES];
    for (unsigned ms = 0;; ms += ASK_MS) {
        const int got = light->link.control(&light->port, true, LIGHT_GET_LIGHT, 0, bytes, sizeof bytes);
        if (got < 0 && got != GUD_LINK_STALL)
            return result_of(light, got, "the board's light");
        const char *refusal = usb_light_refusal(to_light, got, bytes);
        if (!refusal)
            return SINK_SENT;
        if (got != sizeof bytes || bytes[0] != LIGHT_SENSOR_SILENT || ms >= SENSOR_MS) /* after power-up it may be */
            fail("%s: %s", light->name, refusal);
        usb_pause_ms(ASK_MS);
    }
}

/* Waits until the device has drawn the frames of the last lights. */
static void wait_for_frames(struct light_sink *light)
{
    uint8_t status = GUD_BUSY;
    if (usb_bulk_wait(&light->port))
        return;
    for (unsigned ms = 0; status == GUD_BUSY && ms < LAST_FRAMES_MS && !stream_stopped(); ms += ASK_MS) {
        usb_pause_ms(ASK_MS);
        if (light->link.control(&light->port, true, LIGHT_GET_STATUS, 0, &status, 1) != 1)
            return;
    }
}

static void light_close(struct sink *sink)
{
    struct light_sink *light = of(sink);
    const bool is_enabled = !light->gone && !light->is_demo;
    const char *why;
    if (is_enabled)
        wait_for_frames(light);
    light->port.stoppable = false;
    if (is_enabled && enable(light, 0, &why))
        warn("%s: it did not give the panel back: %s", light->name, why);
    leave(light);
}

const struct sink_shader usb_shader = {.open = open_shader,
                                       .send_scene = send_scene,
                                       .send_light = send_light,
                                       .find_mesh = find_mesh,
                                       .send_mesh = send_mesh,
                                       .send_pose = send_pose,
                                       .read_light = read_light,
                                       .close = light_close};
