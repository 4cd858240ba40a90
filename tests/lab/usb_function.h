/* SPDX-License-Identifier: MIT
 * A USB device with one interface of vendor class and one bulk OUT endpoint, through the kernel's FunctionFS. */
#ifndef LAB_USB_FUNCTION_H
#define LAB_USB_FUNCTION_H

#include <stdbool.h>
#include <stdint.h>

struct usb_function_ids {
    uint16_t vendor, product;
    const char *serial;    /* NULL: none */
    const char *interface; /* its name; NULL: "Lab GUD display" */
    bool full_speed;
};

struct usb_function {
    char folder[64]; /* in configfs */
    int ep0, bulk;   /* descriptors, open */
};

void usb_function_build(struct usb_function *f, const char *name, const struct usb_function_ids *ids);
void usb_function_plug(const struct usb_function *f, unsigned controller); /* into dummy_udc.N */
void usb_function_unplug(const struct usb_function *f);
void usb_function_remove(const char *name); /* its process has ended */

#endif
