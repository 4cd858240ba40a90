/* SPDX-License-Identifier: MIT
 * A mesh on a screen, redrawn as LVGL does: only what was invalidated, in strips of a few lines, in two buffers in turn, over a background whose
 * task is still waiting, and in a layer of ARGB8888. Prints what differs from the same mesh drawn in one piece, and what was redrawn. */
#include "glint_lvgl_mesh.h"
#include "lvgl_teapot.h"
#include "lvgl_object.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 200, HEIGHT = 150, SIDE_X = 120, SIDE_Y = 101, LEFT = 37, TOP = 23, BACKGROUND = 0x1f };

static bool has_memory = true, can_dispatch = true;
static unsigned objects;
static uint8_t buffers[2][WIDTH * HEIGHT * 4];
static unsigned turn, dispatches;
static uint16_t shown[HEIGHT][WIDTH];

lv_obj_t *lv_obj_create(lv_obj_t *parent)
{
    return parent == &screen && has_memory && objects++ == 0 ? &object : NULL;
}
void *lv_draw_layer_alloc_buf(lv_layer_t *layer)
{
    layer->draw_buf = has_memory ? &buffer : NULL;
    return has_memory ? buffer.data : NULL;
}
bool lv_draw_dispatch_layer(lv_display_t *disp, lv_layer_t *layer)
{
    (void)disp;
    if (++dispatches > 100)
        exit(3); /* it loops */
    if (!can_dispatch)
        return false;
    for (size_t i = 0; layer->draw_task_head && i < sizeof buffers[0] / 2; i++)
        ((uint16_t *)(void *)buffer.data)[i] = BACKGROUND;
    layer->draw_task_head = NULL;
    return true;
}

/* ---- what the test does ---- */

static void redraw(lv_area_t area, int32_t lines)
{
    for (int32_t y = area.y1; y <= area.y2; y += lines) {
        const int32_t bottom = y + lines - 1 < area.y2 ? y + lines - 1 : area.y2, w = area.x2 - area.x1 + 1;
        const lv_area_t strip = {area.x1, y, area.x2, bottom};
        lv_layer_t layer = {NULL, (lv_draw_task_t *)&screen, strip, strip, LV_COLOR_FORMAT_RGB565};
        turn = !turn;
        buffer.data = buffers[turn];
        buffer.header.stride = (uint16_t)(2 * w);
        dispatches = 0;
        send(LV_EVENT_DRAW_MAIN, &layer, NULL);
        lv_draw_dispatch_layer(NULL, &layer);
        for (int32_t row = y; row <= bottom; row++)
            memcpy(&shown[row][area.x1], buffer.data + 2 * w * (row - y), 2 * (size_t)w);
    }
}

/* LVGL joins what is larger apart than together. */
static int32_t redraw_dirty(int32_t lines)
{
    int32_t pixels = 0;
    if (dirty_count == 2) {
        lv_area_t *a = &dirty[0], *b = &dirty[1];
        a->x1 = a->x1 < b->x1 ? a->x1 : b->x1;
        a->y1 = a->y1 < b->y1 ? a->y1 : b->y1;
        a->x2 = a->x2 > b->x2 ? a->x2 : b->x2;
        a->y2 = a->y2 > b->y2 ? a->y2 : b->y2;
        dirty_count = 1;
    }
    for (unsigned i = 0; i < dirty_count; i++) {
        pixels += (dirty[i].x2 - dirty[i].x1 + 1) * (dirty[i].y2 - dirty[i].y1 + 1);
        redraw(dirty[i], lines);
    }
    dirty_count = 0;
    return pixels;
}

static const struct glint_material gold = {
    GLINT_MSH, 0, 60, 0, {5200, 5200, 5200}, {43000, 43000, 43000}, {65536, 62000, 50000}, {230, 168, 66}, false};
