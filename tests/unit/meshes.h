/* SPDX-License-Identifier: MIT
 * Meshes for tests, and pictures of them. */
#ifndef GLINT_UNIT_MESHES_H
#define GLINT_UNIT_MESHES_H

#include "shading.h"

#include "glint_mesh.h"

enum { MESH_W = 120, MESH_H = 90, MESH_VERTICES = 2000, MESH_FACES = 4000 };

/* A mesh that can be changed, and its view. */
struct made_mesh {
    int16_t places[MESH_VERTICES][3], normals[MESH_VERTICES][3];
    uint16_t faces[MESH_FACES][3], neighbours[MESH_FACES][3], uv[MESH_VERTICES][2];
    uint8_t colours[MESH_FACES][3];
    struct glint_mesh mesh;
    struct glint_pose pose;
    uint16_t distance;
};

static inline void mesh_made(struct made_mesh *m, unsigned vertices, unsigned faces)
{
    const struct glint_mesh mesh = {.places = &m->places[0][0],
                                    .normals = &m->normals[0][0],
                                    .faces = &m->faces[0][0],
                                    .vertex_count = (uint16_t)vertices,
                                    .face_count = (uint16_t)faces,
                                    .use = &glint_use_mesh_albedo};
    const struct glint_pose pose = {{32767, 0, 0, 0}, {0, 0, 0}, 16 * 60};
    m->mesh = mesh;
    m->pose = pose;
    m->distance = 0;
}

/* A ball of radius 32767 from rings of corners, counterclockwise from outside. */
static inline void mesh_ball(struct made_mesh *m, unsigned rings, unsigned corners)
{
    unsigned faces = 0;
    for (unsigned j = 0; j <= rings; j++)
        for (unsigned i = 0; i < corners; i++) {
            const double a = 3.14159265358979 * j / rings, b = 6.28318530717959 * i / corners;
            const double v[3] = {sin(a) * cos(b), cos(a), -sin(a) * sin(b)};
            for (int k = 0; k < 3; k++)
                m->places[j * corners + i][k] = m->normals[j * corners + i][k] = (int16_t)lrint(32767 * v[k]);
        }
    for (unsigned j = 0; j < rings; j++)
        for (unsigned i = 0; i < corners; i++) {
            const unsigned a = j * corners + i, b = j * corners + (i + 1) % corners;
            const uint16_t two[2][3] = {{(uint16_t)a, (uint16_t)(a + corners), (uint16_t)(b + corners)},
                                        {(uint16_t)a, (uint16_t)(b + corners), (uint16_t)b}};
            if (j + 1 < rings)
                memcpy(m->faces[faces++], two[0], sizeof two[0]);
            if (j > 0)
                memcpy(m->faces[faces++], two[1], sizeof two[1]);
        }
    mesh_made(m, (rings + 1) * corners, faces);
}

/* Anything: noise with small and large faces. */
static inline void mesh_noise(struct made_mesh *m, unsigned vertices, unsigned faces)
{
    mesh_made(m, vertices, faces);
    for (unsigned i = 0; i < vertices; i++)
        for (int k = 0; k < 3; k++) {
            m->places[i][k] = (int16_t)(below(65536) - 32768);
            m->normals[i][k] = (int16_t)(below(65536) - 32768);
        }
    for (unsigned i = 0; i < faces; i++)
        for (int k = 0; k < 3; k++)
            m->faces[i][k] = (uint16_t)below(vertices);
    for (int k = 0; k < 4; k++)
        m->pose.turn[k] = (int16_t)(below(65536) - 32768);
    m->pose.turn[0] |= 1;
    for (int k = 0; k < 3; k++)
        m->pose.position[k] = (int16_t)(below(2) ? (int)below(2000) - 1000 : (int)below(65536) - 32768);
    m->pose.scale = (uint16_t)(below(2) ? below(4000) : below(65536));
    m->distance = (uint16_t)(below(3) == 0 ? 0 : below(2) ? 1 + below(4000) : below(65536));
}

/* Neighbours by place: the first face with the edge the other way. */
static inline void mesh_join(struct made_mesh *m)
{
    for (unsigned i = 0; i < 3u * m->mesh.face_count; i++) {
        const int16_t *a = m->places[m->faces[i / 3][i % 3]], *b = m->places[m->faces[i / 3][(i + 1) % 3]];
        m->neighbours[i / 3][i % 3] = GLINT_MESH_RIM;
        for (unsigned j = 3u * m->mesh.face_count; j--;)
            if (memcmp(m->places[m->faces[j / 3][j % 3]], b, 6) == 0 &&
                memcmp(m->places[m->faces[j / 3][(j + 1) % 3]], a, 6) == 0)
                m->neighbours[i / 3][i % 3] = (uint16_t)(j / 3);
    }
    m->mesh.neighbours = m->neighbours[0];
}

/* Any: noise, or a ball. */
static inline void mesh_any(struct made_mesh *m, int round)
{
    if (round % 3)
        mesh_noise(m, 3 + below(200), 1 + below(250));
    else
        mesh_ball(m, 4 + below(8), 5 + below(8));
}

