/* SPDX-License-Identifier: MIT
 * Smooth outlines: no holes, the same pixels however a picture is cut, and the box that a mesh drew. How smooth they are:
 * slow/test_mesh_outlines.c. */
#include "meshes.h"

static struct made_mesh mesh;
static uint8_t pictures[2][MESH_W * MESH_H * 4];

/* A paint of a format, by tables of a kind or exactly, under `count` lights. */
struct drawer {
    struct glint_paint paint;
    struct glint_light lights[2];
    uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4];
    unsigned bytes;
};

static const struct glint_material flat = {GLINT_MSH, 0, 30, 0, {65536, 65536, 65536}, {0}, {0}, {250, 120, 60}, true};
static const struct glint_material shiny = {
    GLINT_MSH, 0, 30, 0, {8000, 8000, 8000}, {40000, 40000, 40000}, {40000, 40000, 40000}, {200, 120, 60}, true};

static void look_set(struct drawer *look, const struct glint_material *material, enum glint_format format, bool tables,
                     unsigned count)
{
    static const int32_t to_light[2][3] = {{-1, 1, 1}, {2, 1, 1}}, to_viewer[3] = {0, 0, 1};
    const struct glint_output output = {format, GLINT_GAMMA, false};
    assert_int_equal(tables ? glint_paint_tables(&look->paint, GLINT_TABLES_COLOUR, material, &output, look->memory,
                                                 sizeof look->memory)
                            : glint_paint_exact(&look->paint, material, &output),
                     GLINT_OK);
    for (unsigned i = 0; i < count; i++)
        assert_int_equal(glint_light_directional(&look->lights[i], to_light[i]), GLINT_OK);
    assert_int_equal(glint_paint_light(&look->paint, look->lights, count, to_viewer), GLINT_OK);
    look->bytes = format == GLINT_RGB565 || format == GLINT_RGB565_SWAPPED ? 2
                  : format == GLINT_GREY8                                  ? 1
                  : format == GLINT_RGB888                                 ? 3
                                                                           : 4;
}

/* Whole, or in strips of 7 lines. */
static void picture(const struct drawer *look, unsigned which, bool in_strips, uint8_t ground)
{
    static const unsigned heights[] = {MESH_H, 7};
    memset(pictures[which], ground, sizeof pictures[which]);
    mesh_picture(&mesh, &look->paint, pictures[which], look->bytes, &heights[in_strips], 1, false);
}

static void ball(void)
{
    mesh_ball(&mesh, 14, 18);
    mesh_join(&mesh);
    mesh.pose.scale = 16 * 40;
}

static void outlines_do_not_depend_on_how_a_picture_is_cut(void **state)
{
    (void)state;
    static struct drawer look;
    static const enum glint_format formats[] = {GLINT_RGB565, GLINT_RGB565_SWAPPED, GLINT_RGB888,
                                                GLINT_GREY8,  GLINT_XRGB8888,       GLINT_ARGB8888};
    for (unsigned i = 0; i < 24; i++) {
        const enum glint_format format = formats[i % 6];
        ball();
        for (int k = 0; k < 4; k++)
            mesh.pose.turn[k] = (int16_t)(below(60000) - 30000);
        mesh.pose.position[0] = (int16_t)(below(1600) - 800);
        mesh.distance = (uint16_t)(i % 3 == 1 ? 2000 : 0);
        look_set(&look, &shiny, format, i % 6 < 2 && i < 12, 1 + i / 18);
        assert_same_in_strips(&mesh, &look.paint, look.bytes * MESH_W);
    }
}

/* Faces and neighbours at random: nothing fits anything. */
static void outlines_of_noise_do_not_depend_on_how_a_picture_is_cut(void **state)
{
    (void)state;
    static struct drawer look;
    for (unsigned i = 0; i < 300; i++) {
        mesh_noise(&mesh, 3 + below(60), 1 + below(60));
        for (unsigned k = 0; k < 3u * mesh.mesh.face_count; k++)
            mesh.neighbours[k / 3][k % 3] =
                (uint16_t)(below(3) ? below(mesh.mesh.face_count) : GLINT_MESH_SEAM + below(2));
        mesh.mesh.neighbours = mesh.neighbours[0];
        assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_OK);
        look_set(&look, &shiny, i % 2 ? GLINT_RGB565 : GLINT_RGB888, i % 2, 1);
        assert_same_in_strips(&mesh, &look.paint, look.bytes * MESH_W);
    }
}

