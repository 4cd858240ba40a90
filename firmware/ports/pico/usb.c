/* SPDX-License-Identifier: MIT
 * TinyUSB's callbacks, on to the portable GUD device. */
#include "usb.h"

#include <tusb.h>

static struct {
    struct gud_device *gud;
    bool is_mounted, is_suspended;
    uint8_t reply[GUD_REPLY_BYTES], data[GUD_DATA_BYTES]; /* they outlive the callback */
} usb;

void usb_start(struct gud_device *gud)
{
    usb.gud = gud;
    tusb_init();
}

void usb_poll(void)
{
    if (!tud_task_event_ready()) /* a cheaper question than tud_task's own */
        return;
    tud_task();
    if (usb.is_mounted && !tud_mounted()) /* a bus reset is told in no other way */
        tud_umount_cb();
}

bool usb_is_suspended(void)
{
    return usb.is_mounted && usb.is_suspended;
}

/* ---- the bus ---- */

void tud_mount_cb(void)
{
    usb.is_mounted = true;
    usb.is_suspended = false;
    gud_device_reset(usb.gud);
}

void tud_umount_cb(void)
{
    usb.is_mounted = false;
    usb.is_suspended = false;
    gud_device_reset(usb.gud);
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

/* ---- requests and pixels ---- */

static bool begin(uint8_t port, const tusb_control_request_t *request, const struct gud_setup *setup)
{
    const int length = gud_device_setup(usb.gud, setup, usb.reply);
    if (length == GUD_STALL)
        return false;
    if (request->bmRequestType_bit.direction == TUSB_DIR_IN)
        return tud_control_xfer(port, request, usb.reply, (uint16_t)length);
    if (length > 0)
        return tud_control_xfer(port, request, usb.data, (uint16_t)length);
    return gud_device_set(usb.gud, setup, usb.data) && tud_control_status(port, request);
}

bool tud_vendor_control_xfer_cb(uint8_t port, uint8_t stage, const tusb_control_request_t *request)
{
    const struct gud_setup setup = {request->bmRequestType, request->bRequest, request->wValue, request->wIndex,
                                    request->wLength};
    if (stage == CONTROL_STAGE_SETUP)
        return begin(port, request, &setup);
    if (stage == CONTROL_STAGE_DATA && request->bmRequestType_bit.direction == TUSB_DIR_OUT)
        return gud_device_set(usb.gud, &setup, usb.data);
    return true;
}

void usb_take(enum usb_interface interface, const uint8_t *bytes, size_t count)
{
    (void)interface;
    gud_device_bulk(usb.gud, bytes, count);
}
