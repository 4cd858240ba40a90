/* SPDX-License-Identifier: MIT */
#include "glint_lvgl.h"

static bool is_format(uint8_t format, unsigned lvgl)
{
    switch (format) {
    case GLINT_RGB565:
        return lvgl == LV_COLOR_FORMAT_RGB565;
#if LVGL_VERSION_MAJOR > 9 || LVGL_VERSION_MINOR >= 3
    case GLINT_RGB565_SWAPPED:
        return lvgl == LV_COLOR_FORMAT_RGB565_SWAPPED;
#endif
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

/* LVGL draws later what it is told to draw: what lies below the object must be there before its pixels are. False: a task cannot be drawn
 * though no other is being drawn: LVGL is out of memory. */
static bool finish_below(lv_obj_t *object, lv_layer_t *layer)
{
    while (layer->draw_task_head) {
        lv_draw_dispatch_wait_for_request();
        if (lv_draw_dispatch_layer(lv_obj_get_display(object), layer))
            continue;
        lv_draw_wait_for_finish();
        lv_draw_dispatch_request();
        if (!lv_draw_dispatch_layer(lv_obj_get_display(object), layer))
            return layer->draw_task_head == NULL;
    }
    return true;
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
    part.shininess = window(maps->shininess, maps->shininess_stride, x, y, 1);
    return part;
}

enum glint_err glint_lvgl_part(lv_obj_t *object, lv_layer_t *layer, const struct glint_box *box, uint8_t format,
                               struct glint_box *part, struct glint_surface *surface)
{
    lv_area_t at;
    lv_obj_get_coords(object, &at);
    /* the part of the box that is in the object, in what is redrawn and in the layer's buffer */
    const lv_area_t *clip = &layer->_clip_area, *buffer = &layer->buf_area;
    const int32_t box_x = at.x1 + box->x, box_y = at.y1 + box->y;
    const int32_t left = larger(box_x, larger(clip->x1, buffer->x1));
    const int32_t top = larger(box_y, larger(clip->y1, buffer->y1));
    const int32_t right = smaller(smaller(at.x2, box_x + box->w - 1), smaller(clip->x2, buffer->x2));
    const int32_t bottom = smaller(smaller(at.y2, box_y + box->h - 1), smaller(clip->y2, buffer->y2));
    part->w = part->h = 0;
    if (left > right || top > bottom)
        return GLINT_OK;
    if (!is_format(format, layer->color_format))
        return GLINT_ERR_FORMAT;
    if (!layer->draw_buf && !lv_draw_layer_alloc_buf(layer))
        return GLINT_ERR_ARG; /* LVGL is out of memory */
    if (!finish_below(object, layer))
        return GLINT_ERR_ARG;
    part->x = (uint16_t)(left - at.x1);
    part->y = (uint16_t)(top - at.y1);
    part->w = (uint16_t)(right - left + 1);
    part->h = (uint16_t)(bottom - top + 1);
    surface->pixels = lv_draw_layer_go_to_xy(layer, left - buffer->x1, top - buffer->y1);
    surface->stride = (ptrdiff_t)layer->draw_buf->header.stride;
    surface->x = part->x;
    surface->y = part->y;
    return GLINT_OK;
}

static enum glint_err draw(const struct glint_lvgl *map, lv_obj_t *object, lv_layer_t *layer)
{
    const struct glint_box whole = {0, 0, map->w, map->h};
    struct glint_box part;
    struct glint_surface surface;
    const enum glint_err err = glint_lvgl_part(object, layer, &whole, map->paint->output.format, &part, &surface);
    if (err != GLINT_OK || part.w == 0)
        return err;
    const struct glint_maps maps = maps_window(&map->maps, part.x, part.y);
    return glint_draw_rect(map->paint, &maps, part.w, part.h, &surface, NULL);
}

void glint_lvgl_draw(lv_event_t *event)
{
    struct glint_lvgl *map = (struct glint_lvgl *)lv_event_get_user_data(event);
    map->err = draw(map, lv_event_get_target_obj(event), lv_event_get_layer(event));
}