/* Of all their edges, in any strip, so that most faces have theirs set when they are asked for. */
static void more_outlines_than_a_strip_keeps_do_not_depend_on_how_a_picture_is_cut(void **state)
{
    (void)state;
    static struct drawer look;
    for (unsigned i = 0; i < 12; i++) {
        mesh_noise(&mesh, 90, 90);
        mesh.distance = 0;
        mesh.pose.scale = 16 * 50;
        mesh.pose.position[0] = mesh.pose.position[1] = mesh.pose.position[2] = 0;
        for (unsigned v = 0; v < 90; v++) /* near the first of the face's corners */
            for (int k = 0; k < 3; k++)
                mesh.places[v][k] = (int16_t)(mesh.places[v - v % 3][k] / 2 + (int)(v % 3 ? below(8000) : 0));
        for (uint16_t f = 0; f < 90; f++)
            for (uint16_t k = 0; k < 3; k++) {
                mesh.faces[f][k] = (uint16_t)(3 * (f / 3) + (f % 3 == 2 ? k : (2 * k) % 3));
                mesh.neighbours[f][k] = GLINT_MESH_RIM;
            }
        mesh.mesh.neighbours = mesh.neighbours[0];
        look_set(&look, &shiny, i % 2 ? GLINT_RGB565 : GLINT_RGB888, i % 2, 1);
        assert_same_in_strips(&mesh, &look.paint, look.bytes * MESH_W);
    }
}

static void a_picture_without_outlines_does_not_look_at_neighbours(void **state)
{
    (void)state;
    static struct drawer look;
    static _Alignas(8) uint8_t memory[MESH_W * MESH_H * 2 + 8192];
    static uint32_t work[20000];
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    ball();
    look_set(&look, &shiny, GLINT_RGB888, false, 1);
    const struct glint_surface surface = {pictures[1], 3 * MESH_W, 0, 0};
    memset(pictures[1], 9, sizeof pictures[1]);
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, MESH_H, 0, memory, sizeof memory), GLINT_OK);
    assert_null(frame.outlines);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &look.paint, work, sizeof work), GLINT_OK);
    assert_int_equal(glint_mesh_strip(&frame, 0, MESH_H, &surface), GLINT_OK);
    mesh.mesh.neighbours = NULL;
    picture(&look, 0, false, 9);
    assert_memory_equal(pictures[0], pictures[1], sizeof pictures[0]);
    mesh.mesh.neighbours = mesh.neighbours[0];
    picture(&look, 0, false, 9);
    assert_memory_not_equal(pictures[0], pictures[1], sizeof pictures[0]);
}

/* Of one colour, over another: inside all is drawn in full, outside nothing, and what is between adds up to the disc. */
static void outlines_leave_no_hole(void **state)
{
    (void)state;
    static struct drawer look;
    look_set(&look, &flat, GLINT_GREY8, false, 0);
    for (unsigned i = 0; i < 60; i++) {
        ball();
        for (int k = 0; k < 4; k++)
            mesh.pose.turn[k] = (int16_t)(below(60000) - 30000);
        mesh.pose.scale = (uint16_t)(16 * 20 + below(16 * 23));
        picture(&look, 0, false, 0);
        const double radius = mesh.pose.scale / 16., inner = radius * .97 - 2;
        unsigned full = 0;
        double sum = 0;
        for (int p = 0; p < MESH_W * MESH_H; p++)
            full = pictures[0][p] > full ? pictures[0][p] : full;
        for (int p = 0; p < MESH_W * MESH_H; p++) {
            const double away = hypot(p % MESH_W + .5 - MESH_W / 2., p / MESH_W + .5 - MESH_H / 2.);
            sum += pictures[0][p] / (double)full;
            if (away < inner)
                assert_int_equal(pictures[0][p], full);
            if (away > radius + 1.5)
                assert_int_equal(pictures[0][p], 0);
        }
        assert_true(sum > .94 * M_PI * radius * radius && sum < 1.01 * M_PI * radius * radius);
    }
}

