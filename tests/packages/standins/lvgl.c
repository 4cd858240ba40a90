/* SPDX-License-Identifier: MIT
 * Two objects on a screen of 160 x 80, redrawn as LVGL does in partial mode: an area at a time, in a buffer of its own, where the background's
 * task is still waiting when an object is drawn. Prints what differs between the canvas and the object that draws itself. */
#include "badge.h"

#include <stdio.h>
#include <string.h>

enum { WIDTH = 160, HEIGHT = 80, BACKGROUND = 0x1f };

struct lv_obj_t {
    lv_area_t at;
    lv_draw_buf_t buffer;
    lv_event_cb_t draw;
    void *user_data;
};
struct lv_event_t {
    lv_obj_t *target;
    lv_layer_t *layer;
};

static lv_obj_t screen, objects[2];
static unsigned count;
static uint16_t shown[HEIGHT][WIDTH], part[HEIGHT * WIDTH];
static lv_draw_buf_t part_buffer;

static int32_t bytes_of(unsigned cf)
{
    return cf == LV_COLOR_FORMAT_RGB565 || cf == LV_COLOR_FORMAT_RGB565_SWAPPED ? 2
           : cf == LV_COLOR_FORMAT_L8                                           ? 1
           : cf == LV_COLOR_FORMAT_RGB888                                       ? 3
                                                                                : 4;
}

lv_obj_t *lv_screen_active(void)
{
    return &screen;
}

lv_obj_t *lv_obj_create(lv_obj_t *parent)
{
    return parent == &screen && count < 2 ? &objects[count++] : NULL;
}

lv_obj_t *lv_canvas_create(lv_obj_t *parent)
{
    return lv_obj_create(parent);
}

void lv_canvas_set_buffer(lv_obj_t *obj, void *buf, int32_t w, int32_t h, lv_color_format_t cf)
{
    obj->buffer.header.cf = cf;
    obj->buffer.header.w = (uint16_t)w;
    obj->buffer.header.h = (uint16_t)h;
    obj->buffer.header.stride = (uint16_t)(bytes_of(cf) * w);
    obj->buffer.data = (uint8_t *)buf;
    lv_obj_set_size(obj, w, h);
}

lv_draw_buf_t *lv_canvas_get_draw_buf(lv_obj_t *obj)
{
    return &obj->buffer;
}

void lv_obj_remove_style_all(lv_obj_t *obj)
{
    (void)obj;
}

void lv_obj_set_pos(lv_obj_t *obj, int32_t x, int32_t y)
{
    const lv_area_t at = {x, y, obj->at.x2 - obj->at.x1 + x, obj->at.y2 - obj->at.y1 + y};
    obj->at = at;
}

void lv_obj_set_size(lv_obj_t *obj, int32_t w, int32_t h)
{
    obj->at.x2 = obj->at.x1 + w - 1;
    obj->at.y2 = obj->at.y1 + h - 1;
}

void lv_obj_get_coords(const lv_obj_t *obj, lv_area_t *coords)
{
    *coords = obj->at;
}

void lv_obj_invalidate(const lv_obj_t *obj)
{
    (void)obj;
}

lv_display_t *lv_obj_get_display(const lv_obj_t *obj)
{
    (void)obj;
    return NULL;
}

void *lv_obj_add_event_cb(lv_obj_t *obj, lv_event_cb_t event_cb, lv_event_code_t filter, void *user_data)
{
    obj->draw = filter == LV_EVENT_DRAW_MAIN ? event_cb : NULL;
    obj->user_data = user_data;
    return obj;
}

void *lv_event_get_user_data(lv_event_t *e)
{
    return e->target->user_data;
}

lv_obj_t *lv_event_get_target_obj(lv_event_t *e)
{
    return e->target;
}

lv_layer_t *lv_event_get_layer(lv_event_t *e)
{
    return e->layer;
}

void *lv_draw_layer_alloc_buf(lv_layer_t *layer)
{
    layer->draw_buf = &part_buffer;
    return part;
}

void *lv_draw_layer_go_to_xy(lv_layer_t *layer, int32_t x, int32_t y)
{
    return layer->draw_buf->data + (ptrdiff_t)y * layer->draw_buf->header.stride + 2 * x;
}

