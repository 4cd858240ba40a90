/* SPDX-License-Identifier: MIT
 *
 * The display loop: relights a baked normal map on a panel. A line is shaded while the one before it is sent and the one
 * after it is fetched from flash. */
#ifndef RELIGHT_H
#define RELIGHT_H

#include "glint.h"
#include "hal.h"

/* The part of a line that has a surface. */
struct relight_extent {
    uint16_t first, count;
};

struct relight {
    /* Config, set by you. Memory is yours. */
    const struct hal *hal;
    const struct panel *panel;
    const uint32_t *map;            /* GLINT_NORMALS_INT8, as large as the panel */
    uint16_t background;            /* the pixel where there is no surface */
    struct glint_prepared *exact;   /* draw by the exact pixel; NULL: by tables */
    void *tables_memory;            /* GLINT_TABLES_COLOUR_BYTES, aligned to 4; not needed by the exact pixel */
    uint16_t *pixels[2];            /* a line each */
    uint32_t *normals[2];           /* a line each; NULL: the map is in RAM */
    struct relight_extent *extents; /* one a line of the panel */

    /* State, ours; zeros at first. */
    struct glint_tables tables;
    struct glint_tables_light light;
    struct glint_light source;
    bool has_gaps;               /* pixels without a surface */
    uint16_t line;               /* that is to be shaded or sent */
    uint8_t buffer;              /* 0 or 1: that line's; they take turns */
    bool in_frame;               /* between relight_frame and the frame's last line */
    volatile uint8_t is_sending; /* yes or no: a line is on its way; as in gud_panel.h no bool */
    volatile bool is_waiting;    /* another is shaded, to follow at once */
    const uint16_t *volatile waiting;
};

/* Fills the tables (2.4 million cycles on a Cortex-M0+) or prepares the shader, and finds the extents. Errors as
 * glint_tables_fill or glint_shade_prepare. */
enum glint_err relight_start(struct relight *relight, const struct glint_shader *shader);
/* Another material for the frames to come; between frames. */
enum glint_err relight_material(struct relight *relight, const struct glint_shader *shader);
/* Begins a frame after the one before is done. GLINT_ERR_VECTOR: the light is invalid; the one before stays. */
enum glint_err relight_frame(struct relight *relight, const int32_t to_light[3]);

enum relight_step { RELIGHT_DONE, RELIGHT_BUSY, RELIGHT_BUS_FAILED };
/* A line at most, without waiting. DONE: all lines of the frame are sent, or no frame was begun. */
enum relight_step relight_step(struct relight *relight);

#endif
