/* SPDX-License-Identifier: MIT */
#include "sinks/usb/options.h"

#include <stdio.h>
#include <string.h>

#include "base/argp.h"

struct usb_options usb_options;

enum key { KEY_VID_PID = 0x600, KEY_SERIAL, KEY_USB_PATH, KEY_DETACH, KEY_WAIT };

static const struct argp_option argp_options[] = {
    {NULL, 0, NULL, 0, "USB displays (--to usb); where there are several, name one:", 8},
    {"usb-path", KEY_USB_PATH, "PORT", 0, "Where it is plugged in, as `glint list` shows it: 1-3.1", 8},
    {"serial", KEY_SERIAL, "TEXT", 0, "Its serial number", 8},
    {"vid-pid", KEY_VID_PID, "VVVV:PPPP", 0, "Its vendor and product IDs, hexadecimal", 8},
    {"detach", KEY_DETACH, NULL, 0,
     "Take a display that the kernel's driver has: the desktop loses this monitor until glint ends", 8},
    {"wait", KEY_WAIT, NULL, 0, "Wait until it is plugged in, and when it is unplugged, until it is back", 8},
    {NULL, 0, NULL, 0, NULL, 0}};

static uint32_t parse_id(const struct argp_state *state, const char *text)
{
    unsigned vendor, product;
    int end = 0;
    if (strspn(text, "0123456789abcdefABCDEF:") != strlen(text) ||
        sscanf(text, "%4x:%4x%n", &vendor, &product, &end) != 2 || text[end] || !(vendor || product))
        refuse(state, "--vid-pid: '%s' is not two numbers of up to four hexadecimal digits, as 1d50:614d", text);
    return (uint32_t)vendor << 16 | product;
}

static const char *parse_path(const struct argp_state *state, const char *text)
{
    const char *dash = strchr(text, '-');
    if (strspn(text, "0123456789.-") != strlen(text) || !dash || dash == text || !dash[1] || strchr(dash + 1, '-') ||
        strlen(text) >= USB_PATH_ROOM)
        refuse(state, "--usb-path: '%s' is not a bus and its ports, as 1-3.1; see `glint list`", text);
    return text;
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    switch (key) {
    case KEY_VID_PID:
        usb_options.id = parse_id(state, text);
        return 0;
    case KEY_SERIAL:
        if (!*text)
            refuse(state, "--serial: the serial number is empty; see `glint list`");
        usb_options.serial = text;
        return 0;
    case KEY_USB_PATH:
        usb_options.path = parse_path(state, text);
        return 0;
    case KEY_DETACH:
        usb_options.detach = true;
        return 0;
    case KEY_WAIT:
        usb_options.wait = true;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp usb_options_argp = {argp_options, parse_option, NULL, NULL, NULL, NULL, NULL};
