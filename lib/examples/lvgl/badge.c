/* SPDX-License-Identifier: MIT
 * A badge of 64 x 64 pixels on the active screen, twice: drawn into a canvas, and drawn directly into what LVGL redraws. Call badge_create
 * after lv_init and the display's own set-up, at 16 bits of colour (LV_COLOR_DEPTH 16). */
#include "badge.h"

static struct glint_paint paint;
static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4], normals[64 * 64];
static uint16_t pixels[64 * 64];
static struct glint_lvgl map;

enum glint_err badge_create(void)
{
    /* model, q, n, n_across, ambient, diffuse, specular, albedo, clamp_peak */
    static const struct glint_material red = {
        GLINT_MSH, 0, 60, 0, {3000, 3000, 3000}, {45000, 9000, 9000}, {60000, 60000, 60000}, {255, 255, 255}, false};
    static const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false};
    static const int32_t to_light[3] = {-1, 1, 3}, to_viewer[3] = {0, 0, 1};
    struct glint_surface surface;
    struct glint_light light;
    for (int i = 0; i < 64 * 64; i++) { /* a dome; `glint bake` makes normals of your own picture */
        const int32_t slope[3] = {i % 64 - 32, 32 - i / 64, 40};
        struct glint_vec normal;
        glint_vec_normalize(&normal, slope);
        normals[i] = glint_normals_pack(GLINT_NORMALS_INT8, &normal);
    }
    map.maps.normals = normals;
    map.maps.normals_stride = sizeof normals / 64;
    map.maps.normals_format = GLINT_NORMALS_INT8;
    enum glint_err err = glint_paint_tables_for(&paint, &glint_use_colour, &red, &output, memory, sizeof memory,
                                                &glint_use_msh, &glint_use_rgb565);
    err = err ? err : glint_light_directional(&light, to_light);
    err = err ? err : glint_paint_light(&paint, &light, 1, to_viewer);

    lv_obj_t *canvas = lv_canvas_create(lv_screen_active());
    lv_canvas_set_buffer(canvas, pixels, 64, 64, LV_COLOR_FORMAT_RGB565);
    lv_obj_set_pos(canvas, 8, 8);
    err = err ? err : glint_lvgl_canvas(canvas, output.format, &surface);
    err = err ? err : glint_draw_rect(&paint, &map.maps, 64, 64, &surface, NULL);
    lv_obj_invalidate(canvas);

    lv_obj_t *object = lv_obj_create(lv_screen_active());
    map.paint = &paint;
    map.w = map.h = 64;
    lv_obj_remove_style_all(object);
    lv_obj_set_pos(object, 80, 8);
    lv_obj_set_size(object, 64, 64);
    lv_obj_add_event_cb(object, glint_lvgl_draw, LV_EVENT_DRAW_MAIN, &map);
    return err;
}
