/* SPDX-License-Identifier: MIT
 * Which USB display, as the user names it. */
#ifndef GLINT_USB_OPTIONS_H
#define GLINT_USB_OPTIONS_H

#include <argp.h>
#include <stdbool.h>
#include <stdint.h>

enum { USB_PATH_ROOM = 32 };

struct usb_options {
    uint32_t id;        /* vendor << 16 | product; 0: any */
    const char *serial; /* NULL: any */
    const char *path;   /* "1-3.1"; NULL: any */
    bool detach, wait;
};

extern struct usb_options usb_options; /* from the command line; once a display is open, that one */
extern const struct argp usb_options_argp;

#endif
