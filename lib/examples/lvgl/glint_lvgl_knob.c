/* SPDX-License-Identifier: MIT
 * Places are in half pixels from the knob's middle, x right, y down, so that pixels' middles are whole numbers. A turn is 65536, clockwise from the
 * right. */
#include "glint_lvgl_knob.h"
#include <lvgl_private.h> /* lv_hit_test_info_t */

enum { TURN = 65536, SWEEP = TURN * 3 / 4, FIRST = TURN * 3 / 8, NO_FINGER = -1 };

/* ---- directions ---- */

static const int16_t arctangents[] = {8192, 4836, 2555, 1297, 651, 326, 163, 81, 41, 20, 10, 5, 3, 1};
enum { STEPS = sizeof arctangents / sizeof *arctangents };

static int32_t direction_of(int32_t x, int32_t y)
{
    int32_t angle = 0;
    x *= 1024;
    y *= 1024;
    if (x < 0) {
        angle = TURN / 2;
        x = -x;
        y = -y;
    }
    for (unsigned i = 0; i < STEPS; i++) {
        const int32_t dx = x / (1 << i), dy = y / (1 << i);
        const int32_t sign = y < 0 ? -1 : 1;
        x += sign * dy;
        y -= sign * dx;
        angle += sign * arctangents[i];
    }
    return angle & (TURN - 1);
}

/* A point so far away in that direction. */
static lv_point_t point_at(int32_t angle, int32_t distance)
{
    const bool is_left = ((angle + TURN / 4) & (TURN / 2)) != 0;
    int32_t left = ((angle + TURN / 4) & (TURN / 2 - 1)) - TURN / 4;
    int32_t x = distance * 2487, y = 0; /* 4096 / 1.6468, by which the steps lengthen */
    for (unsigned i = 0; i < STEPS; i++) {
        const int32_t dx = x / (1 << i), dy = y / (1 << i);
        const int32_t sign = left < 0 ? -1 : 1;
        x -= sign * dy;
        y += sign * dx;
        left -= sign * arctangents[i];
    }
    const lv_point_t point = {(is_left ? -x : x) / 4096, (is_left ? -y : y) / 4096};
    return point;
}

/* ---- shape ---- */

/* Of the knob, of its flat face, from the middle to the dot's, of the dot. */
static int32_t outer(const struct glint_lvgl_knob *knob)
{
    return knob->side - 1;
}

static int32_t flat(const struct glint_lvgl_knob *knob)
{
    return outer(knob) * 7 / 8;
}

static lv_point_t dot_of(const struct glint_lvgl_knob *knob)
{
    return point_at(FIRST + knob->turned, outer(knob) * 5 / 8);
}

static int32_t dot_radius(const struct glint_lvgl_knob *knob)
{
    return outer(knob) / 9;
}

/* In 1/128 pixel; of at most 2^19 quarters of a square pixel. */
static int32_t root(uint32_t squares)
{
    uint32_t left = squares << 12, found = 0;
    for (uint32_t bit = 1u << 30; bit; bit >>= 2) {
        const bool fits = left >= found + bit;
        left -= fits ? found + bit : 0;
        found = (found >> 1) + (fits ? bit : 0);
    }
    return (int32_t)found;
}

/* How much of a pixel is within a circle, of 255. */
static int32_t covered(int32_t distance, int32_t radius)
{
    const int32_t inside = 64 * radius - distance + 64;
    return inside <= 0 ? 0 : inside >= 128 ? 255 : inside * 255 / 128;
}