/* The one task that waits: the background. */
bool lv_draw_dispatch_layer(lv_display_t *disp, lv_layer_t *layer)
{
    (void)disp;
    lv_draw_layer_alloc_buf(layer);
    if (layer->draw_task_head)
        for (size_t i = 0; i < sizeof part / sizeof *part; i++)
            part[i] = BACKGROUND;
    layer->draw_task_head = NULL;
    return true;
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

static void refresh(lv_area_t area)
{
    lv_layer_t layer = {NULL, (lv_draw_task_t *)&screen, area, area, LV_COLOR_FORMAT_RGB565};
    const int32_t w = area.x2 - area.x1 + 1;
    part_buffer.data = (uint8_t *)part;
    part_buffer.header.stride = (uint16_t)(2 * w);
    for (unsigned i = 0; i < 2; i++) {
        lv_event_t event = {&objects[i], &layer};
        if (objects[i].draw)
            objects[i].draw(&event);
    }
    lv_draw_dispatch_layer(NULL, &layer);
    for (int32_t y = area.y1; y <= area.y2; y++)
        memcpy(&shown[y][area.x1], &part[w * (y - area.y1)], 2 * (size_t)w);
}

/* A pixel in a canvas of each format: LVGL's lv_color_t and lv_color32_t are blue, green, red[, alpha]. Returns how many differ. */
static unsigned other_canvases(void)
{
    static const struct {
        uint8_t format, cf, bytes, albedo[3], wanted[4];
    } of[] = {{GLINT_RGB565, LV_COLOR_FORMAT_RGB565, 2, {200, 0, 100}, {12, 192, 0, 0}},
              {GLINT_RGB565_SWAPPED, LV_COLOR_FORMAT_RGB565_SWAPPED, 2, {200, 0, 100}, {192, 12, 0, 0}},
              {GLINT_GREY8, LV_COLOR_FORMAT_L8, 1, {200, 200, 200}, {200, 0, 0, 0}},
              {GLINT_BGR888, LV_COLOR_FORMAT_RGB888, 3, {200, 0, 100}, {100, 0, 200, 0}},
              {GLINT_XRGB8888, LV_COLOR_FORMAT_XRGB8888, 4, {200, 0, 100}, {100, 0, 200, 255}},
              {GLINT_ARGB8888, LV_COLOR_FORMAT_ARGB8888, 4, {200, 0, 100}, {100, 0, 200, 77}}};
    static const struct glint_vec normal = {0, 0, 32767};
    static const uint8_t half = 77;
    static const int32_t to_viewer[3] = {0, 0, 1};
    unsigned wrong = 0;
    for (unsigned i = 0; i < sizeof of / sizeof *of; i++) {
        struct glint_material material;
        struct glint_maps maps;
        struct glint_paint paint;
        struct glint_light light;
        struct glint_surface surface;
        const struct glint_output output = {of[i].format, GLINT_GAMMA, false};
        uint8_t pixel[4] = {0, 0, 0, 0};
        lv_obj_t canvas;
        memset(&material, 0, sizeof material);
        memset(&maps, 0, sizeof maps);
        lv_canvas_set_buffer(&canvas, pixel, 1, 1, (lv_color_format_t)of[i].cf);
        material.n = 60;
        for (unsigned k = 0; k < 3; k++) {
            material.albedo[k] = of[i].albedo[k];
            material.ambient_q16[k] = 65536;
        }
        wrong += glint_paint_exact(&paint, &material, &output) != GLINT_OK;
        wrong += glint_light_directional(&light, to_viewer) != GLINT_OK;
        wrong += glint_paint_light(&paint, &light, 1, to_viewer) != GLINT_OK;
        maps.normals = &normal;
        maps.coverage = of[i].format == GLINT_ARGB8888 ? &half : NULL;
        wrong += glint_lvgl_canvas(&canvas, GLINT_RGB888, &surface) != GLINT_ERR_FORMAT;
        wrong += glint_lvgl_canvas(&canvas, of[i].format, &surface) != GLINT_OK;
        wrong += surface.stride != of[i].bytes;
        wrong += glint_draw_rect(&paint, &maps, 1, 1, &surface, NULL) != GLINT_OK;
        for (unsigned b = 0; b < 4; b++)
            wrong += pixel[b] != of[i].wanted[b];
    }
    return wrong;
}

/* Each map in lines of five as in one piece. Returns how many pixels differ. */
static unsigned maps_in_parts(void)
{
    enum { SIDE = 24, LINES = 5, MAPS = 5, PIXELS = SIDE * SIDE };
    static const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false};
    static const int32_t to_light[3] = {-1, 1, 3}, to_viewer[3] = {0, 0, 1};
    static struct glint_vec dome[PIXELS];
    static uint8_t bytes[3 * PIXELS];
    static uint16_t whole[PIXELS];
    void *const badge = objects[1].user_data;
    const lv_area_t at = objects[1].at;
    unsigned wrong = 0;
    for (int i = 0; i < PIXELS; i++) {
        const int32_t slope[3] = {i % SIDE - SIDE / 2, SIDE / 2 - i / SIDE, SIDE / 2};
        glint_vec_normalize(&dome[i], slope);
    }
    for (unsigned i = 0; i < sizeof bytes; i++)
        bytes[i] = (uint8_t)(97 * i >> 2);
    lv_obj_set_size(&objects[1], SIDE, SIDE);
    for (unsigned k = 0; k < MAPS; k++) {
        struct glint_material material;
        struct glint_paint paint;
        struct glint_light light;
        struct glint_lvgl map;
        const struct glint_surface surface = {whole, 2 * SIDE, 0, 0};
        memset(&material, 0, sizeof material);
        memset(&map, 0, sizeof map);
        material.n = 40;
        material.n_across = k == 3 ? 6 : 0;
        for (unsigned i = 0; i < 3; i++) {
            material.albedo[i] = 150;
            material.diffuse_q16[i] = material.specular_q16[i] = 40000;
        }
        wrong += glint_paint_exact(&paint, &material, &output) != GLINT_OK;
        wrong += glint_light_directional(&light, to_light) != GLINT_OK;
        wrong += glint_paint_light(&paint, &light, 1, to_viewer) != GLINT_OK;
        map.paint = &paint;
        map.w = map.h = SIDE;
        map.maps.normals = dome;
        map.maps.normals_stride = sizeof dome / SIDE;
        const uint8_t **const of[MAPS] = {&map.maps.albedo, &map.maps.gloss, &map.maps.coverage, &map.maps.grain,
                                          &map.maps.shininess};
        ptrdiff_t *const stride[MAPS] = {&map.maps.albedo_stride, &map.maps.gloss_stride, &map.maps.coverage_stride,
                                         &map.maps.grain_stride, &map.maps.shininess_stride};
        *of[k] = bytes;
        *stride[k] = k ? SIDE : 3 * SIDE;
        map.maps.albedo_format = GLINT_RGB888;
        for (unsigned i = 0; i < PIXELS; i++)
            whole[i] = BACKGROUND;
        wrong += glint_draw_rect(&paint, &map.maps, SIDE, SIDE, &surface, NULL) != GLINT_OK;
        objects[1].user_data = &map;
        for (int32_t y = 0; y < SIDE; y += LINES) {
            const lv_area_t lines = {at.x1 + 3, at.y1 + y, at.x1 + SIDE - 1, at.y1 + y + LINES - 1};
            refresh(lines);
            wrong += map.err != GLINT_OK;
        }
        for (unsigned i = 0; i < PIXELS; i++)
            wrong += i % SIDE >= 3 && shown[at.y1 + (int32_t)i / SIDE][at.x1 + (int32_t)i % SIDE] != whole[i];
    }
    objects[1].at = at;
    objects[1].user_data = badge;
    return wrong;
}

int main(void)
{
    if (badge_create())
        return 1;
    const lv_area_t of_canvas = objects[0].at, of_object = objects[1].at;
    unsigned wrong = other_canvases() + maps_in_parts();
    for (int32_t y = 0; y < HEIGHT; y += 20) {
        const lv_area_t lines = {0, y, WIDTH - 1, y + 19};
        refresh(lines);
    }
    const lv_area_t odd = {of_object.x1 + 11, of_object.y1 + 13, of_object.x2 + 3, of_object.y1 + 30};
    for (int32_t y = odd.y1; y <= odd.y2; y++)
        memset(&shown[y][odd.x1], 0, 2 * (size_t)(odd.x2 - odd.x1 + 1));
    refresh(odd);
    for (int32_t y = 0; y < 64; y++)
        for (int32_t x = 0; x < 64; x++)
            wrong +=
                shown[of_object.y1 + y][of_object.x1 + x] != ((const uint16_t *)objects[0].buffer.data)[64 * y + x];
    printf("%u wrong, %04x in the highlight, %04x beside, canvas at %d\n", wrong,
           shown[of_object.y1 + 20][of_object.x1 + 20], shown[odd.y1][odd.x2], (int)of_canvas.x1);
    return 0;
}
