/* SPDX-License-Identifier: MIT
 * Meshes under several lights. */
#include "lamps.h"
#include "glint_mesh_across.h"
#include "meshes.h"

static struct made_mesh mesh;
static uint8_t colours[MESH_FACES][3];
static _Alignas(16) uint8_t memory[4096];
static const unsigned whole[] = {MESH_H}, bands[] = {16}, odd[] = {1, 7, 16, 3, 40};

/* Lamps about the mesh, whose middle is at 0, 0. */
static unsigned lamps_about(struct glint_lamp lamps[GLINT_LAMPS_MAX])
{
    const unsigned count = below(GLINT_LAMPS_MAX + 1);
    random_lamps(lamps);
    for (unsigned i = 0; i < count; i++) {
        lamps[i].position[0] -= 8 * W;
        lamps[i].position[1] -= 8 * H;
        lamps[i].position[2] += (int32_t)below(1500);
        lamps[i].range += 600;
    }
    return count;
}

/* One colour, or those of vertices or of faces. */
static struct glint_mesh_lights lit_by(const struct glint_shader *shader, const struct glint_lamp *lamps,
                                       unsigned count, unsigned kind)
{
    struct glint_mesh_lights lights;
    assert_true(glint_mesh_lights_bytes() <= sizeof memory);
    assert_int_equal(glint_mesh_lights_init(&lights, shader, lamps, count, memory, sizeof memory), GLINT_OK);
    lights.of_vertices = kind == 1 ? &colours[0][0] : NULL;
    lights.of_faces = kind == 2 ? &colours[0][0] : NULL;
    return lights;
}

