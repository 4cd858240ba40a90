/* SPDX-License-Identifier: MIT
 * Meshes in colours of their faces or vertices. */
#include "mesh_colours.h"

#include "glint_mesh_texture.h"

static struct made_mesh mesh;
static uint32_t memory[GLINT_TABLES_ALBEDO_BYTES / 4];
static const unsigned whole[] = {MESH_H}, odd[] = {1, 7, 16, 3, 40};

/* Exactly, and by ALBEDO tables for the formats that they have. */
static void a_picture_in_colours_is_the_same_in_strips_of_any_height_and_order(void **state)
{
    (void)state;
    unsigned by_tables = 0;
    for (int i = 0; i < 8 * GLINT_FORMAT_COUNT; i++) {
        const enum glint_format format = format_number(i);
        const struct look look = random_look(format, (enum glint_space)(i / GLINT_FORMAT_COUNT & 1));
        struct glint_paint paint;
        mesh_any(&mesh, i);
        colour_at_random(&mesh);
        *(i & 1 ? &mesh.mesh.of_vertices : &mesh.mesh.of_faces) = &mesh.colours[0][0];
        paint_of(&paint, &look);
        assert_same_in_strips(&mesh, &paint, bytes_of(format, MESH_W));
        if (!paint_of_albedo(&paint, &look, memory))
            continue;
        by_tables++;
        assert_same_in_strips(&mesh, &paint, bytes_of(format, MESH_W));
    }
    assert_true(by_tables > 5);
}

static void a_face_of_a_colour_has_the_pixels_of_that_albedo(void **state)
{
    (void)state;
    static uint8_t out[MESH_H * MESH_W * 4], expected[MESH_H * MESH_W * 4];
    static struct glint_paint plain[250];
    static uint16_t ends[250];
    for (int i = 0; i < 60; i++) {
        const enum glint_format format = format_number(i);
        const unsigned bytes = bytes_of(format, MESH_W) / MESH_W;
        struct look look = random_look(format, (enum glint_space)(i / GLINT_FORMAT_COUNT & 1));
        struct glint_paint paint;
        if (!bytes)
            continue;
        mesh_any(&mesh, i);
        colour_at_random(&mesh);
        mesh.mesh.of_faces = &mesh.colours[0][0];
        paint_of(&paint, &look);
        memset(out, GUARD, sizeof out);
        mesh_picture(&mesh, &paint, out, bytes, odd, 5, false);
        for (unsigned f = 0; f < mesh.mesh.face_count; f++) { /* each a part of its own */
            memcpy(look.material.albedo, mesh.colours[f], 3);
            paint_of(&plain[f], &look);
            ends[f] = (uint16_t)(f + 1);
        }
        mesh.mesh.of_faces = NULL;
        mesh.mesh.ends = ends;
        mesh.mesh.part_count = (uint8_t)mesh.mesh.face_count;
        memset(expected, GUARD, sizeof expected);
        mesh_picture(&mesh, plain, expected, bytes, whole, 1, false);
        assert_memory_equal(out, expected, sizeof out);
    }
}

/* Corners of one colour are a face of it, wherever it is clipped. */
static void vertices_of_one_colour_have_the_pixels_of_that_albedo(void **state)
{
    (void)state;
    static uint8_t out[MESH_H * MESH_W * 3], expected[MESH_H * MESH_W * 3];
    for (int i = 0; i < 60; i++) {
        const struct look look = random_look(GLINT_RGB888, (enum glint_space)(i & 1));
        struct glint_paint paint;
        mesh_any(&mesh, i);
        for (unsigned v = 0; v < mesh.mesh.vertex_count; v++)
            memcpy(mesh.colours[v], look.material.albedo, 3);
        paint_of(&paint, &look);
        memset(out, GUARD, sizeof out);
        memset(expected, GUARD, sizeof expected);
        mesh_picture(&mesh, &paint, expected, 3, whole, 1, false);
        mesh.mesh.of_vertices = &mesh.colours[0][0];
        mesh_picture(&mesh, &paint, out, 3, odd, 5, false);
        assert_memory_equal(out, expected, sizeof out);
    }
}

/* RGB565 levels as bits apart. */
static int level565(uint16_t pixel, int k)
{
    return k == 0 ? pixel >> 11 : k == 1 ? pixel >> 5 & 63 : pixel & 31;
}

