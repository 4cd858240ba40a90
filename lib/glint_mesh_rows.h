/* SPDX-License-Identifier: MIT
 * Internal. What lines of a triangle become pixels by, and what its corners have, three numbers each, at the pixels between them: colours and normals. */
#ifndef GLINT_MESH_ROWS_H
#define GLINT_MESH_ROWS_H

#include "glint_lights.h"
#include "glint_mesh_triangle.h"
#include "glint_mesh_pose.h"

/* A strip, lines y..end - 1 of the picture. */
struct glint_mesh_target {
    const struct glint_surface *surface;
    uint16_t *depth; /* of its pixels: a smaller one is nearer and stays */
    int32_t w, y, end;
    struct glint_sample *samples; /* GLINT_MESH_RUN of them, to work with */
    struct glint_mesh_frame *frame;
    struct glint_mesh_drawn *drawn; /* the mesh at hand */
    /* glint_mesh_rows, or what draws with outlines. */
    void (*rows)(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                 const struct glint_mesh_target *target);
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

/* From this t on nothing of a paint shines. */
uint32_t glint_mesh_t_end(const struct glint_paint *paint);

static inline bool glint_mesh_has_grain(const struct glint_paint *paint)
{
    return glint_paint_is_exact(paint) && glint_material_across(&paint->material) != 0;
}
/* Are normals interpolated, and not t? */
bool glint_mesh_is_lit(const struct glint_paint *paint);
/* Before a strip: it has no paint's lights at hand, as paints may have been lit again. Its memory is the frame's. */
void glint_mesh_lit_begin(void *memory);

/* Draws a triangle's lines from the first in the strip up to where the triangle or the strip ends; it then stands there, but one
 * by ALBEDO tables for which there was no place, which the next strip skips on in. The triangle is that of a struct glint_mesh_kept,
 * which knows its face. */
void glint_mesh_rows(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                     const struct glint_mesh_target *target);

/* A pixel that an outline's edge cuts: its values, as in a triangle, and their steps along the edge; its column and the strip's line, and
 * how much of it is inside, of 255. */
struct glint_mesh_cell {
    uint32_t z, dz, nl, dnl, t, dt, ddt;
    int32_t x, line;
    uint8_t part;
};
/* Two bytes a pixel at even places, by COLOUR tables without dither: then the fused loop can draw. */
bool glint_mesh_is_colour(const struct glint_paint *paint, const struct glint_mesh_target *target);
/* The same by ALBEDO tables; its loops are glint_mesh_texture.h's. */
bool glint_mesh_is_albedo(const struct glint_paint *paint, const struct glint_mesh_target *target);
void glint_mesh_colour(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                       const struct glint_mesh_target *target);
/* In assembly alone: its routine, and what that needs of a strip; the latter by itself, in C. */
void glint_mesh_colour_begin(const struct glint_tables *tables, const struct glint_mesh_target *target,
                             struct glint_mesh_lines *lines);
/* What lines by any tables need, and by COLOUR tables. */
void glint_mesh_lines_set(const struct glint_mesh_target *target, struct glint_mesh_lines *lines);
void glint_mesh_colour_set(const struct glint_tables *tables, const struct glint_mesh_target *target,
                           struct glint_mesh_lines *lines);

/* Pixels run.x..end - 1 of a line, with the values at run.x and their steps. */
struct glint_mesh_row {
    struct glint_run run;
    uint16_t *depth; /* of the line */
    uint32_t end, z, dz;
    struct glint_span at; /* its w is not used */
};

/* Draws a line of a triangle of which a piece is left; whole: the columns from its first one on, and the one after its last. It works with
 * row, which would take stack. */
void glint_mesh_piece(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                      const struct glint_mesh_target *target, struct glint_mesh_row *row, const int32_t whole[2]);

/* The cells of an edge in the strip that are in front, one after the other; false: there is none left. */
struct glint_mesh_cells;
typedef bool glint_mesh_next(struct glint_mesh_cells *cells, struct glint_mesh_cell *cell);
/* What they are blended by, in the frame's memory, as it would take stack. */
struct glint_mesh_blending {
    struct glint_mesh_row row;
    struct glint_mesh_cell cell;
};
/* Blends them by any paint; triangle: of a struct glint_mesh_kept, of which the face's number counts. */
void glint_mesh_blend_cells(const struct glint_paint *paint, struct glint_mesh_cells *cells, glint_mesh_next *next,
                            struct glint_mesh_blending *blending, struct glint_mesh_triangle *triangle,
                            const struct glint_mesh_target *target);

/* What a triangle's corners have, three numbers each, at the pixels between them: colours and normals. */

/* A triangle at hand: a face, or of one that is clipped a triangle of its fan. */
struct glint_mesh_corners {
    const struct glint_mesh_vertex *at[3];
    const struct glint_mesh_clipped *clipped[3]; /* NULL: not clipped */
};
void glint_mesh_corners_of(struct glint_mesh_corners *corners, const struct glint_mesh_target *target, unsigned face);

/* What the face's corners have becomes what the triangle's have, where these were clipped. */
void glint_mesh_corners_weigh(const struct glint_mesh_corners *corners, int16_t of[3][3]);

/* One of the three numbers at a pixel and its steps, 14 fraction bits, modulo 2^32. */
struct glint_mesh_slope {
    uint32_t at, x, y;
    int16_t least, most; /* of the corners: between these it is held */
};
struct glint_mesh_across {
    struct glint_mesh_slope of[3];
    int32_t x, y; /* the pixel */
};
/* A triangle that shows its front. */
void glint_mesh_across_set(struct glint_mesh_across *across, const struct glint_mesh_corners *corners,
                           int16_t of[3][3]);

/* At a pixel of the picture. */
static inline void glint_mesh_across_at(const struct glint_mesh_across *across, int32_t x, int32_t y, uint32_t now[3])
{
    for (int k = 0; k < 3; k++)
        now[k] = across->of[k].at + (uint32_t)(x - across->x) * across->of[k].x +
                 (uint32_t)(y - across->y) * across->of[k].y;
}

/* A number as it is at a pixel, and on to the one right of it. Of a sliver it may be any word: so the sum is modulo 2^32, too. */
static inline int16_t glint_mesh_across_next(const struct glint_mesh_slope *slope, uint32_t *now)
{
    const int32_t nearest = (int32_t)(*now + (1 << 13)) >> 14;
    *now += slope->x;
    return (int16_t)(nearest < slope->least ? slope->least : nearest > slope->most ? slope->most : nearest);
}

#endif
