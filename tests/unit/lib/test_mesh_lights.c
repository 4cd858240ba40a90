/* SPDX-License-Identifier: MIT
 * Meshes under points, spots and several lights, and those with Phong's model: normals are interpolated, and a pixel has a place. */
#include "lamps.h"
#include "mesh_colours.h"

#include "glint_mesh_rows.h"

static struct made_mesh mesh;
static const unsigned whole[] = {MESH_H}, odd[] = {1, 7, 16, 3, 40};

/* Lights about the mesh, whose middle is that of the picture. */
static unsigned lights_about(struct glint_light lights[GLINT_LIGHTS_MAX])
{
    const unsigned count = below(GLINT_LIGHTS_MAX + 1);
    random_lights(lights);
    for (unsigned i = 0; i < count; i++) {
        if (kind_of(&lights[i]) == DIRECTIONAL)
            continue;
        lights[i].position[0] += 8 * (MESH_W - W);
        lights[i].position[1] += 8 * (MESH_H - H);
        lights[i].position[2] += (int32_t)below(1500);
        lights[i].range += 600;
    }
    return count;
}

static void paint_under(struct glint_paint *paint, const struct look *look, const struct glint_light *lights,
                        unsigned count)
{
    assert_int_equal(glint_paint_exact(paint, &look->material, &look->output), GLINT_OK);
    assert_int_equal(glint_paint_light(paint, lights, count, look->to_viewer), GLINT_OK);
}

static void a_picture_under_lights_is_the_same_in_strips_of_any_height_and_order(void **state)
{
    (void)state;
    for (int i = 0; i < 24; i++) {
        const enum glint_format format = format_number(i);
        const struct look look = random_look(format, (enum glint_space)(i / GLINT_FORMAT_COUNT & 1));
        struct glint_light lights[GLINT_LIGHTS_MAX];
        struct glint_paint paint;
        if (i % 3)
            mesh_noise(&mesh, 3 + below(60), 1 + below(60));
        else
            mesh_ball(&mesh, 4 + below(5), 5 + below(8));
        colour_at_random(&mesh);
        mesh.mesh.of_vertices = i % 3 == 1 ? &mesh.colours[0][0] : NULL;
        mesh.mesh.of_faces = i % 3 == 2 ? &mesh.colours[0][0] : NULL;
        paint_under(&paint, &look, lights, lights_about(lights));
        assert_same_in_strips(&mesh, &paint, bytes_of(format, MESH_W));
    }
}

/* Two triangles side by side at one depth, with one normal. */
static void upright_square(struct glint_vec normal, int16_t z)
{
    static const int16_t places[4][2] = {{-32000, -20000}, {32000, -20000}, {32000, 20000}, {-32000, 20000}};
    static const uint16_t faces[2][3] = {{0, 1, 2}, {0, 2, 3}};
    mesh_made(&mesh, 4, 2);
    memcpy(mesh.faces, faces, sizeof faces);
    mesh.pose.position[2] = z;
    for (int v = 0; v < 4; v++) {
        mesh.places[v][0] = places[v][0];
        mesh.places[v][1] = places[v][1];
        mesh.places[v][2] = 0;
        mesh.normals[v][0] = normal.x;
        mesh.normals[v][1] = normal.y;
        mesh.normals[v][2] = normal.z;
    }
}

/* The place of a pixel on the screen, by sequence.md. */
static void place_of(int32_t place[3], int x, int y, int32_t depth)
{
    const int64_t r = ((int64_t)65535 - depth) << 16, d = mesh.distance;
    place[0] = 16 * x + 8 - 8 * MESH_W;
    place[1] = 16 * y + 8 - 8 * MESH_H;
    place[2] = 32767 - depth;
    if (d) {
        const int64_t q = ((int64_t)1 << 61) / r;
        place[0] = (int32_t)((place[0] * q) >> 32);
        place[1] = (int32_t)((place[1] * q) >> 32);
        place[2] = (int32_t)(d - ((d * q) >> 32));
    }
    place[0] += 8 * MESH_W;
    place[1] += 8 * MESH_H;
}

