/* SPDX-License-Identifier: MIT
 * A knob of spun metal as an object of LVGL 9: copy this file, glint_lvgl_knob.c, glint_lvgl.h and glint_lvgl.c into your project.
 *
 *     static struct glint_lvgl_knob volume = {.paint = &steel, .dot = {235, 80, 40}};
 *     glint_lvgl_knob_create(&volume, lv_screen_active(), 120);
 *     lv_obj_add_event_cb(volume.object, on_volume, LV_EVENT_VALUE_CHANGED, NULL);
 *
 * It goes from the lower left over the top to the lower right, by a finger that goes round it. The value turns a dot in its face, the light
 * alone moves the highlight: only what changes is redrawn. It draws straight into the layer's buffer and needs no map and no buffer. */
#ifndef GLINT_LVGL_KNOB_H
#define GLINT_LVGL_KNOB_H

#include "glint_lvgl.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { GLINT_LVGL_KNOB_RUN = 64, GLINT_LVGL_KNOB_MOST = 512 }; /* pixels that are drawn at once; the largest side */

struct glint_lvgl_knob {
    /* Config, set by you. */
    struct glint_paint *paint; /* exact, of the display's format, with n_across; must outlive the object */
    struct glint_paint
        *layer_paint; /* of GLINT_ARGB8888, for layers of opacity or transformation; NULL: nothing is drawn there */
    uint8_t dot[3];   /* the albedo of the dot that shows the value */

    /* State, ours. */
    lv_obj_t *object;   /* NULL before it is created, and once LVGL has deleted it */
    enum glint_err err; /* of the last call; GLINT_OK, or nothing was drawn */
    int32_t least, most, value;
    int32_t turned; /* from the least value, 0..49152: 65536 is a turn */
    int32_t finger; /* its direction when it was last seen; -1: there is none */
    uint16_t side;
    struct glint_vec normals[GLINT_LVGL_KNOB_RUN];
    uint8_t albedo[GLINT_LVGL_KNOB_RUN][3], coverage[GLINT_LVGL_KNOB_RUN];
};

/* An object without style, side x side pixels, with values of 0..100, at 0. NULL: LVGL is out of memory, or a side of less than 16 or more than
 * GLINT_LVGL_KNOB_MOST (err is GLINT_ERR_ARG then). */
lv_obj_t *glint_lvgl_knob_create(struct glint_lvgl_knob *knob, lv_obj_t *parent, uint16_t side);
/* The value is held to the range. least >= most, or more than 2^30 apart: GLINT_ERR_ARG. Neither sends LV_EVENT_VALUE_CHANGED. */
enum glint_err glint_lvgl_knob_set_range(struct glint_lvgl_knob *knob, int32_t least, int32_t most);
void glint_lvgl_knob_set_value(struct glint_lvgl_knob *knob, int32_t value);
int32_t glint_lvgl_knob_get_value(const struct glint_lvgl_knob *knob);
int32_t glint_lvgl_knob_get_least(const struct glint_lvgl_knob *knob);
int32_t glint_lvgl_knob_get_most(const struct glint_lvgl_knob *knob);
/* Lights both paints. The errors of glint_light_directional and glint_paint_light. */
enum glint_err glint_lvgl_knob_set_light(struct glint_lvgl_knob *knob, const int32_t to_light[3]);

#ifdef __cplusplus
}
#endif

#endif
