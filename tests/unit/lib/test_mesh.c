/* SPDX-License-Identifier: MIT
 * Meshes: pictures that do not depend on how they are drawn, and what is refused. */
#include "meshes.h"

#include "glint_mesh_gradient.h"

static struct made_mesh mesh;
static const unsigned whole[] = {MESH_H}, bands[] = {16}, odd[] = {1, 7, 16, 3, 40};

static void a_picture_is_the_same_in_strips_of_any_height_and_order(void **state)
{
    (void)state;
    static uint8_t one[MESH_H][MESH_W][3], other[MESH_H][MESH_W][3];
    for (int i = 0; i < 60; i++) {
        struct glint_shader shader = random_shader(GLINT_RGB888, (enum glint_space)(i & 1));
        struct glint_prepared prepared;
        if (shader.lobe.model == GLINT_PHONG)
            continue;
        if (i % 3)
            mesh_noise(&mesh, 3 + below(200), 1 + below(300));
        else
            mesh_ball(&mesh, 4 + below(8), 5 + below(8));
        assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
        const struct glint_paint paint = {&glint_mesh_exact, &prepared};
        memset(one, GUARD, sizeof one);
        mesh_picture(&mesh, &shader.light, &paint, &one[0][0][0], 3, whole, 1, false);
        for (int way = 0; way < 4; way++) {
            memset(other, GUARD, sizeof other);
            mesh_picture(&mesh, &shader.light, &paint, &other[0][0][0], 3, way & 1 ? bands : odd, way & 1 ? 1 : 5,
                         way & 2);
            assert_memory_equal(one, other, sizeof one);
        }
    }
}

static void tables_draw_the_pixels_of_the_span(void **state)
{
    (void)state;
    static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4];
    static uint8_t out[MESH_H * MESH_W * 3], kept[MESH_H * MESH_W * 3];
    for (int i = 0; i < 12; i++) {
        const bool small = i & 1;
        struct glint_shader shader = random_shader(small && i & 2 ? GLINT_RGB888 : GLINT_RGB565, GLINT_GAMMA);
        struct glint_tables tables;
        glint_lobe_init(&shader.lobe, GLINT_MSH, 60, 6);
        shader.dither = false;
        assert_int_equal(glint_tables_fill(&tables, small ? GLINT_TABLES_SMALL : GLINT_TABLES_COLOUR, &shader, memory,
                                           sizeof memory),
                         GLINT_OK);
        /* One face, upright to the viewer, so that each line is one span from the left edge. */
        mesh_made(&mesh, 4, 2);
        static const int16_t places[4][3] = {
            {-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
        static const uint16_t faces[2][3] = {{0, 1, 2}, {0, 2, 3}};
        memcpy(mesh.places, places, sizeof places);
        memcpy(mesh.faces, faces, sizeof faces);
        for (int v = 0; v < 4; v++) {
            const struct glint_vec n = random_normal(&shader.light);
            mesh.normals[v][0] = (int16_t)(n.x / 8);
            mesh.normals[v][1] = (int16_t)(n.y / 8);
            mesh.normals[v][2] = 32000;
        }
        const struct glint_paint paint = {&glint_mesh_tables, &tables};
        struct glint_prepared prepared;
        const struct glint_paint exact = {&glint_mesh_exact, &prepared};
        const unsigned bytes = small && i & 2 ? 3 : 2;
        assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
        memset(out, GUARD, sizeof out);
        memset(kept, GUARD, sizeof kept);
        mesh_picture(&mesh, &shader.light, &paint, out, bytes, odd, 5, false);
        mesh_picture(&mesh, &shader.light, &exact, kept, bytes, odd, 5, false);
        /* Tables are within two levels of the exact picture; where there is no surface neither writes. */
        for (unsigned p = 0; p < MESH_W * MESH_H; p++) {
            const uint8_t *a = out + bytes * p, *b = kept + bytes * p;
            for (unsigned k = 0; bytes == 3 && k < 3; k++)
                assert_in_range(a[k] - b[k] + 12, 0, 24);
            if (bytes == 2) {
                const unsigned x = a[0] | a[1] << 8, y = b[0] | b[1] << 8;
                assert_in_range((x >> 11) - (y >> 11) + 2, 0, 4);
                assert_in_range((x >> 5 & 63) - (y >> 5 & 63) + 3, 0, 6);
                assert_in_range((x & 31) - (y & 31) + 2, 0, 4);
            }
        }
    }
}

static void colour_tables_draw_each_pixel_as_in_a_span(void **state)
{
    (void)state;
    static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4];
    _Alignas(4) static uint8_t even[2 * MESH_H * MESH_W + 2], uneven[2 * MESH_H * MESH_W + 2];
    for (int i = 0; i < 60; i++) {
        struct glint_shader shader = random_shader(i & 1 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED, GLINT_GAMMA);
        struct glint_tables tables;
        if (shader.lobe.model == GLINT_PHONG)
            continue;
        shader.dither = false;
        assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &shader, memory, sizeof memory), GLINT_OK);
        if (i % 3)
            mesh_noise(&mesh, 3 + below(100), 1 + below(100));
        else
            mesh_ball(&mesh, 4 + below(8), 5 + below(8));
        const struct glint_paint paint = {&glint_mesh_tables, &tables};
        memset(even, GUARD, sizeof even);
        memset(uneven, GUARD, sizeof uneven);
        mesh_picture(&mesh, &shader.light, &paint, even, 2, bands, 1, false);
        mesh_picture(&mesh, &shader.light, &paint, uneven + 1, 2, bands, 1, false); /* by glint_tables_span */
        assert_memory_equal(even, uneven + 1, sizeof even - 2);
    }
}

