/* SPDX-License-Identifier: MIT
 * Vendor interfaces with one bulk OUT endpoint each. Packets go to two buffers in turn, so that the next one arrives while
 * the last one is handled; TinyUSB's own vendor class would wait. Where there is no room for a packet, the host waits. */
#include <device/usbd_pvt.h>
#include <hardware/structs/usb_dpram.h>
#include <hardware/sync.h>
#include <tusb.h>

#include "usb_class.h"

static struct bulk {
    uint8_t endpoint; /* 0: not open */
    uint8_t turn;
    bool is_armed, is_halted;
    uint32_t packets[2][USB_PACKET / 4]; /* TinyUSB copies words where it can */
} bulk[USB_INTERFACES];

static const struct usb_class_ops *ops;

void usb_class_start(const struct usb_class_ops *wanted)
{
    ops = wanted;
}

static void reset(uint8_t port)
{
    (void)port;
    for (unsigned i = 0; i < USB_INTERFACES; i++)
        bulk[i].endpoint = 0;
}

static void init(void)
{
    reset(0);
}

/* At a bus reset TinyUSB's interrupt switches the endpoints off and empties what it knows of them, which is not to be touched from then on; what
 * happened before is told first. */
static bool is_on(const struct bulk *b)
{
    return usb_dpram->ep_ctrl[b->endpoint - 1].out & EP_CTRL_ENABLE_BITS;
}

/* If there is room for the next packet and for those that are still to be taken. */
static void arm(uint8_t port, enum usb_interface i, size_t pending)
{
    struct bulk *b = &bulk[i];
    if (!b->endpoint || b->is_armed || b->is_halted || !ops->has_room(i, pending + USB_PACKET))
        return;
    const uint32_t interrupts = save_and_disable_interrupts();
    b->is_armed = is_on(b) && usbd_edpt_xfer(port, b->endpoint, (uint8_t *)b->packets[b->turn], USB_PACKET);
    restore_interrupts(interrupts);
}

void usb_class_poll(void)
{
    for (unsigned i = 0; i < USB_INTERFACES; i++)
        arm(0, (enum usb_interface)i, 0);
}

/* TinyUSB gives each interface of the configuration; returned are the bytes of its descriptors. */
static uint16_t open(uint8_t port, const tusb_desc_interface_t *interface, uint16_t max_len)
{
    const tusb_desc_endpoint_t *endpoint = (const void *)tu_desc_next(interface);
    const uint16_t len = sizeof *interface + sizeof *endpoint;
    if (interface->bInterfaceNumber >= USB_INTERFACES || max_len < len || !usbd_edpt_open(port, endpoint))
        return 0;
    struct bulk *b = &bulk[interface->bInterfaceNumber];
    b->endpoint = endpoint->bEndpointAddress;
    b->turn = 0;
    b->is_armed = b->is_halted = false;
    arm(port, (enum usb_interface)interface->bInterfaceNumber, 0);
    return len;
}

/* A halt, or its end: what was armed is given up, at the end even where there was no halt, as the next packet counts as the first one.
 * It is armed again when all that arrived before has been told. */
static void halt(uint8_t port, struct bulk *b, bool halts)
{
    if (!halts && is_on(b)) {
        usbd_edpt_stall(port, b->endpoint);
        usbd_edpt_clear_stall(port, b->endpoint);
    }
    b->is_halted = halts;
    b->is_armed = false;
}

static void restart(uint8_t port, enum usb_interface i, bool halts)
{
    halt(port, &bulk[i], halts);
    ops->restart(i);
}

void usb_class_restart(uint8_t port)
{
    for (unsigned i = 0; i < USB_INTERFACES; i++)
        if (bulk[i].endpoint)
            restart(port, (enum usb_interface)i, false);
}

/* Vendor requests do not come this way. Those to an endpoint are acknowledged whatever is returned, and so is SET_INTERFACE, which ends a
 * halt, too: after it hosts count packets anew (USB 2.0, 9.1.1.5), although there is one setting alone. */
static bool request(uint8_t port, uint8_t stage, const tusb_control_request_t *what)
{
    const bool is_standard = what->bmRequestType_bit.type == TUSB_REQ_TYPE_STANDARD && stage == CONTROL_STAGE_SETUP;
    const unsigned recipient = what->bmRequestType_bit.recipient;
    const bool is_halt = is_standard && recipient == TUSB_REQ_RCPT_ENDPOINT &&
                         (what->bRequest == TUSB_REQ_SET_FEATURE || what->bRequest == TUSB_REQ_CLEAR_FEATURE) &&
                         what->wValue == TUSB_REQ_FEATURE_EDPT_HALT;
    const bool is_choice =
        is_standard && recipient == TUSB_REQ_RCPT_INTERFACE && what->bRequest == TUSB_REQ_SET_INTERFACE;
    for (unsigned i = 0; i < USB_INTERFACES; i++)
        if (bulk[i].endpoint && (is_halt ? bulk[i].endpoint == what->wIndex : is_choice && i == what->wIndex))
            restart(port, (enum usb_interface)i, what->bRequest == TUSB_REQ_SET_FEATURE);
    return false;
}

static bool transferred(uint8_t port, uint8_t endpoint, xfer_result_t result, uint32_t bytes)
{
    for (unsigned i = 0; i < USB_INTERFACES; i++) {
        struct bulk *b = &bulk[i];
        if (b->endpoint != endpoint)
            continue;
        if (!b->is_armed) /* given up */
            return true;
        const uint8_t *packet = (const uint8_t *)b->packets[b->turn];
        b->turn = !b->turn;
        b->is_armed = false;
        arm(port, (enum usb_interface)i, bytes);
        if (result == XFER_RESULT_SUCCESS)
            ops->take((enum usb_interface)i, packet, bytes);
        return true;
    }
    return false;
}

const usbd_class_driver_t *usbd_app_driver_get_cb(uint8_t *count)
{
    static const usbd_class_driver_t driver = {.name = "glint",
                                               .init = init,
                                               .reset = reset,
                                               .open = open,
                                               .control_xfer_cb = request,
                                               .xfer_cb = transferred};
    *count = 1;
    return &driver;
}
