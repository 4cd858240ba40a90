/* SPDX-License-Identifier: MIT
 * A baked normal map, relit. */
#include "shown.h"

#if !TURNS_MESH && !SHOWS_PALETTE
#include "cksum.h"
#include "demo.h"
#if SCENES
#include "demo_scenes.h"
#include "lz4_block.h"
#else
#include "demo_map.h"
#endif
#include "hand.h"
#include "orbit.h"
#include "relight.h"

#include <pico.h>

/* Where a map fills RAM the lines are in a bank of 4 KB, beside the second core's stack of 1 KB; those of a map that is smaller may
 * be too many for it. */
#if OFFERS_LIGHT && PANEL_WIDTH * 4 + PANEL_HEIGHT * 8 <= 3072
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

#if SCENES
bool shown_is_intact(void)
{
    uint32_t sum = 0;
    size_t count = 0;
    for (unsigned i = 0; i < DEMO_SCENES; i++) {
        sum = cksum_add(sum, demo_scenes[i].packed, demo_scenes[i].bytes);
        sum = cksum_add(sum, demo_scenes[i].coverage, demo_scenes[i].coverage_bytes);
        count += demo_scenes[i].bytes + demo_scenes[i].coverage_bytes;
    }
    return cksum_end(sum, count) == DEMO_SCENES_CKSUM;
}
#else
bool shown_is_intact(void)
{
    const uint32_t sum = cksum_add(cksum_add(0, demo_map, sizeof demo_map), DEMO_COVERAGE, DEMO_COVERAGE_BYTES);
    return cksum_end(sum, sizeof demo_map + DEMO_COVERAGE_BYTES) == DEMO_MAP_CKSUM;
}
#endif

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

static bool is_first; /* the demo's next frame, which must be drawn */

#if SCENES
static unsigned scene;

void shown_next_scene(void)
{
    scene = scene + 1 < DEMO_SCENES ? scene + 1 : 0;
}

/* Into memory that the lines on their way are not in. */
enum glint_err shown_begin_demo(void)
{
    const struct demo_scene *const shown = &demo_scenes[scene];
    const uint8_t *in = shown->packed, *run;
    struct lz4_block block = {.window = (uint8_t *)memory.host.map, .window_bytes = sizeof memory.host.map};
    is_first = true;
    lz4_block_begin(&block, PANEL_WIDTH * PANEL_HEIGHT * 4);
    while (lz4_block_next(&block, &in, shown->packed + shown->bytes, &run))
        ;
    return begin(memory.host.map, shown->coverage, &demo_gold, &demo_output, 0);
}
#else
void shown_next_scene(void)
{
}

enum glint_err shown_begin_demo(void)
{
    is_first = true;
#if OFFERS_LIGHT /* a map fits into RAM, from where it is faster */
    board_hal.fetch(board_hal.context, memory.host.map, demo_map, PANEL_WIDTH * PANEL_HEIGHT);
    while (!board_hal.fetched(board_hal.context))
        ;
    return begin(memory.host.map, DEMO_COVERAGE, &demo_gold, &demo_output, 0);
#else
    return begin(demo_map, DEMO_COVERAGE, &demo_gold, &demo_output, 0);
#endif
}
#endif

enum glint_err shown_begin_light(void)
{
    struct glint_output output;
    light_material_output(&output, &lights->material);
    return begin(lights->map, NULL, &lights->material.material, &output, lights->material.background);
}

static int32_t shown_to_light[3]; /* of the demo's last frame */

/* A computer's, the hand's or one that circles; false: it has not moved. */
static bool next_light(uint32_t *frame)
{
    static bool was_given;
    bool has_moved = was_given != lights->is_given;
    was_given = lights->is_given;
    for (unsigned k = 0; k < 3 && was_given; k++) {
        has_moved |= shown_to_light[k] != lights->given[k];
        shown_to_light[k] = lights->given[k];
    }
    if (was_given)
        return has_moved;
    if (hand_is_there())
        return hand_light(shown_to_light) || has_moved;
    orbit_light(shown_to_light, (*frame)++, ORBIT_FRAMES);
    return true;
}

/* A still hand has a still picture, which is not sent again. */
bool shown_next_demo(void)
{
    static uint32_t frame;
    if (!next_light(&frame) && !is_first)
        return false;
    is_first = relight_frame(&relight, shown_to_light) != GLINT_OK;
    return !is_first;
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