static void a_picture_under_lamps_is_the_same_in_strips_of_any_height_and_order(void **state)
{
    (void)state;
    static uint8_t one[MESH_H * MESH_W * 4], other[MESH_H * MESH_W * 4];
    for (int i = 0; i < 24; i++) {
        const enum glint_format format = format_number(i);
        const unsigned bytes = bytes_of(format, MESH_W) / MESH_W;
        const struct glint_shader shader = random_shader(format, (enum glint_space)(i / GLINT_FORMAT_COUNT & 1));
        struct glint_lamp lamps[GLINT_LAMPS_MAX];
        if (!bytes)
            continue;
        if (i % 3)
            mesh_noise(&mesh, 3 + below(60), 1 + below(60));
        else
            mesh_ball(&mesh, 4 + below(5), 5 + below(8));
        for (unsigned f = 0; f < MESH_FACES; f++)
            for (int k = 0; k < 3; k++)
                colours[f][k] = (uint8_t)below(256);
        const unsigned count = lamps_about(lamps);
        const struct glint_mesh_lights lights = lit_by(&shader, lamps, count, (unsigned)i % 3);
        const struct glint_paint paint = {&glint_mesh_lit, &lights};
        for (int way = 0; way < 4; way++) {
            uint8_t *const out = way ? other : one;
            memset(out, GUARD, sizeof one);
            mesh_picture(&mesh, &shader.light, &paint, out, bytes,
                         way & 1 ? bands
                         : way   ? odd
                                 : whole,
                         way & 1 ? 1
                         : way   ? 5
                                 : 1,
                         way & 2);
            assert_memory_equal(one, out, sizeof one);
        }
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

/* The place of a pixel, by sequence.md. */
static void place_of(int32_t place[3], int x, int y, int32_t depth)
{
    const int64_t r = ((int64_t)65535 - depth) << 16, d = mesh.distance;
    place[0] = 16 * x + 8 - 8 * MESH_W;
    place[1] = 16 * y + 8 - 8 * MESH_H;
    place[2] = 32767 - depth;
    if (!d)
        return;
    const int64_t q = ((int64_t)1 << 61) / r;
    place[0] = (int32_t)((place[0] * q) >> 32);
    place[1] = (int32_t)((place[1] * q) >> 32);
    place[2] = (int32_t)(d - ((d * q) >> 32));
}

/* Each pixel is a rectangle of one pixel, seen by lamps that are moved as far as its place is from the surface. */
static void a_pixel_is_that_of_glint_shade_lights_for_its_normal_and_place(void **state)
{
    (void)state;
    static uint8_t out[MESH_H * MESH_W * 4];
    unsigned compared = 0;
    for (int i = 0; i < 60; i++) {
        const enum glint_format format = format_number(i);
        const unsigned bytes = bytes_of(format, MESH_W) / MESH_W;
        const struct glint_shader shader = random_shader(format, (enum glint_space)(i / GLINT_FORMAT_COUNT & 1));
        struct glint_lamp lamps[GLINT_LAMPS_MAX], moved[GLINT_LAMPS_MAX];
        const struct glint_vec normal = random_normal(&shader.light);
        if (!bytes || normal.x == INT16_MIN || normal.y == INT16_MIN || normal.z == INT16_MIN)
            continue;
        upright_square(normal, (int16_t)((int)below(2000) - 1000));
        mesh.distance = (uint16_t)(below(2) ? 0 : 2000 + below(9000));
        const unsigned count = lamps_about(lamps);
        const struct glint_mesh_lights lights = lit_by(&shader, lamps, count, 0);
        const struct glint_paint paint = {&glint_mesh_lit, &lights};
        memset(out, GUARD, sizeof out);
        mesh_picture(&mesh, &shader.light, &paint, out, bytes, odd, 5, false);
        const int32_t z = mesh.pose.position[2], d = mesh.distance;
        const int32_t depth = d ? 65535 - (((d << 14) / (d - z) + 1) >> 1) : 32767 - z;
        for (int p = 0; p < 200; p++) {
            const int x = 20 + (int)below(MESH_W - 40), y = 20 + (int)below(MESH_H - 40);
            const struct glint_source source = {&normal, 6, NULL, 0, NULL, 0, NULL, 0};
            uint8_t expected[4];
            int32_t place[3];
            place_of(place, x, y, depth);
            memcpy(moved, lamps, sizeof moved);
            for (unsigned k = 0; k < count; k++) {
                moved[k].position[0] += 16 * x + 8 - place[0];
                moved[k].position[1] += 16 * y + 8 - place[1];
                moved[k].position[2] -= place[2];
            }
            const struct glint_surface surface = {expected, 4, (uint16_t)x, (uint16_t)y};
            assert_int_equal(glint_shade_lights(&shader, moved, count, &source, 1, 1, &surface, NULL), GLINT_OK);
            if (memcmp(expected, out + bytes * ((size_t)MESH_W * (unsigned)y + (unsigned)x), bytes) != 0)
                fail_msg("round %d, pixel %d, %d", i, x, y);
            compared++;
        }
    }
    assert_true(compared > 5000);
}

/* Not the same: t is of the rounded normal here, and a last bit decides where the light ends. */
static void one_white_directional_lamp_is_near_the_path_of_one_light(void **state)
{
    (void)state;
    static uint8_t lit[MESH_H * MESH_W * 3], exact[MESH_H * MESH_W * 3];
    const int32_t to_light[3] = {-4, 6, 8}, to_viewer[3] = {0, 0, 1};
    for (int i = 0; i < 10; i++) {
        struct glint_shader shader = random_shader(GLINT_RGB888, GLINT_GAMMA);
        struct glint_prepared prepared;
        struct glint_lamp lamp;
        shader.dither = false;
        glint_lobe_init(&shader.lobe, GLINT_MSH, 60, 8);
        assert_int_equal(glint_lamp_directional(&lamp, to_light, to_viewer), GLINT_OK);
        shader.light = lamp.light;
        mesh_ball(&mesh, 12, 16);
        for (int k = 0; k < 4; k++)
            mesh.pose.turn[k] = (int16_t)((int)below(65535) - 32767);
        mesh.distance = (uint16_t)(i & 1 ? 4000 : 0);
        assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
        const struct glint_mesh_lights lights = lit_by(&shader, &lamp, 1, 0);
        const struct glint_paint paint = {&glint_mesh_lit, &lights}, plain = {&glint_mesh_exact, &prepared};
        memset(lit, GUARD, sizeof lit);
        memset(exact, GUARD, sizeof exact);
        mesh_picture(&mesh, &shader.light, &paint, lit, 3, odd, 5, false);
        mesh_picture(&mesh, &shader.light, &plain, exact, 3, whole, 1, false);
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

static enum glint_err strip_with(const struct glint_mesh_lights *lights)
{
    static uint32_t depths[8000], work[8000];
    static uint8_t out[16 * MESH_W * 4];
    const struct glint_shader shader = random_shader(GLINT_RGB888, GLINT_GAMMA);
    const struct glint_paint paint = {&glint_mesh_lit, lights};
    const struct glint_surface surface = {out, 4 * MESH_W, 0, 40};
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    mesh_ball(&mesh, 6, 8);
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, 16, 0, depths, sizeof depths), GLINT_OK);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &shader.light, &paint, work, sizeof work),
                     GLINT_OK);
    memset(out, GUARD, sizeof out);
    const enum glint_err err = glint_mesh_strip(&frame, 40, 16, &surface);
    for (size_t i = 0; err && i < sizeof out; i++)
        assert_int_equal(out[i], GUARD);
    return err;
}

