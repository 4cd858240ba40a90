/* SPDX-License-Identifier: MIT
 * What was forgotten, or is not there, is an error, and nothing is drawn. */
#include "meshes.h"
#include "tables_model.h"

static struct look look;
static struct glint_paint paint;
static uint16_t pixels[4];
static const struct glint_surface surface = {pixels, 8, 0, 0}, nowhere = {NULL, 8, 0, 0};
static const struct glint_span span = {0, 0, 0, 1 << 30, 0, 4, {{0, 0}, {0, 0}}};
static const struct glint_vec normals[4] = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
static const struct glint_maps maps = {.normals = normals, .normals_stride = 6};

static int set_up(void **state)
{
    (void)state;
    look = random_look(GLINT_RGB565, GLINT_GAMMA);
    set_model(&look, GLINT_MSH, 60, 8);
    look.output.dither = false;
    memset(pixels, GUARD, sizeof pixels);
    paint_of(&paint, &look);
    return 0;
}

static int nothing_drawn(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++)
        if (pixels[i] != (GUARD << 8 | GUARD))
            return 1;
    return 0;
}

static void a_paint_without_material_output_or_shininess_is_not_made(void **state)
{
    (void)state;
    struct glint_paint made, before;
    memset(&made, GUARD, sizeof made);
    before = made;
    assert_int_equal(glint_paint_exact(NULL, &look.material, &look.output), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_exact(&made, NULL, &look.output), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_exact(&made, &look.material, NULL), GLINT_ERR_ARG);
    struct look bad = look;
    bad.material.n = 0;
    assert_int_equal(glint_paint_exact(&made, &bad.material, &bad.output), GLINT_ERR_ARG);
    bad = look;
    bad.material.model = GLINT_BLINN; /* it has no grain */
    bad.material.n_across = 59;       /* of 60 */
    assert_int_equal(glint_paint_exact(&made, &bad.material, &bad.output), GLINT_ERR_ARG);
    bad = look;
    bad.material.model = GLINT_MODEL_COUNT;
    assert_int_equal(glint_paint_exact(&made, &bad.material, &bad.output), GLINT_ERR_ARG);
    bad = look;
    bad.output.format = GLINT_FORMAT_COUNT;
    assert_int_equal(glint_paint_exact(&made, &bad.material, &bad.output), GLINT_ERR_FORMAT);
    bad = look;
    bad.output.space = GLINT_LINEAR + 1;
    assert_int_equal(glint_paint_exact(&made, &bad.material, &bad.output), GLINT_ERR_FORMAT);
    assert_memory_equal(&made, &before, sizeof made);
    look.material.n_across = 60;
    assert_int_equal(glint_paint_exact(&made, &look.material, &look.output), GLINT_OK);
}

static void a_paint_of_zeros_or_one_that_was_never_lit_draws_nothing(void **state)
{
    (void)state;
    struct glint_paint bad[2];
    memset(bad, 0, sizeof bad);
    struct glint_span made;
    struct glint_box box = {9, 9, 9, 9};
    assert_int_equal(glint_paint_exact(&bad[1], &look.material, &look.output), GLINT_OK);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(glint_draw_rect(&bad[i], &maps, 4, 1, &surface, &box), GLINT_ERR_ARG);
        assert_int_equal(glint_draw_span(&bad[i], &span, NULL, &surface, &box), GLINT_ERR_ARG);
        assert_int_equal(glint_span_init(&made, &bad[i], &normals[0], &normals[1], 4), GLINT_ERR_ARG);
    }
    assert_int_equal(glint_paint_light(&bad[0], &look.light, 1, in_front), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_rect(&bad[0], &maps, 4, 1, &surface, &box), GLINT_ERR_ARG);
    assert_true(box.x == 9 && box.h == 9);
}

