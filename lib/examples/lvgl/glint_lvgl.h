/* SPDX-License-Identifier: MIT
 * glint under LVGL 9: copy this file and glint_lvgl.c into your project. LVGL's RGB565, RGB565_SWAPPED (from 9.3 on) and L8 are glint's
 * RGB565, RGB565_SWAPPED and GREY8; its RGB888, XRGB8888 and ARGB8888, which hold blue first, are glint's BGR888, XRGB8888 and ARGB8888. */
#ifndef GLINT_LVGL_H
#define GLINT_LVGL_H

#include <glint.h>
#include <lvgl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A canvas's pixels as a surface, without a copy. Afterwards lv_obj_invalidate(canvas). GLINT_ERR_ARG: the canvas has no buffer;
 * GLINT_ERR_FORMAT: its format is not that of the output that is to be drawn there. */
enum glint_err glint_lvgl_canvas(lv_obj_t *canvas, uint8_t format, struct glint_surface *surface);

/* What glint_lvgl_draw draws, from the object's upper left corner on; yours, and must outlive the object. */
struct glint_lvgl {
    const struct glint_paint *paint; /* under another light: glint_paint_light, then lv_obj_invalidate(object) */
    struct glint_maps maps;          /* normals as glint bake writes them: NAME, NAME_FORMAT, NAME_STRIDE */
    uint16_t w, h;                   /* NAME_WIDTH, NAME_HEIGHT */
    enum glint_err err;              /* of the last call; GLINT_OK, or nothing was drawn */
};

/* Draws straight into the layer, only what LVGL is redrawing of the object:
 *
 *     lv_obj_add_event_cb(object, glint_lvgl_draw, LV_EVENT_DRAW_MAIN, &map); */
void glint_lvgl_draw(lv_event_t *event);

/* For objects of your own: the part of a box of the object that LVGL is redrawing in this layer, w = 0: none, and where its first pixel goes.
 * What lies below is finished first. GLINT_ERR_FORMAT: the layer's format is not the output's; GLINT_ERR_ARG: LVGL is out of memory. */
enum glint_err glint_lvgl_part(lv_obj_t *object, lv_layer_t *layer, const struct glint_box *box, uint8_t format,
                               struct glint_box *part, struct glint_surface *surface);

#ifdef __cplusplus
}
#endif

#endif