static void pixel(struct glint_lvgl_knob *knob, unsigned i, int32_t x, int32_t y, const lv_point_t *dot)
{
    static const struct glint_vec up = {0, 0, 32767};
    const int32_t radius = outer(knob), face = flat(knob), hole = dot_radius(knob);
    const int32_t dx = x - dot->x, dy = y - dot->y, reach = (hole + 2) * (hole + 2);
    const int32_t squares = x * x + y * y;
    const uint8_t *albedo = knob->paint->material.albedo;
    int32_t share = 0;
    knob->normals[i] = up;
    knob->coverage[i] = 255;
    if (squares > (radius + 2) * (radius + 2)) {
        knob->coverage[i] = 0;
    } else if (squares > face * face) { /* the rim bends down to 60 degrees */
        const int32_t distance = root((uint32_t)squares);
        const int32_t bend = (distance - 64 * face) * 4 / (radius - face); /* 256 at the edge, or a little more */
        const int32_t slope[3] = {x * 64 * bend / 4 * 7, -y * 64 * bend / 4 * 7, distance * 256};
        knob->coverage[i] = (uint8_t)covered(distance, radius);
        glint_vec_normalize(&knob->normals[i], slope);
    } else if (dx * dx + dy * dy <= reach) { /* a hollow */
        const int32_t slope[3] = {-dx, dy, hole};
        share = covered(root((uint32_t)(dx * dx + dy * dy)), hole);
        if (dx * dx + dy * dy < hole * hole)
            glint_vec_normalize(&knob->normals[i], slope);
    }
    for (unsigned k = 0; k < 3; k++)
        knob->albedo[i][k] = (uint8_t)((albedo[k] * (255 - share) + knob->dot[k] * share + 127) / 255);
}

static lv_area_t area_of(const struct glint_lvgl_knob *knob)
{
    lv_area_t at;
    lv_obj_get_coords(knob->object, &at);
    at.x2 = at.x1 + knob->side - 1;
    at.y2 = at.y1 + knob->side - 1;
    return at;
}

static void invalidate_dot(const struct glint_lvgl_knob *knob)
{
    if (!knob->object)
        return;
    const lv_area_t at = area_of(knob);
    const lv_point_t dot = dot_of(knob);
    const int32_t x = dot.x + knob->side, y = dot.y + knob->side, reach = dot_radius(knob) + 3; /* > 0 */
    const lv_area_t area = {at.x1 + (x - reach) / 2, at.y1 + (y - reach) / 2, at.x1 + (x + reach) / 2,
                            at.y1 + (y + reach) / 2};
    lv_obj_invalidate_area(knob->object, &area);
}

/* ---- drawing ---- */

static int32_t bytes_of(uint8_t format)
{
#define BYTES(number, name, bits, channels, red, green, blue) (bits) / 8,
    static const uint8_t bytes[] = {GLINT_FORMATS(BYTES)};
#undef BYTES
    return bytes[format];
}

static enum glint_err draw(struct glint_lvgl_knob *knob, lv_layer_t *layer)
{
    const bool is_own_layer = knob->layer_paint && layer->color_format == LV_COLOR_FORMAT_ARGB8888;
    const struct glint_paint *paint = is_own_layer ? knob->layer_paint : knob->paint;
    const int32_t bytes = bytes_of(paint->output.format);
    const struct glint_box whole = {0, 0, knob->side, knob->side};
    const lv_point_t dot = dot_of(knob);
    static const struct glint_maps none = {NULL, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0, 0, 0, 0, {0, 0}, NULL, 0};
    struct glint_maps maps = none;
    struct glint_box part;
    struct glint_surface surface;
    enum glint_err err = glint_lvgl_part(knob->object, layer, &whole, paint->output.format, &part, &surface);
    if (err != GLINT_OK || part.w == 0)
        return err;
    maps.normals = knob->normals;
    maps.albedo = knob->albedo[0];
    maps.albedo_format = GLINT_RGB888;
    maps.coverage = knob->coverage;
    maps.grain_kind = GLINT_GRAIN_SPUN;
    maps.grain_at[0] = maps.grain_at[1] = 8 * knob->side;
    for (int32_t y = 0; y < part.h && err == GLINT_OK; y++) {
        for (int32_t x = 0; x < part.w && err == GLINT_OK; x += GLINT_LVGL_KNOB_RUN) {
            const int32_t left = part.w - x, count = left < GLINT_LVGL_KNOB_RUN ? left : GLINT_LVGL_KNOB_RUN;
            const struct glint_surface run = {(char *)surface.pixels + surface.stride * y + bytes * x, surface.stride,
                                              (uint16_t)(part.x + x), (uint16_t)(part.y + y)};
            for (int32_t i = 0; i < count; i++)
                pixel(knob, (unsigned)i, 2 * (run.x + i) + 1 - knob->side, 2 * run.y + 1 - knob->side, &dot);
            err = glint_draw_rect(paint, &maps, (uint16_t)count, 1, &run, NULL);
        }
    }
    return err;
}