static void an_error_of_lighting_leaves_a_paint_that_was_never_lit_as_it_was(void **state)
{
    (void)state;
    static const int32_t zero[3] = {0, 0, 0};
    struct glint_paint made;
    assert_int_equal(glint_paint_exact(&made, &look.material, &look.output), GLINT_OK);
    assert_int_equal(glint_paint_light(&made, &look.light, 1, zero), GLINT_ERR_VECTOR);
    assert_int_equal(glint_paint_light(&made, &look.light, 5, in_front), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_rect(&made, &maps, 4, 1, &surface, NULL), GLINT_ERR_ARG);
}

static void spans_without_an_argument_are_refused(void **state)
{
    (void)state;
    assert_int_equal(glint_draw_span(NULL, &span, NULL, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_span(&paint, NULL, NULL, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_span(&paint, &span, NULL, NULL, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_span(&paint, &span, NULL, &nowhere, NULL), GLINT_ERR_ARG);
}

static void rectangles_without_an_argument_are_refused(void **state)
{
    (void)state;
    const struct glint_maps none = {0};
    assert_int_equal(glint_draw_rect(NULL, &maps, 4, 1, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_rect(&paint, NULL, 4, 1, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_rect(&paint, &none, 4, 1, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_rect(&paint, &maps, 4, 1, NULL, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_rect(&paint, &maps, 4, 1, &nowhere, NULL), GLINT_ERR_ARG);
}

static void a_span_knows_one_directional_light_or_none(void **state)
{
    (void)state;
    static const int32_t place[3] = {0, 0, 100}, target[3] = {0, 0, 0};
    struct glint_light lights[2] = {look.light, look.light};
    for (int kind = 0; kind < 3; kind++) {
        if (kind == 1)
            assert_int_equal(glint_light_point(lights, place, 1000), GLINT_OK);
        if (kind == 2)
            assert_int_equal(glint_light_spot(lights, place, target, 1000, 1 << 30, 0), GLINT_OK);
        assert_int_equal(glint_paint_light(&paint, lights, kind ? 1 : 2, in_front), GLINT_OK);
        assert_int_equal(glint_draw_span(&paint, &span, NULL, &surface, NULL), GLINT_ERR_ARG);
    }
    uint16_t drawn[4];
    const struct glint_surface there = {drawn, 8, 0, 0};
    assert_int_equal(glint_paint_light(&paint, lights + 1, 1, in_front), GLINT_OK);
    assert_int_equal(glint_draw_span(&paint, &span, NULL, &there, NULL), GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, NULL, 0, in_front), GLINT_OK);
    assert_int_equal(glint_draw_span(&paint, &span, NULL, &there, NULL), GLINT_OK);
}

static void maps_that_a_span_does_not_take_are_refused(void **state)
{
    (void)state;
    static const uint8_t map[12] = {0};
    struct glint_maps bad = {.grain = map};
    assert_int_equal(glint_draw_span(&paint, &span, &bad, &surface, NULL), GLINT_ERR_ARG);
    bad = (struct glint_maps){.albedo = map, .albedo_format = GLINT_RGB565};
    assert_int_equal(glint_draw_span(&paint, &span, &bad, &surface, NULL), GLINT_ERR_FORMAT);
    bad.albedo_format = GLINT_FORMAT_COUNT;
    assert_int_equal(glint_draw_span(&paint, &span, &bad, &surface, NULL), GLINT_ERR_FORMAT);
}

static void an_unknown_model_gives_0(void **state)
{
    (void)state;
    const enum glint_model unknown = (enum glint_model)GLINT_MODEL_COUNT;
    struct glint_lobe lobe;
    assert_int_equal(glint_eval(unknown, 60, 65536), 0);
    assert_int_equal(glint_eval_t(unknown, 60, 0), 0);
    assert_int_equal(glint_cutoff(unknown, 60, 8), 0);
    assert_int_equal(glint_cutoff_t(unknown, 60, 8), 0);
    glint_lobe_init(&lobe, unknown, 60, 8);
    assert_int_equal(glint_lobe_eval_t(&lobe, 0), 0);
}

static void a_cutoff_s_shininess_is_held(void **state)
{
    (void)state;
    for (int model = 0; model < GLINT_MODEL_COUNT; model++) {
        const enum glint_model m = (enum glint_model)model;
        assert_int_equal(glint_cutoff(m, 0, 6), glint_cutoff(m, 1, 6));
        assert_int_equal(glint_cutoff(m, UINT32_MAX, 6), glint_cutoff(m, GLINT_N_MAX, 6));
        assert_int_equal(glint_cutoff_t(m, 0, 6), glint_cutoff_t(m, 1, 6));
        assert_int_equal(glint_cutoff_t(m, UINT32_MAX, 6), glint_cutoff_t(m, GLINT_N_MAX, 6));
    }
}

static struct made_mesh mesh;

/* Places for more triangles than a mesh can have. */
static void a_picture_takes_any_amount_of_memory(void **state)
{
    (void)state;
    const size_t bytes = glint_mesh_frame_bytes(4, 4) + (GLINT_MESH_FACES_MAX + (size_t)9) * GLINT_MESH_KEPT_BYTES;
    void *const depths = malloc(bytes);
    struct glint_mesh_frame frame;
    assert_non_null(depths);
    assert_int_equal(glint_mesh_begin(&frame, 4, 8, 4, 0, depths, bytes), GLINT_OK);
    assert_int_equal(glint_mesh_strip(&frame, 0, 1, &surface), GLINT_OK);
    free(depths);
}

static void a_mesh_without_what_it_needs_is_refused(void **state)
{
    (void)state;
    for (int i = 0; i < 5; i++) {
        mesh_ball(&mesh, 6, 8);
        assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_OK);
        if (i == 0)
            mesh.mesh.places = NULL;
        else if (i == 1)
            mesh.mesh.faces = NULL;
        else if (i == 2)
            mesh.mesh.vertex_count = 0;
        else if (i == 3)
            mesh.mesh.face_count = UINT16_MAX;
        else
            mesh.mesh.part_count = 1; /* without its end */
        assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_ERR_ARG);
    }
}

static void a_mesh_at_an_odd_address_is_refused(void **state)
{
    (void)state;
    for (int which = 0; which < 4; which++) {
        mesh_ball(&mesh, 6, 8);
        mesh_join(&mesh);
        assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_OK);
        const uint8_t *odd = (const uint8_t *)mesh.mesh.places + 1;
        if (which == 0)
            mesh.mesh.places = (const int16_t *)(const void *)odd;
        if (which == 1)
            mesh.mesh.normals = (const int16_t *)(const void *)odd;
        if (which == 2)
            mesh.mesh.faces = (const uint16_t *)(const void *)odd;
        if (which == 3)
            mesh.mesh.neighbours = (const uint16_t *)(const void *)odd;
        assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_ERR_ARG);
    }
}

static void a_mesh_picture_without_an_argument_is_refused(void **state)
{
    (void)state;
    static uint32_t depths[8000], work[8000];
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    const size_t all = sizeof depths;
    mesh_ball(&mesh, 6, 8);
    const struct glint_mesh *m = &mesh.mesh;
    const struct glint_pose *pose = &mesh.pose;
    assert_int_equal(glint_mesh_begin(NULL, 4, 8, 4, 0, depths, all), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_begin(&frame, 4, 8, 4, 0, NULL, all), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_begin(&frame, 4, 0, 4, 0, depths, all), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_begin(&frame, 4, 8, 0, 0, depths, all), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_begin(&frame, 4, GLINT_MESH_SIZE_MAX + 1, 4, 0, depths, all), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_begin(&frame, GLINT_MESH_SIZE_MAX, GLINT_MESH_SIZE_MAX, 1, 0, depths, all), GLINT_OK);
    memset(&frame, 0, sizeof frame); /* never begun */
    assert_int_equal(glint_mesh_add(&frame, &drawn, m, pose, &paint, work, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_strip(&frame, 0, 1, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_begin(&frame, 4, 8, 4, 0, depths, all), GLINT_OK);
    assert_int_equal(glint_mesh_add(NULL, &drawn, m, pose, &paint, work, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, NULL, m, pose, &paint, work, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, NULL, pose, &paint, work, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, m, NULL, &paint, work, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, m, pose, NULL, work, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, m, pose, &paint, NULL, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, m, pose, &paint, (char *)work + 2, sizeof work - 4), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, m, pose, &paint, work, sizeof work), GLINT_OK);
    assert_int_equal(glint_mesh_strip(NULL, 0, 1, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_strip(&frame, 0, 1, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_strip(&frame, 0, 1, &nowhere), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_strip(&frame, 8, 1, &surface), GLINT_ERR_ARG);
}

/* Its list would have no end. */
static void what_is_in_a_picture_is_not_added_again(void **state)
{
    (void)state;
    static uint32_t depths[8000], work[3][4000];
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn[3];
    mesh_ball(&mesh, 6, 8);
    assert_int_equal(glint_mesh_begin(&frame, 4, 8, 4, 0, depths, sizeof depths), GLINT_OK);
    for (int i = 0; i < 3; i++)
        assert_int_equal(glint_mesh_add(&frame, &drawn[i], &mesh.mesh, &mesh.pose, &paint, work[i], sizeof *work),
                         GLINT_OK);
    for (int i = 0; i < 3; i++)
        assert_int_equal(glint_mesh_add(&frame, &drawn[i], &mesh.mesh, &mesh.pose, &paint, work[i], sizeof *work),
                         GLINT_ERR_ARG);
}

/* A line of one would not fit the stride that holds the other's. */
static void meshes_of_two_formats_are_not_in_one_picture(void **state)
{
    (void)state;
    static uint32_t depths[8000], work[2][4000];
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn[2];
    struct glint_paint wide;
    look.output.format = GLINT_XRGB8888;
    paint_of(&wide, &look);
    mesh_ball(&mesh, 6, 8);
    assert_int_equal(glint_mesh_begin(&frame, 4, 8, 4, 0, depths, sizeof depths), GLINT_OK);
    assert_int_equal(glint_mesh_add(&frame, &drawn[0], &mesh.mesh, &mesh.pose, &wide, work[0], sizeof *work), GLINT_OK);
    assert_int_equal(glint_mesh_add(&frame, &drawn[1], &mesh.mesh, &mesh.pose, &paint, work[1], sizeof *work),
                     GLINT_ERR_ARG);
}

static void parts_whose_paints_have_other_lights_are_refused(void **state)
{
    (void)state;
    static const int32_t viewers[][3] = {{1, 0, 1}, {0, 1, 1}, {0, 0, -1}};
    static uint32_t depths[8000], work[4000];
    static const int32_t side[3] = {3, 0, 4}, up[3] = {0, 3, 4};
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    struct glint_light lights[3];
    mesh_ball(&mesh, 6, 8);
    const uint16_t ends[] = {8, mesh.mesh.face_count};
    mesh.mesh.ends = ends;
    mesh.mesh.part_count = 2;
    assert_int_equal(glint_light_directional(&lights[0], side), GLINT_OK);
    assert_int_equal(glint_light_directional(&lights[1], up), GLINT_OK);
    lights[2] = lights[0];
    for (unsigned i = 0; i < 10; i++) {
        struct glint_paint paints[2] = {paint, paint};
        assert_int_equal(glint_mesh_begin(&frame, 4, 8, 4, 0, depths, sizeof depths), GLINT_OK);
        assert_int_equal(glint_paint_light(&paints[0], lights, i < 8 ? 1 : 2, in_front), GLINT_OK);
        lights[2].color_q16[i % 3] = 65535;
        assert_int_equal(i < 3    ? glint_paint_light(&paints[1], lights, 1, viewers[i])
                         : i == 3 ? glint_paint_light(&paints[1], lights + 1, 1, in_front)
                         : i < 7  ? glint_paint_light(&paints[1], lights + 2, 1, in_front)
                         : i == 7 ? glint_paint_light(&paints[1], lights, 0, in_front)
                         : i == 8 ? glint_paint_light(&paints[1], lights + 1, 2, in_front)
                                  : glint_paint_light(&paints[1], lights, 2, in_front),
                         GLINT_OK);
        assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, paints, work, sizeof work),
                         i < 9 ? GLINT_ERR_ARG : GLINT_OK);
        lights[2].color_q16[i % 3] = 65536;
    }
    static const int32_t place[3] = {0, 0, 100};
    struct glint_paint paints[2] = {paint, paint};
    assert_int_equal(glint_light_point(&lights[2], place, 1000), GLINT_OK);
    assert_int_equal(glint_paint_light(&paints[1], lights + 2, 1, in_front), GLINT_OK);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, paints, work, sizeof work), GLINT_ERR_ARG);
    /* below what is drawn nothing is moved to make room for lights */
    mesh.mesh.part_count = 0;
    assert_int_equal(glint_paint_light(&paint, lights, 2, in_front), GLINT_OK);
    assert_int_equal(glint_mesh_begin(&frame, 4, 8, 4, 0, depths, sizeof depths), GLINT_OK);
    assert_int_equal(glint_mesh_strip(&frame, 0, 1, &surface), GLINT_OK);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, sizeof work), GLINT_ERR_ARG);
}

