/* SPDX-License-Identifier: MIT
 *
 * The display loop of a mesh: draws it on a panel in strips of lines, each while those before it are sent. With two cores the other
 * one draws the lower part of the picture meanwhile. */
#ifndef TURNTABLE_H
#define TURNTABLE_H

#include "glint_mesh.h"
#include "pieces.h"

enum { TURNTABLE_LINES = 16, TURNTABLE_STRIPS_MAX = (PANEL_ROWS + TURNTABLE_LINES - 1) / TURNTABLE_LINES };

/* What a core draws with. */
struct turntable_core {
    uint32_t *memory; /* yours: TURNTABLE_CORE_BYTES at least; more of it spares work */
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
};

struct turntable {
    /* Config, set by you. Memory is yours. */
    struct pieces pieces;          /* its hal and panel */
    const struct glint_mesh *mesh; /* of one part */
    struct glint_paint *paint;     /* of RGB565; each frame lights it. Between frames it may become another */
    uint32_t memory_bytes;         /* of each core's */
    uint32_t *strips;              /* TURNTABLE_LINES lines each, used in turn */
    uint8_t strip_count;           /* 2 at least; with two cores as many as the picture has */
    uint16_t lower_y; /* where the lower part begins, a multiple of TURNTABLE_LINES; with one core the panel's height */
    uint16_t background; /* the pixel where there is no surface */
    struct turntable_core core[2];

    /* State, ours; zeros at first. */
    struct glint_pose pose;
    uint32_t sent[TURNTABLE_STRIPS_MAX]; /* of each strip's memory, as pieces_add says */
    uint8_t strip;                       /* the next one's */
    uint16_t line;                       /* its first line */
    bool in_frame, is_begun, is_forked;
};

/* Checks the mesh. GLINT_ERR_ARG: as glint_mesh_check, several parts, too little memory, no strips. */
enum glint_err turntable_start(struct turntable *turntable);
/* Lights the paint and begins a frame after the one before is done. GLINT_ERR_VECTOR: a quaternion of 0, or the light is invalid;
 * GLINT_ERR_ARG: a paint of zeros; GLINT_ERR_FORMAT: one that is not of RGB565. Nothing is begun then. */
enum glint_err turntable_frame(struct turntable *turntable, const struct glint_pose *pose, const int32_t to_light[3]);
/* Ends the frame and waits until nothing is drawn or sent any more. */
void turntable_stop(struct turntable *turntable);

enum turntable_step { TURNTABLE_DONE, TURNTABLE_BUSY, TURNTABLE_BUS_FAILED };
/* A strip at most. DONE: all is sent. */
enum turntable_step turntable_step(struct turntable *turntable);

#endif
