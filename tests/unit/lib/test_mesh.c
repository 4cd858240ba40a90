/* SPDX-License-Identifier: MIT
 * Meshes: pictures that do not depend on how they are drawn, and what is refused. */
#include "meshes.h"
#include "tables_model.h"

static struct made_mesh mesh;
static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];
static const unsigned whole[] = {MESH_H}, bands[] = {16}, odd[] = {1, 7, 16, 3, 40};

static void a_picture_is_the_same_in_strips_of_any_height_and_order(void **state)
{
    (void)state;
    for (int i = 0; i < 60; i++) {
        const struct look look = random_look(GLINT_RGB888, (enum glint_space)(i & 1));
        struct glint_paint paint;
        mesh_any(&mesh, i);
        paint_of(&paint, &look);
        assert_same_in_strips(&mesh, &paint, 3 * MESH_W);
    }
}

static struct look plain_look(enum glint_format format, bool dither)
{
    struct look look = random_look(format, GLINT_GAMMA);
    if (look.material.model == GLINT_PHONG)
        look.material.model = GLINT_MSH;
    look.output.dither = dither;
    return look;
}

static void tables_draw_pixels_within_two_levels_of_the_exact_picture(void **state)
{
    (void)state;
    static uint16_t out[MESH_H * MESH_W], exactly[MESH_H * MESH_W];
    for (int i = 0; i < 12; i++) {
        struct look look = plain_look(GLINT_RGB565, false);
        struct glint_paint tables, exact;
        set_model(&look, GLINT_MSH, 60, 6);
        paint_of_tables(&tables, GLINT_TABLES_COLOUR, &look, memory);
        paint_of(&exact, &look);
        /* One square, upright to the viewer. */
        mesh_made(&mesh, 4, 2);
        static const int16_t places[4][3] = {
            {-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
        static const uint16_t faces[2][3] = {{0, 1, 2}, {0, 2, 3}};
        memcpy(mesh.places, places, sizeof places);
        memcpy(mesh.faces, faces, sizeof faces);
        for (int v = 0; v < 4; v++) {
            const struct glint_vec n = random_normal(&look);
            mesh.normals[v][0] = (int16_t)(n.x / 8);
            mesh.normals[v][1] = (int16_t)(n.y / 8);
            mesh.normals[v][2] = 32000;
        }
        memset(out, GUARD, sizeof out);
        memset(exactly, GUARD, sizeof exactly);
        mesh_picture(&mesh, &tables, (uint8_t *)out, 2, odd, 5, false);
        mesh_picture(&mesh, &exact, (uint8_t *)exactly, 2, odd, 5, false);
        for (unsigned p = 0; p < MESH_W * MESH_H; p++) { /* where there is no surface neither writes */
            const unsigned x = out[p], y = exactly[p];
            assert_in_range((x >> 11) - (y >> 11) + 2, 0, 4);
            assert_in_range((x >> 5 & 63) - (y >> 5 & 63) + 3, 0, 6);
            assert_in_range((x & 31) - (y & 31) + 2, 0, 4);
        }
    }
}

/* At odd addresses, where nothing is fused, and at even ones. */
static void colour_tables_draw_the_same_pixels_at_any_address(void **state)
{
    (void)state;
    _Alignas(4) static uint8_t even[2 * MESH_H * MESH_W + 2], uneven[2 * MESH_H * MESH_W + 2];
    for (int i = 0; i < 60; i++) {
        const struct look look = plain_look(i & 1 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED, i & 2);
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
        mesh_any(&mesh, i);
        memset(even, GUARD, sizeof even);
        memset(uneven, GUARD, sizeof uneven);
        mesh_picture(&mesh, &paint, even, 2, bands, 1, false);
        mesh_picture(&mesh, &paint, uneven + 1, 2, bands, 1, false);
        assert_memory_equal(even, uneven + 1, sizeof even - 2);
    }
}

static void dithered_tables_draw_the_same_picture_in_strips(void **state)
{
    (void)state;
    static uint16_t one[MESH_H][MESH_W], plain[MESH_H][MESH_W];
    unsigned different = 0;
    for (int i = 0; i < 20; i++) {
        struct look look = plain_look(i & 1 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED, false);
        mesh_ball(&mesh, 4 + below(8), 5 + below(8));
        for (int dither = 0; dither < 2; dither++) {
            uint16_t *const picture = dither ? &one[0][0] : &plain[0][0];
            struct glint_paint paint;
            look.output.dither = dither;
            paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
            memset(picture, GUARD, sizeof one);
            mesh_picture(&mesh, &paint, (uint8_t *)picture, 2, whole, 1, false);
            assert_same_in_strips(&mesh, &paint, 2 * MESH_W);
        }
        for (unsigned p = 0; p < MESH_W * MESH_H; p++)
            different += (&one[0][0])[p] != (&plain[0][0])[p];
    }
    assert_true(different > 1000); /* it is dithered */
}

/* A line of the face begins with its first pixel, t and nl are those of the corners: a span over the whole line. */
static void a_row_is_the_span_of_its_normals_by_every_paint(void **state)
{
    (void)state;
    static uint8_t out[MESH_H * MESH_W * 4], line[MESH_W * 4 + 1];
    static const int16_t places[3][3] = {{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}};
    for (int i = 0; i < 160; i++) {
        const bool tables = i % 4 == 3;
        struct look look = plain_look(tables ? (enum glint_format)below(2) : format_number(i), below(2));
        const unsigned bytes = bytes_of((enum glint_format)look.output.format, 1);
        struct glint_paint paint;
        if (pixel_bits((enum glint_format)look.output.format) < 8)
            continue;
        if (tables)
            paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
        else
            paint_of(&paint, &look);
        if (!tables && below(2)) { /* coloured, or none */
            for (int k = 0; k < 3; k++)
                look.light.color_q16[k] = below(1 << 18);
            assert_int_equal(glint_paint_light(&paint, &look.light, below(4) != 0, in_front), GLINT_OK);
        }
        const struct glint_vec n = random_normal(&look);
        const int64_t x = n.x - look.h.x, y = n.y - look.h.y, z = n.z - look.h.z;
        const struct glint_span span = {(uint32_t)((x * x >> 1) + (y * y >> 1) + (z * z >> 1)),
                                        0,
                                        0,
                                        (int32_t)dot(n, look.l),
                                        0,
                                        MESH_W,
                                        {{0, 0}, {0, 0}}};
        if (span.t_q30 >= UINT32_C(1) << 31)
            continue;
        mesh_made(&mesh, 3, 1);
        for (int v = 0; v < 3; v++) {
            const int16_t normal[3] = {n.x, n.y, n.z};
            memcpy(mesh.places[v], places[v], sizeof places[v]);
            memcpy(mesh.normals[v], normal, sizeof normal);
            mesh.faces[0][v] = (uint16_t)v;
        }
        mesh.pose.scale = 32768; /* all of the picture is in it */
        mesh.distance = (uint16_t)(i & 1 ? 2000 : 0);
        memset(out, GUARD, sizeof out);
        mesh_picture(&mesh, &paint, out, bytes, odd, 5, false);
        for (unsigned down = 0; down < MESH_H; down++) {
            const struct glint_surface surface = {line + (i & 1), 0, 0, (uint16_t)down};
            memset(line, GUARD, sizeof line);
            assert_int_equal(glint_draw_span(&paint, &span, NULL, &surface, NULL), GLINT_OK);
            assert_memory_equal(out + down * MESH_W * bytes, line + (i & 1), MESH_W * bytes);
        }
    }
}

/* Beyond 2047 pixels from z = 0 all are equally near. */
static void the_nearer_hides_the_farther_and_the_first_of_two_stays(void **state)
{
    (void)state;
    static uint16_t out[MESH_H * MESH_W];
    static const struct {
        int16_t depths[2], position;
        bool first_is_seen;
    } cases[] = {{{0, 100}, 0, false},          {{100, 0}, 0, true},       {{50, 50}, 0, true},
                 {{-20000, 20000}, 0, false},   {{0, 20000}, 32767, true}, {{-20000, -100}, -32767, true},
                 {{-20000, 100}, -32767, false}};
    struct glint_paint paints[2];
    struct look look = random_look(GLINT_RGB565, GLINT_GAMMA);
    set_model(&look, GLINT_MSH, 10, 6);
    look.output.dither = false;
    const uint16_t ends[2] = {1, 2};
    for (int i = 0; i < 2; i++) { /* flat colours: ambient only */
        for (int k = 0; k < 3; k++) {
            look.material.ambient_q16[k] = i ? 65536 : 0;
            look.material.diffuse_q16[k] = look.material.specular_q16[k] = 0;
            look.material.albedo[k] = 255;
        }
        paint_of(&paints[i], &look);
    }
    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
        mesh_made(&mesh, 6, 2);
        mesh.pose.position[2] = cases[i].position;
        mesh.mesh.ends = ends;
        mesh.mesh.part_count = 2;
        for (int v = 0; v < 6; v++) {
            mesh.places[v][0] = (int16_t)(v % 3 == 1 ? 30000 : -30000);
            mesh.places[v][1] = (int16_t)(v % 3 == 2 ? 30000 : -30000);
            mesh.places[v][2] = cases[i].depths[v / 3];
            mesh.normals[v][2] = 32767;
            mesh.normals[v][0] = mesh.normals[v][1] = 0;
            mesh.faces[v / 3][v % 3] = (uint16_t)v;
        }
        memset(out, GUARD, sizeof out);
        mesh_picture(&mesh, paints, (uint8_t *)out, 2, i & 1 ? bands : odd, i & 1 ? 1 : 5, i & 2);
        assert_int_equal(out[MESH_W * (MESH_H / 2 + 10) + MESH_W / 2 - 10], cases[i].first_is_seen ? 0 : 0xffff);
    }
}

static void whatever_a_mesh_holds_nothing_outside_the_strip_is_written(void **state)
{
    (void)state;
    static uint8_t out[MESH_H * MESH_W * 4 + 2];
    for (int i = 0; i < 300; i++) {
        const enum glint_format format = format_number(i);
        const struct look look = random_look(format, (enum glint_space)(i & 1));
        struct glint_paint paint;
        paint_of(&paint, &look);
        mesh_noise(&mesh, 3 + below(60), 1 + below(60));
        memset(out, GUARD, sizeof out);
        const unsigned line = bytes_of(format, MESH_W), height = 1 + below(20), y = below(MESH_H - height);
        static _Alignas(8) uint8_t depths[MESH_W * 21 * 2 + 4096 + GLINT_MESH_LIGHTS_BYTES];
        static uint32_t work[4000];
        struct glint_mesh_frame frame;
        struct glint_mesh_drawn drawn;
        assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, 20, mesh.distance, depths,
                                          glint_mesh_frame_bytes(MESH_W, 20) + GLINT_MESH_LIGHTS_BYTES),
                         GLINT_OK);
        assert_int_equal(
            glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, glint_mesh_bytes(&mesh.mesh, MESH_H)),
            GLINT_OK);
        const struct glint_surface surface = {out + 1, (ptrdiff_t)line, 0, (uint16_t)y};
        assert_int_equal(glint_mesh_strip(&frame, (uint16_t)y, (uint16_t)height, &surface), GLINT_OK);
        assert_int_equal(out[0], GUARD);
        for (size_t p = 1 + (size_t)line * height; p < sizeof out; p++)
            assert_int_equal(out[p], GUARD);
    }
}