static uint32_t memory[40000 / 4], whole_mesh[40000 / 4], whole_frame[100000 / 4];
static uint16_t whole[SIDE_Y][SIDE_X];

static enum glint_err draw_whole(const struct glint_lvgl_mesh *mesh)
{
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    const struct glint_surface surface = {whole, 2 * SIDE_X, 0, 0};
    for (unsigned i = 0; i < SIDE_X * SIDE_Y; i++)
        whole[i / SIDE_X][i % SIDE_X] = BACKGROUND;
    enum glint_err err = glint_mesh_begin(&frame, SIDE_X, SIDE_Y, SIDE_Y, 0, whole_frame, sizeof whole_frame);
    err = err ? err
              : glint_mesh_add(&frame, &drawn, mesh->mesh, &mesh->pose, mesh->paints, whole_mesh, sizeof whole_mesh);
    return err ? err : glint_mesh_strip(&frame, 0, SIDE_Y, &surface);
}

static unsigned wrong_pixels(void)
{
    unsigned wrong = 0;
    for (int32_t y = 0; y < HEIGHT; y++)
        for (int32_t x = 0; x < WIDTH; x++) {
            const int32_t i = x - LEFT, k = y - TOP;
            const uint16_t wanted = i >= 0 && i < SIDE_X && k >= 0 && k < SIDE_Y ? whole[k][i] : BACKGROUND;
            wrong += shown[y][x] != wanted;
        }
    return wrong;
}

/* A click hits where the mesh is drawn, within a pixel of its outline. */
static unsigned wrong_hits(void)
{
    unsigned wrong = 0;
    for (int32_t y = 1; y < SIDE_Y - 1; y++)
        for (int32_t x = 1; x < SIDE_X - 1; x++) {
            const lv_point_t point = {LEFT + x, TOP + y};
            lv_hit_test_info_t info = {&point, false};
            bool all = true, any = false;
            for (int32_t i = 0; i < 9; i++) {
                const bool is_drawn = whole[y + i / 3 - 1][x + i % 3 - 1] != BACKGROUND;
                all &= is_drawn;
                any |= is_drawn;
            }
            send(LV_EVENT_HIT_TEST, NULL, &info);
            wrong += (all && !info.res) || (!any && info.res);
        }
    return wrong;
}

static void turn_to(struct glint_pose *pose, unsigned step)
{
    static const int16_t turns[][4] = {{32767, 0, 0, 0},    {30000, 8000, 9000, 3000}, {100, -90, 20, 80},
                                       {0, 32767, 0, 0},    {-20000, 5, 20000, -9000}, {1, 2, 3, 4},
                                       {23170, 0, 23170, 0}};
    memcpy(pose->turn, turns[step % 7], sizeof pose->turn);
    pose->position[0] = (int16_t)(step * 37 % 400 - 200);
    pose->position[1] = (int16_t)(step * 91 % 300 - 150);
    pose->scale = (uint16_t)(300 + step * 53 % 900);
}

