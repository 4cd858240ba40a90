/* SPDX-License-Identifier: MIT
 * Internal. Smooth outlines: which edges of a mesh are outlines, and those that a strip meets. */
#ifndef GLINT_MESH_EDGES_H
#define GLINT_MESH_EDGES_H

#include "glint_mesh_strip.h"
#include "glint_port.h"

/* Of a face. */
enum {
    GLINT_EDGES = 7,                             /* bit k: its edge from corner k on is an outline */
    GLINT_EDGES_BESIDE = 8,                      /* a neighbour has an outline */
    GLINT_EDGES_FRONT = GLINT_EDGES_IS_FRONT,    /* it shows its front */
    GLINT_EDGES_THIN = GLINT_EDGES_NONE,         /* but so narrow that it counts as back, and is not drawn */
    GLINT_EDGES_CLIPPED = GLINT_EDGES_IS_CLIPPED /* one edge at most, between corners that are in, may be an outline */
};
#define GLINT_EDGES_LISTED 128 /* rims has the number of its first edge in the strip, and not its link */

/* Pixels of the picture. */
struct glint_mesh_window {
    int32_t left, top, right, bottom;
};

/* An outline in a strip. It is walked along its longer axis, a line or, where it is flatter, a column a step; the pixel that it cuts there is a
 * cell. */
struct glint_mesh_rim {
    int32_t e, step; /* at `at`: its column or, of a flat one, line of the strip, Q16; |step| <= 2^16 + 1 */
    uint16_t *depth; /* there, of column or line 0 */
    int16_t at, end; /* the picture's lines or columns whose cells lie in the strip */
    uint8_t is, corner;
    uint16_t face;    /* it begins at this corner of its face */
    uint32_t inverse; /* of its length along, as triangles have it; in the upper 8 bits by how much that is shifted */
};
enum {
    GLINT_RIM_FLAT = 1,
    GLINT_RIM_GROWS = 2,  /* the inside is right of it or below */
    GLINT_RIM_TURNED = 4, /* it ascends from its second corner */
    GLINT_RIM_MORE = 8,   /* the next one is of the same face */
    GLINT_RIM_ENDS = 16   /* no cell of it lies below the strip; of a face's first one: of none */
};

typedef char glint_mesh_edges_ask[(GLINT_EDGES | GLINT_EDGES_BESIDE | GLINT_EDGES_THIN) == GLINT_EDGES_ASK ? 1 : -1];

/* Where an outline's cell is, and what changes from cell to cell; and its face's other outlines. */
struct glint_mesh_cells {
    const struct glint_mesh_target *strip;
    const struct glint_paint *paint; /* of faces before `end` */
    uint32_t t_end, end;
    uint16_t part;
    bool is_colour;
    uint8_t others;
    struct glint_mesh_rim *rim, other[2];
    struct glint_mesh_cell cell;
    struct glint_mesh_blending blending; /* of glint_mesh_blend_cells */
};

/* An outline's cells by COLOUR tables, where nothing shines. Steps along it and across are in bytes. Has a twin in assembly. */
struct glint_mesh_blend {
    uint32_t is_swapped, nl, across, step, dz, dnl, along;
    const uint16_t *end; /* of depth */
    uintptr_t off;       /* what a pixel is beyond its depth */
    const uint8_t *colours;
    uint32_t dark, grows;
    uint32_t z;
    const uint16_t *depth;
    uint32_t e;
};
void glint_mesh_blend_matt(const struct glint_mesh_blend *blend);

#if GLINT_CORTEX_M0PLUS_ASM
/* In assembly: hides the cells that a face leaves out; false: not all outlines are kept, or there is no room for all. */
bool glint_mesh_hide_face(const struct glint_mesh_target *strip, unsigned face);

typedef char glint_outlines_layout[sizeof(struct glint_mesh_rim) == GLINT_MESH_RIM_BYTES &&
                                           offsetof(struct glint_mesh_rim, e) == 0 &&
                                           offsetof(struct glint_mesh_rim, step) == 4 &&
                                           offsetof(struct glint_mesh_rim, depth) == 8 &&
                                           offsetof(struct glint_mesh_rim, at) == GLINT_AT_RIM_AT &&
                                           offsetof(struct glint_mesh_rim, end) == GLINT_AT_RIM_AT + 2 &&
                                           offsetof(struct glint_mesh_rim, is) == GLINT_AT_RIM_IS &&
                                           offsetof(struct glint_mesh_rim, corner) == GLINT_AT_RIM_IS + 1 &&
                                           offsetof(struct glint_mesh_rim, face) == GLINT_AT_RIM_IS + 2 &&
                                           offsetof(struct glint_mesh_rim, inverse) == GLINT_MESH_RIM_BYTES - 4
                                       ? 1
                                       : -1];
typedef char glint_edges_bits[GLINT_EDGES == 7 && GLINT_EDGES_BESIDE == 8 && GLINT_EDGES_LISTED == 128 &&
                                      GLINT_RIM_FLAT == 1 && GLINT_RIM_GROWS == 2 && GLINT_RIM_TURNED == 4 &&
                                      GLINT_RIM_MORE == 8 && GLINT_RIM_ENDS == 16
                                  ? 1
                                  : -1];
