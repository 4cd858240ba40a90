/* SPDX-License-Identifier: MIT
 * A badge of 64 x 64 pixels on the board's display, relit as its light goes round. */
#include <glint.h>
#include <zephyr/device.h>
#include <zephyr/drivers/display.h>
#include <zephyr/kernel.h>

/* The bytes of a pixel, high one first: Zephyr 4.4 renamed this format. */
#ifdef PANEL_PIXEL_FORMAT_RGB_565X
#define SWAPPED PIXEL_FORMAT_RGB_565X
#else
#define SWAPPED PIXEL_FORMAT_BGR_565
#endif

static struct glint_paint paint;
static struct glint_maps maps;
static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4], normals[64 * 64];
static uint16_t pixels[64 * 64];

int main(void)
{
    /* model, q, n, n_across, ambient, diffuse, specular, albedo, clamp_peak */
    static const struct glint_material red = {
        GLINT_MSH, 0, 60, 0, {3000, 3000, 3000}, {45000, 9000, 9000}, {60000, 60000, 60000}, {255, 255, 255}, false};
    static struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false};
    static const int32_t to_lights[4][3] = {{-1, 1, 3}, {1, 1, 3}, {1, -1, 3}, {-1, -1, 3}}, to_viewer[3] = {0, 0, 1};
    const struct device *display = DEVICE_DT_GET(DT_CHOSEN(zephyr_display));
    const struct glint_surface surface = {pixels, 128, 0, 0};
    static struct display_capabilities can;
    static struct display_buffer_descriptor buffer;
    if (!device_is_ready(display)) {
        printk("glint: the display is not ready\n");
        return 0;
    }
    display_get_capabilities(display, &can);
    if (can.current_pixel_format != PIXEL_FORMAT_RGB_565 && can.current_pixel_format != SWAPPED) {
        printk("glint: the display's pixels are not RGB565\n");
        return 0;
    }
    output.format = can.current_pixel_format == SWAPPED ? GLINT_RGB565_SWAPPED : GLINT_RGB565;
    for (int i = 0; i < 64 * 64; i++) { /* a dome; `glint bake` makes normals of your own picture */
        const int32_t slope[3] = {i % 64 - 32, 32 - i / 64, 40};
        struct glint_vec normal;
        glint_vec_normalize(&normal, slope);
        normals[i] = glint_normals_pack(GLINT_NORMALS_INT8, &normal);
    }
    maps.normals = normals;
    maps.normals_stride = sizeof normals / 64;
    maps.normals_format = GLINT_NORMALS_INT8;
    if (glint_paint_tables_for(&paint, &glint_use_colour, &red, &output, memory, sizeof memory, &glint_use_msh,
                               &glint_use_rgb565))
        return 0;
    buffer.buf_size = sizeof pixels;
    buffer.width = buffer.height = buffer.pitch = 64;
    display_blanking_off(display);
    for (int frame = 0;; frame = (frame + 1) % 4) {
        struct glint_light light;
        if (glint_light_directional(&light, to_lights[frame]) || glint_paint_light(&paint, &light, 1, to_viewer) ||
            glint_draw_rect(&paint, &maps, 64, 64, &surface, NULL))
            return 0;
        if (display_write(display, 0, 0, &buffer, pixels) != 0)
            return 0;
        k_msleep(250);
    }
}
