/* SPDX-License-Identifier: MIT
 * Sutherland and Hodgman: plane after plane, a corner inside stays and a side that crosses leaves its crossing. First the near plane, in
 * space, then the guard band, on the screen. A crossing is found from the inner corner on, so that two triangles find the
 * same one on the side that they share. */
#include "glint_mesh_clip.h"

/* a + (b - a) part / whole, rounded down: |b - a| < 2^24, 0 <= part <= whole < 2^24. */
static int32_t clip_between(int32_t a, int32_t b, int32_t part, int32_t whole)
{
    const int64_t x = (int64_t)(b - a) * part;
    return a + (int32_t)(x < 0 ? -((-x + whole - 1) / whole) : x / whole);
}

static struct glint_mesh_clipped clip_crossing(const struct glint_mesh_clipped *in,
                                               const struct glint_mesh_clipped *out, int32_t part, int32_t whole)
{
    const struct glint_mesh_clipped crossing = {{clip_between(in->at.x, out->at.x, part, whole),
                                                 clip_between(in->at.y, out->at.y, part, whole),
                                                 clip_between(in->at.z, out->at.z, part, whole)},
                                                {(int16_t)clip_between(in->normal.x, out->normal.x, part, whole),
                                                 (int16_t)clip_between(in->normal.y, out->normal.y, part, whole),
                                                 (int16_t)clip_between(in->normal.z, out->normal.z, part, whole)},
                                                {(uint16_t)clip_between(in->weight[0], out->weight[0], part, whole),
                                                 (uint16_t)clip_between(in->weight[1], out->weight[1], part, whole)}};
    return crossing;
}

/* How far inside one of the planes: 0 and more is inside. */
static int32_t clip_inside(const struct glint_mesh_frame *frame, unsigned plane, const struct glint_mesh_place *at)
{
    switch (plane) {
    case GLINT_MESH_NEAR:
        return (int32_t)frame->distance - ((int32_t)frame->distance + 7) / 8 - at->z;
    case GLINT_MESH_LEFT:
        return at->x + GLINT_MESH_GUARD;
    case GLINT_MESH_RIGHT:
        return GLINT_MESH_GUARD - at->x;
    case GLINT_MESH_ABOVE:
        return at->y + GLINT_MESH_GUARD;
    default:
        return GLINT_MESH_GUARD - at->y; /* GLINT_MESH_BELOW */
    }
}

/* From one list to the other. A convex polygon gains one corner at most; where rounding made it something
 * else, what exceeds the place for it is left out. */
static unsigned clip_plane(struct glint_mesh_polygon *polygon, unsigned count, const struct glint_mesh_frame *frame,
                           unsigned plane)
{
    const struct glint_mesh_clipped *from = polygon->list[polygon->now].corner;
    struct glint_mesh_clipped *to = polygon->list[1 - polygon->now].corner;
    unsigned found = 0;
    for (unsigned i = 0; i < count; i++) {
        const struct glint_mesh_clipped *a = &from[i], *b = &from[i + 1 < count ? i + 1 : 0];
        const int32_t a_in = clip_inside(frame, plane, &a->at), b_in = clip_inside(frame, plane, &b->at);
        if (a_in >= 0 && found < GLINT_MESH_POLYGON)
            to[found++] = *a;
        if ((a_in >= 0) != (b_in >= 0) && found < GLINT_MESH_POLYGON)
            to[found++] = a_in >= 0 ? clip_crossing(a, b, a_in, a_in - b_in) : clip_crossing(b, a, b_in, b_in - a_in);
    }
    polygon->now = (uint8_t)(1 - polygon->now);
    return found < 3 ? 0 : found;
}

unsigned glint_mesh_clip(struct glint_mesh_polygon *polygon, const struct glint_mesh_frame *frame,
                         const struct glint_mesh_drawn *drawn, const uint16_t face[3])
{
    struct glint_mesh_clipped *corner = polygon->list[0].corner;
    unsigned count = 3;
    polygon->now = 0;
    for (unsigned i = 0; i < 3; i++) {
        corner[i].at = glint_mesh_place_of(drawn, face[i]);
        glint_mesh_normal(&corner[i].normal, drawn->mesh, face[i]);
        corner[i].weight[0] = i == 1 ? 32768 : 0;
        corner[i].weight[1] = i == 2 ? 32768 : 0;
    }
    if (frame->distance)
        count = clip_plane(polygon, count, frame, GLINT_MESH_NEAR);
    corner = polygon->list[polygon->now].corner;
    for (unsigned i = 0; i < count; i++)
        corner[i].at = glint_mesh_project(frame, corner[i].at);
    for (unsigned plane = GLINT_MESH_LEFT; plane <= GLINT_MESH_BELOW && count; plane <<= 1)
        count = clip_plane(polygon, count, frame, plane);
    return count;
}

void glint_mesh_clip_vertex(struct glint_mesh_vertex *vertex, const struct glint_mesh_frame *frame,
                            const struct glint_mesh_drawn *drawn, const struct glint_mesh_clipped *clipped)
{
    vertex->x = (int16_t)(clipped->at.x + 8 * frame->w);
    vertex->y = (int16_t)(clipped->at.y + 8 * frame->h);
    vertex->z = (uint16_t)clipped->at.z;
    vertex->out = 0;
    glint_mesh_light(vertex, drawn, &clipped->normal);
}