static void wrong_lamps_and_memory_are_refused(void **state)
{
    (void)state;
    struct glint_shader shader = random_shader(GLINT_RGB888, GLINT_GAMMA);
    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    struct glint_mesh_lights lights;
    const size_t need = glint_mesh_lights_bytes();
    const int32_t middle[3] = {0, 0, 500};
    random_lamps(lamps);
    assert_int_equal(glint_lamp_point(&lamps[0], middle, 1000), GLINT_OK);
    assert_int_equal(glint_mesh_lights_init(NULL, &shader, lamps, 1, memory, need), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_lights_init(&lights, NULL, lamps, 1, memory, need), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_lights_init(&lights, &shader, NULL, 1, memory, need), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_lights_init(&lights, &shader, lamps, 5, memory, need), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_lights_init(&lights, &shader, lamps, 1, NULL, need), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_lights_init(&lights, &shader, lamps, 1, memory, need - 1), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_lights_init(&lights, &shader, lamps, 1, memory + 1, need), GLINT_ERR_ARG);
    const struct glint_vec v = shader.light.v;
    shader.light.v = (struct glint_vec){0, 0, 0};
    assert_int_equal(glint_mesh_lights_init(&lights, &shader, lamps, 1, memory, need), GLINT_ERR_VECTOR);
    shader.light.v = v;
    shader.format = 99;
    assert_int_equal(glint_mesh_lights_init(&lights, &shader, lamps, 1, memory, need), GLINT_ERR_FORMAT);
    shader.format = GLINT_RGB888;
    lamps[0].range = 0;
    assert_int_equal(glint_mesh_lights_init(&lights, &shader, lamps, 1, memory, need), GLINT_ERR_ARG);
    lamps[0].range = 1000;
    assert_int_equal(glint_mesh_lights_init(&lights, &shader, lamps, 1, memory, need), GLINT_OK);
    assert_int_equal(strip_with(&lights), GLINT_OK);
    assert_int_equal(strip_with(NULL), GLINT_ERR_ARG);
    lights.of_vertices = lights.of_faces = &colours[0][0]; /* one of them at most */
    assert_int_equal(strip_with(&lights), GLINT_ERR_ARG);
    lights.of_faces = NULL;
    assert_int_equal(strip_with(&lights), GLINT_OK);
    lights.memory = NULL;
    assert_int_equal(strip_with(&lights), GLINT_ERR_ARG);
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
        cmocka_unit_test(a_picture_under_lamps_is_the_same_in_strips_of_any_height_and_order),
        cmocka_unit_test(a_pixel_is_that_of_glint_shade_lights_for_its_normal_and_place),
        cmocka_unit_test(one_white_directional_lamp_is_near_the_path_of_one_light),
        cmocka_unit_test(wrong_lamps_and_memory_are_refused),
        cmocka_unit_test(a_number_of_a_sliver_is_held_between_its_corners_whatever_its_sum_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