static void dithered_tables_draw_the_same_picture_in_strips(void **state)
{
    (void)state;
    static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];
    static uint16_t one[MESH_H][MESH_W], other[MESH_H][MESH_W], plain[MESH_H][MESH_W];
    unsigned different = 0;
    for (int i = 0; i < 20; i++) {
        struct glint_shader shader = random_shader(i & 1 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED, GLINT_GAMMA);
        struct glint_tables tables;
        const struct glint_paint paint = {&glint_mesh_tables, &tables};
        if (shader.lobe.model == GLINT_PHONG)
            continue;
        mesh_ball(&mesh, 4 + below(8), 5 + below(8));
        for (int dither = 0; dither < 2; dither++) {
            uint16_t *const picture = dither ? &one[0][0] : &plain[0][0];
            shader.dither = dither;
            assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &shader, memory, sizeof memory), GLINT_OK);
            assert_int_equal(tables.dither, dither);
            memset(picture, GUARD, sizeof one);
            mesh_picture(&mesh, &shader.light, &paint, (uint8_t *)picture, 2, whole, 1, false);
        }
        for (unsigned p = 0; p < MESH_W * MESH_H; p++)
            different += (&one[0][0])[p] != (&plain[0][0])[p];
        for (int way = 0; way < 4; way++) {
            memset(other, GUARD, sizeof other);
            mesh_picture(&mesh, &shader.light, &paint, (uint8_t *)other, 2, way & 1 ? bands : odd, way & 1 ? 1 : 5,
                         way & 2);
            assert_memory_equal(one, other, sizeof one);
        }
    }
    assert_true(different > 1000); /* it is dithered */
}

static void the_nearer_hides_the_farther_and_the_first_of_two_stays(void **state)
{
    (void)state;
    static uint16_t out[MESH_H * MESH_W];
    static const int16_t depths[4][2] = {{0, 100}, {100, 0}, {50, 50}, {-20000, 20000}};
    struct glint_prepared prepared[2];
    struct glint_paint paints[2];
    struct glint_shader shader = random_shader(GLINT_RGB565, GLINT_GAMMA);
    glint_lobe_init(&shader.lobe, GLINT_MSH, 10, 6);
    const uint16_t ends[2] = {1, 2};
    for (int i = 0; i < 2; i++) { /* flat colours: ambient only */
        for (int k = 0; k < 3; k++) {
            shader.material.ambient_q16[k] = i ? 65536 : 0;
            shader.material.diffuse_q16[k] = shader.material.specular_q16[k] = 0;
            shader.material.albedo[k] = 255;
        }
        shader.dither = false;
        assert_int_equal(glint_shade_prepare(&prepared[i], &shader), GLINT_OK);
        paints[i].path = &glint_mesh_exact;
        paints[i].with = &prepared[i];
    }
    for (int i = 0; i < 4; i++) {
        mesh_made(&mesh, 6, 2);
        mesh.mesh.ends = ends;
        mesh.mesh.part_count = 2;
        for (int v = 0; v < 6; v++) {
            mesh.places[v][0] = (int16_t)(v % 3 == 1 ? 30000 : -30000);
            mesh.places[v][1] = (int16_t)(v % 3 == 2 ? 30000 : -30000);
            mesh.places[v][2] = (int16_t)(depths[i][v / 3] * (v < 3 || i < 3 ? 1 : 1));
            mesh.normals[v][2] = 32767;
            mesh.normals[v][0] = mesh.normals[v][1] = 0;
            mesh.faces[v / 3][v % 3] = (uint16_t)v;
        }
        const bool first_is_nearer = depths[i][0] >= depths[i][1];
        memset(out, GUARD, sizeof out);
        mesh_picture(&mesh, &shader.light, paints, (uint8_t *)out, 2, i & 1 ? bands : odd, i & 1 ? 1 : 5, i & 2);
        assert_int_equal(out[MESH_W * (MESH_H / 2 + 10) + MESH_W / 2 - 10], first_is_nearer ? 0 : 0xffff);
    }
}