static void a_face_by_albedo_tables_has_its_colour_within_a_level(void **state)
{
    (void)state;
    static uint16_t out[MESH_H * MESH_W], exact[MESH_H * MESH_W];
    const struct look look = bare(GLINT_RGB565);
    struct glint_paint exactly, tables;
    paint_of(&exactly, &look);
    paint_of_tables(&tables, GLINT_TABLES_ALBEDO, &look, memory);
    for (int i = 0; i < 20; i++) {
        mesh_any(&mesh, i); /* faces that meet, too: which hides which does not depend on the paint */
        colour_at_random(&mesh);
        mesh.mesh.of_faces = &mesh.colours[0][0];
        memset(out, GUARD, sizeof out);
        memset(exact, GUARD, sizeof exact);
        mesh_picture(&mesh, &exactly, (uint8_t *)exact, 2, whole, 1, false);
        mesh_picture(&mesh, &tables, (uint8_t *)out, 2, odd, 5, false);
        for (unsigned p = 0; p < MESH_H * MESH_W; p++)
            for (int k = 0; k < 3; k++)
                assert_in_range(1 + level565(out[p], k) - level565(exact[p], k), 0, 2);
    }
}

/* Full levels are bits apart, which a map in RGB565 holds exactly. */
static void a_face_of_full_levels_has_them_in_light_that_is_ambient_alone(void **state)
{
    (void)state;
    static uint16_t out[MESH_H * MESH_W];
    const struct look look = bare(GLINT_RGB565);
    struct glint_paint paint;
    paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
    mesh_ball(&mesh, 5, 9);
    mesh.mesh.of_faces = &mesh.colours[0][0];
    for (unsigned full = 0; full < 8; full++) {
        const uint16_t wanted = (uint16_t)((full & 4 ? 0xf800 : 0) | (full & 2 ? 0x07e0 : 0) | (full & 1 ? 0x1f : 0));
        for (unsigned f = 0; f < MESH_FACES; f++)
            for (int k = 0; k < 3; k++)
                mesh.colours[f][k] = full >> (2 - k) & 1 ? 255 : 0;
        memset(out, GUARD, sizeof out);
        const uint16_t left = out[0];
        unsigned drawn = 0;
        mesh_picture(&mesh, &paint, (uint8_t *)out, 2, whole, 1, false);
        for (unsigned p = 0; p < MESH_H * MESH_W; p++)
            if (out[p] != left) {
                assert_int_equal(out[p], wanted);
                drawn++;
            }
        assert_true(drawn > 100);
    }
}

/* Triangles of any size, many of them so large that they are clipped, which rounds their corners: against doubles. */
static void colours_of_vertices_are_linear_between_them(void **state)
{
    (void)state;
    static uint8_t out[MESH_H][MESH_W][3];
    const struct look look = bare(GLINT_RGB888);
    struct glint_paint paint;
    paint_of(&paint, &look);
    double most[2] = {0, 0};
    unsigned pixels = 0, clipped = 0;
    for (int round = 0; round < 400; round++) {
        double at[3][2];
        mesh_made(&mesh, 3, 1);
        mesh.mesh.of_vertices = &mesh.colours[0][0];
        mesh.pose.scale = (uint16_t)(round % 4 ? 800 << below(6) : 60000);
        for (unsigned i = 0; i < 3; i++) {
            for (int k = 0; k < 2; k++)
                mesh.places[i][k] = (int16_t)((int32_t)below(65535) - 32767);
            at[i][0] = on_screen(mesh.places[i][0], mesh.pose.scale);
            at[i][1] = on_screen(-mesh.places[i][1], mesh.pose.scale);
            mesh.places[i][2] = 0;
            mesh.faces[0][i] = (uint16_t)i;
        }
        const double bx = at[1][0] - at[0][0], by = at[1][1] - at[0][1];
        const double cx = at[2][0] - at[0][0], cy = at[2][1] - at[0][1], area = bx * cy - cx * by;
        const bool is_large = mesh.pose.scale > 20000;
        if (area > (is_large ? -16e6 : -64)) /* backwards, or a sliver */
            continue;
        clipped += is_large;
        colour_at_random(&mesh);
        memset(out, GUARD, sizeof out);
        mesh_picture(&mesh, &paint, &out[0][0][0], 3, odd, 5, round & 1);
        for (int y = 0; y < MESH_H; y++)
            for (int x = 0; x < MESH_W; x++) {
                const double px = 16 * x + 8 - 8 * MESH_W - at[0][0], py = 16 * y + 8 - 8 * MESH_H - at[0][1];
                const double u = (px * cy - cx * py) / area, v = (bx * py - px * by) / area;
                if (u < .001 || v < .001 || u + v > .999)
                    continue;
                for (int k = 0; k < 3; k++) {
                    const double c = mesh.colours[0][k] + u * (mesh.colours[1][k] - mesh.colours[0][k]) +
                                     v * (mesh.colours[2][k] - mesh.colours[0][k]);
                    const double error = fabs(out[y][x][k] - c);
                    most[is_large] = fmax(most[is_large], error);
                }
                pixels++;
            }
    }
    print_message("%u pixels: off by up to %.2f levels; %u triangles that are clipped: %.2f\n", pixels, most[0],
                  clipped, most[1]);
    assert_true(pixels > 100000 && clipped > 40);
    assert_true(most[0] < .6 && most[1] < 1.5);
}

