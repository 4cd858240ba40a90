/* SPDX-License-Identifier: MIT
 * Meshes in colours of their faces or vertices. */
#include "meshes.h"

static struct made_mesh mesh;
static uint8_t colours[MESH_FACES][3];
static const unsigned whole[] = {MESH_H}, bands[] = {16}, odd[] = {1, 7, 16, 3, 40};

static void colour_at_random(unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            colours[i][k] = (uint8_t)(below(8) ? below(256) : 255 * below(2));
}

/* A shader with the geometry that meshes do. */
static struct glint_shader mesh_shader(enum glint_format format, enum glint_space space)
{
    struct glint_shader shader = random_shader(format, space);
    if (shader.lobe.model == GLINT_PHONG)
        glint_lobe_init(&shader.lobe, GLINT_MSH, shader.lobe.n, 6);
    return shader;
}

static void any_mesh(int round)
{
    if (round % 3)
        mesh_noise(&mesh, 3 + below(200), 1 + below(250));
    else
        mesh_ball(&mesh, 4 + below(5), 5 + below(8));
}

/* Exactly, and by ALBEDO tables for the formats that they have. */
static void a_picture_in_colours_is_the_same_in_strips_of_any_height_and_order(void **state)
{
    (void)state;
    static uint32_t memory[GLINT_TABLES_ALBEDO_BYTES / 4];
    static uint8_t one[MESH_H * MESH_W * 4], other[MESH_H * MESH_W * 4];
    unsigned by_tables = 0;
    for (int i = 0; i < 60; i++) {
        const enum glint_format format = format_number(i);
        const unsigned bytes = bytes_of(format, MESH_W) / MESH_W;
        struct glint_shader shader = mesh_shader(format, (enum glint_space)(i / GLINT_FORMAT_COUNT & 1));
        struct glint_prepared prepared;
        struct glint_tables tables;
        if (!bytes)
            continue;
        any_mesh(i);
        colour_at_random(MESH_FACES);
        const uint8_t *const of = &colours[0][0];
        struct glint_mesh_albedo albedo = {&prepared, i & 1 ? of : NULL, i & 1 ? NULL : of};
        struct glint_paint paint = {&glint_mesh_exact_albedo, &albedo};
        assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
        for (int way = 0; way < 5; way++) {
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
        for (int k = 1; k < 3; k++) {
            shader.material.ambient_q16[0] = shader.material.ambient_q16[k] = 10000;
            shader.material.diffuse_q16[0] = shader.material.diffuse_q16[k] = 50000;
        }
        shader.dither = false;
        if (glint_tables_fill(&tables, GLINT_TABLES_ALBEDO, &shader, memory, sizeof memory))
            continue;
        by_tables++;
        paint.path = &glint_mesh_tables_albedo;
        albedo.with = &tables;
        for (int way = 0; way < 5; way++) {
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
    assert_true(by_tables > 5);
}

static void a_face_of_a_colour_has_the_pixels_of_that_albedo(void **state)
{
    (void)state;
    static uint8_t out[MESH_H * MESH_W * 4], expected[MESH_H * MESH_W * 4];
    static struct glint_prepared plain[250];
    static struct glint_paint plain_paints[250];
    static uint16_t ends[250];
    for (int i = 0; i < 40; i++) {
        const enum glint_format format = format_number(i);
        const unsigned bytes = bytes_of(format, MESH_W) / MESH_W;
        struct glint_shader shader = mesh_shader(format, (enum glint_space)(i / GLINT_FORMAT_COUNT & 1));
        struct glint_prepared prepared;
        if (!bytes)
            continue;
        any_mesh(i);
        colour_at_random(MESH_FACES);
        const struct glint_mesh_albedo albedo = {&prepared, NULL, &colours[0][0]};
        const struct glint_paint paint = {&glint_mesh_exact_albedo, &albedo};
        assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
        memset(out, GUARD, sizeof out);
        mesh_picture(&mesh, &shader.light, &paint, out, bytes, odd, 5, false);
        for (unsigned f = 0; f < mesh.mesh.face_count; f++) { /* each a part of its own */
            memcpy(shader.material.albedo, colours[f], 3);
            assert_int_equal(glint_shade_prepare(&plain[f], &shader), GLINT_OK);
            plain_paints[f] = (struct glint_paint){&glint_mesh_exact, &plain[f]};
            ends[f] = (uint16_t)(f + 1);
        }
        mesh.mesh.ends = ends;
        mesh.mesh.part_count = (uint8_t)mesh.mesh.face_count;
        memset(expected, GUARD, sizeof expected);
        mesh_picture(&mesh, &shader.light, plain_paints, expected, bytes, whole, 1, false);
        assert_memory_equal(out, expected, sizeof out);
    }
}

/* Corners of one colour are a face of it, wherever it is clipped. */
static void vertices_of_one_colour_have_the_pixels_of_that_albedo(void **state)
{
    (void)state;
    static uint8_t out[MESH_H * MESH_W * 3], expected[MESH_H * MESH_W * 3];
    for (int i = 0; i < 40; i++) {
        struct glint_shader shader = mesh_shader(GLINT_RGB888, (enum glint_space)(i & 1));
        struct glint_prepared prepared;
        any_mesh(i);
        for (unsigned v = 0; v < mesh.mesh.vertex_count; v++)
            memcpy(colours[v], shader.material.albedo, 3);
        const struct glint_mesh_albedo albedo = {&prepared, &colours[0][0], NULL};
        const struct glint_paint paint = {&glint_mesh_exact_albedo, &albedo}, plain = {&glint_mesh_exact, &prepared};
        assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
        memset(out, GUARD, sizeof out);
        memset(expected, GUARD, sizeof expected);
        mesh_picture(&mesh, &shader.light, &paint, out, 3, odd, 5, false);
        mesh_picture(&mesh, &shader.light, &plain, expected, 3, whole, 1, false);
        assert_memory_equal(out, expected, sizeof out);
    }
}

/* The colour is the pixel: no light but ambient, as much as there is. */
static struct glint_prepared bare(enum glint_format format)
{
    struct glint_shader shader = mesh_shader(format, GLINT_GAMMA);
    struct glint_prepared prepared;
    shader.dither = false;
    for (int k = 0; k < 3; k++) {
        shader.material.ambient_q16[k] = 65536;
        shader.material.diffuse_q16[k] = shader.material.specular_q16[k] = 0;
    }
    assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
    return prepared;
}

/* RGB565 levels as bits apart. */
static int level565(uint16_t pixel, int k)
{
    return k == 0 ? pixel >> 11 : k == 1 ? pixel >> 5 & 63 : pixel & 31;
}

static void a_face_by_albedo_tables_has_its_colour_within_a_level(void **state)
{
    (void)state;
    static uint32_t memory[GLINT_TABLES_ALBEDO_BYTES / 4];
    static uint16_t out[MESH_H * MESH_W], exact[MESH_H * MESH_W];
    const struct glint_prepared prepared = bare(GLINT_RGB565);
    struct glint_tables tables;
    assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_ALBEDO, &prepared.shader, memory, sizeof memory),
                     GLINT_OK);
    for (int i = 0; i < 20; i++) {
        any_mesh(i); /* faces that meet, too: which hides which does not depend on the path */
        colour_at_random(MESH_FACES);
        struct glint_mesh_albedo albedo = {&prepared, NULL, &colours[0][0]};
        struct glint_paint paint = {&glint_mesh_exact_albedo, &albedo};
        memset(out, GUARD, sizeof out);
        memset(exact, GUARD, sizeof exact);
        mesh_picture(&mesh, &prepared.shader.light, &paint, (uint8_t *)exact, 2, whole, 1, false);
        paint.path = &glint_mesh_tables_albedo;
        albedo.with = &tables;
        mesh_picture(&mesh, &prepared.shader.light, &paint, (uint8_t *)out, 2, odd, 5, false);
        for (unsigned p = 0; p < MESH_H * MESH_W; p++)
            for (int k = 0; k < 3; k++)
                assert_in_range(1 + level565(out[p], k) - level565(exact[p], k), 0, 2);
    }
}

/* Full levels are bits apart, which a map in RGB565 holds exactly. */
static void a_face_of_full_levels_has_them_in_light_that_is_ambient_alone(void **state)
{
    (void)state;
    static uint32_t memory[GLINT_TABLES_ALBEDO_BYTES / 4];
    static uint16_t out[MESH_H * MESH_W];
    const struct glint_prepared prepared = bare(GLINT_RGB565);
    struct glint_tables tables;
    assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_ALBEDO, &prepared.shader, memory, sizeof memory),
                     GLINT_OK);
    mesh_ball(&mesh, 5, 9);
    for (unsigned full = 0; full < 8; full++) {
        const uint16_t wanted = (uint16_t)((full & 4 ? 0xf800 : 0) | (full & 2 ? 0x07e0 : 0) | (full & 1 ? 0x1f : 0));
        const struct glint_mesh_albedo albedo = {&tables, NULL, &colours[0][0]};
        const struct glint_paint paint = {&glint_mesh_tables_albedo, &albedo};
        for (unsigned f = 0; f < MESH_FACES; f++)
            for (int k = 0; k < 3; k++)
                colours[f][k] = full >> (2 - k) & 1 ? 255 : 0;
        memset(out, GUARD, sizeof out);
        const uint16_t left = out[0];
        unsigned drawn = 0;
        mesh_picture(&mesh, &prepared.shader.light, &paint, (uint8_t *)out, 2, whole, 1, false);
        for (unsigned p = 0; p < MESH_H * MESH_W; p++)
            if (out[p] != left) {
                assert_int_equal(out[p], wanted);
                drawn++;
            }
        assert_true(drawn > 100);
    }
}