/* On 64-bit machines, too, whose pointers ask for 8. */
static void memory_at_any_multiple_of_4_is_taken(void **state)
{
    (void)state;
    static uint8_t wanted[MESH_H * MESH_W * 3], out[MESH_H * MESH_W * 3];
    static _Alignas(8) uint8_t frame_memory[MESH_W * MESH_H * 2 + 4096], work[MESH_VERTICES * 20];
    const struct look look = plain_look(GLINT_RGB888, false);
    const struct glint_surface surface = {out, 3 * MESH_W, 0, 0};
    struct glint_paint paint;
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    paint_of(&paint, &look);
    for (int i = 0; i < 40; i++) {
        mesh_any(&mesh, i);
        memset(wanted, GUARD, sizeof wanted);
        memset(out, GUARD, sizeof out);
        mesh_picture(&mesh, &paint, wanted, 3, whole, 1, false);
        memset(frame_memory, GUARD, sizeof frame_memory);
        memset(work, GUARD, sizeof work);
        uint8_t *of_frame = frame_memory + 4 * (i & 1), *of_mesh = work + 4 * (i >> 1 & 1);
        const size_t frame_bytes = glint_mesh_frame_bytes(MESH_W, MESH_H),
                     mesh_bytes = glint_mesh_bytes(&mesh.mesh, MESH_H);
        assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, MESH_H, mesh.distance, of_frame, frame_bytes),
                         GLINT_OK);
        assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, of_mesh, mesh_bytes), GLINT_OK);
        assert_int_equal(glint_mesh_strip(&frame, 0, MESH_H, &surface), GLINT_OK);
        assert_memory_equal(out, wanted, sizeof out);
        assert_int_equal(of_frame[frame_bytes], GUARD);
        assert_int_equal(of_mesh[mesh_bytes], GUARD);
    }
}

