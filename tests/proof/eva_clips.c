/* SPDX-License-Identifier: MIT
 * For Eva: any face clipped by all planes, with or without perspective, and what its corners' colours and normals are across it. A crossing
 * lies between its corners (test_mesh_words).
 * eva: -eva-precision 1 -eva-min-loop-unroll 8 -eva-slevel 60 -split-zeros -eva-use-spec of_between */
#include "eva_meshes.h"
#include "glint_mesh_pose.h"
#define glint_pose_set of_pose_set
#define glint_mesh_place_of of_place_of
#define glint_mesh_normal of_normal
#define glint_mesh_side of_side
#define glint_mesh_sides8 of_sides8
#define glint_mesh_sides16 of_sides16
#define glint_mesh_is_near of_is_near
#define glint_mesh_project of_project
#define glint_mesh_light of_light
#define glint_mesh_vertices of_vertices
#define glint_mesh_clip of_clip
#define glint_mesh_clip_vertex of_clip_vertex
#define clip_between of_between
/*@ requires 0 < whole; assigns \result \from a, b, part, whole; ensures \result <= \max(a, b); ensures \result >= \min(a, b); */
static int32_t clip_between(int32_t a, int32_t b, int32_t part, int32_t whole);
#include "mesh_pose.c"

static struct glint_mesh_frame frame;
static struct glint_mesh_drawn drawn;
static struct glint_mesh_polygon polygon;

static int32_t within(int32_t most)
{
    const int32_t v = any_signed;
    return v > most ? most : v < -most ? -most : v;
}

static void prepare(uint16_t distance)
{
    frame.w = (uint16_t)(1 + any % GLINT_MESH_SIZE_MAX);
    frame.h = (uint16_t)(1 + any % GLINT_MESH_SIZE_MAX);
    frame.distance = distance;
    drawn.l = any_vector();
    drawn.h = any_vector();
}

/* A plane after the other, in the order of glint_mesh_clip: places before the projection are below 2^18, after it below 2^22 and of 16 bits of
 * depth. */
static void plane(unsigned plane, unsigned count, int32_t most, bool in_space)
{
    for (polygon.now = 0; polygon.now < 2; polygon.now++) {
        for (unsigned i = 0; i < count; i++) {
            const struct glint_mesh_clipped corner = {
                {within(most), within(most), plane == GLINT_MESH_NEAR ? within(most) : (int32_t)(any % 65536)},
                any_vector(),
                {(uint16_t)(any % 32769), (uint16_t)(any % 32769)}};
            polygon.list[polygon.now].corner[i] = corner;
        }
        const uint8_t now = polygon.now;
        (void)clip_plane(&polygon, count, &frame, plane, in_space);
        polygon.now = now;
    }
}
void eva_mesh_clip_planes(void)
{
    prepare((uint16_t)any);
    for (unsigned count = 3; count <= GLINT_MESH_POLYGON; count++) {
        plane(GLINT_MESH_NEAR, count, (1 << 18) - 1, false);
        for (unsigned at = GLINT_MESH_LEFT; at <= GLINT_MESH_BELOW; at <<= 1) {
            plane(at, count, (1 << 22) - 1, false);
            plane(at, count, (1 << 22) - 1, true);
        }
    }
}

void eva_mesh_clip_vertex(void)
{
    static struct glint_paint paint;
    struct glint_mesh_vertex vertex;
    const int32_t guard = GLINT_MESH_GUARD;
    const struct glint_mesh_clipped corner = {{within(guard), within(guard), any % 65536}, any_vector(), {0, 0}};
    prepare((uint16_t)any);
    drawn.paints = &paint;
    paint.light_count = (uint8_t)any;
    glint_mesh_clip_vertex(&vertex, &frame, &drawn, &corner);
}
