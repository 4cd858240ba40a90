/* SPDX-License-Identifier: MIT
 *
 * Names come from sysfs, so that devices that may not be opened have them, too. A device that a kernel driver has is sent
 * nothing. */
#include "sinks/usb/find.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sinks/gud/host.h"

static const uint32_t known_ids[] = {GUD_ID_OPENMOKO, GUD_ID_MCS, GUD_ID_PIDCODES};

static bool is_known(uint32_t id)
{
    for (size_t i = 0; i < sizeof known_ids / sizeof known_ids[0]; i++)
        if (known_ids[i] == id)
            return true;
    return false;
}

const char *usb_name(const struct usb_device *device, char *text, size_t size)
{
    snprintf(text, size, "usb %s (%04x:%04x)", device->path, device->id >> 16, device->id & 0xffff);
    return text;
}

/* A file of the kernel's about a device or interface; "" where there is none. */
static void read_file(const char *file_name, char *text, size_t size)
{
    char name[160];
    snprintf(name, sizeof name, "/sys/bus/usb/devices/%s", file_name);
    FILE *file = fopen(name, "re");
    *text = '\0';
    if (!file)
        return;
    if (fgets(text, (int)size, file))
        text[strcspn(text, "\n")] = '\0';
    fclose(file);
    for (char *at = text; *at; at++)
        if ((unsigned char)*at < ' ' || *at == 0x7f)
            *at = '?';
}

static void read_attribute(const struct usb_device *device, const char *attribute, char *text, size_t size)
{
    char file[128];
    snprintf(file, sizeof file, "%s/%s", device->path, attribute);
    read_file(file, text, size);
}

static void read_driver(struct usb_device *device, unsigned configuration, unsigned interface)
{
    char name[128], target[PATH_MAX];
    snprintf(name, sizeof name, "/sys/bus/usb/devices/%s:%u.%u/driver", device->path, configuration, interface);
    const ssize_t length = readlink(name, target, sizeof target - 1);
    target[length < 0 ? 0 : length] = '\0';
    const char *last = strrchr(target, '/');
    snprintf(device->driver, sizeof device->driver, "%.31s", last ? last + 1 : "");
}

bool usb_path_text(uint8_t bus, const uint8_t *ports, int count, char *text, size_t size)
{
    int length = snprintf(text, size, "%u", bus);
    for (int i = 0; i < count && length >= 0 && (size_t)length < size; i++)
        length += snprintf(text + length, size - (size_t)length, "%c%u", i ? '.' : '-', ports[i]);
    return count > 0 && length >= 0 && (size_t)length < size;
}

static bool read_path(struct usb_device *device)
{
    uint8_t ports[8];
    const int count = libusb_get_port_numbers(device->device, ports, sizeof ports);
    return usb_path_text(libusb_get_bus_number(device->device), ports, count, device->path, sizeof device->path);
}

/* The kernel has read the name already: nothing is sent to the device. */
static bool says_gud(const struct usb_device *device, unsigned configuration, unsigned interface)
{
    char file[128], name[128];
    snprintf(file, sizeof file, "%s:%u.%u/interface", device->path, configuration, interface);
    read_file(file, name, sizeof name);
    return strcasestr(name, "gud") != NULL;
}

static void read_interfaces(struct usb_device *device)
{
    struct libusb_config_descriptor *configuration;
    if (libusb_get_active_config_descriptor(device->device, &configuration))
        return;
    for (unsigned i = 0; i < configuration->bNumInterfaces; i++) {
        const struct libusb_interface *interface = &configuration->interface[i];
        if (!interface->num_altsetting || interface->altsetting[0].bInterfaceClass != GUD_INTERFACE_CLASS)
            continue;
        const struct libusb_interface_descriptor *setting = &interface->altsetting[0];
        for (unsigned e = 0; e < setting->bNumEndpoints && device->interface_count < USB_INTERFACES_MAX; e++) {
            const struct libusb_endpoint_descriptor *endpoint = &setting->endpoint[e];
            if ((endpoint->bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) != LIBUSB_TRANSFER_TYPE_BULK ||
                endpoint->bEndpointAddress & LIBUSB_ENDPOINT_IN)
                continue;
            device->interfaces[device->interface_count].number = setting->bInterfaceNumber;
            device->interfaces[device->interface_count].says_gud =
                says_gud(device, configuration->bConfigurationValue, setting->bInterfaceNumber);
            device->interfaces[device->interface_count++].bulk_out = endpoint->bEndpointAddress;
            if (!*device->driver)
                read_driver(device, configuration->bConfigurationValue, setting->bInterfaceNumber);
            break;
        }
    }
    libusb_free_config_descriptor(configuration);
}