static void normals_of_8_bits_draw_what_their_258_folds_draw(void **state)
{
    (void)state;
    static int8_t normals8[MESH_VERTICES][3];
    static uint8_t one[MESH_H][MESH_W][3], other[MESH_H][MESH_W][3];
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    struct glint_paint paint;
    set_model(&look, GLINT_MSH, 60, 8);
    paint_of(&paint, &look);
    mesh_ball(&mesh, 8, 9);
    for (unsigned v = 0; v < mesh.mesh.vertex_count; v++)
        for (int k = 0; k < 3; k++) {
            normals8[v][k] = (int8_t)(mesh.normals[v][k] / 258);
            mesh.normals[v][k] = (int16_t)(normals8[v][k] * 258);
        }
    memset(one, GUARD, sizeof one);
    memset(other, GUARD, sizeof other);
    mesh_picture(&mesh, &paint, &one[0][0][0], 3, whole, 1, false);
    mesh.mesh.normals = NULL;
    mesh.mesh.normals8 = &normals8[0][0];
    assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_OK);
    mesh_picture(&mesh, &paint, &other[0][0][0], 3, whole, 1, false);
    assert_memory_equal(one, other, sizeof one);
}

/* Of an odd number of bytes: every other line is not aligned. */
static void colour_tables_draw_lines_at_any_stride(void **state)
{
    (void)state;
    enum { STRIDE = 2 * MESH_W + 1 };
    static uint32_t depths[8000], work[8000];
    static uint8_t even[MESH_H][2 * MESH_W], apart[MESH_H * STRIDE + 1];
    struct look look = plain_look(GLINT_RGB565, false);
    struct glint_paint paint;
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    set_model(&look, GLINT_MSH, 60, 8);
    paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
    mesh_ball(&mesh, 6, 8);
    memset(even, GUARD, sizeof even);
    memset(apart, GUARD, sizeof apart);
    mesh_picture(&mesh, &paint, &even[0][0], 2, whole, 1, false);
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, MESH_H, 0, depths, sizeof depths), GLINT_OK);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, sizeof work), GLINT_OK);
    const struct glint_surface surface = {apart, STRIDE, 0, 0};
    assert_int_equal(glint_mesh_strip(&frame, 0, MESH_H, &surface), GLINT_OK);
    for (unsigned y = 0; y < MESH_H; y++)
        assert_memory_equal(apart + y * STRIDE, even[y], sizeof even[y]);
}