/* A mesh of a picture, and its paints. */
struct mesh_shown {
    const struct made_mesh *made;
    const struct glint_paint *paints;
};

/* A picture in strips: heights[i % count] lines each, in turn from the top; and in which order they are drawn. */
enum mesh_order { MESH_DOWN, MESH_UP, MESH_SHUFFLED };
struct mesh_cut {
    const unsigned *heights;
    unsigned count;
    enum mesh_order order;
};

static inline void meshes_picture(const struct mesh_shown *shown, unsigned shown_count, const struct mesh_cut *cut,
                                  uint8_t *pixels, unsigned line_bytes)
{
    enum { MOST = 2 };
    static _Alignas(8)
        uint8_t memory[MESH_W * MESH_H * 2 + 4096 + 50 * GLINT_MESH_KEPT_BYTES + GLINT_MESH_LIGHTS_BYTES];
    static uint32_t work[MOST][(MESH_VERTICES * 16 + MESH_FACES * 5 + 1024) / 4];
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn[MOST];
    static unsigned turn;
    static const size_t kept[] = {0, 1, 5, 50}; /* places for triangles that go on */
    const size_t bytes = glint_mesh_frame_bytes(MESH_W, MESH_H) + GLINT_MESH_LIGHTS_BYTES +
                         GLINT_MESH_KEPT_BYTES * kept[turn++ % (sizeof kept / sizeof *kept)];
    unsigned starts[MESH_H + 1], order[MESH_H], strips = 0;
    assert_true(bytes <= sizeof memory && shown_count <= MOST);
    for (starts[0] = 0; starts[strips] < MESH_H; strips++) {
        const unsigned end = starts[strips] + cut->heights[strips % cut->count];
        starts[strips + 1] = end < MESH_H ? end : MESH_H;
    }
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, MESH_H, shown->made->distance, memory, bytes), GLINT_OK);
    for (unsigned i = 0; i < shown_count; i++)
        if (shown[i].made->mesh.neighbours)
            frame.outlines = &glint_outlines;
    for (unsigned i = 0; i < shown_count; i++)
        assert_int_equal(glint_mesh_add(&frame, &drawn[i], &shown[i].made->mesh, &shown[i].made->pose, shown[i].paints,
                                        work[i], sizeof work[i]),
                         GLINT_OK);
    for (unsigned i = 0; i < strips; i++)
        order[i] = cut->order == MESH_UP ? strips - 1 - i : i;
    for (unsigned i = strips; cut->order == MESH_SHUFFLED && i > 1; i--) {
        const unsigned other = below(i), last = order[i - 1];
        order[i - 1] = order[other];
        order[other] = last;
    }
    for (unsigned i = 0; i < strips; i++) {
        const unsigned y = starts[order[i]], h = starts[order[i] + 1] - y;
        const struct glint_surface surface = {pixels + (size_t)line_bytes * y, (ptrdiff_t)line_bytes, 0, (uint16_t)y};
        assert_int_equal(glint_mesh_strip(&frame, (uint16_t)y, (uint16_t)h, &surface), GLINT_OK);
    }
}

/* One mesh, strips from the top, or backwards from the bottom. */
static inline void mesh_picture(const struct made_mesh *m, const struct glint_paint *paints, uint8_t *pixels,
                                unsigned pixel_bytes, const unsigned *heights, unsigned count, bool backwards)
{
    const struct mesh_shown shown = {m, paints};
    const struct mesh_cut cut = {heights, count, backwards ? MESH_UP : MESH_DOWN};
    meshes_picture(&shown, 1, &cut, pixels, pixel_bytes * MESH_W);
}

/* The same picture whole, and in strips of any heights and order. */
static inline void assert_cuts_agree(const struct mesh_shown *shown, unsigned count, unsigned line_bytes)
{
    static const unsigned whole[] = {MESH_H}, bands[] = {GLINT_MESH_BAND}, odd[] = {1, 7, 16, 3, 40}, lines[] = {1},
                          some[] = {3, 20, 1, 40};
    static const struct mesh_cut cuts[] = {{whole, 1, MESH_DOWN}, {odd, 5, MESH_DOWN},      {bands, 1, MESH_UP},
                                           {odd, 5, MESH_UP},     {some, 4, MESH_SHUFFLED}, {lines, 1, MESH_DOWN}};
    static uint8_t one[MESH_H * MESH_W * 4], other[MESH_H * MESH_W * 4];
    assert_true(line_bytes * MESH_H <= sizeof one);
    for (size_t i = 0; i < sizeof cuts / sizeof *cuts; i++) {
        uint8_t *const out = i ? other : one;
        memset(out, GUARD, sizeof one);
        meshes_picture(shown, count, &cuts[i], out, line_bytes);
        assert_memory_equal(one, out, sizeof one);
    }
}

/* Of one mesh. */
static inline void assert_same_in_strips(const struct made_mesh *m, const struct glint_paint *paints,
                                         unsigned line_bytes)
{
    assert_cuts_agree(&(struct mesh_shown){m, paints}, 1, line_bytes);
}

#endif