static void whatever_a_mesh_holds_nothing_outside_the_strip_is_written(void **state)
{
    (void)state;
    static uint8_t out[MESH_H * MESH_W * 4 + 2];
    for (int i = 0; i < 300; i++) {
        const enum glint_format format = format_number(i);
        struct glint_shader shader = random_shader(format, (enum glint_space)(i & 1));
        struct glint_prepared prepared;
        if (shader.lobe.model == GLINT_PHONG)
            shader.lobe.model = GLINT_BLINN;
        if (i % 5 == 0)
            shader.light.h.x = shader.light.l.y = INT16_MIN;
        assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
        const struct glint_paint paint = {&glint_mesh_exact, &prepared};
        mesh_noise(&mesh, 3 + below(60), 1 + below(60));
        memset(out, GUARD, sizeof out);
        const unsigned line = bytes_of(format, MESH_W), height = 1 + below(20), y = below(MESH_H - height);
        static uint32_t depths[(MESH_W * 21 * 2 + 4096) / 4], work[4000];
        struct glint_mesh_frame frame;
        struct glint_mesh_drawn drawn;
        assert_int_equal(
            glint_mesh_begin(&frame, MESH_W, MESH_H, 20, mesh.distance, depths, glint_mesh_frame_bytes(MESH_W, 20)),
            GLINT_OK);
        assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &shader.light, &paint, work,
                                        glint_mesh_bytes(&mesh.mesh, MESH_H)),
                         GLINT_OK);
        const struct glint_surface surface = {out + 1, (ptrdiff_t)line, 0, (uint16_t)y};
        assert_int_equal(glint_mesh_strip(&frame, (uint16_t)y, (uint16_t)height, &surface), GLINT_OK);
        assert_int_equal(out[0], GUARD);
        for (size_t p = 1 + (size_t)line * height; p < sizeof out; p++)
            assert_int_equal(out[p], GUARD);
    }
}

static void normals_of_8_bits_draw_what_their_258_folds_draw(void **state)
{
    (void)state;
    static int8_t normals8[MESH_VERTICES][3];
    static uint8_t one[MESH_H][MESH_W][3], other[MESH_H][MESH_W][3];
    struct glint_shader shader = random_shader(GLINT_RGB888, GLINT_GAMMA);
    struct glint_prepared prepared;
    glint_lobe_init(&shader.lobe, GLINT_MSH, 60, 8);
    assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
    const struct glint_paint paint = {&glint_mesh_exact, &prepared};
    mesh_ball(&mesh, 8, 9);
    for (unsigned v = 0; v < mesh.mesh.vertex_count; v++)
        for (int k = 0; k < 3; k++) {
            normals8[v][k] = (int8_t)(mesh.normals[v][k] / 258);
            mesh.normals[v][k] = (int16_t)(normals8[v][k] * 258);
        }
    memset(one, GUARD, sizeof one);
    memset(other, GUARD, sizeof other);
    mesh_picture(&mesh, &shader.light, &paint, &one[0][0][0], 3, whole, 1, false);
    mesh.mesh.normals = NULL;
    mesh.mesh.normals8 = &normals8[0][0];
    assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_OK);
    mesh_picture(&mesh, &shader.light, &paint, &other[0][0][0], 3, whole, 1, false);
    assert_memory_equal(one, other, sizeof one);
}

/* At odd addresses they draw as spans do, two bytes at a time. */
static void colour_tables_draw_lines_at_any_address(void **state)
{
    (void)state;
    enum { STRIDE = 2 * MESH_W + 1 };
    static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4], depths[8000], work[8000];
    static uint8_t even[MESH_H][2 * MESH_W], apart[MESH_H * STRIDE + 1];
    struct glint_shader shader = random_shader(GLINT_RGB565, GLINT_GAMMA);
    struct glint_tables tables;
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    glint_lobe_init(&shader.lobe, GLINT_MSH, 60, 8);
    shader.dither = false;
    assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &shader, memory, sizeof memory), GLINT_OK);
    const struct glint_paint paint = {&glint_mesh_tables, &tables};
    mesh_ball(&mesh, 6, 8);
    memset(even, GUARD, sizeof even);
    memset(apart, GUARD, sizeof apart);
    mesh_picture(&mesh, &shader.light, &paint, &even[0][0], 2, whole, 1, false);
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, MESH_H, 0, depths, sizeof depths), GLINT_OK);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &shader.light, &paint, work, sizeof work),
                     GLINT_OK);
    const struct glint_surface surface = {apart, STRIDE, 0, 0};
    assert_int_equal(glint_mesh_strip(&frame, 0, MESH_H, &surface), GLINT_OK);
    for (unsigned y = 0; y < MESH_H; y++)
        assert_memory_equal(apart + y * STRIDE, even[y], sizeof even[y]);
}

