/* SPDX-License-Identifier: MIT
 * What is quick, counted and not timed: fused loops draw what they can, and few pixels are left to the 64-bit sequence. */
#include "lamps.h"
#include "mesh_colours.h"

#include "glint_mesh_edges.h"
#include "glint_mesh_strip.h"
#include "glint_mesh_texture.h"
#include "glint_pixel.h"

static unsigned quick, slow;

static void count_lines(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                        const struct glint_mesh_target *target, const struct glint_texture *texture)
{
    quick++;
    glint_use_mesh_albedo.lines(tables, triangle, target, texture);
}

static void count_rgb565(struct glint_mesh_over *over, int32_t x, uint8_t *out, unsigned count)
{
    slow++;
    glint_use_mesh_albedo.rgb565(over, x, out, count);
}

static void triangles_in_one_strip_are_drawn_by_the_fused_lines_of_albedo_tables(void **state)
{
    (void)state;
    static struct made_mesh mesh;
    static uint32_t memory[GLINT_TABLES_ALBEDO_BYTES / 4];
    static uint16_t out[MESH_H * MESH_W];
    static const unsigned whole[] = {MESH_H};
    const struct look look = bare(GLINT_RGB565);
    struct glint_use_mesh counted = glint_use_mesh_albedo;
    struct glint_paint paint;
    paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
    counted.lines = count_lines;
    counted.rgb565 = count_rgb565;
    mesh_ball(&mesh, 5, 9);
    colour_at_random(&mesh);
    mesh.mesh.of_vertices = &mesh.colours[0][0];
    mesh.mesh.use = &counted;
    quick = slow = 0;
    mesh_picture(&mesh, &paint, (uint8_t *)out, 2, whole, 1, false);
    assert_in_range(quick, 20, mesh.mesh.face_count);
    assert_int_equal(slow, 0);
}

static void (*rows_between_outlines)(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                                     const struct glint_mesh_target *strip);

static void count_rows(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                       const struct glint_mesh_target *strip)
{
    slow++;
    rows_between_outlines(paint, triangle, strip);
}

static void count_outlined(struct glint_mesh_target *strip)
{
    glint_outlines.begin(strip);
    rows_between_outlines = strip->rows;
    strip->rows = count_rows;
}

static void tables_draw_faces_that_no_outline_cuts_without_asking_for_cells(void **state)
{
    (void)state;
    static struct made_mesh mesh;
    static uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4], work[20000];
    static uint16_t out[MESH_H * MESH_W];
    static _Alignas(8) uint8_t memory[MESH_W * MESH_H * 2 + 8192];
    const struct look look = bare(GLINT_RGB565);
    const struct glint_surface surface = {.pixels = out, .stride = 2 * MESH_W};
    struct glint_use_outlines counted = glint_outlines;
    counted.begin = count_outlined;
    mesh_ball(&mesh, 14, 18);
    mesh_join(&mesh);
    mesh.pose.scale = 16 * 40;
    colour_at_random(&mesh);
    mesh.mesh.use = &glint_use_mesh_albedo;
    for (unsigned kind = 0; kind < 2; kind++) {
        struct glint_mesh_frame frame;
        struct glint_mesh_drawn drawn;
        struct glint_paint paint;
        mesh.mesh.of_vertices = kind ? &mesh.colours[0][0] : NULL;
        paint_of_tables(&paint, kind ? GLINT_TABLES_ALBEDO : GLINT_TABLES_COLOUR, &look, tables);
        assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, MESH_H, 0, memory, sizeof memory), GLINT_OK);
        frame.outlines = &counted;
        assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, sizeof work), GLINT_OK);
        slow = 0;
        assert_int_equal(glint_mesh_strip(&frame, 0, MESH_H, &surface), GLINT_OK);
        unsigned cut = 0;
        for (unsigned i = 0; i < mesh.mesh.face_count; i++)
            cut += (drawn.edges[i] & GLINT_EDGES_ASK) != 0;
        assert_in_range(cut, 20, mesh.mesh.face_count / 2);
        assert_in_range(slow, 1, cut);
    }
}

