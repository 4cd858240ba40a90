/* SPDX-License-Identifier: MIT */
#include "glint_lvgl.h"

static bool is_format(uint8_t format, unsigned lvgl)
{
    switch (format) {
    case GLINT_RGB565:
        return lvgl == LV_COLOR_FORMAT_RGB565;
    case GLINT_RGB565_SWAPPED:
        return lvgl == LV_COLOR_FORMAT_RGB565_SWAPPED;
    case GLINT_GREY8:
        return lvgl == LV_COLOR_FORMAT_L8;
    case GLINT_BGR888:
        return lvgl == LV_COLOR_FORMAT_RGB888;
    case GLINT_XRGB8888:
        return lvgl == LV_COLOR_FORMAT_XRGB8888;
    case GLINT_ARGB8888:
        return lvgl == LV_COLOR_FORMAT_ARGB8888;
    }
    return false;
}

enum glint_err glint_lvgl_canvas(lv_obj_t *canvas, uint8_t format, struct glint_surface *surface)
{
    const lv_draw_buf_t *buffer = lv_canvas_get_draw_buf(canvas);
    if (!buffer || !buffer->data)
        return GLINT_ERR_ARG;
    if (!is_format(format, buffer->header.cf))
        return GLINT_ERR_FORMAT;
    surface->pixels = buffer->data;
    surface->stride = (ptrdiff_t)buffer->header.stride;
    surface->x = surface->y = 0;
    return GLINT_OK;
}

/* LVGL draws later what it is told to draw: what lies below the object must be there before its pixels are. */
static void finish_below(lv_obj_t *object, lv_layer_t *layer)
{
    while (layer->draw_task_head) {
        lv_draw_dispatch_wait_for_request();
        if (!lv_draw_dispatch_layer(lv_obj_get_display(object), layer)) {
            lv_draw_wait_for_finish();
            lv_draw_dispatch_request();
        }
    }
}

static int32_t larger(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

static int32_t smaller(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

/* A map of so many bytes a pixel, from column x and line y on. */
static const uint8_t *window(const uint8_t *map, ptrdiff_t stride, int32_t x, int32_t y, int32_t bytes)
{
    return map ? map + y * stride + x * bytes : NULL;
}

static struct glint_maps maps_window(const struct glint_maps *maps, int32_t x, int32_t y)
{
    struct glint_maps part = *maps;
    if (maps->normals)
        part.normals = glint_normals_window((enum glint_normals)maps->normals_format, maps->normals,
                                            maps->normals_stride, (uint32_t)x, (uint32_t)y);
    part.albedo = window(maps->albedo, maps->albedo_stride, x, y, maps->albedo_format == GLINT_RGB888 ? 3 : 2);
    part.gloss = window(maps->gloss, maps->gloss_stride, x, y, 1);
    part.coverage = window(maps->coverage, maps->coverage_stride, x, y, 1);
    part.grain = window(maps->grain, maps->grain_stride, x, y, 1);
    return part;
}

static enum glint_err draw(const struct glint_lvgl *map, lv_obj_t *object, lv_layer_t *layer)
{
    lv_area_t at;
    lv_obj_get_coords(object, &at);
    /* the part of the map that is in the object, in what is redrawn and in the layer's buffer */
    const lv_area_t *clip = &layer->_clip_area, *buffer = &layer->buf_area;
    const int32_t left = larger(at.x1, larger(clip->x1, buffer->x1)), top = larger(at.y1, larger(clip->y1, buffer->y1));
    const int32_t right = smaller(smaller(at.x2, at.x1 + map->w - 1), smaller(clip->x2, buffer->x2));
    const int32_t bottom = smaller(smaller(at.y2, at.y1 + map->h - 1), smaller(clip->y2, buffer->y2));
    if (left > right || top > bottom)
        return GLINT_OK;
    if (!is_format(map->paint->output.format, layer->color_format))
        return GLINT_ERR_FORMAT;
    if (!layer->draw_buf && !lv_draw_layer_alloc_buf(layer))
        return GLINT_ERR_ARG; /* LVGL is out of memory */
    finish_below(object, layer);
    const int32_t x = left - at.x1, y = top - at.y1;
    const struct glint_maps maps = maps_window(&map->maps, x, y);
    const struct glint_surface surface = {lv_draw_layer_go_to_xy(layer, left - buffer->x1, top - buffer->y1),
                                          (ptrdiff_t)layer->draw_buf->header.stride, (uint16_t)x, (uint16_t)y};
    return glint_draw_rect(map->paint, &maps, (uint16_t)(right - left + 1), (uint16_t)(bottom - top + 1), &surface,
                           NULL);
}

void glint_lvgl_draw(lv_event_t *event)
{
    struct glint_lvgl *map = (struct glint_lvgl *)lv_event_get_user_data(event);
    map->err = draw(map, lv_event_get_target_obj(event), lv_event_get_layer(event));
}