/* Each pixel is a rectangle of one pixel, seen by lights that are moved as far as its place is from the surface. */
static void a_pixel_is_that_of_a_rectangle_for_its_normal_and_place(void **state)
{
    (void)state;
    static uint8_t out[MESH_H * MESH_W * 4];
    unsigned compared = 0;
    for (int i = 0; i < 80; i++) {
        const enum glint_format format = format_number(i);
        const unsigned bytes = bytes_of(format, MESH_W) / MESH_W;
        struct look look = random_look(format, (enum glint_space)(i / GLINT_FORMAT_COUNT & 1));
        struct glint_light lights[GLINT_LIGHTS_MAX], moved[GLINT_LIGHTS_MAX];
        struct glint_paint paint;
        const struct glint_vec normal = random_normal(&look);
        if (!bytes || normal.x == INT16_MIN || normal.y == INT16_MIN || normal.z == INT16_MIN)
            continue;
        upright_square(normal, (int16_t)((int)below(2000) - 1000));
        mesh.distance = (uint16_t)(below(2) ? 0 : 2000 + below(9000));
        unsigned count = lights_about(lights);
        if (i % 4 == 0) { /* one directional one: only Phong's way has its normals */
            look.material.model = GLINT_PHONG;
            lights[0] = look.light;
            count = 1;
        } else if (count < 2) {
            lights[1] = look.light;
            count = 2;
        }
        paint_under(&paint, &look, lights, count);
        memset(out, GUARD, sizeof out);
        mesh_picture(&mesh, &paint, out, bytes, odd, 5, false);
        const int32_t z = mesh.pose.position[2], d = mesh.distance;
        const int32_t depth = d ? 65535 - (((d << 14) / (d - z) + 1) >> 1) : 32767 - z;
        for (int p = 0; p < 200; p++) {
            const int x = 20 + (int)below(MESH_W - 40), y = 20 + (int)below(MESH_H - 40);
            const struct glint_maps maps = {.normals = &normal};
            uint8_t expected[4];
            int32_t place[3];
            place_of(place, x, y, depth);
            memcpy(moved, lights, sizeof moved);
            for (unsigned k = 0; k < count; k++) {
                if (kind_of(&moved[k]) == DIRECTIONAL)
                    continue;
                moved[k].position[0] += 16 * x + 8 - place[0];
                moved[k].position[1] += 16 * y + 8 - place[1];
                moved[k].position[2] -= place[2];
            }
            const struct glint_surface surface = {expected, 4, (uint16_t)x, (uint16_t)y};
            assert_int_equal(draw_under(&look, moved, count, &maps, 1, 1, &surface, NULL), GLINT_OK);
            if (memcmp(expected, out + bytes * ((size_t)MESH_W * (unsigned)y + (unsigned)x), bytes) != 0)
                fail_msg("round %d, pixel %d, %d", i, x, y);
            compared++;
        }
    }
    assert_true(compared > 5000);
}

/* Lights have places on the screen, and so has a picture: surface.x, y of its first pixel. A picture that moves with its lights is the same. */
static void a_picture_that_moves_with_its_lights_over_the_screen_stays_the_same(void **state)
{
    (void)state;
    enum { BYTES = 3 * MESH_W * MESH_H };
    static uint8_t out[2][BYTES];
    static _Alignas(8) uint8_t memory[MESH_W * 16 * 2 + 4096 + GLINT_MESH_LIGHTS_BYTES];
    static uint32_t work[8000];
    unsigned lit = 0;
    for (int i = 0; i < 10; i++) {
        struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
        struct glint_light lights[GLINT_LIGHTS_MAX];
        struct glint_paint paint;
        const unsigned count = lights_about(lights);
        mesh_ball(&mesh, 8, 9);
        mesh.distance = (uint16_t)(i & 1 ? 4000 : 0);
        for (int moved = 0; moved < 2; moved++) {
            const uint16_t left = (uint16_t)(moved ? 4 * below(1000) : 0),
                           top = (uint16_t)(moved ? 4 * below(1000) : 0);
            struct glint_mesh_frame frame;
            struct glint_mesh_drawn drawn;
            for (unsigned k = 0; k < count; k++)
                if (kind_of(&lights[k]) != DIRECTIONAL) {
                    lights[k].position[0] += 16 * left;
                    lights[k].position[1] += 16 * top;
                }
            paint_under(&paint, &look, lights, count);
            memset(out[moved], GUARD, BYTES);
            assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, 16, mesh.distance, memory,
                                              glint_mesh_frame_bytes(MESH_W, 16) + GLINT_MESH_LIGHTS_BYTES),
                             GLINT_OK);
            assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, sizeof work),
                             GLINT_OK);
            for (uint16_t y = 0; y < MESH_H; y = (uint16_t)(y + 15)) {
                const struct glint_surface surface = {out[moved] + 3 * MESH_W * y, 3 * MESH_W, left,
                                                      (uint16_t)(top + y)};
                assert_int_equal(glint_mesh_strip(&frame, y, 15, &surface), GLINT_OK);
            }
        }
        assert_memory_equal(out[0], out[1], BYTES);
        lit += count > 0;
    }
    assert_true(lit > 4);
}

