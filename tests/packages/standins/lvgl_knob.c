/* SPDX-License-Identifier: MIT
 * A knob, redrawn as LVGL does: what was invalidated, in strips, over a background whose task is still waiting; turned by a finger. Prints what
 * differs from the same knob drawn in one piece, the picture (with a name of a file: as PPM), and what was redrawn. */
#include "glint_lvgl_knob.h"
#include "lvgl_object.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 160, HEIGHT = 150, SIDE = 121, LEFT = 17, TOP = 13, BACKGROUND = 0x1f };

static uint8_t pixels[WIDTH * HEIGHT * 4];
static lv_point_t finger;
static unsigned changes;
static uint16_t shown[HEIGHT][WIDTH], wanted[HEIGHT][WIDTH];

lv_obj_t *lv_obj_create(lv_obj_t *parent)
{
    object.flags = LV_OBJ_FLAG_SCROLLABLE | LV_OBJ_FLAG_SCROLL_CHAIN_HOR | LV_OBJ_FLAG_SCROLL_CHAIN_VER;
    return parent == &screen ? &object : NULL;
}
void lv_obj_remove_flag(lv_obj_t *obj, lv_obj_flag_t f)
{
    obj->flags &= ~(unsigned)f;
}
lv_result_t lv_obj_send_event(lv_obj_t *obj, lv_event_code_t event_code, void *param)
{
    (void)param;
    changes += obj == &object && event_code == LV_EVENT_VALUE_CHANGED;
    return LV_RESULT_OK;
}
lv_indev_t *lv_indev_active(void)
{
    return (lv_indev_t *)&finger;
}
void lv_indev_get_point(const lv_indev_t *indev, lv_point_t *point)
{
    (void)indev;
    *point = finger;
}
bool lv_draw_dispatch_layer(lv_display_t *disp, lv_layer_t *layer)
{
    (void)disp;
    for (unsigned i = 0; layer->draw_task_head && i < sizeof pixels / 2; i++)
        ((uint16_t *)(void *)buffer.data)[i] = BACKGROUND;
    layer->draw_task_head = NULL;
    return true;
}
void *lv_draw_layer_alloc_buf(lv_layer_t *layer)
{
    layer->draw_buf = &buffer;
    return buffer.data;
}

/* ---- what the test does ---- */

static void redraw(uint16_t screen_pixels[HEIGHT][WIDTH], lv_area_t area, int32_t lines)
{
    for (int32_t y = area.y1; y <= area.y2; y += lines) {
        const int32_t bottom = y + lines - 1 < area.y2 ? y + lines - 1 : area.y2, w = area.x2 - area.x1 + 1;
        const lv_area_t strip = {area.x1, y, area.x2, bottom};
        lv_layer_t layer = {NULL, (lv_draw_task_t *)&screen, strip, strip, LV_COLOR_FORMAT_RGB565};
        buffer.header.stride = (uint16_t)(2 * w);
        send(LV_EVENT_DRAW_MAIN, &layer, NULL);
        lv_draw_dispatch_layer(NULL, &layer);
        for (int32_t row = y; row <= bottom; row++)
            memcpy(&screen_pixels[row][area.x1], buffer.data + 2 * w * (row - y), 2 * (size_t)w);
    }
}

static const lv_area_t all = {0, 0, WIDTH - 1, HEIGHT - 1};

static int32_t redraw_dirty(int32_t lines)
{
    int32_t count = 0;
    for (unsigned i = 0; i < dirty_count; i++) {
        count += (dirty[i].x2 - dirty[i].x1 + 1) * (dirty[i].y2 - dirty[i].y1 + 1);
        redraw(shown, dirty[i], lines);
    }
    dirty_count = 0;
    return count;
}

static unsigned wrong_pixels(void)
{
    unsigned wrong = 0;
    redraw(wanted, all, HEIGHT);
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++)
        wrong += shown[i / WIDTH][i % WIDTH] != wanted[i / WIDTH][i % WIDTH];
    return wrong;
}

static void touch(lv_event_code_t code, int32_t x, int32_t y)
{
    finger.x = LEFT + SIDE / 2 + x;
    finger.y = TOP + SIDE / 2 + y;
    send(code, NULL, NULL);
}

static void save(const char *name)
{
    FILE *file = fopen(name, "wb");
    if (!file)
        exit(1);
    fprintf(file, "P6 %d %d 255\n", WIDTH, HEIGHT);
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const unsigned p = shown[i / WIDTH][i % WIDTH];
        fputc((int)((p >> 11) * 255 / 31), file);
        fputc((int)((p >> 5 & 63) * 255 / 63), file);
        fputc((int)((p & 31) * 255 / 31), file);
    }
    fclose(file);
}

