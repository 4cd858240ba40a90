/* SPDX-License-Identifier: MIT
 * A class driver for TinyUSB: vendor interfaces with one bulk OUT endpoint each. Its packets go to two buffers by turns, so
 * that the next one arrives while the last one is handled; TinyUSB's own vendor class waits. */
#include <device/usbd_pvt.h>
#include <tusb.h>

#include "usb.h"

enum { PACKET = 64 };

static struct bulk {
    uint8_t endpoint; /* 0: not open */
    uint8_t turn;
    uint32_t packets[2][PACKET / 4]; /* TinyUSB copies words where it can */
} bulk[USB_INTERFACES];

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

static bool arm(uint8_t port, struct bulk *b)
{
    return usbd_edpt_xfer(port, b->endpoint, (uint8_t *)b->packets[b->turn], PACKET);
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
    return arm(port, b) ? len : 0;
}

static bool request(uint8_t port, uint8_t stage, const tusb_control_request_t *what)
{
    (void)port;
    (void)stage;
    (void)what;
    return false; /* vendor requests do not come this way, others are none of ours */
}

static bool transferred(uint8_t port, uint8_t endpoint, xfer_result_t result, uint32_t bytes)
{
    for (unsigned i = 0; i < USB_INTERFACES; i++) {
        struct bulk *b = &bulk[i];
        if (b->endpoint != endpoint)
            continue;
        const uint8_t *packet = (const uint8_t *)b->packets[b->turn];
        b->turn = !b->turn;
        const bool armed = arm(port, b);
        if (result == XFER_RESULT_SUCCESS)
            usb_take((enum usb_interface)i, packet, bytes);
        return armed;
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
