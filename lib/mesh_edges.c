/* SPDX-License-Identifier: MIT
 * Which edges of a mesh are outlines: those between a face that shows its front and one that does not. They are found once a picture, and each
 * strip sets up those that it meets. mesh_cells.c draws them. */
#include "glint_mesh_edges.h"
#include "glint_port.h"

/* ---- Memory: behind the mesh's ---- */

uint32_t glint_mesh_edges_bytes(const struct glint_mesh *mesh, uint16_t h)
{
    return mesh->neighbours
               ? (uint32_t)sizeof(void *) - 2 /* to align */ + (uint32_t)sizeof(struct glint_mesh_outlines) +
                     3u * mesh->face_count + 2 * glint_mesh_bands(h)
               : 0;
}

static void edges_place(const struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn)
{
    uint8_t *memory = (uint8_t *)(drawn->bands + glint_mesh_bands(frame->h));
    while (GLINT_MISALIGNED(memory, pointer))
        memory += 2;
    drawn->outlines = (struct glint_mesh_outlines *)(void *)memory;
    drawn->outlines->count = 0;
    drawn->outlines->later = drawn->outlines->rest = GLINT_MESH_NONE;
    drawn->rims = (uint16_t *)(void *)(drawn->outlines + 1);
    drawn->rim_bands = drawn->rims + drawn->mesh->face_count;
    drawn->edges = (uint8_t *)(drawn->rim_bands + glint_mesh_bands(frame->h));
}

/* ---- Which edges are outlines ---- */

static int32_t edges_span(int32_t a, int32_t b, int32_t c)
{
    const int32_t low = a < b ? a : b, high = a < b ? b : a;
    return (c > high ? c : high) - (c < low ? c : low);
}

/* Narrower than 1/8 pixel, across its longest side along an axis? */
static bool edges_is_thin(const struct glint_mesh_drawn *drawn, const uint16_t face[3])
{
    const struct glint_mesh_vertex *const a = &drawn->vertices[face[0]], *const b = &drawn->vertices[face[1]],
                                          *const c = &drawn->vertices[face[2]];
    const int32_t x = edges_span(a->x, b->x, c->x), y = edges_span(a->y, b->y, c->y);
    return -glint_mesh_area(a, b, c) < 2 * (x > y ? x : y);
}

/* Sorts the mesh, which marks the faces that show their fronts, and those that are clipped. */
static void edges_fronts(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn)
{
    uint8_t *const edges = drawn->edges;
    for (unsigned i = drawn->mesh->face_count; i--;)
        edges[i] = 0;
    glint_mesh_sort(frame, drawn, frame->y);
}

/* A clipped face with an edge that is in shows what the largest triangle of its fan shows. */
static void edges_clipped(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn)
{
    for (unsigned i = 0; i < drawn->mesh->face_count; i++)
        if (drawn->edges[i] & GLINT_EDGES_CLIPPED && glint_mesh_fan_shows(frame, drawn, i))
            drawn->edges[i] |= GLINT_EDGES_FRONT;
}

/* Which of its edges lie on the screen as they are. */
static unsigned edges_in(const struct glint_mesh_drawn *drawn, unsigned face)
{
    unsigned in = GLINT_EDGES;
    if (drawn->edges[face] & GLINT_EDGES_CLIPPED)
        in &= 1u << glint_mesh_edge_in(drawn, face);
    return in;
}

/* A thin face's neighbours have outlines towards it. */
static void edges_round(const struct glint_mesh_drawn *drawn, unsigned face)
{
    const uint16_t *const all = drawn->mesh->neighbours;
    for (unsigned k = 0; k < 3; k++) {
        const unsigned beside = all[3 * (size_t)face + k];
        if (beside >= drawn->mesh->face_count ||
            (drawn->edges[beside] & (GLINT_EDGES_FRONT | GLINT_EDGES_THIN)) != GLINT_EDGES_FRONT)
            continue;
        for (unsigned j = 0; j < 3; j++)
            if (all[3 * (size_t)beside + j] == face)
                drawn->edges[beside] = (uint8_t)(drawn->edges[beside] | (1u << j & edges_in(drawn, beside)));
    }
}

static inline bool edges_ends(const uint8_t *edges, unsigned beside, unsigned count)
{
    return beside < count ? !(edges[beside] & GLINT_EDGES_FRONT) : beside == GLINT_MESH_RIM;
}

static void edges_mark(const struct glint_mesh_drawn *drawn)
{
    const unsigned count = drawn->mesh->face_count;
    uint8_t *const edges = drawn->edges;
    uint16_t thin = GLINT_MESH_NONE; /* a list in rims */
    const uint16_t *beside = drawn->mesh->neighbours;
    for (unsigned i = 0; i < count; i++, beside += 3) {
        if (!(edges[i] & GLINT_EDGES_FRONT))
            continue;
        if (beside[0] < count && beside[1] < count && beside[2] < count &&
            edges[beside[0]] & edges[beside[1]] & edges[beside[2]] & GLINT_EDGES_FRONT)
            continue;
        unsigned found = 0;
        bool has_back = false;
        for (unsigned k = 0; k < 3; k++)
            if (edges_ends(edges, beside[k], count)) {
                found |= 1u << k;
                has_back |= beside[k] < count;
            }
        const bool is_thin =
            has_back && !(edges[i] & GLINT_EDGES_CLIPPED) && edges_is_thin(drawn, drawn->mesh->faces + 3 * (size_t)i);
        edges[i] = (uint8_t)(edges[i] | (is_thin ? (unsigned)GLINT_EDGES_THIN : found & edges_in(drawn, i)));
        if (is_thin) {
            drawn->rims[i] = thin;
            thin = (uint16_t)i;
        }
    }
    for (; thin != GLINT_MESH_NONE; thin = drawn->rims[thin])
        edges_round(drawn, thin);
}