static const struct glint_use_model *counted_model;

static void count_shine(const struct glint_paint *paint, struct glint_sample *samples, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        (*(samples[i].t_q30 == GLINT_MESH_FAR_T ? &quick : &slow))++;
    counted_model->run(paint, samples, count);
}

static void draw_no_rows(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                         const struct glint_mesh_target *strip)
{
    (void)paint, (void)triangle, (void)strip;
}

static void begin_without_rows(struct glint_mesh_target *strip)
{
    glint_outlines.begin(strip);
    strip->rows = draw_no_rows;
}

/* Of a triangle whose normals lean outwards by so much, the light and the viewer in front. */
static void count_outlines_that_shine(double degrees)
{
    static const int16_t places[3][3] = {{-20000, -15000, 0}, {20000, -15000, 0}, {0, 20000, 0}};
    static struct made_mesh mesh;
    static uint8_t out[3 * MESH_H * MESH_W];
    static uint32_t work[2000];
    static _Alignas(8) uint8_t memory[MESH_W * MESH_H * 2 + 8192];
    const struct glint_surface surface = {.pixels = out, .stride = 3 * MESH_W};
    struct look look = bare(GLINT_RGB888);
    struct glint_use_outlines counted = glint_outlines;
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    struct glint_paint paint;
    mesh_made(&mesh, 3, 1);
    for (uint16_t i = 0; i < 3; i++) {
        const double lean = degrees * acos(-1) / 180, towards = (i * 120 - 150) * acos(-1) / 180;
        memcpy(mesh.places[i], places[i], sizeof places[i]);
        mesh.normals[i][0] = (int16_t)lrint(32767 * sin(lean) * cos(towards));
        mesh.normals[i][1] = (int16_t)lrint(32767 * sin(lean) * sin(towards));
        mesh.normals[i][2] = (int16_t)lrint(32767 * cos(lean));
        mesh.faces[0][i] = i;
        mesh.neighbours[0][i] = GLINT_MESH_RIM;
    }
    mesh.mesh.neighbours = mesh.neighbours[0];
    set_model(&look, GLINT_MSH, 1000, 8);
    assert_int_equal(look_light(&look, in_front, in_front), GLINT_OK);
    paint_of(&paint, &look);
    counted_model = paint.model;
    struct glint_use_model shine = *paint.model;
    shine.run = count_shine;
    paint.model = &shine;
    counted.begin = begin_without_rows;
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, MESH_H, 0, memory, sizeof memory), GLINT_OK);
    frame.outlines = &counted;
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, sizeof work), GLINT_OK);
    quick = slow = 0;
    assert_int_equal(glint_mesh_strip(&frame, 0, MESH_H, &surface), GLINT_OK);
    assert_in_range(quick + slow, 100, 400);
}

/* Between normals so far apart t might dip by more than that (sequence.md), and yet it does not reach the highlight. */
static void an_outline_whose_ends_are_a_half_beyond_the_highlight_has_no_t(void **state)
{
    (void)state;
    count_outlines_that_shine(62);
    assert_int_equal(slow, 0);
    count_outlines_that_shine(55);
    assert_int_equal(quick, 0);
}

