/* SPDX-License-Identifier: MIT
 *
 * The display loop of a picture too large for a map: few normals, a palette, are coloured once a frame, and each pixel is a place in it. The
 * places stay in flash: a line of them is fetched while the line before it is drawn, and a band is sent while the next one is drawn. */
#ifndef RECOLOUR_H
#define RECOLOUR_H

#include "glint.h"
#include "pieces.h"

struct recolour {
    /* Config, set by you. Memory is yours. */
    struct pieces pieces;            /* its hal and panel, whose windows are even */
    const struct glint_vec *normals; /* the palette; the first is no surface */
    uint16_t entries;
    const uint32_t
        *places;         /* of each pixel that can be seen, line by line, 2 bytes each as glint_draw_palette has them */
    uint16_t background; /* the pixel where there is no surface */
    struct glint_paint *paint; /* of RGB565, undithered; each frame lights it */
    uint16_t *colours;         /* `entries` */
    uint32_t *fetched[2];      /* a line of places each */
    uint16_t *bands[2];        /* PANEL_BAND lines each */

    /* State, ours; zeros at first. */
    const uint32_t *next;         /* places that are to be fetched */
    struct panel_columns seen[2]; /* of the line that is in `fetched`, or on its way */
    uint32_t sent[2];             /* of each band's memory, as pieces_add says */
    uint16_t line;                /* that is to be drawn */
    bool in_frame;
};

/* Lights the paint, colours the palette and begins a frame after the one before is done. Errors as relight_frame. */
enum glint_err recolour_frame(struct recolour *recolour, const int32_t to_light[3]);
/* Ends the frame and waits until nothing is sent any more; a line may still be being fetched. */
void recolour_stop(struct recolour *recolour);

enum recolour_step { RECOLOUR_DONE, RECOLOUR_BUSY, RECOLOUR_BUS_FAILED };
/* A line at most, without waiting. DONE: all is sent. */
enum recolour_step recolour_step(struct recolour *recolour);

#endif