/* In noise there are slivers so thin that colours would leave their range along a line, below and above. */
static void the_fused_lines_of_albedo_tables_have_the_pixels_of_the_general_way(void **state)
{
    (void)state;
    static uint16_t out[MESH_H * MESH_W], expected[MESH_H * MESH_W + 1];
    uint8_t *const at_an_odd_address = (uint8_t *)expected + 1; /* where nothing is fused */
    const struct look look = bare(GLINT_RGB565);
    struct glint_paint paint;
    paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
    for (int i = 0; i < 1000; i++) {
        struct made_texture texture = texture_at_random();
        mesh_any(&mesh, i);
        if (i % 8 > 2) {
            mesh_noise(&mesh, 200, 250);
            memset(mesh.pose.position, 0, sizeof mesh.pose.position);
            mesh.pose.scale = 3200;
            mesh.distance = 2000;
        }
        for (unsigned v = 0; v < MESH_VERTICES; v++)
            for (int k = 0; k < 3; k++)
                mesh.colours[v][k] = (uint8_t)(255 * below(2));
        uv_at_random(&mesh);
        if (i % 8 > 1)
            mesh.mesh.of_vertices = &mesh.colours[0][0];
        else
            mesh.mesh.textures = &texture.texture;
        memset(out, GUARD, sizeof out);
        memset(expected, GUARD, sizeof expected);
        mesh_picture(&mesh, &paint, (uint8_t *)out, 2, odd, 5, false);
        mesh_picture(&mesh, &paint, at_an_odd_address, 2, whole, 1, false);
        assert_memory_equal(out, at_an_odd_address, sizeof out);
        texture_free(&texture);
    }
}

/* A sliver, clipped, of which lines begin within the range of each channel and end beyond it. */
static void a_colour_that_leaves_its_range_behind_a_line_s_first_pixel_is_held(void **state)
{
    (void)state;
    static const int16_t places[3][3] = {{4594, -9473, -843}, {-28366, 29561, 25006}, {29174, 16191, -18158}},
                         turn[4] = {12215, -12029, -18149, -2185};
    static uint16_t out[MESH_H * MESH_W], expected[MESH_H * MESH_W + 1];
    uint8_t *const at_an_odd_address = (uint8_t *)expected + 1; /* where nothing is fused */
    const struct look look = bare(GLINT_RGB565);
    struct glint_paint paint;
    paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
    mesh_made(&mesh, 3, 1);
    memcpy(mesh.places, places, sizeof places);
    memcpy(mesh.pose.turn, turn, sizeof turn);
    mesh.pose.scale = 2000;
    mesh.distance = 1700;
    mesh.mesh.of_vertices = &mesh.colours[0][0];
    for (uint16_t i = 0; i < 3; i++)
        mesh.faces[0][i] = i;
    for (unsigned k = 0; k < 3; k++) {
        memset(mesh.colours, 0, sizeof mesh.colours);
        mesh.colours[2][k] = 255;
        memset(out, GUARD, sizeof out);
        memset(expected, GUARD, sizeof expected);
        mesh_picture(&mesh, &paint, (uint8_t *)out, 2, whole, 1, false);
        mesh_picture(&mesh, &paint, at_an_odd_address, 2, whole, 1, false);
        assert_memory_equal(out, at_an_odd_address, sizeof out);
    }
}

/* With this normal t, an even number as that of every corner, is that. */
static void normal_of_t(int16_t normal[3], const struct glint_vec *h, uint32_t t)
{
    for (int32_t x = -8000; x < 8000; x++)
        for (int32_t y = -8000; y < 0; y++) {
            const uint32_t rest = t - ((uint32_t)(x * x) >> 1) - ((uint32_t)(y * y) >> 1);
            const int32_t z = (int32_t)lround(sqrt(2. * (double)(rest & INT32_MAX)));
            if (rest >> 31 || (uint32_t)z * (uint32_t)z >> 1 != rest)
                continue;
            normal[0] = (int16_t)(h->x + x);
            normal[1] = (int16_t)(h->y + y);
            normal[2] = (int16_t)(h->z - z);
            return;
        }
    assert_true(false);
}

