/* SPDX-License-Identifier: MIT */
#include "sinks/usb/choose.h"

#include <stdio.h>
#include <string.h>

#include "gud_protocol.h"

static void wanted_text(const struct usb_options *options, char *text, size_t size)
{
    const size_t ends = size - 1;
    *text = '\0';
    if (options->path)
        snprintf(text, size, " at %s", options->path);
    if (options->serial)
        snprintf(text + strlen(text), ends - strlen(text), " with serial number %s", options->serial);
    if (options->id)
        snprintf(text + strlen(text), ends - strlen(text), " with IDs %04x:%04x", options->id >> 16,
                 options->id & 0xffff);
}

static void none_text(const struct usb_options *options, char *line, size_t size)
{
    char wanted[120];
    wanted_text(options, wanted, sizeof wanted);
    if (*wanted)
        snprintf(line, size, "no USB device%s; `glint list` shows the displays; --wait waits for one", wanted);
    else
        snprintf(line, size,
                 "no USB display: no device has the IDs %04x:%04x, %04x:%04x or %04x:%04x, and none "
                 "calls its interface GUD; plug it in, name another by --vid-pid, or give --wait",
                 GUD_ID_OPENMOKO >> 16, GUD_ID_OPENMOKO & 0xffff, GUD_ID_MCS >> 16, GUD_ID_MCS & 0xffff,
                 GUD_ID_PIDCODES >> 16, GUD_ID_PIDCODES & 0xffff);
}

static void several_text(const struct usb_found *found, const bool *fits, char *line, size_t size)
{
    bool first = true;
    snprintf(line, size, "several USB displays: ");
    for (unsigned i = 0; i < found->count; i++) {
        const struct usb_device *device = &found->devices[i];
        if (!fits[i])
            continue;
        snprintf(line + strlen(line), size - strlen(line), "%s%s (%04x:%04x%s%s)", first ? "" : ", ", device->path,
                 device->id >> 16, device->id & 0xffff, *device->serial ? " serial " : "", device->serial);
        first = false;
    }
    snprintf(line + strlen(line), size - strlen(line), "; choose one by --usb-path, --serial or --vid-pid");
}

enum usb_attempt usb_unusable(const struct usb_device *device, char *line, size_t size)
{
    char name[48];
    usb_name(device, name, sizeof name);
    switch (device->state) {
    case USB_KERNEL:
        snprintf(line, size,
                 "%s: the kernel's driver %s has it; --detach takes the monitor from the desktop until glint ends",
                 name, device->driver);
        break;
    case USB_IN_USE:
        snprintf(line, size, "%s: another program uses it; end that first", name);
        break;
    case USB_DENIED:
        snprintf(
            line, size,
            "%s: permission denied; install glint's udev rule (make install, 70-glint.rules) and plug it in again, "
            "or run as root",
            name);
        break;
    default:
        snprintf(line, size, "%s: %s", name, device->problem.text);
        break;
    }
    return device->state == USB_DENIED || device->state == USB_IN_USE ? USB_TRY_SOON
           : device->state == USB_VANISHED                            ? USB_TRY_AGAIN
                                                                      : USB_TRY_NO_GOOD;
}

const struct usb_device *usb_choose(const struct usb_found *found, const struct usb_options *options, char *line,
                                    size_t size, enum usb_attempt *attempt)
{
    const struct usb_device *chosen = NULL, *unusable = NULL;
    bool fits[USB_FOUND_MAX] = {false};
    unsigned count = 0;
    for (unsigned i = 0; i < found->count; i++) {
        const struct usb_device *device = &found->devices[i];
        fits[i] = device->state == USB_DISPLAY || (device->state == USB_KERNEL && options->detach);
        if (fits[i]) {
            chosen = device;
            count++;
        } else if (device->state != USB_VANISHED && (!unusable || unusable->state == USB_NOT_DISPLAY)) {
            unusable = device;
        }
    }
    *attempt = USB_TRY_NO_GOOD;
    if (count == 1)
        return chosen;
    if (count) {
        several_text(found, fits, line, size);
    } else if (unusable) {
        *attempt = usb_unusable(unusable, line, size);
    } else {
        none_text(options, line, size);
        *attempt = USB_TRY_AGAIN;
    }
    return NULL;
}

void usb_remember(const struct usb_device *device)
{
    static char serial[sizeof device->serial];
    usb_options.id = device->id;
    if (!usb_options.serial && *device->serial)
        usb_options.serial = strcpy(serial, device->serial);
}

bool usb_may_pass(enum usb_attempt attempt, unsigned *moments)
{
    enum { SOON_TRIES = 8 };
    if (attempt == USB_TRY_AGAIN) /* what comes back begins anew */
        *moments = 0;
    return attempt == USB_TRY_AGAIN || (attempt == USB_TRY_SOON && ++*moments < SOON_TRIES);
}
