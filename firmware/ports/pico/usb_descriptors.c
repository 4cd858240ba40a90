/* SPDX-License-Identifier: MIT
 * What the board says of itself on USB. */
#include <hardware/flash.h>
#include <hardware/sync.h>
#include <tusb.h>

#include "glint.h"
#include "gud_protocol.h"
#include "usb_class.h"
#include "usb_descriptors.h"

enum { STRING_LANGUAGE, STRING_MANUFACTURER, STRING_PRODUCT, STRING_SERIAL, STRINGS };
enum {
    ENDPOINT_GUD = 0x01,
    ENDPOINT_LIGHT = 0x02,
    MILLIAMPERES = 250,
    DESCRIPTORS = 1, /* counts up with each change here and in usb_bos.c: Windows keeps what it read by this number */
    RELEASE = GLINT_VERSION_MAJOR << 8 | GLINT_VERSION_MINOR << 4 | DESCRIPTORS
};

static const tusb_desc_device_t device = {.bLength = sizeof device,
                                          .bDescriptorType = TUSB_DESC_DEVICE,
                                          .bcdUSB = OFFERS_LIGHT ? 0x0210 : 0x0200, /* 2.10: read usb_bos.c's, too */
                                          .bMaxPacketSize0 = CFG_TUD_ENDPOINT0_SIZE,
                                          .idVendor = GUD_ID_OPENMOKO >> 16,
                                          .idProduct = GUD_ID_OPENMOKO & 0xffff,
                                          .bcdDevice = RELEASE,
                                          .iManufacturer = STRING_MANUFACTURER,
                                          .iProduct = STRING_PRODUCT,
                                          .iSerialNumber = STRING_SERIAL,
                                          .bNumConfigurations = 1};

/* Number, alternate, endpoints, class, subclass, protocol, string; and an endpoint, bulk OUT. */
#define INTERFACE_BYTES (9 + 7)
#define INTERFACE(number, endpoint)                                                                                    \
    9, TUSB_DESC_INTERFACE, number, 0, 1, GUD_INTERFACE_CLASS, 0, 0, 0, 7, TUSB_DESC_ENDPOINT, endpoint,               \
        TUSB_XFER_BULK, U16_TO_U8S_LE(USB_PACKET), 0
#define CONFIG_BYTES (TUD_CONFIG_DESC_LEN + USB_INTERFACES * INTERFACE_BYTES)
static const uint8_t configuration[] = {TUD_CONFIG_DESCRIPTOR(1, USB_INTERFACES, 0, CONFIG_BYTES, 0, MILLIAMPERES),
                                        INTERFACE(USB_GUD, ENDPOINT_GUD),
#if OFFERS_LIGHT
                                        INTERFACE(USB_LIGHT, ENDPOINT_LIGHT)
#endif
};

const uint8_t *tud_descriptor_device_cb(void)
{
    return (const uint8_t *)&device;
}

const uint8_t *tud_descriptor_configuration_cb(uint8_t index)
{
    (void)index;
    return configuration;
}

/* The flash chip's own number, by functions of the boot ROM; zeros where there is no ROM, as in an emulator. */
const char *usb_serial(void)
{
    static char text[2 * FLASH_UNIQUE_ID_SIZE_BYTES + 1];
    uint8_t id[FLASH_UNIQUE_ID_SIZE_BYTES] = {0};
    uintptr_t magic = 0x10;
    __asm__("" : "+r"(magic)); /* not the address of an object, which a compiler would warn about */
    if (text[0])
        return text;
    if (*(const uint16_t *)magic == ('u' << 8 | 'M')) {
        const uint32_t interrupts = save_and_disable_interrupts();
        flash_get_unique_id(id);
        restore_interrupts(interrupts);
    }
    for (unsigned i = 0; i < 2 * sizeof id; i++)
        text[i] = "0123456789ABCDEF"[id[i / 2] >> (i % 2 ? 0 : 4) & 15];
    return text;
}

const uint16_t *tud_descriptor_string_cb(uint8_t index, uint16_t language)
{
    static uint16_t words[1 + 32];
    const char *const texts[STRINGS] = {NULL, "glint", PANEL_NAME, usb_serial()};
    unsigned count = 1;
    (void)language;
    if (index >= STRINGS)
        return NULL;
    if (index == STRING_LANGUAGE)
        words[count++] = 0x0409; /* English */
    else
        for (const char *at = texts[index]; *at && count < sizeof words / sizeof *words; at++)
            words[count++] = (uint8_t)*at;
    words[0] = (uint16_t)(TUSB_DESC_STRING << 8 | 2 * count);
    return words;
}
