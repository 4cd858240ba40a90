/* SPDX-License-Identifier: MIT
 * Descriptors by "WebUSB API" (its appendix on descriptors), "Microsoft OS 2.0 Descriptors Specification" and USB 3.2, 9.6.2.
 *
 * A host reads the BOS descriptor of a device with bcdUSB 2.10. It names two vendor requests to the device: one for the
 * landing page's address, one for the descriptor set, which gives the light interface to WinUSB. */
#include "usb_bos.h"

#include "usb_class.h"

#if OFFERS_LIGHT

enum { REQUEST_WEBUSB = 0x01, REQUEST_MICROSOFT = 0x02 };  /* bRequest, ours to choose */
enum { WEBUSB_GET_URL = 2, MICROSOFT_DESCRIPTOR_SET = 7 }; /* wIndex */

/* ---- the landing page ---- */

static const char landing_page[] = LANDING_PAGE; /* "" where none is built in */
enum { URL_DESCRIPTOR = 3, URL_WHOLE = 255 /* its scheme is in the text */, URL_HEAD_BYTES = 3 };
enum { HAS_LANDING_PAGE = sizeof landing_page > 1, URL_BYTES = URL_HEAD_BYTES + sizeof landing_page - 1 };
typedef char landing_page_fits[URL_BYTES <= 255 ? 1 : -1];
static const struct {
    uint8_t length, type, scheme;
    char text[sizeof landing_page];
} url = {URL_BYTES, URL_DESCRIPTOR, URL_WHOLE, LANDING_PAGE};

/* ---- the descriptor set: configuration > function > WinUSB and a name under which programs find it ---- */

#define U(character) character, 0 /* UTF-16 */
#define NAME                                                                                                           \
    U('D'), U('e'), U('v'), U('i'), U('c'), U('e'), U('I'), U('n'), U('t'), U('e'), U('r'), U('f'), U('a'), U('c'),    \
        U('e'), U('G'), U('U'), U('I'), U('D'), U('s')
#define GUID /* of this interface and no other; random, for ever */                                                    \
    U('{'), U('4'), U('3'), U('1'), U('E'), U('E'), U('1'), U('A'), U('2'), U('-'), U('2'), U('4'), U('A'), U('1'),    \
        U('-'), U('4'), U('F'), U('B'), U('2'), U('-'), U('9'), U('5'), U('6'), U('3'), U('-'), U('6'), U('7'),        \
        U('3'), U('5'), U('E'), U('F'), U('4'), U('8'), U('3'), U('4'), U('4'), U('4'), U('}')
enum {
    COMPATIBLE_BYTES = 20,
    NAME_BYTES = 2 * (20 + 1),
    GUID_BYTES = 2 * (38 + 2), /* a list of texts ends with an empty one */
    PROPERTY_BYTES = 10 + NAME_BYTES + GUID_BYTES,
    FUNCTION_BYTES = 8 + COMPATIBLE_BYTES + PROPERTY_BYTES,
    CONFIGURATION_BYTES = 8 + FUNCTION_BYTES,
    SET_BYTES = 10 + CONFIGURATION_BYTES,
    REG_MULTI_SZ = 7
};
#define WINDOWS_8_1 U32_TO_U8S_LE(0x06030000)

static const uint8_t microsoft[] = {
    U16_TO_U8S_LE(10), U16_TO_U8S_LE(MS_OS_20_SET_HEADER_DESCRIPTOR), WINDOWS_8_1, U16_TO_U8S_LE(SET_BYTES),
    /* Windows takes it for the configuration's index, not for its value. */
    U16_TO_U8S_LE(8), U16_TO_U8S_LE(MS_OS_20_SUBSET_HEADER_CONFIGURATION), 0, 0, U16_TO_U8S_LE(CONFIGURATION_BYTES),
    U16_TO_U8S_LE(8), U16_TO_U8S_LE(MS_OS_20_SUBSET_HEADER_FUNCTION), USB_LIGHT, 0, U16_TO_U8S_LE(FUNCTION_BYTES),
    U16_TO_U8S_LE(COMPATIBLE_BYTES), U16_TO_U8S_LE(MS_OS_20_FEATURE_COMPATBLE_ID), 'W', 'I', 'N', 'U', 'S', 'B', 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, U16_TO_U8S_LE(PROPERTY_BYTES), U16_TO_U8S_LE(MS_OS_20_FEATURE_REG_PROPERTY),
    U16_TO_U8S_LE(REG_MULTI_SZ), U16_TO_U8S_LE(NAME_BYTES), NAME, U(0), U16_TO_U8S_LE(GUID_BYTES), GUID, U(0), U(0)};
typedef char set_is_complete[sizeof microsoft == SET_BYTES ? 1 : -1];

/* ---- BOS ---- */

enum { BOS_BYTES = TUD_BOS_DESC_LEN + TUD_BOS_WEBUSB_DESC_LEN + TUD_BOS_MICROSOFT_OS_DESC_LEN };
static const uint8_t bos[] = {TUD_BOS_DESCRIPTOR(BOS_BYTES, 2),
                              TUD_BOS_WEBUSB_DESCRIPTOR(REQUEST_WEBUSB, HAS_LANDING_PAGE),
                              TUD_BOS_MS_OS_20_DESCRIPTOR(SET_BYTES, REQUEST_MICROSOFT)};
typedef char bos_is_complete[sizeof bos == BOS_BYTES ? 1 : -1];

const uint8_t *tud_descriptor_bos_cb(void)
{
    return bos;
}

static bool reply(uint8_t port, const tusb_control_request_t *request, const void *bytes, uint16_t count)
{
    return tud_control_xfer(port, request, (void *)(uintptr_t)bytes, count); /* it only reads them */
}

bool usb_bos_request(uint8_t port, const tusb_control_request_t *request)
{
    if (request->bmRequestType_bit.direction != TUSB_DIR_IN)
        return false;
    if (request->bRequest == REQUEST_MICROSOFT && request->wIndex == MICROSOFT_DESCRIPTOR_SET && request->wValue == 0)
        return reply(port, request, microsoft, sizeof microsoft);
    if (request->bRequest == REQUEST_WEBUSB && request->wIndex == WEBUSB_GET_URL && HAS_LANDING_PAGE &&
        request->wValue == HAS_LANDING_PAGE)
        return reply(port, request, &url, URL_BYTES);
    return false;
}

#else

bool usb_bos_request(uint8_t port, const tusb_control_request_t *request)
{
    (void)port;
    (void)request;
    return false;
}

#endif
