/* SPDX-License-Identifier: MIT
 * Internal. Smooth outlines: which edges of a mesh are outlines, and those that a strip meets. */
#ifndef GLINT_MESH_EDGES_H
#define GLINT_MESH_EDGES_H

#include "glint_mesh_strip.h"

/* Of a face. */
enum {
    GLINT_EDGES = 7,         /* bit k: its edge from corner k on is an outline */
    GLINT_EDGES_BESIDE = 8,  /* a neighbour has an outline */
    GLINT_EDGES_FRONT = 16,  /* it shows its front */
    GLINT_EDGES_THIN = 32,   /* but so narrow that it counts as back, and is not drawn */
    GLINT_EDGES_CLIPPED = 64 /* front or back is not known: there is no outline beside it */
};
#define GLINT_EDGES_LISTED 128 /* rims has the number of its first edge in the strip, and not its link */

/* Pixels of the picture. */
struct glint_mesh_window {
    int32_t left, top, right, bottom;
};

/* An outline in a strip. It is walked along its longer axis, a line or, where it is flatter, a column a step; the pixel that it cuts there is a
 * cell. */
struct glint_mesh_rim {
    int32_t e, step;    /* at `at`: where it is across, Q16; |step| <= 2^16 */
    int16_t at, end;    /* lines or columns whose cells lie in the strip */
    uint32_t inverse;   /* of its length along, as triangles have it, and by how much it is shifted */
    uint8_t up, corner; /* from this corner of its face on */
    uint8_t is;
    uint16_t face;
};
enum {
    GLINT_RIM_FLAT = 1,
    GLINT_RIM_GROWS = 2, /* the inside is right of it or below */
    GLINT_RIM_TURNED = 4 /* it ascends from its second corner */
};

#define GLINT_MESH_RIMS 32   /* kept for a strip; others are set each time they are asked for */
#define GLINT_MESH_HIDDEN 48 /* cells that a face leaves out at a time */

/* Where an outline's cell is, and what changes from cell to cell; and its face's other outlines. */
struct glint_mesh_cells {
    const struct glint_mesh_target *strip;
    struct glint_mesh_rim rim, other[2];
    struct glint_mesh_cell cell;
    unsigned others;
};

/* Of a mesh and the strip at hand. */
struct glint_mesh_outlines {
    struct glint_mesh_rim
        rims[GLINT_MESH_RIMS + 3]; /* by face and corner; behind them those of a face that are not kept */
    uint16_t count;
    uint16_t later, rest; /* faces: without cells here, but maybe in the next strip; whose outlines are not kept */
    uint16_t hidden;
    union {
        struct {
            uint16_t *at;
            uint32_t depth;
        } depths[GLINT_MESH_HIDDEN]; /* of pixels that the face at hand leaves out */
        struct glint_mesh_cells cells;
    } of;
};

static inline const struct glint_mesh_vertex *glint_mesh_corner_at(const struct glint_mesh_drawn *drawn, unsigned face,
                                                                   unsigned corner)
{
    return &drawn->vertices[drawn->mesh->faces[3 * (size_t)face + corner]];
}

static inline unsigned glint_mesh_corner_after(unsigned corner)
{
    return corner == 2 ? 0 : corner + 1;
}

static inline uint32_t glint_mesh_bands(uint16_t h)
{
    return (h + GLINT_MESH_BAND - 1u) / GLINT_MESH_BAND;
}

/* Marks the mesh's faces, and sorts it. */
void glint_mesh_edges_add(const struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn);
/* Sorts faces with outlines as glint_mesh_sort does all. */
void glint_mesh_edges_sort(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y);

/* Sets up a strip's outlines, and gives those that go on to the next. */
void glint_mesh_rims_take(const struct glint_mesh_target *strip);
void glint_mesh_rims_give(const struct glint_mesh_target *strip);
/* A face's first outline in the strip, and how many follow. */
const struct glint_mesh_rim *glint_mesh_rims_of(const struct glint_mesh_target *strip, unsigned face, unsigned *count);
/* false: it has no cell in the window. */
bool glint_mesh_rim_set(struct glint_mesh_rim *rim, const struct glint_mesh_drawn *drawn, unsigned face,
                        unsigned corner, const struct glint_mesh_window *window);

/* How much of the cell at e is inside, of 255. */
static inline unsigned glint_mesh_rim_part(const struct glint_mesh_rim *rim, int32_t e)
{
    return ((unsigned)e >> 8 ^ (rim->is & GLINT_RIM_GROWS ? 255u : 0u)) & 255;
}

#endif
