/* SPDX-License-Identifier: MIT */
#include "unit.h"

#include "lab.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#define DEVICE "/sys/devices/platform/usbip-vudc.0/usbip_sockfd"
#define HOST "/sys/devices/platform/vhci_hcd.0/attach"

enum { PORT = 0, DEVICE_ID = 1, SPEED_HIGH = 3 /* enum usb_device_speed */ };

static void write_file(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    if (!file || fputs(text, file) < 0 || fclose(file) != 0)
        fail_msg("%s: writing %s: %s", path, text, strerror(errno));
}

void usbip_attach(void)
{
    int ends[2];
    char text[64];
    assert_int_equal(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
    snprintf(text, sizeof text, "%d", ends[0]);
    write_file(DEVICE, text);
    snprintf(text, sizeof text, "%d %d %d %d", PORT, ends[1], DEVICE_ID, SPEED_HIGH);
    write_file(HOST, text);
    close(ends[0]); /* the kernel holds both */
    close(ends[1]);
}
