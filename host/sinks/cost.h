/* SPDX-License-Identifier: MIT
 * What sending takes, for choosing the cheapest form and for predictions. */
#ifndef GLINT_SINK_COST_H
#define GLINT_SINK_COST_H

struct sink_cost {
    double rectangle_s; /* before the first byte of each piece */
    double bytes_per_s; /* 0 where nothing is known */
};

/* USB at full speed as public logs report it: the slow end and the fast end of real devices. The sink usb plans with the
 * value between them. */
enum { USB_RATES = 2 };
extern const struct sink_cost usb_costs[USB_RATES], usb_full_speed_cost, usb_high_speed_cost, usb_super_speed_cost;

#endif