static void wrong_arguments_are_refused_and_nothing_is_drawn(void **state)
{
    (void)state;
    static uint32_t depths[8000], work[8000];
    uint8_t out[17 * MESH_W * 3];
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    struct glint_paint paint;
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    set_model(&look, GLINT_MSH, 60, 8);
    paint_of(&paint, &look);
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
    static const uint8_t colour[3] = {0, 0, 0};
    struct glint_mesh one = {.places = mesh.mesh.places,
                             .normals = mesh.mesh.normals,
                             .faces = face,
                             .vertex_count = 1,
                             .face_count = 1,
                             .of_vertices = colour};
    assert_int_equal(glint_mesh_check(&one), GLINT_OK);
    one.of_faces = colour; /* one of them at most */
    assert_int_equal(glint_mesh_check(&one), GLINT_ERR_ARG);
    one.of_vertices = NULL;
    assert_int_equal(glint_mesh_check(&one), GLINT_OK);
    one.normals = NULL;
    one.normals8 = lowest;
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
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, mesh_need - 1),
                     GLINT_ERR_ARG);
    bad = mesh.mesh;
    bad.vertex_count = 0;
    assert_int_equal(glint_mesh_add(&frame, &drawn, &bad, &mesh.pose, &paint, work, sizeof work), GLINT_ERR_ARG);
    struct glint_pose no_turn = mesh.pose;
    memset(no_turn.turn, 0, sizeof no_turn.turn);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &no_turn, &paint, work, mesh_need), GLINT_ERR_VECTOR);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, mesh_need), GLINT_OK);
    memset(out, GUARD, sizeof out);
    const struct glint_surface surface = {out, 3 * MESH_W, 0, 0};
    assert_int_equal(glint_mesh_strip(&frame, 0, 17, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_strip(&frame, MESH_H - 8, 9, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_strip(&frame, 0, 0, &surface), GLINT_ERR_ARG);
    for (int sign = -1; sign <= 1; sign += 2)
        for (int stride = 0; stride < 3 * MESH_W; stride += 3 * MESH_W - 1) {
            const struct glint_surface narrow = {out, sign * stride, 0, 0};
            assert_int_equal(glint_mesh_strip(&frame, 40, 2, &narrow), GLINT_ERR_ARG);
        }
    for (size_t i = 0; i < sizeof out; i++)
        assert_int_equal(out[i], GUARD);
    const struct glint_surface of_one = {out, 0, 0, 0};
    assert_int_equal(glint_mesh_strip(&frame, 45, 1, &of_one), GLINT_OK); /* of one line it is not looked at */
    assert_int_not_equal(out[3 * MESH_W / 2], GUARD);
}

/* ---- Its paints ---- */

static enum glint_err added(const struct glint_paint *paints, unsigned count, bool coloured, bool with_room)
{
    static _Alignas(8) uint8_t frame_memory[MESH_W * 16 * 2 + 4096 + GLINT_MESH_LIGHTS_BYTES];
    static uint32_t work[8000];
    static const uint8_t colours[3 * MESH_VERTICES] = {1, 2, 3};
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    uint16_t ends[3];
    mesh_ball(&mesh, 6, 8);
    for (unsigned i = 0; i < count; i++)
        ends[i] = (uint16_t)(i + 1 < count ? 10 * (i + 1) : mesh.mesh.face_count);
    mesh.mesh.ends = ends;
    mesh.mesh.part_count = (uint8_t)count;
    mesh.mesh.of_vertices = coloured ? colours : NULL;
    const size_t room = with_room ? GLINT_MESH_LIGHTS_BYTES : GLINT_MESH_LIGHTS_BYTES - 1;
    assert_int_equal(
        glint_mesh_begin(&frame, MESH_W, MESH_H, 16, 0, frame_memory, glint_mesh_frame_bytes(MESH_W, 16) + room),
        GLINT_OK);
    return glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, paints, work, sizeof work);
}