typedef char glint_window_layout[offsetof(struct glint_mesh_window, left) == 0 &&
                                         offsetof(struct glint_mesh_window, top) == 4 &&
                                         offsetof(struct glint_mesh_window, right) == 8 &&
                                         offsetof(struct glint_mesh_window, bottom) == 12
                                     ? 1
                                     : -1];
#define BLEND_AT(field, word) (offsetof(struct glint_mesh_blend, field) == 4 * (word))
typedef char glint_blend_layout[BLEND_AT(is_swapped, 0) && BLEND_AT(nl, 1) && BLEND_AT(across, 2) &&
                                        BLEND_AT(step, 3) && BLEND_AT(dz, 4) && BLEND_AT(dnl, 5) &&
                                        BLEND_AT(along, 6) && BLEND_AT(end, 7) && BLEND_AT(off, 8) &&
                                        BLEND_AT(colours, 9) && BLEND_AT(dark, 10) && BLEND_AT(grows, 11) &&
                                        BLEND_AT(z, 12) && BLEND_AT(depth, 13) && BLEND_AT(e, 14)
                                    ? 1
                                    : -1];
#undef BLEND_AT
#endif

/* A pixel that the face at hand leaves out, and its depth. */
struct glint_mesh_hidden {
    uint16_t *at;
    uint32_t depth;
};

/* Of a mesh and the strip at hand. */
struct glint_mesh_outlines {
    struct glint_mesh_rim
        rims[GLINT_MESH_RIMS + 3]; /* by face and corner; behind them those of a face that are not kept */
    uint16_t count;
    uint16_t later, rest; /* faces: without cells here, but maybe in the next strip; whose outlines are not kept */
    uint16_t hidden;
    union {
        struct glint_mesh_hidden depths[GLINT_MESH_HIDDEN];
        struct glint_mesh_cells cells;
    } of;
    struct glint_mesh_kept piece; /* of a face of more cells */
    struct glint_mesh_row row;    /* of it */
};

#if GLINT_CORTEX_M0PLUS_ASM
typedef char glint_outlines_at[offsetof(struct glint_mesh_outlines, rest) == GLINT_AT_OUTLINES_REST &&
                                       offsetof(struct glint_mesh_outlines, hidden) == GLINT_AT_OUTLINES_REST + 2 &&
                                       offsetof(struct glint_mesh_outlines, of) == GLINT_AT_OUTLINES_DEPTHS &&
                                       offsetof(struct glint_mesh_outlines, rims) == 0 &&
                                       offsetof(struct glint_mesh_hidden, at) == 0 &&
                                       offsetof(struct glint_mesh_hidden, depth) == 4 &&
                                       sizeof(struct glint_mesh_hidden) == 8 &&
                                       offsetof(struct glint_mesh_drawn, outlines) == GLINT_AT_DRAWN_OUTLINES &&
                                       offsetof(struct glint_mesh_drawn, rims) == GLINT_AT_DRAWN_OUTLINES + 4 &&
                                       offsetof(struct glint_mesh, neighbours) == GLINT_AT_MESH_NEIGHBOURS
                                   ? 1
                                   : -1];
#endif

static inline const struct glint_mesh_vertex *glint_mesh_corner_at(const struct glint_mesh_drawn *drawn, unsigned face,
                                                                   unsigned corner)
{
    return &drawn->vertices[drawn->mesh->faces[3 * (size_t)face + corner]];
}

static inline unsigned glint_mesh_corner_after(unsigned corner)
{
    return corner == 2 ? 0 : corner + 1;
}

/* Marks the mesh's faces, and sorts it. */
void glint_mesh_edges_add(const struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn);
/* Sorts faces with outlines as glint_mesh_sort does all. */
void glint_mesh_edges_sort(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y);

/* Sets up a strip's outlines, and gives those that go on to the next. */
void glint_mesh_rims_take(const struct glint_mesh_target *strip);
void glint_mesh_rims_give(const struct glint_mesh_target *strip);
/* The first outline in the strip of a face that is not listed; NULL: it has none. */
struct glint_mesh_rim *glint_mesh_rims_of(const struct glint_mesh_target *strip, unsigned face);
/* The next one. */
static inline struct glint_mesh_rim *glint_mesh_rim_after(struct glint_mesh_rim *rim)
{
    return rim->is & GLINT_RIM_MORE ? rim + 1 : NULL;
}
/* All but its depth; its lines are the picture's, too. false: it has no cell in the window; of it only `is` is to be read then. Has a twin in
 * assembly. */
bool glint_mesh_rim_set(struct glint_mesh_rim *rim, const struct glint_mesh_drawn *drawn, unsigned face,
                        unsigned corner, const struct glint_mesh_window *window);

/* How much of the cell at e is inside, of 255. */
static inline unsigned glint_mesh_rim_part(const struct glint_mesh_rim *rim, int32_t e)
{
    return ((unsigned)e >> 8 ^ (rim->is & GLINT_RIM_GROWS ? 255u : 0u)) & 255;
}

#endif
