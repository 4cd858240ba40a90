/* SPDX-License-Identifier: MIT
 *
 * A GUD display on a panel: each line goes out while the next one arrives. */
#ifndef GUD_PANEL_H
#define GUD_PANEL_H

#include "gud_device.h"
#include "hal.h"

struct gud_panel {
    /* Config, set by you. */
    const struct hal *hal;
    const struct panel *panel;
    /* State. */
    bool has_failed;             /* the panel's bus */
    bool is_open;                /* a rectangle is open: more lines follow */
    volatile uint8_t is_sending; /* yes or no; no bool: with -fsanitize=bool gcc 12 reads a volatile one once */
};

/* For panel_show. GUD states brightness as the eye sees it, and 0 is not dark: its square, at least 1; 0 if off. */
uint8_t gud_panel_percent(bool on, uint8_t brightness);

/* For gud_device_config, whose output is then GLINT_RGB565, lines aligned to 2, and whose context is a struct gud_panel. */
extern const struct gud_device_ops gud_panel_ops;

#endif