/* Lights paint so that L is that of `of`, and H is not. */
static bool lit_with_another_half(struct glint_paint *paint, const struct glint_paint *of,
                                  const struct glint_light *light)
{
    for (int i = 0; i < 1000; i++) {
        struct glint_light other = *light;
        other.direction_q30[below(3)] += (int32_t)below(20001) - 10000;
        assert_int_equal(glint_paint_light(paint, &other, 1, in_front), GLINT_OK);
        if (!memcmp(&paint->l, &of->l, sizeof of->l) && memcmp(&paint->h, &of->h, sizeof of->h))
            return true;
    }
    return false;
}

static void paints_that_are_not_there_not_lit_or_lit_otherwise_are_refused(void **state)
{
    (void)state;
    const int32_t aside[3] = {1, 0, 2}, place[3] = {100, 100, 900};
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    struct glint_paint paints[3];
    struct glint_light of_other[2], several[2];
    set_model(&look, GLINT_MSH, 60, 8);
    for (int i = 0; i < 3; i++)
        paint_of(&paints[i], &look);
    assert_int_equal(added(paints, 3, false, false), GLINT_OK);
    for (int i = 0; i < 3; i++) {
        struct glint_paint bad[3];
        const struct glint_paint none = {0};
        memcpy(bad, paints, sizeof bad);
        bad[i] = none;
        assert_int_equal(added(bad, 3, false, true), GLINT_ERR_ARG);
        assert_int_equal(glint_paint_exact(&bad[i], &look.material, &look.output), GLINT_OK); /* never lit */
        assert_int_equal(added(bad, 3, false, true), GLINT_ERR_ARG);
        assert_int_equal(glint_paint_light(&bad[i], &look.light, 1, aside), GLINT_OK); /* seen from elsewhere */
        assert_int_equal(added(bad, 3, false, true), GLINT_ERR_ARG);
        assert_int_equal(glint_light_directional(&of_other[0], aside), GLINT_OK);
        assert_int_equal(glint_paint_light(&bad[i], of_other, 1, in_front), GLINT_OK);
        assert_int_equal(added(bad, 3, false, true), GLINT_ERR_ARG);
        for (int k = 0; k < 3; k++) {
            of_other[0] = look.light;
            of_other[0].color_q16[k]++;
            assert_int_equal(glint_paint_light(&bad[i], of_other, 1, in_front), GLINT_OK);
            assert_int_equal(added(bad, 3, false, true), GLINT_ERR_ARG);
        }
        assert_int_equal(glint_paint_light(&bad[i], NULL, 0, in_front), GLINT_OK);
        assert_int_equal(added(bad, 3, false, true), GLINT_ERR_ARG);
        assert_true(lit_with_another_half(&bad[i], &paints[0], &look.light));
        assert_int_equal(added(bad, 3, false, true), GLINT_ERR_ARG);
        assert_int_equal(glint_light_point(&of_other[0], place, 2000), GLINT_OK); /* one, too */
        assert_int_equal(glint_paint_light(&bad[i], of_other, 1, in_front), GLINT_OK);
        assert_int_equal(added(bad, 3, false, true), GLINT_ERR_ARG);
        of_other[0] = of_other[1] = look.light;
        assert_int_equal(glint_paint_light(&bad[i], of_other, 2, in_front), GLINT_OK);
        assert_int_equal(added(bad, 3, false, true), GLINT_ERR_ARG);
        assert_int_equal(glint_paint_light(&bad[i], &look.light, 1, in_front), GLINT_OK); /* and like the others */
        assert_int_equal(added(bad, 3, false, true), GLINT_OK);
    }
    several[0] = look.light;
    assert_int_equal(glint_light_point(&several[1], place, 2000), GLINT_OK);
    memcpy(of_other, several, sizeof several);
    of_other[1].range++;
    for (int i = 0; i < 3; i++)
        assert_int_equal(glint_paint_light(&paints[i], several, 2, in_front), GLINT_OK);
    assert_int_equal(added(paints, 3, false, true), GLINT_OK);
    assert_int_equal(glint_paint_light(&paints[1], of_other, 2, in_front), GLINT_OK);
    assert_int_equal(added(paints, 3, false, true), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_light(&paints[1], several, 1, in_front), GLINT_OK);
    assert_int_equal(added(paints, 3, false, true), GLINT_ERR_ARG);
}

