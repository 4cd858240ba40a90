/* SPDX-License-Identifier: MIT */
#include "sinks/cost.h"

/* A control request of 25 bytes announces each rectangle: .10 to .37 ms where requests are queued, so .4 ms. Bulk data at
 * full speed: 565 to 1151 KB/s seen, of the 1216 KB/s that the bus can carry. */
#define FULL_SPEED_RECTANGLE_S .4e-3

const struct sink_cost usb_costs[USB_RATES] = {{FULL_SPEED_RECTANGLE_S, 600e3}, {FULL_SPEED_RECTANGLE_S, 1000e3}};
const struct sink_cost usb_full_speed_cost = {FULL_SPEED_RECTANGLE_S, 800e3};
const struct sink_cost usb_high_speed_cost = {.3e-3, 35e6}, usb_super_speed_cost = {.2e-3, 200e6};