/* The first line that a cell of a face's outlines may lie in: the walk rounds by 1/16. */
static int32_t edges_first(const struct glint_mesh_vertex *vertices, const uint16_t face[3])
{
    const int32_t a = vertices[face[0]].y, b = vertices[face[1]].y, c = vertices[face[2]].y, low = a < b ? a : b;
    return ((c < low ? c : low) - 1) >> 4;
}

void glint_mesh_edges_sort(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y)
{
    /* At hand, since what is written in edges may be anything. */
    const struct glint_mesh_vertex *const vertices = drawn->vertices;
    const uint16_t *const neighbours = drawn->mesh->neighbours, *const faces = drawn->mesh->faces;
    const unsigned count = drawn->mesh->face_count;
    uint8_t *const edges = drawn->edges;
    uint16_t *const bands = drawn->rim_bands, *const rims = drawn->rims;
    for (uint32_t i = 0; i < glint_mesh_bands(frame->h); i++)
        bands[i] = GLINT_MESH_NONE;
    for (unsigned i = count; i--;) {
        if (!(edges[i] & GLINT_EDGES))
            continue;
        const uint16_t *const beside = neighbours + 3 * (size_t)i;
        for (unsigned k = 0; k < 3; k++)
            if (beside[k] < count)
                edges[beside[k]] |= GLINT_EDGES_BESIDE;
        const int32_t low = edges[i] & GLINT_EDGES_CLIPPED ? y : edges_first(vertices, faces + 3 * (size_t)i),
                      first = low > y ? low : y;
        if (first >= frame->h)
            continue;
        uint16_t *band = &bands[(uint32_t)first / GLINT_MESH_BAND];
        rims[i] = *band;
        *band = (uint16_t)i;
    }
}

void glint_mesh_edges_add(const struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn)
{
    edges_place(frame, drawn);
    edges_fronts(frame, drawn);
    if (drawn->is_cut)
        edges_clipped(frame, drawn);
    edges_mark(drawn);
    glint_mesh_edges_sort(frame, drawn, frame->y);
}

/* ---- Those of a strip ---- */

#if !GLINT_CORTEX_M0PLUS_ASM
static int32_t edges_size(int32_t x)
{
    return x < 0 ? -x : x;
}

/* As edges of triangles. */
bool glint_mesh_rim_set(struct glint_mesh_rim *rim, const struct glint_mesh_drawn *drawn, unsigned face,
                        unsigned corner, const struct glint_mesh_window *window)
{
    const struct glint_mesh_vertex *const a = glint_mesh_corner_at(drawn, face, corner),
                                          *const b = glint_mesh_corner_at(drawn, face, glint_mesh_corner_after(corner));
    const int32_t dx = b->x - a->x, dy = b->y - a->y;
    const bool is_flat = edges_size(dy) < edges_size(dx), turned = (is_flat ? dx : dy) < 0;
    const struct glint_mesh_vertex *const p = turned ? b : a, *const q = turned ? a : b;
    const int32_t low = is_flat ? p->x : p->y, high = is_flat ? q->x : q->y, from = is_flat ? p->y : p->x,
                  to = is_flat ? q->y : q->x;
    const int32_t top = is_flat ? window->left : window->top, bottom = is_flat ? window->right : window->bottom;
    const int32_t least = is_flat ? window->top : window->left,
                  room = (is_flat ? window->bottom : window->right) - least;
    const int32_t first = glint_mesh_first(low), last = glint_mesh_first(high);
    int32_t at = first > top ? first : top, end = last < bottom ? last : bottom;
    rim->is = (uint8_t)((is_flat ? GLINT_RIM_FLAT : 0) | (is_flat == turned ? GLINT_RIM_GROWS : 0) |
                        (turned ? GLINT_RIM_TURNED : 0) |
                        ((a->y > b->y ? a->y : b->y) + 1 < 16 * window->bottom ? GLINT_RIM_ENDS : 0));
    if (at >= end || (from < to ? from : to) - 1 >= 16 * (least + room) || (from < to ? to : from) + 1 < 16 * least)
        return false;
    const uint32_t length = (uint32_t)(high - low); /* 1..2^15 - 2 */
    const unsigned up = glint_mesh_zeros(length);
    const uint32_t inverse = glint_mesh_inverse(length << up >> 4);
    const int32_t step = (to - from) * (int32_t)inverse >> (31 - up);
    int32_t e = from * 4096 + (step >> 4) * (16 * first + 8 - low) + step * (at - first),
            e_last = e + step * (end - 1 - at);
    for (; at < end && (uint32_t)((e >> 16) - least) >= (uint32_t)room; at++)
        e += step;
    for (; at < end && (uint32_t)((e_last >> 16) - least) >= (uint32_t)room; end--)
        e_last -= step;
    rim->e = e;
    rim->step = step;
    rim->at = (int16_t)at;
    rim->end = (int16_t)end;
    rim->corner = (uint8_t)corner;
    rim->inverse = inverse | (uint32_t)up << 24;
    rim->face = (uint16_t)face;
    return at < end;
}
#endif

