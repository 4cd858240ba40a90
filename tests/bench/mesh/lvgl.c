/* SPDX-License-Identifier: MIT
 * The teapot as LVGL's object (lib/examples/lvgl, with tests/packages' stand-ins for LVGL), and beside it the same strips with glint's own calls, in
 * the same memory: what the object costs more. */
#include "glint_lvgl_mesh.h"
#include "lvgl_object.h"
#include "lvgl_bench.h"
#include "teapot.h"

enum { WIDTH = 240, HEIGHT = 240 };

/* A strip of LVGL's, RGB565; and how the mesh is painted. */
uint32_t lvgl_out[WIDTH * GLINT_MESH_BAND / 2];
static uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4], memory[9400];
static struct glint_paint paint;

static const struct glint_pose pose = {{30895, 6849, -8278, -1835}, {0, 0, 0}, 2410};

static struct glint_lvgl_mesh widget;
static struct glint_mesh bare;
static struct glint_mesh_frame frame;
static struct glint_mesh_drawn drawn;

lv_obj_t *lv_obj_create(lv_obj_t *parent)
{
    (void)parent;
    return &object;
}

void *lv_draw_layer_alloc_buf(lv_layer_t *layer)
{
    layer->draw_buf = &buffer;
    return buffer.data;
}

bool lv_draw_dispatch_layer(lv_display_t *disp, lv_layer_t *layer)
{
    (void)disp;
    layer->draw_task_head = NULL;
    return true;
}

/* By tables or exactly; not counted. */
int lvgl_begin(unsigned is_exact)
{
    static const struct glint_material clay = {
        GLINT_MSH, 8, 60, 0, {6554, 3932, 2621}, {40632, 22282, 9175}, {52429, 52429, 52429}, {255, 255, 255}, true};
    static const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false};
    static const int32_t to_light[3] = {-4, 6, 8};
    enum glint_err err = is_exact ? glint_paint_exact_for(&paint, &clay, &output, &glint_use_msh, &glint_use_rgb565)
                                  : glint_paint_tables_for(&paint, &glint_use_colour, &clay, &output, tables,
                                                           sizeof tables, &glint_use_msh, &glint_use_rgb565);
    bare = teapot;
    object.count = 0; /* of callbacks */
    widget.mesh = &bare;
    widget.paints = &paint;
    if (!err && !glint_lvgl_mesh_create(&widget, &screen, WIDTH, HEIGHT, memory, sizeof memory))
        err = widget.err;
    return err ? err : glint_lvgl_mesh_set_light(&widget, to_light);
}

/* A new pose, which invalidates; then each strip of `lines` lines, as wide as the screen, is an event. */
int lvgl_frame(void)
{
    dirty_count = 0;
    return glint_lvgl_mesh_set_pose(&widget, &pose);
}

int lvgl_strip(unsigned y, unsigned lines)
{
    const lv_area_t strip = {0, (int32_t)y, WIDTH - 1, (int32_t)(y + lines - 1)};
    lv_layer_t layer = {NULL, (lv_draw_task_t *)&screen, strip, strip, LV_COLOR_FORMAT_RGB565};
    buffer.data = (uint8_t *)lvgl_out;
    buffer.header.stride = 2 * WIDTH;
    send(LV_EVENT_DRAW_MAIN, &layer, NULL);
    return widget.err;
}

int lvgl_bare_frame(void)
{
    const size_t mesh_bytes = (glint_mesh_bytes(&bare, HEIGHT) + 7) & ~(size_t)7;
    const int error = glint_mesh_begin(&frame, WIDTH, HEIGHT, GLINT_MESH_BAND, 0, (char *)memory + mesh_bytes,
                                       sizeof memory - mesh_bytes);
    return error ? error : glint_mesh_add(&frame, &drawn, &bare, &pose, &paint, memory, mesh_bytes);
}

int lvgl_bare_strip(unsigned y, unsigned lines)
{
    const struct glint_surface surface = {lvgl_out, 2 * WIDTH, 0, (uint16_t)y};
    return glint_mesh_strip(&frame, (uint16_t)y, (uint16_t)lines, &surface);
}
