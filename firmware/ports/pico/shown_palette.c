/* SPDX-License-Identifier: MIT
 * A picture as large as an AMOLED panel: a palette of normals, and places in it, in flash. Every normal is shaded exactly. */
#include "shown.h"

#if SHOWS_PALETTE
#include "cksum.h"
#include "demo.h"
#include "demo_palette.h"
#include "hand.h"
#include "orbit.h"
#include "recolour.h"

enum { ENTRIES = sizeof demo_palette / sizeof *demo_palette, LINE_WORDS = (PANEL_WIDTH + 1) / 2 };

/* A host draws into what is ours while we draw nothing; but a line may still be being fetched. */
static union {
    struct shown_gud_memory gud;
    uint16_t bands[2][PANEL_BAND * PANEL_WIDTH];
} memory;
static uint32_t fetched[2][LINE_WORDS];
static uint16_t colours[ENTRIES];

static struct glint_paint paint;
static struct recolour recolour = {.pieces.hal = &board_hal,
                                   .normals = demo_palette,
                                   .entries = ENTRIES,
                                   .places = demo_places,
                                   .paint = &paint,
                                   .colours = colours,
                                   .fetched = {fetched[0], fetched[1]},
                                   .bands = {memory.bands[0], memory.bands[1]}};

const char *const shown_words = "relighting";

struct shown_gud_memory *shown_gud_memory(void)
{
    return &memory.gud;
}

uint16_t *shown_line(void)
{
    return memory.bands[0];
}

bool shown_is_intact(void)
{
    const uint32_t sum = cksum_add(cksum_add(0, (const uint8_t *)demo_palette, sizeof demo_palette),
                                   (const uint8_t *)demo_places, sizeof demo_places);
    return cksum_end(sum, sizeof demo_palette + sizeof demo_places) == DEMO_PALETTE_CKSUM;
}

/* No interface takes lights for a panel of this size (usb_class.h). */
void shown_prepare(struct panel *panel, struct light_device *light)
{
    (void)light;
    recolour.pieces.panel = panel;
}

void shown_next_scene(void)
{
}

static bool is_first; /* the demo's next frame, which must be drawn */

enum glint_err shown_begin_demo(void)
{
    is_first = true;
    return glint_paint_exact(&paint, &demo_gold, &demo_output);
}

enum glint_err shown_begin_light(void)
{
    return GLINT_ERR_ARG;
}

static int32_t shown_to_light[3]; /* of the demo's last frame */

bool shown_next_demo(void)
{
    static uint32_t frame;
    if (!hand_is_there())
        orbit_light(shown_to_light, frame++, ORBIT_FRAMES);
    else if (!hand_light(shown_to_light) && !is_first)
        return false;
    is_first = recolour_frame(&recolour, shown_to_light) != GLINT_OK;
    return !is_first;
}

bool shown_next_light(void)
{
    return false;
}

enum shown_state shown_step(void)
{
    static const enum shown_state of[] = {
        [RECOLOUR_DONE] = SHOWN_DONE, [RECOLOUR_BUSY] = SHOWN_SENDING, [RECOLOUR_BUS_FAILED] = SHOWN_FAILED};
    const enum shown_state state = of[recolour_step(&recolour)];
    return recolour.in_frame && state != SHOWN_FAILED ? SHOWN_DRAWING : state;
}

void shown_abandon(void)
{
    recolour_stop(&recolour);
}
#endif
