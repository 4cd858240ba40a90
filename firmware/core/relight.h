/* SPDX-License-Identifier: MIT
 *
 * The display loop: relights a baked normal map on a panel. A line is shaded while the one before it is sent and the one
 * after it is fetched from flash. */
#ifndef RELIGHT_H
#define RELIGHT_H

#include "glint.h"
#include "hal.h"

/* The part of a line that has a surface and can be seen; of a map with coverage also the longest part that is covered wholly, which is drawn faster. */
struct relight_extent {
    uint16_t first, count, solid, solid_count;
};

struct relight {
    /* Config, set by you. Memory is yours. */
    const struct hal *hal;
    const struct panel *panel;
    const uint32_t *map;            /* GLINT_NORMALS_INT8, as large as the panel */
    const uint8_t *coverage;        /* of each pixel of the map, lines without gaps; NULL: 255 */
    uint16_t background;            /* the pixel where there is no surface, and behind soft edges */
    struct glint_paint *paint;      /* of RGB565; each frame lights it. Between frames it may become another */
    uint16_t *pixels[2];            /* a line each */
    uint32_t *normals[2];           /* a line each; NULL: the map is in RAM */
    struct relight_extent *extents; /* one a line of the panel */

    /* State, ours; zeros at first. */
    struct glint_maps
        maps[2];   /* of a line's left part and its right one: here, as they would cost cycles a line and stack */
    bool has_gaps; /* pixels without a surface that can be seen */
    struct panel_columns seen;   /* of that line's band, which are sent */
    uint16_t line;               /* that is to be shaded or sent */
    uint8_t buffer;              /* 0 or 1: that line's; they take turns */
    bool in_frame;               /* between relight_frame and the frame's last line */
    volatile uint8_t is_sending; /* yes or no: a line is on its way; as in gud_panel.h no bool */
    volatile uint8_t is_waiting; /* nor here: another is shaded, to follow at once */
    const uint16_t *volatile waiting;
    volatile uint16_t waiting_count;
};

/* Of a map: finds its extents, after the lines of the picture before are sent. */
void relight_start(struct relight *relight);
/* Begins a frame after the one before is done. GLINT_ERR_VECTOR: the light is invalid; the one before stays. GLINT_ERR_ARG: a paint of
 * zeros. GLINT_ERR_FORMAT: one that is not of RGB565. */
enum glint_err relight_frame(struct relight *relight, const int32_t to_light[3]);

enum relight_step { RELIGHT_DONE, RELIGHT_BUSY, RELIGHT_BUS_FAILED };
/* A line at most, without waiting. DONE: all lines of the frame are sent, or no frame was begun. */
enum relight_step relight_step(struct relight *relight);

#endif