int main(int argc, char **argv)
{
    static const struct glint_material steel = {
        GLINT_MSH, 0, 4, 160, {9000, 9000, 9500}, {20000, 20000, 21000}, {52000, 52000, 54000}, {160, 162, 168}, false};
    static const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false},
                                     over = {GLINT_ARGB8888, GLINT_GAMMA, false};
    static const int32_t lights[][3] = {{-2, 3, 5}, {3, 1, 4}};
    static const int32_t lines[] = {10, 1, 7, 16, 150};
    static struct glint_paint paint, layer_paint;
    static struct glint_lvgl_knob knob;
    unsigned wrong = 0, hits = 0;
    knob.paint = &paint;
    knob.dot[0] = 235;
    knob.dot[1] = 80;
    knob.dot[2] = 40;
    object.at.x1 = LEFT;
    object.at.y1 = TOP;
    buffer.data = pixels;
    if (glint_paint_exact(&paint, &steel, &output) || glint_paint_exact(&layer_paint, &steel, &over) ||
        glint_lvgl_knob_create(&knob, &screen, 15) || knob.err != GLINT_ERR_ARG ||
        !glint_lvgl_knob_create(&knob, &screen, SIDE) || object.flags != LV_OBJ_FLAG_ADV_HITTEST ||
        glint_lvgl_knob_set_light(&knob, lights[0]))
        return 1;
    redraw(shown, all, 10);
    dirty_count = 0;
    /* Values: only the dot's places are redrawn. */
    int32_t redrawn = 0;
    for (int32_t i = 0; i <= 50; i++) {
        glint_lvgl_knob_set_value(&knob, i * 37 % 101);
        redrawn += redraw_dirty(lines[i % 5]);
        wrong += knob.err != GLINT_OK || glint_lvgl_knob_get_value(&knob) != i * 37 % 101;
        wrong += wrong_pixels();
    }
    printf("%u wrong, %d %% redrawn a value, ", wrong, (int)(redrawn * 100 / (51 * SIDE * SIDE)));
    glint_lvgl_knob_set_value(&knob, glint_lvgl_knob_get_value(&knob));
    wrong = dirty_count != 0;
    /* A light: the knob is. */
    if (glint_lvgl_knob_set_light(&knob, lights[1]))
        return 1;
    redrawn = redraw_dirty(10);
    wrong += wrong_pixels() + (redrawn != SIDE * SIDE);
    /* A range holds the value. */
    wrong += glint_lvgl_knob_set_range(&knob, 5, 5) != GLINT_ERR_ARG;
    wrong += glint_lvgl_knob_set_range(&knob, -1000, -500) != GLINT_OK || glint_lvgl_knob_get_value(&knob) != -500;
    wrong += glint_lvgl_knob_get_least(&knob) != -1000 || glint_lvgl_knob_get_most(&knob) != -500 || changes;
    printf("%u wrong by light and range, ", wrong);
    /* A finger: from the top a quarter turn to the right is a third of the range; past the end it stays there. */
    glint_lvgl_knob_set_value(&knob, -1000);
    touch(LV_EVENT_PRESSED, 0, -40);
    touch(LV_EVENT_PRESSING, 28, -28);
    touch(LV_EVENT_PRESSING, 40, 0);
    printf("%d after a quarter turn, ", (int)glint_lvgl_knob_get_value(&knob));
    touch(LV_EVENT_PRESSING, 40, 0);
    const unsigned changed = changes;
    touch(LV_EVENT_PRESSING, 0, 40);
    touch(LV_EVENT_PRESSING, -40, 0);
    touch(LV_EVENT_PRESSING, 0, -40);
    printf("%d after a whole one, ", (int)glint_lvgl_knob_get_value(&knob));
    touch(LV_EVENT_PRESSING, -28, -28);
    printf("%d back by an eighth; %u and %u changes, ", (int)glint_lvgl_knob_get_value(&knob), changed, changes);
    /* Another finger elsewhere turns nothing by coming, nor does one that slides onto the knob. */
    touch(LV_EVENT_RELEASED, -28, -28);
    touch(LV_EVENT_PRESSING, 30, 30);
    touch(LV_EVENT_PRESS_LOST, 0, 0);
    touch(LV_EVENT_PRESSED, -30, 10);
    wrong += changes != 5;
    dirty_count = 0;
    redraw(shown, all, 10);
    /* Clicks hit the disc. */
    for (int32_t i = 0; i < SIDE * SIDE; i++) {
        const lv_point_t point = {LEFT + i % SIDE, TOP + i / SIDE};
        lv_hit_test_info_t info = {&point, false};
        send(LV_EVENT_HIT_TEST, NULL, &info);
        hits += info.res;
        const int32_t x = i % SIDE - SIDE / 2, y = i / SIDE - SIDE / 2;
        wrong += info.res != (x * x + y * y <= SIDE / 2 * (SIDE / 2));
    }
    printf("%u pixels hit, %u wrong, ", hits, wrong);
    /* A layer: its alpha is the coverage. */
    const lv_area_t at = {LEFT, TOP, LEFT + SIDE - 1, TOP + SIDE - 1};
    lv_layer_t layer = {NULL, NULL, at, at, LV_COLOR_FORMAT_ARGB8888};
    unsigned alphas[3] = {0, 0, 0};
    memset(pixels, 0, sizeof pixels);
    buffer.header.stride = 4 * SIDE;
    send(LV_EVENT_DRAW_MAIN, &layer, NULL);
    const bool is_refused = knob.err == GLINT_ERR_FORMAT;
    knob.layer_paint = &layer_paint;
    wrong = glint_lvgl_knob_set_light(&knob, lights[1]) != GLINT_OK;
    send(LV_EVENT_DRAW_MAIN, &layer, NULL);
    wrong += knob.err != GLINT_OK;
    for (unsigned i = 0; i < SIDE * SIDE; i++)
        alphas[pixels[4 * i + 3] == 0 ? 0 : pixels[4 * i + 3] == 255 ? 2 : 1]++;
    printf("%u wrong in a layer: %u %u %u, without its paint %s\n", wrong, alphas[0], alphas[1], alphas[2],
           is_refused ? "refused" : "drawn");
    if (argc > 1)
        save(argv[1]);
    /* Once LVGL has deleted it, its calls reach nothing. */
    dirty_count = 0;
    send(LV_EVENT_DELETE, NULL, NULL);
    glint_lvgl_knob_set_value(&knob, -700);
    return knob.object || glint_lvgl_knob_get_value(&knob) != -700 || glint_lvgl_knob_set_light(&knob, lights[0]) ||
           dirty_count;
}