static bool is_wanted(const struct usb_device *device, const struct usb_options *options)
{
    return device->interface_count && (!options->id || options->id == device->id) &&
           (!options->path || !strcmp(options->path, device->path)) &&
           (!options->serial || !strcmp(options->serial, device->serial));
}

enum usb_state usb_state_unopened(enum usb_opened opened, const struct gud_problem *problem)
{
    switch (opened) {
    case USB_OPEN_KERNEL:
        return USB_KERNEL;
    case USB_OPEN_IN_USE:
        return USB_IN_USE;
    case USB_OPEN_DENIED:
        return USB_DENIED;
    default:
        return problem->fault == GUD_LINK_GONE ? USB_VANISHED : USB_NOT_DISPLAY;
    }
}

/* Asks one interface for its descriptor. */
static enum usb_state ask(libusb_context *libusb, struct usb_device *device, uint8_t interface, double until)
{
    struct usb_port port = {
        .libusb = libusb, .stoppable = true, .brief = !device->expected || until > 0, .until = until};
    struct gud_link link = {.context = &port, .control = usb_control};
    struct gud_descriptor descriptor;
    const enum usb_opened opened = usb_port_open(&port, device->device, interface, NULL, &device->problem);
    if (opened != USB_OPENED)
        return usb_state_unopened(opened, &device->problem);
    const bool good = gud_descriptor_read(&link, &descriptor, &device->problem);
    usb_port_close(&port, false);
    return good ? USB_DISPLAY : device->problem.fault == GUD_LINK_GONE ? USB_VANISHED : USB_NOT_DISPLAY;
}

static bool may_ask(const struct usb_device *device, unsigned i)
{
    return device->expected || device->interfaces[i].says_gud || strcmp(device->driver, "gud") == 0;
}

static void probe(libusb_context *libusb, struct usb_device *device, double until)
{
    device->state = USB_NOT_DISPLAY;
    for (unsigned i = 0; i < device->interface_count; i++) {
        if (!may_ask(device, i))
            continue;
        device->interface = device->interfaces[i].number;
        device->bulk_out = device->interfaces[i].bulk_out;
        device->state = ask(libusb, device, device->interface, until);
        if (device->state != USB_NOT_DISPLAY)
            return;
    }
}

/* Devices that were neither named nor known do not count unless they answer as displays. */
static bool is_foreign(const struct usb_device *device)
{
    return !device->expected && device->state != USB_DISPLAY &&
           !(device->state == USB_KERNEL && !strcmp(device->driver, "gud"));
}

static int by_path(const void *a, const void *b)
{
    return strverscmp(((const struct usb_device *)a)->path, ((const struct usb_device *)b)->path);
}

void usb_find(libusb_context *libusb, const struct usb_options *options, double until, struct usb_found *found)
{
    found->count = 0;
    const ssize_t count = libusb_get_device_list(libusb, &found->list);
    if (count < 0) {
        found->list = NULL;
        return;
    }
    for (ssize_t i = 0; i < count && found->count < USB_FOUND_MAX; i++) {
        struct usb_device *device = &found->devices[found->count];
        struct libusb_device_descriptor descriptor;
        *device = (struct usb_device){.device = found->list[i]};
        if (!read_path(device) || libusb_get_device_descriptor(device->device, &descriptor))
            continue;
        device->id = (uint32_t)descriptor.idVendor << 16 | descriptor.idProduct;
        device->expected = is_known(device->id) || options->id || options->path || options->serial;
        read_attribute(device, "serial", device->serial, sizeof device->serial);
        read_attribute(device, "product", device->product, sizeof device->product);
        read_interfaces(device);
        if (!is_wanted(device, options))
            continue;
        probe(libusb, device, until);
        if (!is_foreign(device))
            found->count++;
    }
    qsort(found->devices, found->count, sizeof found->devices[0], by_path);
}

void usb_found_free(struct usb_found *found)
{
    if (found->list)
        libusb_free_device_list(found->list, 1);
    found->list = NULL;
    found->count = 0;
}
