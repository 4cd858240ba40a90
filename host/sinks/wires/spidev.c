/* SPDX-License-Identifier: MIT */
#include "sinks/wires/spidev.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/spi/spidev.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/message.h"
#include "sinks/wires/device.h"

enum { USUAL_CHUNK = 4096 };

static _Noreturn void fail_absent(const char *path)
{
    char **names;
    const unsigned count = device_names("spidev", &names);
    if (count)
        fail("--spidev: %s: there is no such device; choose from /dev/%s%s (`glint list` shows all)", path, names[0],
             count > 1 ? " ..." : "");
    fail("--spidev: %s: there is no SPI device; switch the SPI bus on (Raspberry Pi: dtparam=spi=on in config.txt), "
         "or drive "
         "the wires by --to gpio",
         path);
}

/* As the module was loaded: a longer write is refused. */
static size_t largest_write(void)
{
    unsigned long bytes = 0;
    FILE *file = fopen("/sys/module/spidev/parameters/bufsiz", "r");
    if (file) {
        if (fscanf(file, "%lu", &bytes) != 1)
            bytes = 0;
        fclose(file);
    }
    return bytes ? bytes : USUAL_CHUNK;
}

int spidev_open(const char *path, uint32_t hz, bool rests_high, size_t *chunk)
{
    const int descriptor = open(path, O_RDWR | O_CLOEXEC);
    if (descriptor < 0 && errno == ENOENT)
        fail_absent(path);
    if (descriptor < 0 && errno == EACCES)
        fail("--spidev: %s: %s", path, device_permission(path));
    if (descriptor < 0)
        fail("--spidev: %s: %s", path, strerror(errno));
    const uint8_t mode = rests_high ? SPI_MODE_3 : SPI_MODE_0, bits = 8;
    if (ioctl(descriptor, SPI_IOC_WR_MODE, &mode) != 0 || ioctl(descriptor, SPI_IOC_WR_BITS_PER_WORD, &bits) != 0) {
        if (errno == ENOTTY)
            fail("--spidev: %s: is not an SPI device; their names are /dev/spidevB.C", path);
        fail("--spidev: %s: cannot do mode %u with 8 bits: %s", path, mode, strerror(errno));
    }
    if (ioctl(descriptor, SPI_IOC_WR_MAX_SPEED_HZ, &hz) != 0)
        fail("--spi-hz: %s: cannot do %u: %s", path, hz, strerror(errno));
    *chunk = largest_write();
    return descriptor;
}

/* ---- for `glint list` ---- */

static json_t *list_device(const char *name)
{
    char path[300];
    snprintf(path, sizeof path, "/dev/%s", name);
    const int descriptor = open(path, O_RDWR | O_CLOEXEC);
    uint32_t hz = 0;
    if (descriptor >= 0 && ioctl(descriptor, SPI_IOC_RD_MAX_SPEED_HZ, &hz) == 0) {
        close(descriptor);
        return json_pack("{s:s, s:I}", "device", path, "max_hz", (json_int_t)hz);
    }
    const int reason = errno;
    if (descriptor >= 0)
        close(descriptor);
    char *why = reason == EACCES ? device_permission(path) : copied(strerror(reason));
    json_t *device = json_pack("{s:s, s:s}", "device", path, "error", why);
    free(why);
    return device;
}

json_t *spidev_list(void)
{
    json_t *devices = json_array();
    char **names;
    const unsigned count = device_names("spidev", &names);
    for (unsigned i = 0; i < count; i++)
        json_array_append_new(devices, list_device(names[i]));
    device_names_free(names, count);
    return devices;
}

void spidev_print(const json_t *devices, FILE *stream)
{
    size_t i;
    json_t *device;
    json_array_foreach(devices, i, device)
    {
        const char *path = json_string_value(json_object_get(device, "device"));
        const char *error = json_string_value(json_object_get(device, "error"));
        if (error)
            fprintf(stream, "%s: %s\n", path, error);
        else
            fprintf(stream, "%s  at most %lld Hz\n", path,
                    (long long)json_integer_value(json_object_get(device, "max_hz")));
    }
}