static void lights_and_phong_need_room_and_others_do_not(void **state)
{
    (void)state;
    const int32_t place[3] = {100, 100, 900}, target[3] = {0, 0, 0};
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    for (int model = 0; model < GLINT_MODEL_COUNT; model++) {
        const enum glint_err by_one = model == GLINT_PHONG ? GLINT_ERR_ARG : GLINT_OK;
        struct glint_paint paint;
        struct glint_light lights[2];
        set_model(&look, (enum glint_model)model, 60, 8);
        paint_of(&paint, &look);
        assert_int_equal(added(&paint, 1, false, false), by_one);
        assert_int_equal(added(&paint, 1, true, false), by_one);
        assert_int_equal(added(&paint, 1, model & 1, true), GLINT_OK);
        assert_int_equal(glint_paint_light(&paint, NULL, 0, in_front), GLINT_OK);
        assert_int_equal(added(&paint, 1, false, false), by_one);
        lights[0] = lights[1] = look.light;
        for (int kind = 0; kind < 3; kind++) {
            if (kind == 1)
                assert_int_equal(glint_light_point(lights, place, 2000), GLINT_OK);
            if (kind == 2)
                assert_int_equal(glint_light_spot(lights, place, target, 2000, 1 << 30, 0), GLINT_OK);
            assert_int_equal(glint_paint_light(&paint, lights, kind ? 1 : 2, in_front), GLINT_OK);
            assert_int_equal(added(&paint, 1, false, false), GLINT_ERR_ARG);
            assert_int_equal(added(&paint, 1, true, true), GLINT_OK);
        }
    }
}

