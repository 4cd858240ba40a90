/* SPDX-License-Identifier: MIT
 * Internal. What lines of a triangle become pixels by. */
#ifndef GLINT_MESH_PATH_H
#define GLINT_MESH_PATH_H

#include "glint_math_flash.h"
#include "glint_lobe_near.h"
#include "glint_mesh_edges.h"

/* A strip, lines y..end - 1 of the picture. */
struct glint_mesh_target {
    const struct glint_surface *surface;
    uint16_t *depth; /* of its pixels: a smaller one is nearer and stays */
    int32_t w, y, end;
    struct glint_sample *samples; /* GLINT_RUN of them, to work with */
    struct glint_mesh_frame *frame;
    struct glint_mesh_drawn *drawn; /* the mesh at hand */
};

/* What assembly that draws lines needs of a strip, in the frame where it takes it from; cortex_m0plus_mesh.inc has the rest. */
struct glint_mesh_lines {
    void (*draw)(void);             /* a triangle's lines, called as cortex_m0plus_mesh.inc says */
    uint32_t off_first, line_first; /* of line 0 of the picture: what out is beyond the depths, and these */
    uint32_t off, line;             /* of the line at hand */
    uint32_t line_step, off_step;
    uint32_t last; /* the line after the last one */
    const void *colours;
    uint32_t dark, shift, limit;
    int32_t w, end;
    const void *columns;
    uint32_t t_max;
};

struct glint_mesh_path {
    bool (*can)(const void *with);       /* false: a strip with it is refused */
    uint32_t (*t_end)(const void *with); /* from there on nothing shines */
    /* Draws a triangle's lines from its own, which is in the strip, to the strip's end, and brings it there. The triangle is that of a
     * struct glint_mesh_kept, which knows its face. */
    void (*draw)(const void *with, struct glint_mesh_triangle *triangle, const struct glint_mesh_target *target);
    /* For the assembly of a strip, where lines are drawn in assembly, too: can it draw them there? lines: NULL, or what it needs for that.
     * NULL: it cannot. */
    bool (*begin)(const void *with, const struct glint_mesh_target *target, struct glint_mesh_lines *lines);
};

/* Pixels x..end - 1 of a line, with the values at x and their steps. */
struct glint_mesh_row {
    uint8_t *line; /* the surface's */
    uint16_t *depth;
    uint32_t x, end;
    uint32_t left, y; /* on the screen, of the line's first pixel */
    uint32_t t, dt, ddt, nl, dnl, z, dz;
};

/* The triangle's next row; the triangle goes on to the line after it. false: there is none before the end of it or of the strip. */
bool glint_mesh_row_next(struct glint_mesh_row *row, struct glint_mesh_triangle *triangle,
                         const struct glint_mesh_target *target);

/* The next pixels side by side that are in front, at most `most`: enters their depths and returns how many they are; row stands at the
 * first of them. 0: there is none. */
unsigned glint_mesh_in_front(struct glint_mesh_row *row, unsigned most);

/* t and nl to another pixel. */
static inline void glint_mesh_step(struct glint_mesh_row *row)
{
    row->t += row->dt;
    row->dt += row->ddt;
    row->nl += row->dnl;
}

#endif
