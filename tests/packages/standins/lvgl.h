/* SPDX-License-Identifier: MIT
 * The part of LVGL 9.5.0 that the example calls, with its types and signatures; fields that it does not read are left out. */
#ifndef STUB_LVGL_H
#define STUB_LVGL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define LVGL_VERSION_MAJOR 9
#ifndef LVGL_VERSION_MINOR /* a test asks for an older one, less its formats */
#define LVGL_VERSION_MINOR 5
#endif

typedef enum {
    LV_COLOR_FORMAT_L8 = 0x06,
    LV_COLOR_FORMAT_RGB888 = 0x0f,
    LV_COLOR_FORMAT_ARGB8888 = 0x10,
    LV_COLOR_FORMAT_XRGB8888 = 0x11,
#if LVGL_VERSION_MINOR >= 3
    LV_COLOR_FORMAT_RGB565_SWAPPED = 0x1b,
#endif
    LV_COLOR_FORMAT_RGB565 = 0x12
} lv_color_format_t;
typedef enum {
    LV_EVENT_PRESSED = 1,
    LV_EVENT_PRESSING = 2,
    LV_EVENT_PRESS_LOST = 3,
    LV_EVENT_RELEASED = 11,
    LV_EVENT_HIT_TEST = 22,
    LV_EVENT_DRAW_MAIN = 29,
    LV_EVENT_VALUE_CHANGED = 35,
    LV_EVENT_DELETE = 42,
    LV_EVENT_SIZE_CHANGED = 50
} lv_event_code_t;
typedef enum {
    LV_OBJ_FLAG_SCROLLABLE = 1 << 4,
    LV_OBJ_FLAG_SCROLL_CHAIN_HOR = 1 << 8,
    LV_OBJ_FLAG_SCROLL_CHAIN_VER = 1 << 9,
    LV_OBJ_FLAG_ADV_HITTEST = 1 << 16
} lv_obj_flag_t;
typedef enum { LV_RESULT_INVALID, LV_RESULT_OK } lv_result_t;
typedef struct {
    int32_t x, y;
} lv_point_t;
typedef struct _lv_hit_test_info_t lv_hit_test_info_t; /* lvgl_private.h */
typedef struct {
    int32_t x1, y1, x2, y2; /* both ends are inside */
} lv_area_t;
typedef struct {
    uint32_t cf : 8, w : 16, h : 16, stride : 16;
} lv_image_header_t;
typedef struct {
    lv_image_header_t header;
    uint8_t *data;
} lv_draw_buf_t;
typedef struct lv_draw_task_t lv_draw_task_t;
typedef struct {
    lv_draw_buf_t *draw_buf;
    lv_draw_task_t *draw_task_head;
    lv_area_t buf_area, _clip_area;
    lv_color_format_t color_format;
} lv_layer_t;
typedef struct lv_display_t lv_display_t;
typedef struct lv_obj_t lv_obj_t;
typedef struct lv_event_t lv_event_t;
typedef struct _lv_indev_t lv_indev_t;
typedef void (*lv_event_cb_t)(lv_event_t *e);

lv_obj_t *lv_screen_active(void);
lv_obj_t *lv_canvas_create(lv_obj_t *parent);
void lv_canvas_set_buffer(lv_obj_t *obj, void *buf, int32_t w, int32_t h, lv_color_format_t cf);
lv_draw_buf_t *lv_canvas_get_draw_buf(lv_obj_t *obj);
lv_obj_t *lv_obj_create(lv_obj_t *parent);
void lv_obj_remove_style_all(lv_obj_t *obj);
void lv_obj_set_pos(lv_obj_t *obj, int32_t x, int32_t y);
void lv_obj_set_size(lv_obj_t *obj, int32_t w, int32_t h);
void lv_obj_get_coords(const lv_obj_t *obj, lv_area_t *coords);
void lv_obj_invalidate(const lv_obj_t *obj);
lv_result_t lv_obj_invalidate_area(const lv_obj_t *obj, const lv_area_t *area);
void lv_obj_add_flag(lv_obj_t *obj, lv_obj_flag_t f);
void lv_obj_remove_flag(lv_obj_t *obj, lv_obj_flag_t f);
lv_result_t lv_obj_send_event(lv_obj_t *obj, lv_event_code_t event_code, void *param);
lv_indev_t *lv_indev_active(void);
void lv_indev_get_point(const lv_indev_t *indev, lv_point_t *point);
lv_display_t *lv_obj_get_display(const lv_obj_t *obj);
void *lv_obj_add_event_cb(lv_obj_t *obj, lv_event_cb_t event_cb, lv_event_code_t filter, void *user_data);
void *lv_event_get_user_data(lv_event_t *e);
lv_obj_t *lv_event_get_target_obj(lv_event_t *e);
lv_layer_t *lv_event_get_layer(lv_event_t *e);
lv_hit_test_info_t *lv_event_get_hit_test_info(lv_event_t *e);
void *lv_draw_layer_alloc_buf(lv_layer_t *layer);
void *lv_draw_layer_go_to_xy(lv_layer_t *layer, int32_t x, int32_t y);
bool lv_draw_dispatch_layer(lv_display_t *disp, lv_layer_t *layer);
void lv_draw_dispatch_wait_for_request(void);
void lv_draw_dispatch_request(void);
void lv_draw_wait_for_finish(void);

#ifdef __cplusplus
}
#endif

#endif