/* A face's outlines, from `to` on; returns how many have a cell in the strip. to->is: none goes on below it, also where there are none. */
static unsigned rims_set(struct glint_mesh_rim *to, const struct glint_mesh_target *strip,
                         const struct glint_mesh_window *window, unsigned face)
{
    struct glint_mesh_rim *rim = to;
    unsigned edges = strip->drawn->edges[face] & GLINT_EDGES, ends = GLINT_RIM_ENDS, count = 0;
    for (unsigned k = 0; edges; k++, edges >>= 1) {
        if (!(edges & 1))
            continue;
        const bool is_there = glint_mesh_rim_set(rim, strip->drawn, face, k, window);
        ends &= rim->is;
        if (!is_there)
            continue;
        if (rim->is & GLINT_RIM_FLAT)
            rim->e -= strip->y * 65536;
        rim->depth = strip->depth + (rim->is & GLINT_RIM_FLAT ? rim->at : strip->w * (rim->at - strip->y));
        if (count++)
            rim[-1].is |= GLINT_RIM_MORE;
        rim++;
    }
    to->is = (uint8_t)((to->is & ~(unsigned)GLINT_RIM_ENDS) | ends);
    return count;
}

struct glint_mesh_rim *glint_mesh_rims_of(const struct glint_mesh_target *strip, unsigned face)
{
    const struct glint_mesh_drawn *const drawn = strip->drawn;
    struct glint_mesh_outlines *const outlines = drawn->outlines;
    struct glint_mesh_rim *const rim = outlines->rims + GLINT_MESH_RIMS;
    const struct glint_mesh_window window = {0, strip->y, strip->w, strip->end};
    return rims_set(rim, strip, &window, face) ? rim : NULL;
}

/* The lists of faces with outlines for those of all faces, and back. */
static void rims_swap(struct glint_mesh_drawn *drawn)
{
    uint16_t *const links = drawn->links, *const bands = drawn->bands;
    drawn->links = drawn->rims;
    drawn->bands = drawn->rim_bands;
    drawn->rims = links;
    drawn->rim_bands = bands;
}

void glint_mesh_rims_take(const struct glint_mesh_target *strip)
{
    struct glint_mesh_drawn *const drawn = strip->drawn;
    struct glint_mesh_outlines *const outlines = drawn->outlines;
    uint16_t *later = &outlines->later;
    const struct glint_mesh_window window = {0, strip->y, strip->w, strip->end};
    rims_swap(drawn);
    uint16_t i = glint_mesh_take(drawn, strip->y, strip->end);
    rims_swap(drawn);
    outlines->count = 0;
    while (i != GLINT_MESH_NONE) {
        uint16_t *const link = &drawn->rims[i];
        struct glint_mesh_rim *const rim = outlines->rims + outlines->count;
        const unsigned count = rims_set(rim, strip, &window, i);
        if (outlines->count + count > GLINT_MESH_RIMS)
            break;
        const uint16_t next = *link;
        if (count) {
            *link = outlines->count;
            drawn->edges[i] |= GLINT_EDGES_LISTED;
            outlines->count = (uint16_t)(outlines->count + count);
        } else if (!(rim->is & GLINT_RIM_ENDS)) {
            *later = i;
            later = link;
        }
        i = next;
    }
    *later = GLINT_MESH_NONE;
    outlines->rest = i;
}

void glint_mesh_rims_give(const struct glint_mesh_target *strip)
{
    struct glint_mesh_drawn *const drawn = strip->drawn;
    struct glint_mesh_outlines *const outlines = drawn->outlines;
    uint16_t kept = GLINT_MESH_NONE, *last = &kept;
    const uint16_t later = outlines->later;
    for (const struct glint_mesh_rim *rim = outlines->rims, *const end = rim + outlines->count; rim < end; rim++) {
        const uint16_t face = rim->face;
        drawn->edges[face] &= (uint8_t)~GLINT_EDGES_LISTED;
        if (!(rim->is & GLINT_RIM_ENDS)) {
            *last = face;
            last = &drawn->rims[face];
        }
        while (rim->is & GLINT_RIM_MORE)
            rim++;
    }
    *last = outlines->rest;
    outlines->count = 0;
    outlines->later = outlines->rest = GLINT_MESH_NONE;
    if (strip->end >= strip->frame->h)
        return;
    rims_swap(drawn);
    glint_mesh_give(drawn, kept, strip->end);
    glint_mesh_give(drawn, later, strip->end);
    rims_swap(drawn);
}