/* Not the same: t is of the rounded normal here, and a last bit decides where the light ends. */
static void interpolated_normals_are_near_the_quadratic_of_one_light(void **state)
{
    (void)state;
    static uint8_t lit[MESH_H * MESH_W * 3], exact[MESH_H * MESH_W * 3];
    const int32_t to_light[3] = {-4, 6, 8};
    for (int i = 0; i < 10; i++) {
        struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
        struct glint_paint paint, plain;
        look.output.dither = false;
        set_model(&look, GLINT_MSH, 60, 8);
        assert_int_equal(look_light(&look, to_light, in_front), GLINT_OK);
        struct glint_light lights[2] = {look.light, look.light};
        memset(lights[1].color_q16, 0, sizeof lights[1].color_q16); /* two of them, one black */
        mesh_ball(&mesh, 12, 16);
        for (int k = 0; k < 4; k++)
            mesh.pose.turn[k] = (int16_t)((int)below(65535) - 32767);
        mesh.distance = (uint16_t)(i & 1 ? 4000 : 0);
        paint_of(&plain, &look);
        paint_under(&paint, &look, lights, 2);
        memset(lit, GUARD, sizeof lit);
        memset(exact, GUARD, sizeof exact);
        mesh_picture(&mesh, &paint, lit, 3, odd, 5, false);
        mesh_picture(&mesh, &plain, exact, 3, whole, 1, false);
        unsigned differ = 0, most = 0;
        for (unsigned p = 0; p < sizeof lit; p++) {
            const unsigned off = (unsigned)abs(lit[p] - exact[p]);
            differ += off > 1;
            most = off > most ? off : most;
        }
        print_message("%u of %zu off by more than 1, at most by %u\n", differ, sizeof lit, most);
        assert_true(differ < sizeof lit / 500);
    }
}

/* A picture of two meshes, of which the second needs the lights' memory: taken once, for both. */
static void the_meshes_of_a_picture_share_one_memory_of_lights_in_either_order(void **state)
{
    (void)state;
    enum { BYTES = 3 * MESH_W * MESH_H, PLACES = 7 };
    static uint8_t out[2][BYTES];
    static _Alignas(8)
        uint8_t memory[MESH_W * MESH_H * 2 + 4096 + GLINT_MESH_LIGHTS_BYTES + 50 * GLINT_MESH_KEPT_BYTES];
    static uint32_t work[2][8000];
    for (int i = 0; i < 12; i++) {
        struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
        struct glint_light lights[GLINT_LIGHTS_MAX];
        struct glint_paint paints[2];
        random_lights(lights);
        if (look.material.model == GLINT_PHONG)
            look.material.model = GLINT_MSH;
        paint_of(&paints[0], &look);
        paint_under(&paints[1], &look, lights, 4);
        mesh_ball(&mesh, 8, 9);
        for (int height = 0; height < 2; height++) {
            struct glint_mesh_frame frame;
            struct glint_mesh_drawn drawn[2];
            const uint16_t lines = height ? 6 : MESH_H;
            memset(out[height], GUARD, BYTES);
            assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, lines, 0, memory,
                                              glint_mesh_frame_bytes(MESH_W, lines) + GLINT_MESH_LIGHTS_BYTES +
                                                  PLACES * GLINT_MESH_KEPT_BYTES * (unsigned)(i & 2)),
                             GLINT_OK);
            for (int which = 0; which < 2; which++) {
                struct glint_pose pose = mesh.pose;
                pose.position[0] = (int16_t)(which ? 300 : -300);
                assert_int_equal(glint_mesh_add(&frame, &drawn[which], &mesh.mesh, &pose, &paints[which ^ (i & 1)],
                                                work[which], sizeof work[which]),
                                 GLINT_OK);
            }
            for (uint16_t y = 0; y < MESH_H; y = (uint16_t)(y + lines)) {
                const struct glint_surface surface = {out[height] + 3 * MESH_W * y, 3 * MESH_W, 0, y};
                assert_int_equal(glint_mesh_strip(&frame, y, lines, &surface), GLINT_OK);
            }
        }
        assert_memory_equal(out[0], out[1], BYTES);
    }
}

