/* SPDX-License-Identifier: MIT
 * Internal. Lines of a source as runs of pixels that are drawn, and the highlight's box. */
#ifndef GLINT_DRAW_H
#define GLINT_DRAW_H

#include "glint_pixel.h"

/* The smallest box that holds what has been added, lines from the top; x and y < 65535. */
struct glint_bounds {
    uint16_t left, right, top, bottom; /* empty: left > right */
};
static inline void glint_bounds_begin(struct glint_bounds *b) /* by fields: no call of memset */
{
    b->left = b->top = UINT16_MAX;
    b->right = b->bottom = 0;
}
void glint_bounds_add(struct glint_bounds *b, uint32_t x, uint32_t y);
void glint_bounds_box(const struct glint_bounds *b, struct glint_box *box); /* box may be NULL */

/* The lines of a source, and how far they are drawn. */
struct glint_lines {
    /* Set once, by the function that draws: */
    const struct glint_maps *maps; /* NULL: none */
    const struct glint_surface *target;
    const struct glint_use_coverage *soft; /* NULL: there is no coverage */
    glint_draw_lines *draw;
    void (*source)(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at,
                   struct glint_sample *samples); /* the next run's samples: what an exact paint's are */
    const struct glint_paint *paint;
    uint32_t w;
    uint16_t most; /* pixels in a run; where it is of samples, up to GLINT_RUN */
    bool has_gaps; /* runs end where there is no surface; for tables samples say so */
    /* Set for each run: */
    struct glint_run run; /* the one at hand */
    uint16_t count;       /* its pixels */
    int16_t grain[2];     /* which way it runs, where that is the same everywhere: set by grain alone */
    const uint8_t *normals, *albedo, *gloss; /* of the line, or NULL */
};

/* Begins line y. */
void glint_lines_set(struct glint_lines *lines, uint32_t y);
/* The next run, of what is drawn side by side; run.x is to stand where the one before ended. false: the line is done. */
bool glint_lines_next(struct glint_lines *lines);
/* The run's normals; those of INT8 unpacked, which takes room for lines->most. */
const struct glint_vec *glint_lines_normals(const struct glint_lines *lines, struct glint_vec *unpacked);

/* The run's samples of a span, over what is not drawn, too: at->w is how many pixels are left from *at on. */
void glint_lines_walk(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at,
                      struct glint_sample *samples);

#endif
