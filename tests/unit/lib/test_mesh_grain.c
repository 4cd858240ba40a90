/* SPDX-License-Identifier: MIT
 * Grain along an axis of a mesh. */
#include "grained.h"
#include "meshes.h"

#include "glint_grain.h"

static struct made_mesh ball;

static void make_ball(void)
{
    static const struct glint_pose pose = {{30000, 9000, -5000, 7000}, {0, 0, 0}, 16 * 44};
    mesh_ball(&ball, 12, 20);
    ball.pose = pose;
    ball.mesh.grain[0] = 20000, ball.mesh.grain[1] = -12000, ball.mesh.grain[2] = 23000;
    ball.mesh.use_grain = &glint_use_mesh_grain;
}

static void draw_ball(const struct look *look, uint8_t *drawn, unsigned height, bool backwards)
{
    struct glint_paint paint;
    paint_of(&paint, look);
    memset(drawn, GUARD, 3 * MESH_W * MESH_H);
    mesh_picture(&ball, &paint, drawn, 3, &height, 1, backwards);
}

static void a_mesh_with_grain_does_not_depend_on_how_it_is_cut_or_on_the_axis_sign(void **state)
{
    (void)state;
    static uint8_t drawn[2][3 * MESH_W * MESH_H];
    for (int k = 0; k < GRAINED; k++)
        for (int outlined = 0; outlined < 2; outlined++) {
            const struct look look = metal((enum glint_model)grained[k], 60, 8);
            make_ball();
            if (outlined)
                mesh_join(&ball);
            draw_ball(&look, drawn[0], MESH_H, false);
            draw_ball(&look, drawn[1], 7, true);
            assert_memory_equal(drawn[0], drawn[1], sizeof *drawn);
            for (int j = 0; j < 3; j++)
                ball.mesh.grain[j] = (int16_t)-ball.mesh.grain[j];
            draw_ball(&look, drawn[1], MESH_H, false);
            for (size_t i = 0; i < sizeof *drawn; i++)
                assert_in_range(drawn[0][i] - drawn[1][i] + 1, 0, 2);
        }
}

/* A mesh whose normals are one, but for what it rounds. Across a normal N grain along A and along N_z A - A_z N, which lies in the picture's plane, is
 * the same. */
static void a_mesh_has_the_grain_of_a_rectangle_that_is_brushed_along_its_axis(void **state)
{
    (void)state;
    static uint8_t drawn[3 * MESH_W * MESH_H];
    for (int i = 0; i < 100; i++) {
        const struct look look = metal((enum glint_model)grained[i % GRAINED], 60, 8);
        int32_t wide[3] = {look.h.x + (int32_t)below(16001) - 8000, look.h.y + (int32_t)below(16001) - 8000, look.h.z};
        struct glint_vec normal;
        uint8_t pixel[3];
        assert_int_equal(glint_vec_normalize(&normal, wide), GLINT_OK);
        make_ball();
        ball.pose = (struct glint_pose){{1, 0, 0, 0}, {0, 0, 0}, 16 * 44};
        for (int k = 0; k < 2; k++)
            ball.mesh.grain[k] = (int16_t)(below(40001) - 20000);
        ball.mesh.grain[2] = (int16_t)(i % 2 ? below(40001) - 20000 : 0);
        double flat[2];
        for (int k = 0; k < 2; k++)
            flat[k] = (double)ball.mesh.grain[k] * normal.z - (double)ball.mesh.grain[2] * (k ? normal.y : normal.x);
        const double unit = 20000 / fmax(fabs(flat[0]), fabs(flat[1]));
        for (unsigned v = 0; v < ball.mesh.vertex_count; v++) {
            ball.normals[v][0] = normal.x;
            ball.normals[v][1] = normal.y;
            ball.normals[v][2] = normal.z;
        }
        draw_ball(&look, drawn, MESH_H, false);
        const struct glint_maps maps = {.normals = &normal,
                                        .grain_kind = GLINT_GRAIN_BRUSHED,
                                        .grain_at = {(int16_t)lrint(unit * flat[0]), (int16_t)lrint(unit * flat[1])}};
        const struct glint_surface surface = {pixel, 3, 0, 0};
        assert_int_equal(draw_rect(&look, &maps, 1, 1, &surface, NULL), GLINT_OK);
        for (int k = 0; k < 3; k++)
            assert_in_range(drawn[3 * (MESH_H / 2 * MESH_W + MESH_W / 2) + k] - pixel[k] + 1, 0, 2);
    }
}

/* A third of a turn about (1, 1, 1) makes y of x, z of y and x of z, exactly. */
static void the_axis_turns_with_the_mesh(void **state)
{
    (void)state;
    static const struct glint_pose straight = {{1, 0, 0, 0}, {0, 0, 0}, 16 * 44},
                                   turned = {{1, 1, 1, 1}, {0, 0, 0}, 16 * 44};
    static uint8_t drawn[2][3 * MESH_W * MESH_H];
    for (int k = 0; k < GRAINED; k++) {
        const struct look look = metal((enum glint_model)grained[k], 60, 8);
        make_ball();
        ball.pose = straight;
        draw_ball(&look, drawn[0], MESH_H, false);
        const struct made_mesh was = ball;
        for (int j = 0; j < 3; j++) {
            for (unsigned v = 0; v < ball.mesh.vertex_count; v++) {
                ball.places[v][j] = was.places[v][(j + 1) % 3];
                ball.normals[v][j] = was.normals[v][(j + 1) % 3];
            }
            ball.mesh.grain[j] = was.mesh.grain[(j + 1) % 3];
        }
        ball.pose = turned;
        draw_ball(&look, drawn[1], MESH_H, false);
        assert_memory_equal(drawn[0], drawn[1], sizeof *drawn);
    }
}