/* A square of two triangles whose outlines have more cells than a face may hide at a time: each edge's cells, and no more, are between. */
static void a_face_of_many_cells_is_drawn_in_pieces(void **state)
{
    (void)state;
    static struct drawer look;
    static const int16_t corners[4][3] = {
        {-32000, -30000, 0}, {32000, -30500, 0}, {31000, 30000, 0}, {-31500, 31000, 0}};
    static const uint16_t faces[2][3] = {{0, 1, 2}, {0, 2, 3}};
    look_set(&look, &flat, GLINT_GREY8, false, 0);
    memcpy(mesh.places, corners, sizeof corners);
    memcpy(mesh.faces, faces, sizeof faces);
    for (int i = 0; i < 4; i++) {
        const int16_t normal[3] = {0, 0, 32767};
        memcpy(mesh.normals[i], normal, sizeof normal);
    }
    mesh_made(&mesh, 4, 2);
    mesh_join(&mesh);
    mesh.pose.scale = 16 * 43;
    picture(&look, 0, false, 0);
    picture(&look, 1, true, 0);
    assert_memory_equal(pictures[0], pictures[1], sizeof pictures[0]);
    const uint8_t full = pictures[0][MESH_W * MESH_H / 2 + MESH_W / 2];
    unsigned between = 0;
    for (int y = 0; y < MESH_H; y++) { /* empty, one in part or, along flat edges, some, full, and back */
        const uint8_t *line = pictures[0] + MESH_W * y;
        for (int x = 0; x < MESH_W; x++)
            between += line[x] != 0 && line[x] != full;
        for (int x = 25; x < 95; x++)
            if (y > 6 && y < 83)
                assert_int_equal(line[x], full);
    }
    assert_in_range(between, 250, 340);
}

/* Two sheets side by side, whose edges do not meet: nothing is seen through between them. */
static void a_seam_has_no_outline(void **state)
{
    (void)state;
    static struct drawer look;
    static const int16_t corners[8][3] = {{-25000, -25000, 0}, {1100, -25000, 0}, {3800, 25000, 0},
                                          {-25000, 25000, 0},  {2450, 0, 0},      {25000, 0, 0},
                                          {25000, -25000, 0},  {25000, 25000, 0}};
    static const uint16_t faces[6][3] = {{0, 1, 2}, {0, 2, 3}, {1, 6, 5}, {1, 5, 4}, {4, 5, 7}, {4, 7, 2}};
    look_set(&look, &flat, GLINT_GREY8, false, 0);
    memcpy(mesh.places, corners, sizeof corners);
    memcpy(mesh.faces, faces, sizeof faces);
    for (int i = 0; i < 8; i++) {
        const int16_t normal[3] = {0, 0, 32767};
        memcpy(mesh.normals[i], normal, sizeof normal);
    }
    mesh_made(&mesh, 8, 6);
    mesh_join(&mesh);
    mesh.neighbours[0][1] = mesh.neighbours[3][2] = mesh.neighbours[5][2] = GLINT_MESH_SEAM;
    mesh.pose.scale = 16 * 43;
    picture(&look, 0, false, 0);
    for (int y = 15; y < 75; y++)
        for (int x = 40; x < 80; x++)
            assert_int_equal(pictures[0][MESH_W * y + x], pictures[0][MESH_W * MESH_H / 2 + 50]);
}

/* Draws the mesh in strips of `lines` lines, each of which changes pixels of its box alone. The boxes are at most `most` wide and begin no
 * further left than `left`. */