/* Where the library has a place that is not turned: 1/16 pixel from the middle. */
static double on_screen(int32_t place, uint32_t scale)
{
    return scale < 16384 ? (double)((place * (int32_t)scale) >> 15)
                         : (double)((int64_t)(place >> 2) * (int32_t)scale >> 13);
}

/* Triangles of any size, many of them so large that they are clipped, which rounds their corners: against doubles. */
static void colours_of_vertices_are_linear_between_them(void **state)
{
    (void)state;
    static uint8_t out[MESH_H][MESH_W][3];
    const struct glint_prepared prepared = bare(GLINT_RGB888);
    const struct glint_mesh_albedo albedo = {&prepared, &colours[0][0], NULL};
    const struct glint_paint paint = {&glint_mesh_exact_albedo, &albedo};
    double most[2] = {0, 0};
    unsigned pixels = 0, clipped = 0;
    for (int round = 0; round < 400; round++) {
        double at[3][2];
        mesh_made(&mesh, 3, 1);
        mesh.pose.scale = (uint16_t)(round % 4 ? 800 << below(6) : 60000);
        for (unsigned i = 0; i < 3; i++) {
            for (int k = 0; k < 2; k++)
                mesh.places[i][k] = (int16_t)((int32_t)below(65535) - 32767);
            at[i][0] = on_screen(mesh.places[i][0], mesh.pose.scale);
            at[i][1] = -on_screen(mesh.places[i][1], mesh.pose.scale);
            mesh.places[i][2] = 0;
            mesh.faces[0][i] = (uint16_t)i;
        }
        const double bx = at[1][0] - at[0][0], by = at[1][1] - at[0][1];
        const double cx = at[2][0] - at[0][0], cy = at[2][1] - at[0][1], area = bx * cy - cx * by;
        const bool is_large = mesh.pose.scale > 20000;
        if (area > (is_large ? -16e6 : -64)) /* backwards, or a sliver */
            continue;
        clipped += is_large;
        colour_at_random(3);
        memset(out, GUARD, sizeof out);
        mesh_picture(&mesh, &prepared.shader.light, &paint, &out[0][0][0], 3, odd, 5, round & 1);
        for (int y = 0; y < MESH_H; y++)
            for (int x = 0; x < MESH_W; x++) {
                const double px = 16 * x + 8 - 8 * MESH_W - at[0][0], py = 16 * y + 8 - 8 * MESH_H - at[0][1];
                const double u = (px * cy - cx * py) / area, v = (bx * py - px * by) / area;
                if (u < .001 || v < .001 || u + v > .999)
                    continue;
                for (int k = 0; k < 3; k++) {
                    const double c =
                        colours[0][k] + u * (colours[1][k] - colours[0][k]) + v * (colours[2][k] - colours[0][k]);
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

static enum glint_err strip_with(const struct glint_mesh_path *path, const void *with)
{
    static uint32_t depths[8000], work[8000];
    static uint8_t out[16 * MESH_W * 4];
    const struct glint_shader shader = random_shader(GLINT_RGB888, GLINT_GAMMA);
    const struct glint_paint paint = {path, with};
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

static void colours_that_a_path_cannot_draw_are_refused_and_nothing_is_drawn(void **state)
{
    (void)state;
    static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4];
    static const uint8_t of[3000];
    struct glint_shader shader = mesh_shader(GLINT_RGB565, GLINT_GAMMA);
    struct glint_prepared prepared;
    struct glint_tables tables;
    struct glint_mesh_albedo albedo = {&prepared, of, NULL};
    assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
    assert_int_equal(strip_with(&glint_mesh_exact_albedo, &albedo), GLINT_OK);
    assert_int_equal(strip_with(&glint_mesh_exact_albedo, NULL), GLINT_ERR_ARG);
    albedo.of_faces = of; /* two of them, none */
    assert_int_equal(strip_with(&glint_mesh_exact_albedo, &albedo), GLINT_ERR_ARG);
    albedo.of_faces = albedo.of_vertices = NULL;
    assert_int_equal(strip_with(&glint_mesh_exact_albedo, &albedo), GLINT_ERR_ARG);
    albedo.of_vertices = of;
    albedo.with = NULL;
    assert_int_equal(strip_with(&glint_mesh_exact_albedo, &albedo), GLINT_ERR_ARG);
    assert_int_equal(strip_with(&glint_mesh_tables_albedo, &albedo), GLINT_ERR_ARG);
    albedo.with = &prepared;
    shader.lobe.model = GLINT_PHONG;
    assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
    assert_int_equal(strip_with(&glint_mesh_exact_albedo, &albedo), GLINT_ERR_ARG);
    shader.lobe.model = GLINT_MSH;
    shader.dither = false;
    for (int k = 0; k < 3; k++)
        shader.material.ambient_q16[k] = shader.material.diffuse_q16[k] = 20000;
    albedo.with = &tables;
    for (int kind = GLINT_TABLES_COLOUR; kind <= GLINT_TABLES_ALBEDO; kind++) {
        const bool can = kind == GLINT_TABLES_ALBEDO;
        assert_int_equal(glint_tables_fill(&tables, (enum glint_tables_kind)kind, &shader, memory, sizeof memory),
                         GLINT_OK);
        assert_int_equal(strip_with(&glint_mesh_tables_albedo, &albedo), can ? GLINT_OK : GLINT_ERR_ARG);
        assert_int_equal(strip_with(&glint_mesh_tables, &tables), can ? GLINT_ERR_ARG : GLINT_OK);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_picture_in_colours_is_the_same_in_strips_of_any_height_and_order),
        cmocka_unit_test(a_face_of_a_colour_has_the_pixels_of_that_albedo),
        cmocka_unit_test(vertices_of_one_colour_have_the_pixels_of_that_albedo),
        cmocka_unit_test(a_face_by_albedo_tables_has_its_colour_within_a_level),
        cmocka_unit_test(a_face_of_full_levels_has_them_in_light_that_is_ambient_alone),
        cmocka_unit_test(colours_of_vertices_are_linear_between_them),
        cmocka_unit_test(colours_that_a_path_cannot_draw_are_refused_and_nothing_is_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
