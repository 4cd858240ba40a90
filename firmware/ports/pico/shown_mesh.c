/* SPDX-License-Identifier: MIT
 * A mesh that turns. With both cores one draws the lower part, up to the line where they take equally long. */
#include "shown.h"

#if TURNS_MESH
#include "demo.h"
#include "demo_mesh_sizes.h"
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
static struct turntable turntable = {.pieces.hal = &board_hal,
                                     .mesh = &held_mesh,
                                     .tables_memory = tables,
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

enum glint_err shown_begin_demo(void)
{
    struct glint_shader shader;
    demo_shader(&shader);
    turntable.background = 0;
    return turntable_start(&turntable, &shader);
}

enum glint_err shown_begin_light(void)
{
    struct glint_shader shader;
    light_device_shader(lights, &shader);
    turntable.background = lights->material.background;
    return turntable_start(&turntable, &shader);
}

static bool begin_frame(const struct glint_pose *pose, const int32_t to_light[3])
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    struct glint_light light;
    return glint_light_init(&light, to_light, to_viewer) == GLINT_OK &&
           turntable_frame(&turntable, pose, &light) == GLINT_OK;
}

bool shown_next_demo(void)
{
    static uint32_t frame;
    struct glint_pose pose;
    demo_pose(&pose, frame++, PANEL_WIDTH);
    return begin_frame(&pose, demo_mesh_light);
}

bool shown_next_light(void)
{
    struct light_pose next;
    if (!light_device_next_pose(lights, &next))
        return false;
    const int32_t to_light[3] = {next.to_light[0], next.to_light[1], next.to_light[2]};
    return begin_frame(&next.pose, to_light);
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
