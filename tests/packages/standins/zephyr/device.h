/* SPDX-License-Identifier: MIT
 * The part of Zephyr 4.4 that the example calls, with its signatures. */
#ifndef STUB_ZEPHYR_H
#define STUB_ZEPHYR_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

struct device {
    const void *api;
};
extern const struct device standin_display;
#define DT_CHOSEN(name) standin_display
#define DEVICE_DT_GET(node) (&node)
#define PANEL_PIXEL_FORMAT_RGB_565X (0x1 << 5)
#define printk printf

enum display_pixel_format { PIXEL_FORMAT_RGB_888 = 1, PIXEL_FORMAT_RGB_565 = 16, PIXEL_FORMAT_RGB_565X = 32 };
struct display_capabilities {
    uint16_t x_resolution, y_resolution;
    uint32_t supported_pixel_formats, screen_info;
    enum display_pixel_format current_pixel_format;
};
struct display_buffer_descriptor {
    uint32_t buf_size;
    uint16_t width, height, pitch;
    bool frame_incomplete;
};
bool device_is_ready(const struct device *dev);
void display_get_capabilities(const struct device *dev, struct display_capabilities *capabilities);
int display_blanking_off(const struct device *dev);
int display_write(const struct device *dev, const uint16_t x, const uint16_t y,
                  const struct display_buffer_descriptor *desc, const void *buf);
int32_t k_msleep(int32_t ms);

#endif
