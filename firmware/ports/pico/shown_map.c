/* SPDX-License-Identifier: MIT
 * A baked normal map, relit. */
#include "shown.h"

#if !TURNS_MESH
#include "cksum.h"
#include "demo.h"
#include "demo_map.h"
#include "orbit.h"
#include "relight.h"

#include <pico.h>

/* Where a map fills RAM the lines are in a bank of 4 KB, beside the second core's stack. */
#if OFFERS_LIGHT
#define LINES_BANK __scratch_x("lines")
#else
#define LINES_BANK
#endif
static struct {
#if !OFFERS_LIGHT
    uint32_t normals[2][PANEL_WIDTH];
#endif
    uint16_t pixels[2][PANEL_WIDTH];
    struct relight_extent extents[PANEL_HEIGHT];
} lines LINES_BANK;
static struct {
#if !EXACT
    uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4];
#endif
    union {
        struct shown_gud_memory gud;
#if OFFERS_LIGHT
        uint32_t map[PANEL_WIDTH * PANEL_HEIGHT];
#else
        uint32_t map[1]; /* no interface fills it */
#endif
    } host;
} memory;

static struct light_device *lights;
static struct glint_paint paint;
static struct relight relight = {.hal = &board_hal,
                                 .paint = &paint,
                                 .pixels = {lines.pixels[0], lines.pixels[1]},
#if !OFFERS_LIGHT /* the map stays in flash */
                                 .normals = {lines.normals[0], lines.normals[1]},
#endif
                                 .extents = lines.extents};

const char *const shown_words = "relighting";

struct shown_gud_memory *shown_gud_memory(void)
{
    return &memory.host.gud;
}

uint16_t *shown_line(void)
{
    return lines.pixels[0];
}

bool shown_is_intact(void)
{
    const uint32_t sum = cksum_add(cksum_add(0, demo_map, sizeof demo_map), DEMO_COVERAGE, DEMO_COVERAGE_BYTES);
    return cksum_end(sum, sizeof demo_map + DEMO_COVERAGE_BYTES) == DEMO_MAP_CKSUM;
}

void shown_prepare(struct panel *panel, struct light_device *light)
{
    relight.panel = panel;
    light->map = memory.host.map;
    lights = light;
}

/* coverage: NULL where all that the map has is drawn wholly. */
static enum glint_err begin(const uint32_t *map, const uint8_t *coverage, const struct glint_material *material,
                            const struct glint_output *output, uint16_t background)
{
    relight.map = map;
    relight.coverage = coverage;
    relight.background = background;
    relight_start(&relight);
#if EXACT
    return glint_paint_exact(&paint, material, output);
#else
    return glint_paint_tables(&paint, GLINT_TABLES_COLOUR, material, output, memory.tables, sizeof memory.tables);
#endif
}

enum glint_err shown_begin_demo(void)
{
#if OFFERS_LIGHT /* a map fits into RAM, from where it is faster */
    board_hal.fetch(board_hal.context, memory.host.map, demo_map, PANEL_WIDTH * PANEL_HEIGHT);
    while (!board_hal.fetched(board_hal.context))
        ;
    return begin(memory.host.map, DEMO_COVERAGE, &demo_gold, &demo_output, 0);
#else
    return begin(demo_map, DEMO_COVERAGE, &demo_gold, &demo_output, 0);
#endif
}

enum glint_err shown_begin_light(void)
{
    struct glint_output output;
    light_material_output(&output, &lights->material);
    return begin(lights->map, NULL, &lights->material.material, &output, lights->material.background);
}

bool shown_next_demo(void)
{
    static uint32_t frame;
    int32_t to_light[3];
    orbit_light(to_light, frame++, ORBIT_FRAMES);
    return relight_frame(&relight, to_light) == GLINT_OK;
}

bool shown_next_light(void)
{
    int32_t to_light[3];
    return light_device_next(lights, to_light) && relight_frame(&relight, to_light) == GLINT_OK;
}

enum shown_state shown_step(void)
{
    if (relight_step(&relight) == RELIGHT_BUS_FAILED)
        return SHOWN_FAILED;
    return relight.in_frame ? SHOWN_DRAWING : relight.is_sending ? SHOWN_SENDING : SHOWN_DONE;
}

void shown_abandon(void)
{
    relight.in_frame = false;
}
#endif
