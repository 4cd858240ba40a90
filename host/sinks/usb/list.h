/* SPDX-License-Identifier: MIT
 * USB displays for glint list. */
#ifndef GLINT_USB_LIST_H
#define GLINT_USB_LIST_H

#include <jansson.h>
#include <stdio.h>

/* One that the kernel or another program has is named and not asked. */
json_t *usb_list(void);
void usb_list_print(const json_t *devices, FILE *stream);

#endif
