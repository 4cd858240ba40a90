/* SPDX-License-Identifier: MIT
 * Hands TinyUSB's callbacks to the portable devices. */
#include "usb.h"

#include <tusb.h>

#include "usb_bos.h"
#include "usb_class.h"
#include "usb_descriptors.h"

static struct {
    struct gud_device *gud;
    struct light_device *light;
    bool is_mounted, is_suspended;
    bool is_new;                              /* the configuration that is set just now */
    uint8_t reply[GUD_REPLY_BYTES], data[64]; /* they outlive the callback */
} usb;

void usb_poll(void)
{
    usb_class_poll();
    if (!tud_task_event_ready()) /* cheaper than tud_task */
        return;
    tud_task();
    if (usb.is_mounted && !tud_mounted()) /* TinyUSB reports a bus reset in no other way */
        tud_umount_cb();
}

bool usb_is_suspended(void)
{
    return usb.is_mounted && usb.is_suspended;
}

/* ---- the bus ---- */

static void reset(bool is_mounted)
{
    usb.is_mounted = is_mounted;
    usb.is_suspended = false;
    gud_device_reset(usb.gud);
    light_device_reset(usb.light);
}

void tud_mount_cb(void)
{
    reset(true);
    usb.is_new = true;
}

void tud_umount_cb(void)
{
    reset(false);
}

void tud_suspend_cb(bool remote_wakeup)
{
    (void)remote_wakeup;
    usb.is_suspended = true;
    gud_device_suspend(usb.gud);
}

void tud_resume_cb(void)
{
    usb.is_suspended = false;
    gud_device_resume(usb.gud);
}

/* TinyUSB does nothing where a host sets the configuration that is set, as Linux does to reset a device without its bus, but hosts count packets
 * anew after it (USB 2.0, 9.1.1.5). So the linker leads its acknowledgements here first. */
bool __real_tud_control_status(uint8_t port, const tusb_control_request_t *request);
bool __wrap_tud_control_status(uint8_t port, const tusb_control_request_t *request);

bool __wrap_tud_control_status(uint8_t port, const tusb_control_request_t *request)
{
    const bool configures = request->bmRequestType == 0 && request->bRequest == TUSB_REQ_SET_CONFIGURATION;
    if (configures && usb.is_mounted && !usb.is_new) {
        usb_class_restart(port);
        reset(true);
    }
    usb.is_new = false;
    return __real_tud_control_status(port, request);
}

/* ---- requests ---- */

/* Requests to an interface have it as wIndex. */
static bool is_for_light(const struct gud_setup *setup)
{
    return USB_INTERFACES > USB_LIGHT && setup->index == USB_LIGHT;
}

static bool set(const struct gud_setup *setup)
{
    return is_for_light(setup) ? light_device_set(usb.light, setup, usb.data)
                               : gud_device_set(usb.gud, setup, usb.data);
}

static bool begin(uint8_t port, const tusb_control_request_t *request, const struct gud_setup *setup)
{
    const int length = is_for_light(setup) ? light_device_setup(usb.light, setup, usb.reply)
                                           : gud_device_setup(usb.gud, setup, usb.reply);
    if (length == GUD_STALL || length > (int)sizeof usb.data)
        return false;
    if (request->bmRequestType_bit.direction == TUSB_DIR_IN)
        return tud_control_xfer(port, request, usb.reply, (uint16_t)length);
    if (length > 0)
        return tud_control_xfer(port, request, usb.data, (uint16_t)length);
    return set(setup) && tud_control_status(port, request);
}

/* What wIndex means depends on the recipient: that comes first. */
bool tud_vendor_control_xfer_cb(uint8_t port, uint8_t stage, const tusb_control_request_t *request)
{
    if (request->bmRequestType_bit.recipient == TUSB_REQ_RCPT_DEVICE)
        return stage != CONTROL_STAGE_SETUP || usb_bos_request(port, request);
    if (request->bmRequestType_bit.recipient != TUSB_REQ_RCPT_INTERFACE)
        return false;
    const struct gud_setup setup = {request->bmRequestType, request->bRequest, request->wValue, request->wIndex,
                                    request->wLength};
    if (stage == CONTROL_STAGE_SETUP)
        return begin(port, request, &setup);
    if (stage == CONTROL_STAGE_DATA && request->bmRequestType_bit.direction == TUSB_DIR_OUT)
        return set(&setup);
    return true;
}

/* ---- bulk ---- */

static bool has_room(enum usb_interface interface, size_t count)
{
    return interface == USB_GUD || light_device_has_room(usb.light, count);
}

static void take(enum usb_interface interface, const uint8_t *bytes, size_t count)
{
    if (interface == USB_GUD)
        gud_device_bulk(usb.gud, bytes, count);
    else
        light_device_bulk(usb.light, bytes, count);
}

static void restart(enum usb_interface interface)
{
    if (interface == USB_GUD)
        gud_device_restart(usb.gud);
}

/* ---- start ---- */

void usb_start(struct gud_device *gud, struct light_device *light)
{
    static const struct usb_class_ops bulk = {has_room, take, restart};
    usb.gud = gud;
    usb.light = light;
    (void)usb_serial();
    usb_class_start(&bulk);
    tusb_init();
}
