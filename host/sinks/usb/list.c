/* SPDX-License-Identifier: MIT */
#include "sinks/usb/list.h"

#include <stdlib.h>

#include "base/clock.h"
#include "base/json.h"
#include "sinks/gud/host.h"
#include "sinks/gud/pack.h"
#include "sinks/usb/find.h"
#include "sinks/usb/port.h"

/* For all devices together: a display answers each request in some milliseconds. */
#define LIST_S 1.2

static json_t *formats_json(const struct gud_display *display)
{
    json_t *formats = json_array();
    for (size_t i = 0; i < display->format_count; i++) {
        const char *name = gud_format_name(display->formats[i]);
        json_array_append_new(formats, name ? json_string(name) : json_integer(display->formats[i]));
    }
    return formats;
}

static json_t *modes_json(const struct gud_display *display)
{
    json_t *modes = json_array();
    for (size_t i = 0; i < display->mode_count; i++) {
        const struct gud_mode *mode = &display->modes[i];
        json_array_append_new(modes,
                              json_pack("{s:i, s:i, s:b}", "width", (int)mode->hdisplay, "height", (int)mode->vdisplay,
                                        "preferred", (mode->flags & GUD_MODE_PREFERRED) != 0));
    }
    return modes;
}

/* Formats, modes and limits, or the problem. */
static void describe(libusb_context *libusb, struct usb_device *device, double until, json_t *object)
{
    struct usb_port port = {.libusb = libusb, .brief = true, .until = until};
    struct gud_link link = {.context = &port, .control = usb_control};
    struct gud_display display;
    if (usb_port_open(&port, device->device, device->interface, NULL, &device->problem) != USB_OPENED) {
        json_object_set_new(object, "problem", json_text(device->problem.text));
        return;
    }
    if (gud_display_read(&link, &display, false, &device->problem)) {
        json_object_set_new(object, "formats", formats_json(&display));
        json_object_set_new(object, "modes", modes_json(&display));
        json_object_set_new(object, "lz4", json_boolean(display.descriptor.compression & GUD_COMPRESSION_LZ4));
        json_object_set_new(object, "max_buffer", json_integer(display.descriptor.max_buffer));
    } else {
        json_object_set_new(object, "problem", json_text(device->problem.text));
    }
    usb_port_close(&port, false);
}

static json_t *device_json(libusb_context *libusb, struct usb_device *device, double until)
{
    static const char *const states[] = {[USB_DISPLAY] = "free",
                                         [USB_KERNEL] = "taken by the kernel",
                                         [USB_IN_USE] = "in use by another program",
                                         [USB_DENIED] = "permission denied",
                                         [USB_NOT_DISPLAY] = "not usable",
                                         [USB_VANISHED] = "vanished"};
    char id[16];
    snprintf(id, sizeof id, "%04x:%04x", device->id >> 16, device->id & 0xffff);
    json_t *object =
        json_pack("{s:s, s:s, s:o, s:o, s:s}", "path", device->path, "id", id, "serial", json_text(device->serial),
                  "product", json_text(device->product), "state", states[device->state]);
    if (device->state == USB_KERNEL)
        json_object_set_new(object, "driver", json_text(device->driver));
    else if (device->state == USB_DISPLAY)
        describe(libusb, device, until, object);
    else if (device->state == USB_NOT_DISPLAY)
        json_object_set_new(object, "problem", json_text(device->problem.text));
    return object;
}

json_t *usb_list(void)
{
    static struct usb_found found;
    libusb_context *libusb;
    json_t *devices = json_array();
    if (libusb_init(&libusb))
        return devices;
    const double until = seconds_now() + LIST_S;
    usb_find(libusb, &(struct usb_options){0}, until, &found);
    for (unsigned i = 0; i < found.count; i++)
        json_array_append_new(devices, device_json(libusb, &found.devices[i], until));
    usb_found_free(&found);
    libusb_exit(libusb);
    return devices;
}

static const char *text_of(const json_t *device, const char *key)
{
    const char *text = json_string_value(json_object_get(device, key));
    return text ? text : "";
}

void usb_list_print(const json_t *devices, FILE *stream)
{
    size_t i, k;
    json_t *device, *item;
    json_array_foreach(devices, i, device)
    {
        fprintf(stream, "%-8s %s  %s", text_of(device, "path"), text_of(device, "id"), text_of(device, "state"));
        if (*text_of(device, "driver"))
            fprintf(stream, " (driver %s)", text_of(device, "driver"));
        if (*text_of(device, "product"))
            fprintf(stream, "  %s", text_of(device, "product"));
        if (*text_of(device, "serial"))
            fprintf(stream, "  serial %s", text_of(device, "serial"));
        if (*text_of(device, "problem"))
            fprintf(stream, "  %s", text_of(device, "problem"));
        json_array_foreach(json_object_get(device, "modes"), k, item)
        {
            fprintf(stream, "%s%lldx%lld%s", k ? " " : "  ", json_integer_value(json_object_get(item, "width")),
                    json_integer_value(json_object_get(item, "height")),
                    json_is_true(json_object_get(item, "preferred")) ? "*" : "");
        }
        json_array_foreach(json_object_get(device, "formats"), k, item) if (json_is_string(item))
            fprintf(stream, "%s%s", k ? " " : "  ", json_string_value(item));
        fprintf(stream, "%s\n", json_is_true(json_object_get(device, "lz4")) ? "  lz4" : "");
    }
}
