/* SPDX-License-Identifier: MIT
 * A mesh that turns. With both cores one draws the lower part, up to the line where they take equally long. */
#include "shown.h"

#if TURNS_MESH
#include "demo.h"
#include "demo_mesh_sizes.h"
#include "hand.h"
#include "held_mesh.h"
#include "turntable.h"

enum {
    STRIPS = SECOND_CORE ? PANEL_HEIGHT / TURNTABLE_LINES : 2,
    LOWER_Y = SECOND_CORE ? 112 : PANEL_HEIGHT,
    /* As glint_mesh_bytes and glint_mesh_frame_bytes count, which turntable_start compares it with. There are places for 56 triangles
     * that go on, and for more in a larger mesh. */
    BANDS = (PANEL_HEIGHT + TURNTABLE_LINES - 1) / TURNTABLE_LINES,
    CORE_BYTES = (16 * DEMO_MESH_VERTICES + 2 * (DEMO_MESH_FACES + BANDS) + 2 * PANEL_WIDTH * TURNTABLE_LINES +
                  (56 + DEMO_MESH_FACES / 128) * (int)GLINT_MESH_KEPT_BYTES + 3) /
                 4 * 4
};

/* What a core writes next to what a host may fill already: pixels only, so that nothing but a picture that nobody will see is spoilt. */
static union {
    struct shown_gud_memory gud;
    uint32_t strips[STRIPS * PANEL_WIDTH * TURNTABLE_LINES / 2];
} memory;
static uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4], work[1 + SECOND_CORE][CORE_BYTES / 4];

static struct light_device *lights;
static struct glint_paint paint;
static struct turntable turntable = {.pieces.hal = &board_hal,
                                     .mesh = &held_mesh,
                                     .paint = &paint,
                                     .memory_bytes = CORE_BYTES,
                                     .strips = memory.strips,
                                     .strip_count = STRIPS,
                                     .lower_y = LOWER_Y,
#if SECOND_CORE
                                     .core[1].memory = work[1],
#endif
                                     .core[0].memory = work[0]};

const char *const shown_words = "turning a mesh";

struct shown_gud_memory *shown_gud_memory(void)
{
    return &memory.gud;
}

uint16_t *shown_line(void)
{
    return (uint16_t *)memory.strips;
}

bool shown_is_intact(void)
{
    return held_mesh_is_intact();
}

void shown_prepare(struct panel *panel, struct light_device *light)
{
    turntable.pieces.panel = panel;
    light->mesh = &held_mesh_identity;
    lights = light;
}

static enum glint_err begin(const struct glint_material *material, const struct glint_output *output,
                            uint16_t background)
{
    turntable.background = background;
    const enum glint_err error = turntable_start(&turntable);
    return error ? error : glint_paint_tables(&paint, GLINT_TABLES_COLOUR, material, output, tables, sizeof tables);
}

enum glint_err shown_begin_demo(void)
{
    return begin(&demo_gold, &demo_output, 0);
}

enum glint_err shown_begin_light(void)
{
    struct glint_output output;
    light_material_output(&output, &lights->material);
    return begin(&lights->material.material, &output, lights->material.background);
}

static bool stands;

void shown_next_scene(void)
{
    stands = !stands;
}

bool shown_next_demo(void)
{
    static uint32_t frame;
    struct glint_pose pose;
    int32_t to_light[3];
    const int32_t *light = demo_mesh_light;
    demo_pose(&pose, frame, PANEL_WIDTH);
    frame += !stands;
    if (lights->is_given) {
        light = lights->given;
    } else if (hand_is_there()) {
        (void)hand_light(to_light);
        light = to_light;
    }
    return turntable_frame(&turntable, &pose, light) == GLINT_OK;
}

bool shown_next_light(void)
{
    struct light_pose next;
    if (!light_device_next_pose(lights, &next))
        return false;
    const int32_t to_light[3] = {next.to_light[0], next.to_light[1], next.to_light[2]};
    return turntable_frame(&turntable, &next.pose, to_light) == GLINT_OK;
}

enum shown_state shown_step(void)
{
    static const enum shown_state of[] = {
        [TURNTABLE_DONE] = SHOWN_DONE, [TURNTABLE_BUSY] = SHOWN_SENDING, [TURNTABLE_BUS_FAILED] = SHOWN_FAILED};
    const enum shown_state state = of[turntable_step(&turntable)];
    return turntable.in_frame && state != SHOWN_FAILED ? SHOWN_DRAWING : state;
}

void shown_abandon(void)
{
    turntable_stop(&turntable);
}
#endif
