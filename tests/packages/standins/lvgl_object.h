/* SPDX-License-Identifier: MIT
 * One object as LVGL has them: its place, its events, what is to be redrawn of it. Included by the stand-ins that draw one. */
#ifndef STUB_LVGL_OBJECT_H
#define STUB_LVGL_OBJECT_H

#include <lvgl_private.h>

enum { CALLBACKS = 8 };
struct lv_obj_t {
    lv_area_t at;
    struct {
        lv_event_cb_t call;
        lv_event_code_t code;
        void *user_data;
    } callbacks[CALLBACKS];
    unsigned count, flags;
};
struct lv_event_t {
    lv_obj_t *target;
    lv_layer_t *layer;
    void *user_data;
    lv_hit_test_info_t *hit;
};

static lv_obj_t screen, object;
static lv_area_t dirty[8];
static unsigned dirty_count;
static lv_draw_buf_t buffer;

static void send(lv_event_code_t code, lv_layer_t *layer, lv_hit_test_info_t *hit)
{
    for (unsigned i = 0; i < object.count; i++) {
        lv_event_t event = {&object, layer, object.callbacks[i].user_data, hit};
        if (object.callbacks[i].code == code)
            object.callbacks[i].call(&event);
    }
}

void lv_obj_set_size(lv_obj_t *obj, int32_t w, int32_t h)
{
    obj->at.x2 = obj->at.x1 + w - 1;
    obj->at.y2 = obj->at.y1 + h - 1;
    send(LV_EVENT_SIZE_CHANGED, NULL, NULL);
}
void lv_obj_add_flag(lv_obj_t *obj, lv_obj_flag_t f)
{
    obj->flags |= (unsigned)f;
}
void lv_obj_remove_style_all(lv_obj_t *obj)
{
    (void)obj;
}
void lv_obj_get_coords(const lv_obj_t *obj, lv_area_t *coords)
{
    *coords = obj->at;
}
lv_result_t lv_obj_invalidate_area(const lv_obj_t *obj, const lv_area_t *area)
{
    (void)obj;
    if (dirty_count < sizeof dirty / sizeof *dirty)
        dirty[dirty_count++] = *area;
    return LV_RESULT_OK;
}
void *lv_obj_add_event_cb(lv_obj_t *obj, lv_event_cb_t event_cb, lv_event_code_t filter, void *user_data)
{
    obj->callbacks[obj->count].call = event_cb;
    obj->callbacks[obj->count].code = filter;
    obj->callbacks[obj->count++].user_data = user_data;
    return obj;
}
void *lv_event_get_user_data(lv_event_t *e)
{
    return e->user_data;
}
lv_layer_t *lv_event_get_layer(lv_event_t *e)
{
    return e->layer;
}
lv_hit_test_info_t *lv_event_get_hit_test_info(lv_event_t *e)
{
    return e->hit;
}
void *lv_draw_layer_go_to_xy(lv_layer_t *layer, int32_t x, int32_t y)
{
    const int32_t bytes = layer->color_format == LV_COLOR_FORMAT_ARGB8888 ? 4 : 2;
    return layer->draw_buf->data + (ptrdiff_t)y * layer->draw_buf->header.stride + bytes * x;
}
void lv_draw_dispatch_wait_for_request(void)
{
}
void lv_draw_dispatch_request(void)
{
}
void lv_draw_wait_for_finish(void)
{
}
/* What these widgets do not call. */
lv_draw_buf_t *lv_canvas_get_draw_buf(lv_obj_t *obj)
{
    (void)obj;
    return NULL;
}
lv_obj_t *lv_event_get_target_obj(lv_event_t *e)
{
    return e->target;
}
lv_display_t *lv_obj_get_display(const lv_obj_t *obj)
{
    (void)obj;
    return NULL;
}

#endif
