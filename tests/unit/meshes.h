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
    uint16_t faces[MESH_FACES][3], neighbours[MESH_FACES][3];
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

/* Draws a picture in strips: heights[i % count] lines each, in turn from the top, or backwards from the bottom. */
static inline void mesh_picture(const struct made_mesh *m, const struct glint_paint *paints, uint8_t *pixels,
                                unsigned pixel_bytes, const unsigned *heights, unsigned count, bool backwards)
{
    static _Alignas(8)
        uint8_t memory[MESH_W * MESH_H * 2 + 4096 + 50 * GLINT_MESH_KEPT_BYTES + GLINT_MESH_LIGHTS_BYTES];
    static uint32_t work[(MESH_VERTICES * 16 + MESH_FACES * 5 + 1024) / 4];
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    static unsigned turn;
    static const size_t kept[] = {0, 1, 5, 50}; /* places for triangles that go on */
    const size_t bytes = glint_mesh_frame_bytes(MESH_W, MESH_H) + GLINT_MESH_LIGHTS_BYTES +
                         GLINT_MESH_KEPT_BYTES * kept[turn++ % (sizeof kept / sizeof *kept)];
    unsigned starts[MESH_H + 1], strips = 0;
    assert_true(bytes <= sizeof memory);
    for (starts[0] = 0; starts[strips] < MESH_H; strips++) {
        const unsigned end = starts[strips] + heights[strips % count];
        starts[strips + 1] = end < MESH_H ? end : MESH_H;
    }
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, MESH_H, m->distance, memory, bytes), GLINT_OK);
    frame.outlines = m->mesh.neighbours ? &glint_outlines : NULL;
    assert_int_equal(glint_mesh_add(&frame, &drawn, &m->mesh, &m->pose, paints, work, sizeof work), GLINT_OK);
    for (unsigned i = 0; i < strips; i++) {
        const unsigned strip = backwards ? strips - 1 - i : i, y = starts[strip];
        const struct glint_surface surface = {pixels + (size_t)pixel_bytes * MESH_W * y,
                                              (ptrdiff_t)(pixel_bytes * MESH_W), 0, (uint16_t)y};
        assert_int_equal(glint_mesh_strip(&frame, (uint16_t)y, (uint16_t)(starts[strip + 1] - y), &surface), GLINT_OK);
    }
}

#endif