static void the_fused_lines_of_albedo_tables_end_a_highlight_where_the_general_way_does(void **state)
{
    (void)state;
    static const int16_t places[3][3] = {{-30000, -30000, 0}, {30000, -30000, 0}, {0, 30000, 0}};
    static const int32_t to_light[3] = {-4, 6, 8};
    static uint16_t out[MESH_H * MESH_W], expected[MESH_H * MESH_W + 1];
    uint8_t *const at_an_odd_address = (uint8_t *)expected + 1; /* where nothing is fused */
    struct look look = random_look(GLINT_RGB565, GLINT_GAMMA);
    struct glint_paint paint;
    for (uint16_t n = 60; n == 60 || paint.of.tables.filled.t_max_q30 % 2; n++) {
        set_model(&look, GLINT_MSH, n, 2);
        make_grey(&look, 8000, 20000);
        look.output.dither = false;
        assert_int_equal(look_light(&look, to_light, in_front), GLINT_OK);
        paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
    }
    mesh_made(&mesh, 3, 1);
    memcpy(mesh.places, places, sizeof places);
    memset(mesh.colours, 128, sizeof mesh.colours);
    mesh.mesh.of_vertices = &mesh.colours[0][0];
    for (uint16_t i = 0; i < 3; i++)
        mesh.faces[0][i] = i;
    for (unsigned beyond = 0; beyond < 2; beyond++) {
        for (unsigned i = 0; i < 3; i++)
            normal_of_t(mesh.normals[i], &paint.h, paint.of.tables.filled.t_max_q30 + 2 * beyond);
        memset(out, GUARD, sizeof out);
        memset(expected, GUARD, sizeof expected);
        mesh_picture(&mesh, &paint, (uint8_t *)out, 2, whole, 1, false);
        mesh_picture(&mesh, &paint, at_an_odd_address, 2, whole, 1, false);
        assert_memory_equal(out, at_an_odd_address, sizeof out);
    }
}

/* The parts of a line in perspective, one after the other: `perspective` of sequence.md. */
static unsigned parts_of[9];

static void line_in_parts(struct glint_mesh_over *over, int32_t y, int32_t left, int32_t right, uint32_t z, uint32_t dz)
{
    glint_use_mesh_albedo.line(over, y, left, right, z, dz);
    struct glint_mesh_over at = *over;
    while (at.is_far && at.to < right) {
        const int32_t before[2] = {at.off[0], at.off[1]};
        glint_use_mesh_albedo.next(&at);
        const int32_t n = (at.to < right ? at.to : right - 1) - at.from;
        assert_in_range(n, 0, 8);
        const int64_t part = n == 0 ? 0 : n == 1 ? 65535 : (2 * 65536 / n + 1) / 2;
        for (int k = 0; k < 2; k++) {
            const int64_t change = (int32_t)((uint32_t)at.off[k] - (uint32_t)before[k]);
            assert_int_equal(at.step[k], (uint32_t)(change * part >> 16) << at.up);
            assert_int_equal(at.now[k], at.base[k] + ((uint32_t)before[k] << at.up));
        }
        parts_of[n]++;
    }
}

static void in_perspective_textures_go_in_steps_of_the_sequence(void **state)
{
    (void)state;
    static uint8_t out[MESH_H * MESH_W * 3];
    struct glint_use_mesh checked = glint_use_mesh_albedo;
    checked.line = line_in_parts;
    for (int i = 0; i < 40; i++) {
        const struct look look = bare(GLINT_RGB888);
        struct made_texture texture = texture_at_random();
        struct glint_paint paint;
        paint_of(&paint, &look);
        mesh_ball(&mesh, 4, 7);
        mesh.distance = 2000;
        uv_at_random(&mesh);
        mesh.mesh.textures = &texture.texture;
        mesh.mesh.use = &checked;
        mesh_picture(&mesh, &paint, out, 3, whole, 1, false);
        texture_free(&texture);
    }
    for (int n = 1; n <= 8; n++)
        assert_true(parts_of[n] > 20);
}