static void boxed_picture(const struct drawer *look, uint16_t lines, bool is_outlined, int most, int left)
{
    static _Alignas(8) uint8_t memory[MESH_W * MESH_H * 2 + 8192 + GLINT_MESH_LIGHTS_BYTES];
    static uint32_t work[20000];
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, lines, mesh.distance, memory, sizeof memory), GLINT_OK);
    frame.outlines = is_outlined ? &glint_outlines : NULL;
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &look->paint, work, sizeof work), GLINT_OK);
    for (unsigned y = 0; y < MESH_H; y += lines) {
        const unsigned h = y + lines < MESH_H ? lines : MESH_H - y;
        const struct glint_surface surface = {pictures[0] + MESH_W * y, MESH_W, 0, (uint16_t)y};
        memset(pictures[0], 1, MESH_W * MESH_H);
        assert_int_equal(glint_mesh_strip(&frame, (uint16_t)y, (uint16_t)h, &surface), GLINT_OK);
        const struct glint_box *box = &frame.box;
        assert_true(box->w == 0 || (box->y >= y && box->y + box->h <= (int)(y + h) && box->x + box->w <= MESH_W));
        for (int p = 0; p < MESH_W * MESH_H; p++)
            if (pictures[0][p] != 1)
                assert_true(p % MESH_W >= box->x && p % MESH_W < box->x + box->w && p / MESH_W >= box->y &&
                            p / MESH_W < box->y + box->h);
        assert_true(box->w == 0 || (box->w <= most && box->x >= left));
    }
}

static void all_that_a_strip_changes_lies_in_its_box(void **state)
{
    (void)state;
    static struct drawer look;
    look_set(&look, &flat, GLINT_GREY8, false, 0);
    for (unsigned i = 0; i < 200; i++) {
        if (i % 2) {
            ball();
            mesh.pose.position[0] = (int16_t)(below(3000) - 1500);
            mesh.pose.position[1] = (int16_t)(below(3000) - 1500);
        } else {
            mesh_noise(&mesh, 3 + below(60), 1 + below(60));
            mesh_join(&mesh);
        }
        /* A ball is of radius 40, within a pixel. */
        boxed_picture(&look, (uint16_t)(1 + below(MESH_H)), i & 2, i % 2 ? 82 : MESH_W,
                      i % 2 ? MESH_W / 2 - 42 + (mesh.pose.position[0] >> 4) : 0);
    }
}

/* The boxes of a picture's strips of 10 lines. */
enum { STRIPS = MESH_H / 10 };
static void boxes_of(const struct drawer *look, struct made_mesh *const shown[], unsigned count,
                     struct glint_box boxes[STRIPS])
{
    static _Alignas(8) uint8_t memory[MESH_W * MESH_H * 2 + 8192];
    static uint32_t work[2][20000];
    const struct glint_surface surface = {pictures[0], MESH_W, 0, 0};
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn[2];
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, 10, 0, memory, sizeof memory), GLINT_OK);
    for (unsigned i = 0; i < count; i++)
        assert_int_equal(
            glint_mesh_add(&frame, &drawn[i], &shown[i]->mesh, &shown[i]->pose, &look->paint, work[i], sizeof work[i]),
            GLINT_OK);
    for (unsigned i = 0; i < STRIPS; i++) {
        assert_int_equal(glint_mesh_strip(&frame, (uint16_t)(10 * i), 10, &surface), GLINT_OK);
        boxes[i] = frame.box;
    }
}