/* Of a triangle whose steep edge ends in the line above its last outline, which goes on from there to the right. */
static void an_outline_asks_no_other_of_its_face_that_ends_before_it(void **state)
{
    (void)state;
    static const double places[3][2] = {{90, 40.2}, {14.3, 2.1}, {10.3, 20.4}}; /* pixels */
    static struct made_mesh mesh;
    static uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4], work[2000];
    static uint16_t out[MESH_H * MESH_W];
    static _Alignas(8) uint8_t memory[MESH_W * MESH_H * 2 + 8192];
    const struct glint_surface surface = {.pixels = out, .stride = 2 * MESH_W};
    const struct look look = bare(GLINT_RGB565);
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    struct glint_paint paint;
    mesh_made(&mesh, 3, 1);
    mesh.pose.scale = 8192; /* 64 units are a pixel */
    for (uint16_t i = 0; i < 3; i++) {
        mesh.places[i][0] = (int16_t)lrint(64 * (places[i][0] - MESH_W / 2));
        mesh.places[i][1] = (int16_t)lrint(64 * (MESH_H / 2 - places[i][1]));
        mesh.normals[i][2] = 32767;
        mesh.faces[0][i] = i;
        mesh.neighbours[0][i] = GLINT_MESH_RIM;
    }
    mesh.mesh.neighbours = mesh.neighbours[0];
    paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, tables);
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, MESH_H, 0, memory, sizeof memory), GLINT_OK);
    frame.outlines = &glint_outlines;
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, sizeof work), GLINT_OK);
    assert_int_equal(glint_mesh_strip(&frame, 0, MESH_H, &surface), GLINT_OK);
    assert_int_equal(drawn.outlines->of.cells.others, 1);
}

static const struct glint_use_format *counted_format;

static void count_exact(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                        const struct glint_sample *sums, unsigned apart)
{
    slow++;
    counted_format->exact(paint, run, i, sums, apart);
}

/* A normal that is longer than 1 has N.L of all of 1.0. */
static void where_a_coloured_lamp_shines_in_full_32_bits_decide(void **state)
{
    (void)state;
    enum { COUNT = 64 };
    static struct glint_vec normals[COUNT];
    static uint8_t out[3 * COUNT];
    const struct look look = bare(GLINT_RGB888);
    struct glint_paint paint;
    static const int32_t position[3] = {8 * COUNT, 0, 2000};
    struct glint_light lamp;
    assert_int_equal(glint_light_point(&lamp, position, GLINT_LIGHT_FAR), GLINT_OK);
    lamp.color_q16[1] = 40000;
    assert_int_equal(glint_paint_exact(&paint, &look.material, &look.output), GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, &lamp, 1, in_front), GLINT_OK);
    struct glint_use_format counted = *paint.format;
    counted_format = paint.format;
    counted.exact = count_exact;
    paint.format = &counted;
    for (unsigned i = 0; i < COUNT; i++)
        normals[i] = (struct glint_vec){32767, 32767, 32767};
    const struct glint_maps maps = {.normals = normals};
    const struct glint_surface surface = {.pixels = out, .stride = sizeof out};
    slow = 0;
    assert_int_equal(glint_draw_rect(&paint, &maps, COUNT, 1, &surface, NULL), GLINT_OK);
    assert_int_equal(slow, 0);
}

/* What is diffuse is so dim that it is doubled and N.L halved. F, of two lights a sum of 1.0 .. 2.0, is not, and there is room for it. */
static void where_two_lights_shine_on_a_dim_material_32_bits_decide(void **state)
{
    (void)state;
    enum { COUNT = 64 };
    static struct glint_vec normals[COUNT];
    static uint8_t out[3 * COUNT];
    struct look look = bare(GLINT_RGB888);
    struct glint_paint paint;
    set_model(&look, GLINT_MSH, 10, 8);
    assert_int_equal(look_light(&look, in_front, in_front), GLINT_OK);
    for (int k = 0; k < 3; k++) {
        look.material.diffuse_q16[k] = 1000;
        look.material.specular_q16[k] = 65536;
        look.material.ambient_q16[k] = 0;
    }
    const struct glint_light lights[2] = {look.light, look.light};
    assert_int_equal(glint_paint_exact(&paint, &look.material, &look.output), GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, lights, 2, in_front), GLINT_OK);
    struct glint_use_format counted = *paint.format;
    counted_format = paint.format;
    counted.exact = count_exact;
    paint.format = &counted;
    for (int32_t i = 0; i < COUNT; i++)
        assert_int_equal(glint_vec_normalize(&normals[i], (const int32_t[]){100 + i, 0, 600}), GLINT_OK);
    const struct glint_maps maps = {.normals = normals};
    const struct glint_surface surface = {.pixels = out, .stride = sizeof out};
    slow = 0;
    assert_int_equal(glint_draw_rect(&paint, &maps, COUNT, 1, &surface, NULL), GLINT_OK);
    assert_in_range(slow, 0, 2);
}

