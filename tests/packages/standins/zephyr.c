/* SPDX-License-Identifier: MIT
 * A display of the format that the environment's FORMAT names: prints the pixel at the highlight of each picture; ends after four. */
#include <zephyr/device.h>

#include <string.h>

const struct device standin_display = {NULL};
static int frames;

bool device_is_ready(const struct device *dev)
{
    return dev == &standin_display;
}

void display_get_capabilities(const struct device *dev, struct display_capabilities *capabilities)
{
    const char *format = getenv("FORMAT");
    (void)dev;
    capabilities->current_pixel_format = !format                       ? PIXEL_FORMAT_RGB_888
                                         : strcmp(format, "565X") == 0 ? PIXEL_FORMAT_RGB_565X
                                                                       : PIXEL_FORMAT_RGB_565;
}

int display_blanking_off(const struct device *dev)
{
    (void)dev;
    return 0;
}

int display_write(const struct device *dev, const uint16_t x, const uint16_t y,
                  const struct display_buffer_descriptor *desc, const void *buf)
{
    const uint8_t *pixel = (const uint8_t *)buf + 2 * (20 * desc->pitch + 20);
    (void)dev;
    printf("%d,%d %dx%d %02x %02x\n", x, y, desc->width, desc->height, pixel[0], pixel[1]);
    return ++frames == 4;
}

int32_t k_msleep(int32_t ms)
{
    return ms - ms;
}