static void the_box_of_two_meshes_is_the_least_that_holds_the_boxes_of_both(void **state)
{
    (void)state;
    static struct made_mesh other;
    static struct drawer look;
    struct made_mesh *const shown[2] = {&mesh, &other};
    unsigned of_both = 0;
    look_set(&look, &flat, GLINT_GREY8, false, 0);
    for (unsigned i = 0; i < 300; i++) {
        struct glint_box boxes[3][STRIPS];
        for (unsigned k = 0; k < 2; k++) {
            mesh_ball(shown[k], 4, 5);
            shown[k]->pose.scale = (uint16_t)(16 * (1 + below(20)));
            shown[k]->pose.position[0] = (int16_t)((int)below(1600) - 800);
            shown[k]->pose.position[1] = (int16_t)((int)below(1200) - 600);
            boxes_of(&look, &shown[k], 1, boxes[k]);
        }
        boxes_of(&look, shown, 2, boxes[2]);
        for (unsigned k = 0; k < STRIPS; k++) {
            const struct glint_box a = boxes[0][k].w ? boxes[0][k] : boxes[1][k],
                                   b = boxes[1][k].w ? boxes[1][k] : boxes[0][k], *const box = &boxes[2][k];
            assert_int_equal(box->x, a.x < b.x ? a.x : b.x);
            assert_int_equal(box->y, a.y < b.y ? a.y : b.y);
            assert_int_equal(box->x + box->w, a.x + a.w > b.x + b.w ? a.x + a.w : b.x + b.w);
            assert_int_equal(box->y + box->h, a.y + a.h > b.y + b.h ? a.y + a.h : b.y + b.h);
            of_both += boxes[0][k].w && boxes[1][k].w;
        }
    }
    assert_true(of_both > 100);
}

/* Its corners within 1/16 of a pixel's side. */
static void triangle_at_sides(unsigned reach)
{
    mesh_made(&mesh, 3, 1);
    for (unsigned i = 0; i < 3; i++) {
        mesh.places[i][0] = (int16_t)(64 * ((int)below(reach) - 50) + 4 * ((int)below(3) - 1));
        mesh.places[i][1] = (int16_t)(64 * ((int)below(reach) - 40) + 4 * ((int)below(3) - 1));
        mesh.places[i][2] = 0;
        mesh.normals[i][2] = 32767;
        mesh.faces[0][i] = (uint16_t)i;
        mesh.neighbours[0][i] = GLINT_MESH_RIM;
    }
    mesh.pose.scale = 8192; /* four units are 1/16 pixel */
    mesh.mesh.neighbours = mesh.neighbours[0];
}

/* To the pixel before, where a corner lies on its side; no further. */
static void a_box_holds_what_an_outline_rounds_down_by_a_sixteenth_of_a_pixel(void **state)
{
    (void)state;
    static struct drawer look;
    look_set(&look, &flat, GLINT_GREY8, false, 0);
    for (unsigned i = 0; i < 10000; i++) {
        triangle_at_sides(i % 4 ? 90 : 550);
        int left = INT16_MAX;
        for (unsigned k = 0; k < 3; k++)
            left = mesh.places[k][0] < left ? mesh.places[k][0] : left;
        boxed_picture(&look, MESH_H, true, MESH_W, (8 * MESH_W + left / 4 - 1) >> 4);
    }
}

static void neighbours_beyond_the_faces_are_refused(void **state)
{
    (void)state;
    ball();
    assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_OK);
    mesh.neighbours[5][1] = mesh.mesh.face_count;
    assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_ERR_ARG);
    mesh.neighbours[5][1] = GLINT_MESH_SEAM;
    assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(outlines_do_not_depend_on_how_a_picture_is_cut),
        cmocka_unit_test(outlines_of_noise_do_not_depend_on_how_a_picture_is_cut),
        cmocka_unit_test(more_outlines_than_a_strip_keeps_do_not_depend_on_how_a_picture_is_cut),
        cmocka_unit_test(a_picture_without_outlines_does_not_look_at_neighbours),
        cmocka_unit_test(outlines_leave_no_hole),
        cmocka_unit_test(a_face_of_many_cells_is_drawn_in_pieces),
        cmocka_unit_test(a_seam_has_no_outline),
        cmocka_unit_test(all_that_a_strip_changes_lies_in_its_box),
        cmocka_unit_test(the_box_of_two_meshes_is_the_least_that_holds_the_boxes_of_both),
        cmocka_unit_test(a_box_holds_what_an_outline_rounds_down_by_a_sixteenth_of_a_pixel),
        cmocka_unit_test(neighbours_beyond_the_faces_are_refused),
    };
    return cmocka_run_group_tests_name("mesh edges", tests, NULL, NULL);
}
