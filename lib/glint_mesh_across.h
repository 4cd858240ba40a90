/* SPDX-License-Identifier: MIT
 * Internal. What a triangle's corners have, three numbers each, at the pixels between them: colours and normals. */
#ifndef GLINT_MESH_ACROSS_H
#define GLINT_MESH_ACROSS_H

#include "glint_mesh_clip.h"
#include "glint_mesh_path.h"

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

/* The picture's line of a row that glint_mesh_row_next gave. */
static inline int32_t glint_mesh_row_line(const struct glint_mesh_triangle *triangle)
{
    return triangle->y - 1;
}

#endif
