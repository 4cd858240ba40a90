/* SPDX-License-Identifier: MIT
 * A mesh as an object of LVGL 9: copy this file, glint_lvgl_mesh.c, glint_lvgl.h and glint_lvgl.c into your project.
 *
 *     static struct glint_lvgl_mesh pot = {.mesh = &teapot, .paints = &gold};
 *     glint_lvgl_mesh_create(&pot, lv_screen_active(), 240, 240, memory, sizeof memory);
 *     glint_lvgl_mesh_set_pose(&pot, &pose);       as often as it moves
 *
 * It draws in LVGL's own strips straight into the layer's buffer, in LV_EVENT_DRAW_MAIN: it needs no draw unit and nothing in lv_conf.h, and no buffer
 * but glint's memory. (A draw unit for LV_DRAW_TASK_TYPE_3D is for what a GPU has drawn into a texture: it would need one, and a copy.) Vertices are
 * placed once a picture, not once a strip, as long as LVGL's strips have the same columns. */
#ifndef GLINT_LVGL_MESH_H
#define GLINT_LVGL_MESH_H

#include "glint_lvgl.h"
#include <glint_mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

struct glint_lvgl_mesh {
    /* Config, set by you. All that they point to must outlive the object. */
    const struct glint_mesh *mesh;
    struct glint_paint *paints; /* of each part, of the display's format */
    struct glint_paint
        *layer_paints; /* of GLINT_ARGB8888, for layers of opacity or transformation; NULL: nothing is drawn there */

    /* State, ours. */
    lv_obj_t *object;   /* NULL before it is created, and once LVGL has deleted it */
    enum glint_err err; /* of the last call; GLINT_OK, or nothing was drawn */
    struct glint_pose pose;
    struct glint_box box; /* of the object's pixels that the mesh may touch */
    void *memory;
    size_t bytes, mesh_bytes;
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    const struct glint_paint *begun; /* with which paints; NULL: the picture must be begun */
    uint16_t x, y, w, h; /* the columns and the first line of the picture that is begun; the object's height then */
};

/* Memory for a mesh on an object of w x h pixels, at most GLINT_MESH_SIZE_MAX each, aligned to 4 (to a pointer under several lights). */
size_t glint_lvgl_mesh_bytes(const struct glint_mesh *mesh, uint16_t w, uint16_t h);
/* An object without style, of that size. NULL: too little memory, or LVGL is out of it; err says which of what glint_mesh_check says otherwise. */
lv_obj_t *glint_lvgl_mesh_create(struct glint_lvgl_mesh *mesh, lv_obj_t *parent, uint16_t w, uint16_t h, void *memory,
                                 size_t bytes);
/* From the object's middle. Only the box that the mesh took before and the one that it takes now are redrawn. GLINT_ERR_VECTOR: a quaternion of 0;
 * GLINT_ERR_ARG: there is no object. */
enum glint_err glint_lvgl_mesh_set_pose(struct glint_lvgl_mesh *mesh, const struct glint_pose *pose);
/* Lights all paints. The errors of glint_light_directional and glint_paint_light. */
enum glint_err glint_lvgl_mesh_set_light(struct glint_lvgl_mesh *mesh, const int32_t to_light[3]);
void glint_lvgl_mesh_set_paint(struct glint_lvgl_mesh *mesh, struct glint_paint *paints,
                               struct glint_paint *layer_paints);

#ifdef __cplusplus
}
#endif

#endif