int main(void)
{
    static const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false},
                                     over = {GLINT_ARGB8888, GLINT_GAMMA, false};
    static const int32_t to_light[3] = {-2, 3, 4};
    static struct glint_paint paint, layer_paint;
    static struct glint_lvgl_mesh mesh;
    struct glint_pose pose;
    unsigned wrong = 0, misses = 0;
    int32_t redrawn = 0;
    mesh.mesh = &lvgl_teapot;
    mesh.paints = &paint;
    if (glint_paint_exact(&paint, &gold, &output) || glint_paint_exact(&layer_paint, &gold, &over))
        return 1;
    object.at.x1 = LEFT;
    object.at.y1 = TOP;
    const size_t bytes = glint_lvgl_mesh_bytes(&lvgl_teapot, SIDE_X, SIDE_Y);
    if (bytes > sizeof memory || glint_lvgl_mesh_create(&mesh, &screen, SIDE_X, SIDE_Y, memory, bytes - 1) ||
        mesh.err != GLINT_ERR_ARG || !glint_lvgl_mesh_create(&mesh, &screen, SIDE_X, SIDE_Y, memory, bytes) ||
        object.flags != LV_OBJ_FLAG_ADV_HITTEST || glint_lvgl_mesh_set_light(&mesh, to_light))
        return 1;
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
        shown[i / WIDTH][i % WIDTH] = BACKGROUND;
    static const int32_t lines[] = {10, 16, 1, 7, 150};
    for (unsigned step = 0; step < 50; step++) {
        turn_to(&pose, step);
        if (glint_lvgl_mesh_set_pose(&mesh, &pose))
            return 1;
        redrawn += redraw_dirty(lines[step % 5]);
        if (mesh.err || draw_whole(&mesh))
            return 1;
        wrong += wrong_pixels();
        if (step % 10 == 0)
            misses += wrong_hits();
    }
    /* A part, as where something in front of it moves. */
    const lv_area_t odd = {LEFT + 31, TOP + 17, LEFT + 77, TOP + 60};
    for (int32_t y = odd.y1; y <= odd.y2; y++)
        memset(&shown[y][odd.x1], 0, 2 * (size_t)(odd.x2 - odd.x1 + 1));
    redraw(odd, 11);
    wrong += wrong_pixels();
    /* Another light, then a layer. */
    static const int32_t other_light[3] = {3, 1, 2};
    wrong += glint_lvgl_mesh_set_light(&mesh, other_light) != GLINT_OK;
    redraw_dirty(10);
    wrong += draw_whole(&mesh) != GLINT_OK;
    wrong += wrong_pixels();
    const lv_area_t all = {LEFT, TOP, LEFT + SIDE_X - 1, TOP + SIDE_Y - 1};
    lv_layer_t layer = {NULL, NULL, all, all, LV_COLOR_FORMAT_ARGB8888};
    memset(buffers, 0, sizeof buffers);
    buffer.header.stride = 4 * SIDE_X;
    send(LV_EVENT_DRAW_MAIN, &layer, NULL);
    const bool is_refused = mesh.err == GLINT_ERR_FORMAT;
    glint_lvgl_mesh_set_paint(&mesh, &paint, &layer_paint);
    wrong += glint_lvgl_mesh_set_light(&mesh, other_light) != GLINT_OK;
    send(LV_EVENT_DRAW_MAIN, &layer, NULL);
    wrong += mesh.err != GLINT_OK;
    for (unsigned i = 0; i < SIDE_X * SIDE_Y; i++)
        wrong += (buffer.data[4 * i + 3] == 255) != (whole[i / SIDE_X][i % SIDE_X] != BACKGROUND);
    /* Out of memory: nothing is drawn, and it ends. */
    has_memory = false;
    layer.draw_buf = NULL;
    send(LV_EVENT_DRAW_MAIN, &layer, NULL);
    bool ends = mesh.err == GLINT_ERR_ARG;
    has_memory = true;
    can_dispatch = false;
    layer.draw_task_head = (lv_draw_task_t *)&screen;
    send(LV_EVENT_DRAW_MAIN, &layer, NULL);
    ends &= mesh.err == GLINT_ERR_ARG;
    printf("%u wrong, %u missed, %d %% of the object redrawn, a layer without its paint %s, without memory it %s\n",
           wrong, misses, (int)(redrawn * 100 / (50 * SIDE_X * SIDE_Y)), is_refused ? "refused" : "drawn",
           ends ? "ends" : "goes on");
    /* Once LVGL has deleted it, its calls reach nothing. */
    dirty_count = 0;
    send(LV_EVENT_DELETE, NULL, NULL);
    return mesh.object || glint_lvgl_mesh_set_pose(&mesh, &pose) != GLINT_ERR_ARG ||
           glint_lvgl_mesh_set_light(&mesh, to_light) || dirty_count;
}