/* The axis turned, to nearest, for a turn that does nothing. */
static void row_of_turned(const struct glint_paint *paint, const struct glint_run *run, const int16_t axis[3],
                          int16_t turn[3][3], const struct glint_vec *normals, struct glint_sample *samples,
                          unsigned count)
{
    static int16_t none[3][3] = {{16384, 0, 0}, {0, 16384, 0}, {0, 0, 16384}};
    int16_t turned[3];
    for (int k = 0; k < 3; k++) {
        const double sum = (double)turn[k][0] * axis[0] + (double)turn[k][1] * axis[1] + (double)turn[k][2] * axis[2];
        turned[k] = (int16_t)fmax(fmin(floor(sum / 16384 + .5), 32767), -32767);
    }
    glint_use_mesh_grain.row(paint, run, turned, none, normals, samples, count);
}

static void the_axis_is_turned_to_nearest(void **state)
{
    (void)state;
    static const struct glint_use_axis turned = {row_of_turned};
    static uint8_t drawn[2][3 * MESH_W * MESH_H];
    for (int i = 0; i < 20; i++) {
        const struct look look = metal((enum glint_model)grained[i % GRAINED], 900, 8);
        make_ball();
        for (int k = 0; k < 4; k++)
            ball.pose.turn[k] = (int16_t)(below(65535) - 32767);
        for (int k = 0; k < 3; k++)
            ball.mesh.grain[k] = (int16_t)(below(40001) - 20000);
        draw_ball(&look, drawn[0], MESH_H, false);
        ball.mesh.use_grain = &turned;
        draw_ball(&look, drawn[1], MESH_H, false);
        assert_memory_equal(drawn[0], drawn[1], sizeof *drawn);
    }
}

/* Whatever it shows, nothing overflows: the sanitizers tell. */
static void a_mesh_with_grain_is_drawn_whatever_its_axis_and_normals_are(void **state)
{
    (void)state;
    static uint8_t drawn[3 * MESH_W * MESH_H];
    const struct look look = metal(GLINT_LYON, 60, 8);
    make_ball();
    for (unsigned i = 0; i < ball.mesh.vertex_count; i++)
        for (unsigned k = 0; k < 3; k++)
            ball.normals[i][k] = ball.normals[i][k] < 0 ? INT16_MIN : INT16_MAX;
    for (unsigned signs = 0; signs < 8; signs++) {
        for (unsigned k = 0; k < 3; k++)
            ball.mesh.grain[k] = signs >> k & 1 ? INT16_MIN : INT16_MAX;
        draw_ball(&look, drawn, MESH_H, false);
    }
}

static enum glint_err added(const struct glint_mesh *mesh, const struct glint_paint *paint, size_t more)
{
    static _Alignas(8) uint8_t memory[8192 + GLINT_MESH_LIGHTS_BYTES];
    static uint32_t work[16384];
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    assert_int_equal(glint_mesh_begin(&frame, 16, 16, 16, 0, memory, glint_mesh_frame_bytes(16, 16) + more), GLINT_OK);
    return glint_mesh_add(&frame, &drawn, mesh, &ball.pose, paint, work, sizeof work);
}

static void a_mesh_takes_grain_along_its_axis_under_one_directional_light(void **state)
{
    (void)state;
    static const int32_t place[3] = {100, 100, 5000};
    const struct look look = metal(GLINT_MSH, 60, 8);
    struct glint_paint paint;
    struct glint_light point;
    make_ball();
    paint_of(&paint, &look);
    assert_int_equal(added(&ball.mesh, &paint, GLINT_MESH_LIGHTS_BYTES), GLINT_OK);
    assert_int_equal(added(&ball.mesh, &paint, 0), GLINT_ERR_ARG);
    ball.mesh.use_grain = NULL;
    assert_int_equal(added(&ball.mesh, &paint, GLINT_MESH_LIGHTS_BYTES), GLINT_ERR_ARG);
    ball.mesh.use_grain = &glint_use_mesh_grain;
    assert_int_equal(glint_paint_light(&paint, &look.light, 0, in_front), GLINT_OK);
    assert_int_equal(added(&ball.mesh, &paint, GLINT_MESH_LIGHTS_BYTES), GLINT_OK);
    assert_int_equal(glint_light_point(&point, place, 20000), GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, &point, 1, in_front), GLINT_OK);
    assert_int_equal(added(&ball.mesh, &paint, GLINT_MESH_LIGHTS_BYTES), GLINT_ERR_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mesh_with_grain_does_not_depend_on_how_it_is_cut_or_on_the_axis_sign),
        cmocka_unit_test(a_mesh_has_the_grain_of_a_rectangle_that_is_brushed_along_its_axis),
        cmocka_unit_test(the_axis_turns_with_the_mesh),
        cmocka_unit_test(the_axis_is_turned_to_nearest),
        cmocka_unit_test(a_mesh_with_grain_is_drawn_whatever_its_axis_and_normals_are),
        cmocka_unit_test(a_mesh_takes_grain_along_its_axis_under_one_directional_light),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