/* What draws an even line lays the triangle's colours behind it, for the strips after this one. */
enum { SIDE = 64, STRIP = 16, BYTES = 2 * SIDE };
/* In strips, each at an odd address where its bit is set, all with an odd stride where bit 4 is; the mesh is added before strip number `added`. */
static void draw_in_strips(uint8_t picture[SIDE * BYTES], unsigned odd_ones, int added)
{
    static const int16_t places[] = {-800, 900, 0, -900, -900, 0, 900, -700, 0},
                         normals[] = {0, 0, 32767, 0, 0, 32767, 0, 0, 32767};
    static const uint16_t face[] = {0, 1, 2};
    static const uint8_t colours[] = {255, 0, 0, 0, 255, 0, 0, 0, 255};
    static const int32_t front[] = {0, 0, 1};
    static uint32_t frame_memory[60000], mesh_memory[100];
    static uint16_t strip[STRIP * (SIDE + 1)];
    const struct glint_material material = {
        .model = GLINT_MSH, .n = 20, .ambient_q16 = {30000, 30000, 30000}, .diffuse_q16 = {30000, 30000, 30000}};
    const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false};
    const struct glint_mesh triangle = {.places = places,
                                        .normals = normals,
                                        .faces = face,
                                        .vertex_count = 3,
                                        .face_count = 1,
                                        .of_vertices = colours,
                                        .use = &glint_use_mesh_albedo};
    const struct glint_pose pose = {.turn = {32767, 0, 0, 0}, .scale = 16383};
    struct glint_light light;
    struct glint_paint paint;
    assert_int_equal(glint_light_directional(&light, front), GLINT_OK);
    assert_int_equal(glint_paint_tables(&paint, GLINT_TABLES_ALBEDO, &material, &output, memory, sizeof memory),
                     GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, &light, 1, front), GLINT_OK);
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    assert_int_equal(glint_mesh_begin(&frame, SIDE, SIDE, STRIP, 0, frame_memory, sizeof frame_memory), GLINT_OK);
    for (int i = 0; i < SIDE / STRIP; i++) {
        uint8_t *const pixels = (uint8_t *)strip + (odd_ones >> i & 1);
        const ptrdiff_t stride = BYTES + (odd_ones >> 4 & 1);
        const struct glint_surface surface = {pixels, stride, 0, (uint16_t)(i * STRIP)};
        memset(strip, 0, sizeof strip);
        if (i == added)
            assert_int_equal(glint_mesh_add(&frame, &drawn, &triangle, &pose, &paint, mesh_memory, sizeof mesh_memory),
                             GLINT_OK);
        assert_int_equal(glint_mesh_strip(&frame, (uint16_t)(i * STRIP), STRIP, &surface), GLINT_OK);
        for (int y = 0; y < STRIP; y++)
            memcpy(picture + (i * STRIP + y) * BYTES, pixels + y * stride, BYTES);
    }
}

static void a_mesh_is_the_same_in_strips_at_even_and_odd_addresses_and_strides(void **state)
{
    (void)state;
    static uint8_t even[SIDE * BYTES], mixed[SIDE * BYTES];
    draw_in_strips(even, 0, 0);
    for (unsigned odd_ones = 1; odd_ones < 32; odd_ones++) {
        draw_in_strips(mixed, odd_ones, 0);
        assert_memory_equal(mixed, even, sizeof even);
    }
}

static void a_mesh_added_between_strips_is_the_same_below(void **state)
{
    (void)state;
    static uint8_t early[SIDE * BYTES], late[SIDE * BYTES];
    draw_in_strips(early, 0, 0);
    for (int added = 1; added < SIDE / STRIP; added++) {
        draw_in_strips(late, 0, added);
        assert_memory_equal(late + added * STRIP * BYTES, early + added * STRIP * BYTES,
                            sizeof early - (size_t)(added * STRIP * BYTES));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mesh_is_the_same_in_strips_at_even_and_odd_addresses_and_strides),
        cmocka_unit_test(a_mesh_added_between_strips_is_the_same_below),
        cmocka_unit_test(a_picture_in_colours_is_the_same_in_strips_of_any_height_and_order),
        cmocka_unit_test(a_face_of_a_colour_has_the_pixels_of_that_albedo),
        cmocka_unit_test(vertices_of_one_colour_have_the_pixels_of_that_albedo),
        cmocka_unit_test(a_face_by_albedo_tables_has_its_colour_within_a_level),
        cmocka_unit_test(a_face_of_full_levels_has_them_in_light_that_is_ambient_alone),
        cmocka_unit_test(the_fused_lines_of_albedo_tables_have_the_pixels_of_the_general_way),
        cmocka_unit_test(a_colour_that_leaves_its_range_behind_a_line_s_first_pixel_is_held),
        cmocka_unit_test(the_fused_lines_of_albedo_tables_end_a_highlight_where_the_general_way_does),
        cmocka_unit_test(in_perspective_textures_go_in_steps_of_the_sequence),
        cmocka_unit_test(colours_of_vertices_are_linear_between_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
