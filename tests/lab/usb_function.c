/* SPDX-License-Identifier: MIT */
#include "usb_function.h"

#include <endian.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/usb/functionfs.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#define GADGETS "/sys/kernel/config/usb_gadget"

/* Reports what fails; the test then ends because no device appears. */
static void put(const char *folder, const char *file, const char *format, ...) __attribute__((format(printf, 3, 4)));
static void put(const char *folder, const char *file, const char *format, ...)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, file);
    FILE *stream = fopen(path, "w");
    va_list arguments;
    va_start(arguments, format);
    if (!stream || vfprintf(stream, format, arguments) < 0 || fclose(stream) != 0)
        fprintf(stderr, "usb_function: %s: %s\n", path, strerror(errno));
    va_end(arguments);
}

static void make_folder(const char *folder, const char *name)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (mkdir(path, 0755) != 0 && errno != EEXIST)
        fprintf(stderr, "usb_function: %s: %s\n", path, strerror(errno));
}

static void write_descriptors(int ep0, const char *name)
{
    struct {
        struct usb_functionfs_descs_head_v2 head;
        __le32 full_count, high_count;
        struct {
            struct usb_interface_descriptor interface;
            struct usb_endpoint_descriptor_no_audio bulk;
        } __attribute__((packed)) full, high;
    } __attribute__((packed)) all = {.head = {.magic = htole32(FUNCTIONFS_DESCRIPTORS_MAGIC_V2),
                                              .flags = htole32(FUNCTIONFS_HAS_FS_DESC | FUNCTIONFS_HAS_HS_DESC),
                                              .length = htole32(sizeof all)},
                                     .full_count = htole32(2),
                                     .high_count = htole32(2),
                                     .full = {.interface = {.bLength = sizeof all.full.interface,
                                                            .bDescriptorType = USB_DT_INTERFACE,
                                                            .bNumEndpoints = 1,
                                                            .bInterfaceClass = USB_CLASS_VENDOR_SPEC,
                                                            .iInterface = 1},
                                              .bulk = {.bLength = sizeof all.full.bulk,
                                                       .bDescriptorType = USB_DT_ENDPOINT,
                                                       .bEndpointAddress = 1 | USB_DIR_OUT,
                                                       .bmAttributes = USB_ENDPOINT_XFER_BULK,
                                                       .wMaxPacketSize = htole16(64)}}};
    all.high = all.full;
    all.high.bulk.wMaxPacketSize = htole16(512);
    struct {
        struct usb_functionfs_strings_head head;
        __le16 language;
        char name[64];
    } __attribute__((packed)) strings = {.language = htole16(0x409)};
    snprintf(strings.name, sizeof strings.name, "%s", name);
    const size_t bytes = sizeof strings.head + sizeof strings.language + strlen(strings.name) + 1;
    strings.head = (struct usb_functionfs_strings_head){.magic = htole32(FUNCTIONFS_STRINGS_MAGIC),
                                                        .length = htole32((uint32_t)bytes),
                                                        .str_count = htole32(1),
                                                        .lang_count = htole32(1)};
    if (write(ep0, &all, sizeof all) < 0 || write(ep0, &strings, bytes) < 0)
        perror("usb_function: descriptors");
}

void usb_function_build(struct usb_function *f, const char *name, const struct usb_function_ids *ids)
{
    char path[256], mounted[64];
    snprintf(f->folder, sizeof f->folder, GADGETS "/%s", name);
    snprintf(mounted, sizeof mounted, "/run/%s", name);
    make_folder(GADGETS, name);
    make_folder("/run", name);
    put(f->folder, "idVendor", "%#x", ids->vendor);
    put(f->folder, "idProduct", "%#x", ids->product);
    if (ids->full_speed)
        put(f->folder, "max_speed", "full-speed");
    make_folder(f->folder, "strings/0x409");
    if (ids->serial)
        put(f->folder, "strings/0x409/serialnumber", "%s", ids->serial);
    put(f->folder, "strings/0x409/product", "Lab display");
    make_folder(f->folder, "configs/c.1");
    snprintf(path, sizeof path, "functions/ffs.%s", name);
    make_folder(f->folder, path);
    char function[400], link[256];
    snprintf(function, sizeof function, "%s/%s", f->folder, path);
    snprintf(link, sizeof link, "%s/configs/c.1/f", f->folder);
    if (symlink(function, link) != 0 || mount(name, mounted, "functionfs", 0, NULL) != 0)
        perror("usb_function: function");
    snprintf(path, sizeof path, "%s/ep0", mounted);
    f->ep0 = open(path, O_RDWR);
    write_descriptors(f->ep0, ids->interface ? ids->interface : "Lab GUD display");
    fcntl(f->ep0, F_SETFL, O_NONBLOCK); /* for events; data is waited for all the same */
    snprintf(path, sizeof path, "%s/ep1", mounted);
    f->bulk = open(path, O_RDWR);
    if (f->ep0 < 0 || f->bulk < 0)
        perror(path);
}

void usb_function_remove(const char *name)
{
    char path[256];
    static const char *const folders[] = {"configs/c.1", NULL, "strings/0x409", ""};
    snprintf(path, sizeof path, GADGETS "/%s/configs/c.1/f", name);
    unlink(path);
    snprintf(path, sizeof path, "/run/%s", name);
    umount2(path, MNT_DETACH);
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        if (folders[i])
            snprintf(path, sizeof path, GADGETS "/%s/%s", name, folders[i]);
        else
            snprintf(path, sizeof path, GADGETS "/%s/functions/ffs.%s", name, name);
        rmdir(path);
    }
}

void usb_function_plug(const struct usb_function *f, unsigned controller)
{
    put(f->folder, "UDC", "dummy_udc.%u", controller);
}

void usb_function_unplug(const struct usb_function *f)
{
    put(f->folder, "UDC", "\n");
}