/* As an LCD's next frame may be: the mesh stays, a lamp moves or becomes red. */
static void a_picture_drawn_again_is_under_the_lights_that_its_paint_then_has(void **state)
{
    (void)state;
    enum { BYTES = 3 * MESH_W * MESH_H };
    static const unsigned counts[] = {4, 1, 2, 3};
    static uint8_t out[2][BYTES];
    static _Alignas(8) uint8_t memory[2][MESH_W * MESH_H * 2 + 4096 + GLINT_MESH_LIGHTS_BYTES];
    static uint32_t work[2][8000];
    for (int i = 0; i < 16; i++) {
        const struct look look = random_look(GLINT_RGB888, (enum glint_space)(i & 1));
        struct glint_light lights[4][GLINT_LIGHTS_MAX];
        struct glint_mesh_frame frames[2];
        struct glint_mesh_drawn drawn[2];
        struct glint_paint paint;
        mesh_ball(&mesh, 8, 9);
        for (int k = 0; k < 4; k++) {
            (void)lights_about(lights[k]);
            assert_int_equal(glint_light_point(&lights[k][0], (int32_t[3]){8 * MESH_W, 8 * MESH_H, 1500}, 3000),
                             GLINT_OK);
            lights[k][0].color_q16[1] = below(65536);
        }
        paint_under(&paint, &look, lights[0], 4);
        for (int which = 0; which < 2; which++) {
            assert_int_equal(glint_mesh_begin(&frames[which], MESH_W, MESH_H, MESH_H, 0, memory[which],
                                              glint_mesh_frame_bytes(MESH_W, MESH_H) + GLINT_MESH_LIGHTS_BYTES),
                             GLINT_OK);
            assert_int_equal(glint_mesh_add(&frames[which], &drawn[which], &mesh.mesh, &mesh.pose, &paint, work[which],
                                            sizeof work[which]),
                             GLINT_OK);
        }
        for (int k = 0; k < 4;
             k++) { /* the first frame goes on from lights to lights; the second sees the last ones alone */
            assert_int_equal(glint_paint_light(&paint, lights[k], counts[k], look.to_viewer), GLINT_OK);
            for (int which = k < 3 ? 0 : 1; which >= 0; which--) {
                const struct glint_surface surface = {out[which], 3 * MESH_W, 0, 0};
                memset(out[which], GUARD, BYTES);
                assert_int_equal(glint_mesh_strip(&frames[which], 0, MESH_H, &surface), GLINT_OK);
            }
        }
        assert_memory_equal(out[0], out[1], BYTES);
    }
}

/* A sliver's slopes are coarse, so that its sum may come to any word: also to those to which half a unit adds up beyond 2^31. */
static void a_number_of_a_sliver_is_held_between_its_corners_whatever_its_sum_is(void **state)
{
    (void)state;
    static const uint32_t sums[] = {0,         INT32_MAX - 8192u,   INT32_MAX - 8191u,
                                    INT32_MAX, (uint32_t)INT32_MIN, UINT32_MAX};
    static const int16_t held[] = {3, 200, 3, 3, 3, 3};
    const struct glint_mesh_slope slope = {0, 1 << 14, 0, 3, 200};
    for (unsigned i = 0; i < sizeof sums / sizeof *sums; i++) {
        uint32_t now = sums[i];
        assert_int_equal(glint_mesh_across_next(&slope, &now), held[i]);
        assert_int_equal(now, sums[i] + (1 << 14));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_picture_under_lights_is_the_same_in_strips_of_any_height_and_order),
        cmocka_unit_test(a_pixel_is_that_of_a_rectangle_for_its_normal_and_place),
        cmocka_unit_test(a_picture_that_moves_with_its_lights_over_the_screen_stays_the_same),
        cmocka_unit_test(interpolated_normals_are_near_the_quadratic_of_one_light),
        cmocka_unit_test(the_meshes_of_a_picture_share_one_memory_of_lights_in_either_order),
        cmocka_unit_test(a_picture_drawn_again_is_under_the_lights_that_its_paint_then_has),
        cmocka_unit_test(a_number_of_a_sliver_is_held_between_its_corners_whatever_its_sum_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