static const struct glint_use_coverage *counted_soft;

static void count_soft(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                       const struct glint_sample *sums, unsigned apart)
{
    slow++;
    counted_soft->format.exact(paint, run, i, sums, apart);
}

/* The share of pixels of random scenes that took the 64-bit sequence. lights: 0, a white directional one. */
static double share_of_64_bits(enum glint_format format, enum glint_space space, unsigned lights, bool maps, bool soft)
{
    enum { SCENES = 30 };
    static struct scene s;
    slow = 0;
    for (int i = 0; i < SCENES; i++) {
        struct glint_light lamps[GLINT_LIGHTS_MAX];
        struct glint_paint paint;
        scene_init(&s, format, space);
        paint_of(&paint, &s.look);
        if (lights) {
            random_lights(lamps);
            assert_int_equal(glint_paint_light(&paint, lamps, lights, in_front), GLINT_OK);
        }
        struct glint_use_format counted = *paint.format;
        struct glint_use_coverage counted_blend = glint_use_coverage;
        counted_format = paint.format;
        counted.exact = count_exact;
        paint.format = &counted;
        counted_soft = &glint_use_coverage;
        counted_blend.format.exact = count_soft;
        if (!maps)
            s.maps.albedo = s.maps.gloss = NULL;
        if (!soft)
            s.maps.coverage = NULL;
        assert_int_equal(glint_draw_rect_by(&paint, &s.maps, W, H, &s.surface, NULL, soft ? &counted_blend : NULL),
                         GLINT_OK);
    }
    return slow / (double)(SCENES * W * H);
}

static void thirty_two_bits_decide_most_pixels_of_each_format_light_and_map(void **state)
{
    (void)state;
    /* More lights are more often brighter than 1.0. */
    static const double most[] = {.08, .25, .25, .4, .65};
    for (int format = 0; format < GLINT_FORMAT_COUNT; format++)
        for (int space = 0; space < 2; space++)
            for (unsigned lights = 0; lights <= 4; lights++)
                for (int maps = 0; maps < 4; maps++)
                    assert_true(share_of_64_bits((enum glint_format)format, (enum glint_space)space, lights, maps & 1,
                                                 maps & 2) < most[lights]);
}

/* Bounds that are wider than they must be cost such pixels, of 900 scenes: a part in 1000 of them all. */
static void no_bound_leaves_more_to_64_bits_than_it_must(void **state)
{
    (void)state;
    double of_color = 0, of_coverage = 0;
    seed = 7;
    for (int i = 0; i < 30; i++) {
        of_color += 1000 * share_of_64_bits(GLINT_RGB565, GLINT_LINEAR, 1, false, false) / 30;
        of_coverage += 1000 * share_of_64_bits(GLINT_RGB565, GLINT_GAMMA, 0, false, true) / 30;
    }
    assert_true(of_color < 31.5);
    assert_true(of_coverage < 6.6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(triangles_in_one_strip_are_drawn_by_the_fused_lines_of_albedo_tables),
        cmocka_unit_test(tables_draw_faces_that_no_outline_cuts_without_asking_for_cells),
        cmocka_unit_test(an_outline_whose_ends_are_a_half_beyond_the_highlight_has_no_t),
        cmocka_unit_test(an_outline_asks_no_other_of_its_face_that_ends_before_it),
        cmocka_unit_test(thirty_two_bits_decide_most_pixels_of_each_format_light_and_map),
        cmocka_unit_test(no_bound_leaves_more_to_64_bits_than_it_must),
        cmocka_unit_test(where_a_coloured_lamp_shines_in_full_32_bits_decide),
        cmocka_unit_test(where_two_lights_shine_on_a_dim_material_32_bits_decide),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
