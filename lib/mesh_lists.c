/* SPDX-License-Identifier: MIT
 * Each band has a list of the faces that begin in it. A strip takes the lists of its bands, and gives those that go on to the
 * band after it. Lists ascend by the face's number, and faces are drawn in that order: of two at the same depth the first stays,
 * however the picture is cut into strips. */
#include "glint_mesh_lists.h"
#include "glint_math_assembly.h"
#include "glint_mesh_edges.h"

#if !GLINT_CORTEX_M0PLUS_ASM
/* The line from y on where a face begins; -1 where it shows its back, or no line. */
static int32_t lists_first(const struct glint_mesh_frame *frame, const struct glint_mesh_vertex *vertices,
                           const uint16_t face[3], int32_t y)
{
    const struct glint_mesh_vertex *a = &vertices[face[0]], *b = &vertices[face[1]], *c = &vertices[face[2]];
    if (a->out | b->out | c->out) /* seen once it is clipped, unless one plane cuts all of it */
        return (a->out & b->out & c->out) == 0 ? y : -1;
    if (glint_mesh_area(a, b, c) >= 0)
        return -1;
    int32_t low = a->y, high = b->y;
    if (low > high) {
        low = b->y;
        high = a->y;
    }
    low = c->y < low ? c->y : low;
    high = c->y > high ? c->y : high;
    low = glint_mesh_first(low);
    high = glint_mesh_first(high);
    low = low > y ? low : y;
    return low < high && low < frame->h ? low : -1;
}

void glint_mesh_sort_faces(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y)
{
    const uint16_t *face = drawn->mesh->faces + 3 * (size_t)drawn->mesh->face_count;
    for (unsigned i = drawn->mesh->face_count; i--;) {
        face -= 3;
        const int32_t first = lists_first(frame, drawn->vertices, face, y);
        if (first < 0)
            continue;
        uint16_t *band = &drawn->bands[(uint32_t)first / GLINT_MESH_BAND];
        drawn->links[i] = *band;
        *band = (uint16_t)i;
    }
}
#endif

void glint_mesh_sort(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y)
{
    const unsigned bands = (frame->h + GLINT_MESH_BAND - 1) / GLINT_MESH_BAND;
    for (unsigned i = 0; i < bands; i++)
        drawn->bands[i] = GLINT_MESH_NONE;
    glint_mesh_sort_faces(frame, drawn, y);
}

/* Two lists that ascend as one. */
static uint16_t lists_merged(uint16_t *links, uint16_t a, uint16_t b)
{
    uint16_t first = GLINT_MESH_NONE, *at = &first;
    while (a != GLINT_MESH_NONE && b != GLINT_MESH_NONE) {
        uint16_t *const lower = a < b ? &a : &b;
        *at = *lower;
        at = &links[*lower];
        *lower = *at;
    }
    *at = a != GLINT_MESH_NONE ? a : b;
    return first;
}

uint16_t glint_mesh_take(const struct glint_mesh_drawn *drawn, int32_t y, int32_t end)
{
    uint16_t list = GLINT_MESH_NONE;
    for (uint32_t band = (uint32_t)y / GLINT_MESH_BAND; band * GLINT_MESH_BAND < (uint32_t)end; band++) {
        list = lists_merged(drawn->links, list, drawn->bands[band]);
        drawn->bands[band] = GLINT_MESH_NONE;
    }
    return list;
}

void glint_mesh_give(const struct glint_mesh_drawn *drawn, uint16_t list, int32_t y)
{
    uint16_t *band = &drawn->bands[(uint32_t)y / GLINT_MESH_BAND];
    *band = lists_merged(drawn->links, list, *band);
}
