/* SPDX-License-Identifier: MIT
 * For Eva: a mesh and where it stands, up to its faces' lists: any pose, light, places, normals and camera, of four vertices and
 * three faces or fewer, in a picture of any size.
 * eva: -eva-precision 1 -eva-min-loop-unroll 16 -eva-slevel 40 -eva-split-return auto */
#include "eva.h"
#include "glint_mesh_pose.h"
#include "glint_mesh_strip.h"

enum { VERTICES = 4, FACES = 3, PARTS = 3 };
static int16_t places[3 * VERTICES], normals[3 * VERTICES];
static int8_t normals8[3 * VERTICES];
static uint16_t faces[3 * FACES], ends[PARTS];
static struct glint_mesh_vertex vertices[VERTICES];
static struct glint_mesh_drawn drawn;

/* Indices as glint_mesh_check lets them pass, where it is not itself at stake. */
static struct glint_mesh mesh(bool is_wide)
{
    ANY_BYTES(places);
    ANY_BYTES(normals);
    ANY_BYTES(normals8);
    for (unsigned i = 0; i < 3 * FACES; i++)
        faces[i] = (uint16_t)(any % VERTICES);
    const struct glint_mesh of = {
        places, is_wide ? normals : NULL, is_wide ? NULL : normals8, faces, NULL, VERTICES, FACES, 0, NULL, NULL};
    return of;
}

/* With and without each of its arrays, for every count of parts. */
void eva_mesh_check(void)
{
    for (unsigned missing = 0; missing < 6; missing++)
        for (uint8_t parts = 0; parts <= PARTS; parts++) {
            struct glint_mesh of = mesh(missing == 4);
            for (unsigned i = 0; i < 3 * FACES; i++)
                faces[i] = (uint16_t)any;
            for (unsigned i = 0; i < PARTS; i++)
                ends[i] = (uint16_t)any;
            of.places = missing == 1 ? NULL : places;
            of.faces = missing == 2 ? NULL : faces;
            of.normals8 = missing >= 3 && missing <= 4 ? NULL : normals8;
            of.ends = missing == 5 ? NULL : ends;
            of.vertex_count = (uint16_t)(any % (VERTICES + 1));
            of.face_count = (uint16_t)(any % (FACES + 1));
            of.part_count = parts;
            (void)glint_mesh_check(&of);
        }
    (void)glint_mesh_check(NULL);
}

enum glint_err eva_mesh_pose_set(void)
{
    const struct glint_pose pose = {{(int16_t)any, (int16_t)any, (int16_t)any, (int16_t)any},
                                    {(int16_t)any, (int16_t)any, (int16_t)any},
                                    (uint16_t)any};
    static struct glint_paint paint;
    paint.l = any_vector();
    paint.h = any_vector();
    return glint_pose_set(&drawn, &pose, &paint) ? GLINT_OK : GLINT_ERR_VECTOR;
}

/* As glint_pose_set leaves it: |turn| <= 2^14 (test_mesh_words). */
static void stand(const struct glint_mesh *of)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const int32_t turn = any_signed;
            drawn.turn[i][j] = (int16_t)(turn > 16384 ? 16384 : turn < -16384 ? -16384 : turn);
        }
        drawn.position[i] = (int16_t)any;
    }
    drawn.l = any_vector();
    drawn.h = any_vector();
    drawn.scale = (uint16_t)any;
    drawn.mesh = of;
    drawn.vertices = vertices;
}

static struct glint_mesh_frame frame(uint16_t distance)
{
    const struct glint_mesh_frame of = {NULL,
                                        NULL,
                                        NULL,
                                        NULL,
                                        (uint16_t)(1 + any % GLINT_MESH_SIZE_MAX),
                                        (uint16_t)(1 + any % GLINT_MESH_SIZE_MAX),
                                        1,
                                        distance,
                                        0,
                                        0,
                                        0,
                                        NULL};
    return of;
}

static void stands(bool is_wide, uint16_t distance)
{
    const struct glint_mesh of = mesh(is_wide);
    const struct glint_mesh_frame picture = frame(distance);
    stand(&of);
    (void)glint_mesh_vertices(&picture, &drawn);
    (void)glint_mesh_place_of(&drawn, any % VERTICES);
}
void eva_mesh_vertices(void)
{
    stands(false, 0);
    stands(true, 0);
}
void eva_mesh_vertices_far(void)
{
    stands(false, (uint16_t)(1 + any % 65535));
    stands(true, (uint16_t)(1 + any % 65535));
}

uint32_t eva_mesh_sides(void)
{
    struct glint_mesh_corner corner[3];
    const struct glint_mesh of = mesh(true), narrow = mesh(false);
    glint_mesh_sides(corner, &of, faces);
    glint_mesh_sides(corner, &narrow, faces);
    return corner[0].side + corner[1].side + corner[2].side;
}

/* What a picture and a mesh in it take. */
uint32_t eva_mesh_bytes(void)
{
    struct glint_mesh of = mesh(true);
    of.vertex_count = (uint16_t)any;
    of.face_count = (uint16_t)any;
    return (uint32_t)(glint_mesh_bytes(&of, (uint16_t)any) + glint_mesh_frame_bytes((uint16_t)any, (uint16_t)any));
}

/* Lists of any faces that lists may hold. */
static uint16_t any_face(void)
{
    const uint16_t face = (uint16_t)(any % (FACES + 1));
    return face == FACES ? GLINT_MESH_NONE : face;
}
void eva_mesh_lists(void)
{
    enum { BANDS = 3 };
    static uint16_t links[FACES], bands[BANDS];
    const struct glint_mesh of = mesh(true);
    drawn.mesh = &of;
    drawn.vertices = vertices;
    drawn.links = links;
    drawn.bands = bands;
    for (uint16_t h = 1; h <= BANDS * GLINT_MESH_BAND; h++) {
        struct glint_mesh_frame picture = frame((uint16_t)any);
        picture.h = h;
        ANY_BYTES(vertices);
        for (unsigned i = 0; i < FACES; i++)
            links[i] = any_face();
        for (unsigned i = 0; i < BANDS; i++)
            bands[i] = any_face();
        glint_mesh_sort(&picture, &drawn, (int32_t)(any % h));
        for (uint16_t y = 0; y < h; y = (uint16_t)(y + GLINT_MESH_BAND)) {
            for (unsigned i = 0; i < BANDS; i++)
                bands[i] = any_face();
            const int32_t last = (int32_t)(y + any % GLINT_MESH_BAND);
            (void)glint_mesh_take(&drawn, last, 1 + (int32_t)(any % h));
            glint_mesh_give(&drawn, any_face(), last);
        }
    }
}

/* A crossing of any sides: what eva_clips.c takes for granted of it is shown by test_mesh_words. */
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
#include "mesh_pose.c"
int eva_mesh_between(void)
{
    const int32_t size = 1 << 23, a = any_signed % size, b = any_signed % size;
    return clip_between(a, b, (int32_t)(any % (2 * size)), (int32_t)(1 + any % (2 * size)));
}