/* ---- events ---- */

static int32_t turned_of(const struct glint_lvgl_knob *knob, int32_t value)
{
    return (int32_t)(((int64_t)value - knob->least) * SWEEP / ((int64_t)knob->most - knob->least));
}

static void turn(struct glint_lvgl_knob *knob, int32_t turned)
{
    if (turned == knob->turned)
        return;
    invalidate_dot(knob);
    knob->turned = turned;
    invalidate_dot(knob);
}

static lv_point_t finger_of(const struct glint_lvgl_knob *knob, const lv_point_t *point)
{
    const lv_area_t at = area_of(knob);
    const lv_point_t place = {2 * (point->x - at.x1) + 1 - knob->side, 2 * (point->y - at.y1) + 1 - knob->side};
    return place;
}

static bool see_finger(lv_event_t *event, lv_point_t *place)
{
    const struct glint_lvgl_knob *knob = (const struct glint_lvgl_knob *)lv_event_get_user_data(event);
    lv_point_t point;
    lv_indev_t *indev = lv_indev_active();
    if (!indev)
        return false;
    lv_indev_get_point(indev, &point);
    *place = finger_of(knob, &point);
    return true;
}

/* A finger that slides onto the knob may come without LV_EVENT_PRESSED. */
static void on_off(lv_event_t *event)
{
    struct glint_lvgl_knob *knob = (struct glint_lvgl_knob *)lv_event_get_user_data(event);
    knob->finger = NO_FINGER;
}

static void on_pressing(lv_event_t *event)
{
    struct glint_lvgl_knob *knob = (struct glint_lvgl_knob *)lv_event_get_user_data(event);
    lv_point_t place;
    if (!see_finger(event, &place))
        return;
    const int32_t finger = direction_of(place.x, place.y), before = knob->finger == NO_FINGER ? finger : knob->finger;
    const int32_t by = ((finger - before + TURN / 2) & (TURN - 1)) - TURN / 2; /* the shorter way */
    const int32_t turned = knob->turned + by < 0 ? 0 : knob->turned + by > SWEEP ? SWEEP : knob->turned + by;
    const int64_t wide = (int64_t)knob->most - knob->least;
    const int32_t value = by == 0 ? knob->value : knob->least + (int32_t)(((int64_t)turned * wide + SWEEP / 2) / SWEEP);
    knob->finger = finger;
    turn(knob, turned);
    if (value == knob->value)
        return;
    knob->value = value;
    lv_obj_send_event(knob->object, LV_EVENT_VALUE_CHANGED, NULL);
}

static void on_draw(lv_event_t *event)
{
    struct glint_lvgl_knob *knob = (struct glint_lvgl_knob *)lv_event_get_user_data(event);
    knob->err = draw(knob, lv_event_get_layer(event));
}

/* With its screen, or by another's call: what users call must not reach what is gone. */
static void on_delete(lv_event_t *event)
{
    struct glint_lvgl_knob *knob = (struct glint_lvgl_knob *)lv_event_get_user_data(event);
    knob->object = NULL;
}