static void coverage_without_what_draws_it_is_refused(void **state)
{
    (void)state;
    static const uint8_t coverage[4] = {0};
    struct glint_maps soft = maps;
    soft.coverage = coverage;
    assert_int_equal(glint_draw_rect_by(&paint, &soft, 4, 1, &surface, NULL, NULL), GLINT_ERR_ARG);
}

static void a_light_of_no_direction_or_a_long_one_is_refused(void **state)
{
    (void)state;
    struct glint_light light = look.light;
    for (int i = 0; i < 3; i++)
        light.direction_q30[i] = 0;
    assert_int_equal(glint_paint_light(&paint, &light, 1, in_front), GLINT_ERR_ARG);
    for (int i = 0; i < 3; i++)
        light.direction_q30[i] = i < 2 ? 1 << 30 : 0;
    assert_int_equal(glint_paint_light(&paint, &light, 1, in_front), GLINT_ERR_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_paint_without_material_output_or_shininess_is_not_made, set_up,
                                        nothing_drawn),
        cmocka_unit_test_setup_teardown(parts_whose_paints_have_other_lights_are_refused, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(coverage_without_what_draws_it_is_refused, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(a_light_of_no_direction_or_a_long_one_is_refused, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(a_paint_of_zeros_or_one_that_was_never_lit_draws_nothing, set_up,
                                        nothing_drawn),
        cmocka_unit_test_setup_teardown(an_error_of_lighting_leaves_a_paint_that_was_never_lit_as_it_was, set_up,
                                        nothing_drawn),
        cmocka_unit_test_setup_teardown(spans_without_an_argument_are_refused, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(rectangles_without_an_argument_are_refused, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(a_span_knows_one_directional_light_or_none, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(maps_that_a_span_does_not_take_are_refused, set_up, nothing_drawn),
        cmocka_unit_test(an_unknown_model_gives_0),
        cmocka_unit_test(a_cutoff_s_shininess_is_held),
        cmocka_unit_test_setup_teardown(a_picture_takes_any_amount_of_memory, set_up, nothing_drawn),
        cmocka_unit_test(a_mesh_without_what_it_needs_is_refused),
        cmocka_unit_test(a_mesh_at_an_odd_address_is_refused),
        cmocka_unit_test_setup_teardown(a_mesh_picture_without_an_argument_is_refused, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(what_is_in_a_picture_is_not_added_again, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(meshes_of_two_formats_are_not_in_one_picture, set_up, nothing_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
