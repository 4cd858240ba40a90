/* SPDX-License-Identifier: MIT
 * attach COMMAND...: plugs a USB/IP device at full speed into the kernel's virtual host controller and becomes COMMAND, which
 * speaks for the device on file descriptor 3. */
#include <stdio.h>
#include <sys/socket.h>
#include <unistd.h>

enum { PORT = 0, DEVICE_ID = 1, SPEED_FULL = 2 /* enum usb_device_speed */, DEVICE_FD = 3 };

int main(int argc, char **argv)
{
    static const char path[] = "/sys/devices/platform/vhci_hcd.0/attach";
    int ends[2];
    FILE *file = argc > 1 ? fopen(path, "w") : NULL;
    if (!file || socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) {
        perror(argc > 1 ? path : "attach: no command");
        return 1;
    }
    fprintf(file, "%d %d %d %d", PORT, ends[1], DEVICE_ID, SPEED_FULL);
    if (fclose(file) != 0 || dup2(ends[0], DEVICE_FD) < 0) {
        perror(path);
        return 1;
    }
    if (ends[0] != DEVICE_FD)
        close(ends[0]);
    if (ends[1] != DEVICE_FD)
        close(ends[1]); /* the kernel holds it */
    execvp(argv[1], argv + 1);
    perror(argv[1]);
    return 127;
}
