/* SPDX-License-Identifier: MIT
 * What lets browsers in, where there is an interface for light: WebUSB's capability, and Microsoft OS 2.0 descriptors, by
 * which Windows has its driver WinUSB for that interface without an installation. The display's interface stays as it is. */
#ifndef USB_BOS_H
#define USB_BOS_H

#include <tusb.h>

/* Answers a vendor request to the device; false: STALL. */
bool usb_bos_request(uint8_t port, const tusb_control_request_t *request);

#endif