static void tables_take_colours_of_the_mesh_if_they_are_albedo_tables_and_need_them_then(void **state)
{
    (void)state;
    static uint32_t other_memory[GLINT_TABLES_ALBEDO_BYTES / 4];
    struct look look = plain_look(GLINT_RGB565, false);
    struct glint_paint colour, albedo, mixed[2];
    make_grey(&look, 6000, 50000);
    paint_of_tables(&colour, GLINT_TABLES_COLOUR, &look, memory);
    paint_of_tables(&albedo, GLINT_TABLES_ALBEDO, &look, other_memory);
    assert_int_equal(added(&colour, 1, false, false), GLINT_OK);
    assert_int_equal(added(&colour, 1, true, false), GLINT_ERR_ARG);
    assert_int_equal(added(&albedo, 1, false, false), GLINT_ERR_ARG);
    assert_int_equal(added(&albedo, 1, true, false), GLINT_OK);
    mixed[0] = albedo; /* parts of any paints */
    paint_of(&mixed[1], &look);
    assert_int_equal(added(mixed, 2, true, false), GLINT_OK);
    mixed[0] = colour;
    assert_int_equal(added(mixed, 2, false, false), GLINT_OK);
    assert_int_equal(added(mixed, 2, true, false), GLINT_ERR_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_picture_is_the_same_in_strips_of_any_height_and_order),
        cmocka_unit_test(tables_draw_pixels_within_two_levels_of_the_exact_picture),
        cmocka_unit_test(colour_tables_draw_the_same_pixels_at_any_address),
        cmocka_unit_test(dithered_tables_draw_the_same_picture_in_strips),
        cmocka_unit_test(a_row_is_the_span_of_its_normals_by_every_paint),
        cmocka_unit_test(the_nearer_hides_the_farther_and_the_first_of_two_stays),
        cmocka_unit_test(whatever_a_mesh_holds_nothing_outside_the_strip_is_written),
        cmocka_unit_test(memory_at_any_multiple_of_4_is_taken),
        cmocka_unit_test(normals_of_8_bits_draw_what_their_258_folds_draw),
        cmocka_unit_test(colour_tables_draw_lines_at_any_stride),
        cmocka_unit_test(wrong_arguments_are_refused_and_nothing_is_drawn),
        cmocka_unit_test(paints_that_are_not_there_not_lit_or_lit_otherwise_are_refused),
        cmocka_unit_test(lights_and_phong_need_room_and_others_do_not),
        cmocka_unit_test(tables_take_colours_of_the_mesh_if_they_are_albedo_tables_and_need_them_then),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