static void on_hit_test(lv_event_t *event)
{
    const struct glint_lvgl_knob *knob = (const struct glint_lvgl_knob *)lv_event_get_user_data(event);
    lv_hit_test_info_t *info = lv_event_get_hit_test_info(event);
    const lv_point_t at = finger_of(knob, info->point);
    info->res = at.x * at.x + at.y * at.y <= outer(knob) * outer(knob);
}

/* ---- what users call ---- */

lv_obj_t *glint_lvgl_knob_create(struct glint_lvgl_knob *knob, lv_obj_t *parent, uint16_t side)
{
    knob->err = side < 16 || side > GLINT_LVGL_KNOB_MOST ? GLINT_ERR_ARG : GLINT_OK;
    knob->object = knob->err == GLINT_OK ? lv_obj_create(parent) : NULL;
    if (!knob->object)
        return NULL;
    knob->least = knob->value = knob->turned = 0;
    knob->finger = NO_FINGER;
    knob->most = 100;
    knob->side = side;
    lv_obj_remove_style_all(knob->object);
    lv_obj_set_size(knob->object, side, side);
    lv_obj_add_flag(knob->object, LV_OBJ_FLAG_ADV_HITTEST);
    lv_obj_remove_flag(knob->object, LV_OBJ_FLAG_SCROLLABLE); /* a drag turns it */
    lv_obj_remove_flag(knob->object, LV_OBJ_FLAG_SCROLL_CHAIN_HOR);
    lv_obj_remove_flag(knob->object, LV_OBJ_FLAG_SCROLL_CHAIN_VER);
    lv_obj_add_event_cb(knob->object, on_draw, LV_EVENT_DRAW_MAIN, knob);
    lv_obj_add_event_cb(knob->object, on_hit_test, LV_EVENT_HIT_TEST, knob);
    lv_obj_add_event_cb(knob->object, on_pressing, LV_EVENT_PRESSED, knob);
    lv_obj_add_event_cb(knob->object, on_pressing, LV_EVENT_PRESSING, knob);
    lv_obj_add_event_cb(knob->object, on_off, LV_EVENT_RELEASED, knob);
    lv_obj_add_event_cb(knob->object, on_off, LV_EVENT_PRESS_LOST, knob);
    lv_obj_add_event_cb(knob->object, on_delete, LV_EVENT_DELETE, knob);
    return knob->object;
}

enum glint_err glint_lvgl_knob_set_range(struct glint_lvgl_knob *knob, int32_t least, int32_t most)
{
    if (least >= most || (int64_t)most - least > 1 << 30)
        return GLINT_ERR_ARG;
    knob->least = least;
    knob->most = most;
    glint_lvgl_knob_set_value(knob, knob->value);
    return GLINT_OK;
}

void glint_lvgl_knob_set_value(struct glint_lvgl_knob *knob, int32_t value)
{
    knob->value = value < knob->least ? knob->least : value > knob->most ? knob->most : value;
    turn(knob, turned_of(knob, knob->value));
}

int32_t glint_lvgl_knob_get_value(const struct glint_lvgl_knob *knob)
{
    return knob->value;
}

int32_t glint_lvgl_knob_get_least(const struct glint_lvgl_knob *knob)
{
    return knob->least;
}

int32_t glint_lvgl_knob_get_most(const struct glint_lvgl_knob *knob)
{
    return knob->most;
}

enum glint_err glint_lvgl_knob_set_light(struct glint_lvgl_knob *knob, const int32_t to_light[3])
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    struct glint_light light;
    enum glint_err err = glint_light_directional(&light, to_light);
    if (err == GLINT_OK)
        err = glint_paint_light(knob->paint, &light, 1, to_viewer);
    if (err == GLINT_OK && knob->layer_paint)
        err = glint_paint_light(knob->layer_paint, &light, 1, to_viewer);
    if (knob->object) {
        const lv_area_t area = area_of(knob);
        lv_obj_invalidate_area(knob->object, &area);
    }
    return err;
}
