/* SPDX-License-Identifier: MIT
 * What glint_mesh_add reads of a mesh, and which faces it lists. */
#include "meshes.h"

#include <sys/mman.h>
#include <unistd.h>

static struct made_mesh mesh;
static _Alignas(8) uint8_t memory[MESH_W * MESH_H * 2 + 8192];
static uint32_t work[40000];

static void add(struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn, bool outlined)
{
    const struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    struct glint_paint paint;
    assert_int_equal(glint_paint_exact(&paint, &look.material, &look.output), GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, NULL, 0, in_front), GLINT_OK);
    assert_int_equal(glint_mesh_begin(frame, MESH_W, MESH_H, MESH_H, mesh.distance, memory, sizeof memory), GLINT_OK);
    frame->outlines = outlined ? &glint_outlines : NULL;
    assert_int_equal(glint_mesh_add(frame, drawn, &mesh.mesh, &mesh.pose, &paint, work, sizeof work), GLINT_OK);
}

/* A copy that ends where no memory is. */
static void *at_the_end(uint8_t *pages, const void *from, size_t bytes)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    assert_true(bytes <= page);
    return memcpy(pages + page - bytes, from, bytes);
}

static void nothing_is_read_beyond_a_mesh_s_arrays(void **state)
{
    (void)state;
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    uint8_t *pages[4];
    for (int i = 0; i < 4; i++) {
        pages[i] = mmap(NULL, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        assert_ptr_not_equal(pages[i], MAP_FAILED);
        assert_int_equal(mprotect(pages[i] + page, page, PROT_NONE), 0);
    }
    for (int round = 0; round < 3000; round++) {
        struct glint_mesh_frame frame;
        struct glint_mesh_drawn drawn;
        mesh_ball(&mesh, 3 + below(3), 3 + below(4));
        for (int k = 0; k < 4; k++)
            mesh.pose.turn[k] = (int16_t)((int)below(65535) - 32767);
        mesh.pose.turn[0] |= 1;
        mesh.pose.scale = (uint16_t)(16 * (1 + below(60)));
        uint16_t last[3]; /* any face */
        const unsigned chosen = below(mesh.mesh.face_count), end = mesh.mesh.face_count - 1u;
        memcpy(last, mesh.faces[chosen], sizeof last);
        memcpy(mesh.faces[chosen], mesh.faces[end], sizeof last);
        memcpy(mesh.faces[end], last, sizeof last);
        mesh_join(&mesh);
        mesh.mesh.places = at_the_end(pages[0], mesh.places, mesh.mesh.vertex_count * sizeof *mesh.places);
        mesh.mesh.normals = at_the_end(pages[1], mesh.normals, mesh.mesh.vertex_count * sizeof *mesh.normals);
        mesh.mesh.faces = at_the_end(pages[2], mesh.faces, mesh.mesh.face_count * sizeof *mesh.faces);
        mesh.mesh.neighbours = at_the_end(pages[3], mesh.neighbours, mesh.mesh.face_count * sizeof *mesh.neighbours);
        add(&frame, &drawn, true);
    }
    for (int i = 0; i < 4; i++)
        assert_int_equal(munmap(pages[i], 2 * page), 0);
}

static void faces_beyond_one_side_of_the_picture_are_in_no_list(void **state)
{
    (void)state;
    for (int side = 0; side < 4; side++)
        for (int beyond = 0; beyond < 2; beyond++) {
            struct glint_mesh_frame frame;
            struct glint_mesh_drawn drawn;
            unsigned listed = 0;
            mesh_ball(&mesh, 5, 7);
            mesh.pose.scale = 16 * 20;
            mesh.pose.position[side / 2] = (int16_t)((side % 2 ? -1 : 1) * (beyond ? 32000 : 0));
            add(&frame, &drawn, false);
            for (uint32_t i = 0; i < (MESH_H + GLINT_MESH_BAND - 1) / GLINT_MESH_BAND; i++)
                for (uint16_t face = drawn.bands[i]; face != UINT16_MAX; face = drawn.links[face])
                    listed++;
            assert_int_equal(listed > 0, !beyond);
        }
}

/* Phong takes the last places for its work memory; here something else is wrong. */
static void a_mesh_that_is_refused_takes_nothing_of_the_picture(void **state)
{
    (void)state;
    const struct glint_output output = {GLINT_RGB888, GLINT_GAMMA, false}, other = {GLINT_GREY8, GLINT_GAMMA, false};
    for (int wrong = 0; wrong < 3; wrong++) {
        struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
        struct glint_paint paints[2];
        struct glint_mesh_frame frame, before;
        struct glint_mesh_drawn drawn;
        look.material.model = GLINT_PHONG;
        look.material.n_across = 0;
        for (int i = 0; i < 2; i++) {
            assert_int_equal(glint_paint_exact(&paints[i], &look.material, i && wrong == 0 ? &other : &output),
                             GLINT_OK);
            assert_int_equal(glint_paint_light(&paints[i], NULL, 0, in_front), GLINT_OK);
        }
        mesh_ball(&mesh, 5, 7);
        const uint16_t ends[2] = {5, mesh.mesh.face_count};
        mesh.mesh.ends = ends;
        mesh.mesh.part_count = 2;
        if (wrong == 1)
            memset(mesh.pose.turn, 0, sizeof mesh.pose.turn);
        if (wrong == 2)
            paints[1].light_count = UINT8_MAX; /* never lit */
        assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, MESH_H, mesh.distance, memory, sizeof memory),
                         GLINT_OK);
        memcpy(&before, &frame, sizeof frame);
        assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, paints, work, sizeof work),
                         wrong == 1 ? GLINT_ERR_VECTOR : GLINT_ERR_ARG);
        assert_memory_equal(&frame, &before, sizeof frame);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_read_beyond_a_mesh_s_arrays),
        cmocka_unit_test(faces_beyond_one_side_of_the_picture_are_in_no_list),
        cmocka_unit_test(a_mesh_that_is_refused_takes_nothing_of_the_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
