/* SPDX-License-Identifier: MIT
 * What the board draws by itself: a map under a light (shown_map), where it is too large a palette (shown_palette), or a
 * mesh that turns (shown_mesh, DEMO=teapot). */
#ifndef SHOWN_H
#define SHOWN_H

#include "board.h"
#include "gud_device.h"
#include "light_device.h"
#include "usb_class.h"

/* What a host that draws takes; the map, or the mesh's pixels, lie in the same memory. Only one hosts the panel at a time. */
struct shown_gud_memory {
    uint32_t lines[(GUD_DEVICE_LINE_BYTES(PANEL_WIDTH, 2, 2) + 3) / 4];
    uint8_t lz4_window[LZ4_BLOCK_REACH];
};
struct shown_gud_memory *shown_gud_memory(void);

extern const char *const shown_words; /* of the demo, over the UART */
bool shown_is_intact(void);           /* what lies in flash? */
void shown_prepare(struct panel *panel, struct light_device *light);
uint16_t *shown_line(void); /* a line's pixels, while nothing is drawn */

/* What a tap or a shake does: another map; a mesh stands still or turns on. Then the demo begins anew. */
void shown_next_scene(void);
/* The demo; or what a host has sent, as soon as it is complete. */
enum glint_err shown_begin_demo(void);
enum glint_err shown_begin_light(void);
/* Begins the next frame of it; false: there is none yet, or it is invalid, and the last picture stays. */
bool shown_next_demo(void);
bool shown_next_light(void);

/* Some lines at most. */
enum shown_state { SHOWN_FAILED, SHOWN_DRAWING, SHOWN_SENDING, SHOWN_DONE };
enum shown_state shown_step(void);
void shown_abandon(void); /* the frame */

#endif
