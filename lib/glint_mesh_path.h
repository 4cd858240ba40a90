/* SPDX-License-Identifier: MIT
 * Internal. What a line of a triangle becomes pixels by. */
#ifndef GLINT_MESH_PATH_H
#define GLINT_MESH_PATH_H

#include "glint_lobe_near.h"
#include "glint_mesh.h"

/* Pixels x..end - 1 of a line, with the values at x and their steps. */
struct glint_mesh_row {
    uint8_t *line;   /* the surface's */
    uint16_t *depth; /* of the line's pixels: a smaller one is nearer and stays */
    uint32_t x, end;
    uint32_t left, y; /* on the screen, of the line's first pixel */
    uint32_t t, dt, ddt, nl, dnl, z, dz;
    struct glint_sample *samples; /* GLINT_RUN of them, to work with */
};

struct glint_mesh_path {
    bool (*can)(const void *with, const struct glint_surface *surface);
    void (*row)(const void *with, struct glint_mesh_row *row);
};

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