static void wrong_arguments_are_refused_and_nothing_is_drawn(void **state)
{
    (void)state;
    static uint32_t depths[8000], work[8000];
    uint8_t out[16 * MESH_W * 3];
    struct glint_shader shader = random_shader(GLINT_RGB888, GLINT_GAMMA);
    struct glint_prepared prepared;
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    glint_lobe_init(&shader.lobe, GLINT_MSH, 60, 8);
    assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
    struct glint_paint paint = {&glint_mesh_exact, &prepared};
    mesh_ball(&mesh, 6, 8);
    struct glint_mesh bad = mesh.mesh;
    assert_int_equal(glint_mesh_check(&bad), GLINT_OK);
    assert_int_equal(glint_mesh_check(NULL), GLINT_ERR_ARG);
    bad.vertex_count--; /* the last index is beyond */
    assert_int_equal(glint_mesh_check(&bad), GLINT_ERR_ARG);
    bad = mesh.mesh;
    bad.normals = NULL;
    assert_int_equal(glint_mesh_check(&bad), GLINT_ERR_ARG);
    const uint16_t ends[2] = {5, 4}, short_of[1] = {3};
    bad = mesh.mesh;
    bad.ends = ends;
    bad.part_count = 2;
    assert_int_equal(glint_mesh_check(&bad), GLINT_ERR_ARG);
    bad.ends = short_of;
    bad.part_count = 1;
    assert_int_equal(glint_mesh_check(&bad), GLINT_ERR_ARG);
    static const int8_t lowest[3] = {INT8_MIN, 0, 0};
    static const uint16_t face[3] = {0, 0, 0};
    const struct glint_mesh one = {mesh.mesh.places, NULL, lowest, face, NULL, 1, 1, 0};
    assert_int_equal(glint_mesh_check(&one), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_bytes(NULL, 90), 0);

    const size_t need = glint_mesh_frame_bytes(MESH_W, 16), mesh_need = glint_mesh_bytes(&mesh.mesh, MESH_H);
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, 16, 0, depths, need - 1), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_begin(&frame, 0, MESH_H, 16, 0, depths, need), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_begin(&frame, GLINT_MESH_SIZE_MAX + 1, 1, 1, 0, depths, sizeof depths), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_begin(&frame, 1, GLINT_MESH_SIZE_MAX + 1, 1, 0, depths, sizeof depths), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_begin(&frame, 1, GLINT_MESH_SIZE_MAX, 1, 0, depths, sizeof depths), GLINT_OK);
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, 16, 0, (uint8_t *)depths + 1, need), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, 16, 0, depths, need), GLINT_OK);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &shader.light, &paint, work, mesh_need - 1),
                     GLINT_ERR_ARG);
    struct glint_pose no_turn = mesh.pose;
    memset(no_turn.turn, 0, sizeof no_turn.turn);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &no_turn, &shader.light, &paint, work, mesh_need),
                     GLINT_ERR_VECTOR);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &shader.light, &paint, work, mesh_need),
                     GLINT_OK);
    memset(out, GUARD, sizeof out);
    const struct glint_surface surface = {out, 3 * MESH_W, 0, 0};
    assert_int_equal(glint_mesh_strip(&frame, 0, 17, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_strip(&frame, MESH_H - 8, 9, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_strip(&frame, 0, 0, &surface), GLINT_ERR_ARG);
    glint_lobe_init(&shader.lobe, GLINT_PHONG, 60, 8);
    assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
    assert_int_equal(glint_mesh_strip(&frame, 40, 16, &surface), GLINT_ERR_ARG);
    for (size_t i = 0; i < sizeof out; i++)
        assert_int_equal(out[i], GUARD);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_picture_is_the_same_in_strips_of_any_height_and_order),
        cmocka_unit_test(tables_draw_the_pixels_of_the_span),
        cmocka_unit_test(colour_tables_draw_each_pixel_as_in_a_span),
        cmocka_unit_test(dithered_tables_draw_the_same_picture_in_strips),
        cmocka_unit_test(the_nearer_hides_the_farther_and_the_first_of_two_stays),
        cmocka_unit_test(whatever_a_mesh_holds_nothing_outside_the_strip_is_written),
        cmocka_unit_test(normals_of_8_bits_draw_what_their_258_folds_draw),
        cmocka_unit_test(colour_tables_draw_lines_at_any_address),
        cmocka_unit_test(wrong_arguments_are_refused_and_nothing_is_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
