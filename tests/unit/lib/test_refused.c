/* SPDX-License-Identifier: MIT
 * Exact rectangles and spans, meshes and albedo spans: an argument that is not there is refused, and nothing is drawn. */
#include "meshes.h"

static struct glint_shader shader;
static struct glint_prepared prepared;
static uint16_t pixels[4];
static const struct glint_surface surface = {pixels, 8, 0, 0}, nowhere = {NULL, 8, 0, 0};
static const struct glint_span span = {0, 0, 0, 1 << 30, 0, 4};

static int set_up(void **state)
{
    (void)state;
    shader = random_shader(GLINT_RGB565, GLINT_GAMMA);
    glint_lobe_init(&shader.lobe, GLINT_MSH, 60, 8);
    shader.dither = false;
    memset(pixels, GUARD, sizeof pixels);
    return glint_shade_prepare(&prepared, &shader);
}

static int nothing_drawn(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++)
        if (pixels[i] != (GUARD << 8 | GUARD))
            return 1;
    return 0;
}

static void spans_without_an_argument_are_refused(void **state)
{
    (void)state;
    assert_int_equal(glint_shade_span(NULL, &span, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_span(&shader, NULL, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_span(&shader, &span, NULL, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_span(&shader, &span, &nowhere, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_span_c16(NULL, &span, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_span_c16(&shader, NULL, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_span_c16(&shader, &span, NULL, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_span_c16(&shader, &span, &nowhere, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_prepared_span(NULL, &span, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_prepared_span(&prepared, NULL, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_prepared_span(&prepared, &span, NULL, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_prepared_span(&prepared, &span, &nowhere, NULL), GLINT_ERR_ARG);
}

static void a_span_by_c_of_an_unknown_format_is_refused(void **state)
{
    (void)state;
    shader.format = (uint8_t)GLINT_FORMAT_COUNT;
    assert_int_equal(glint_shade_span_c16(&shader, &span, &surface, NULL), GLINT_ERR_FORMAT);
    assert_int_equal(glint_shade_span(&shader, &span, &surface, NULL), GLINT_ERR_FORMAT);
}

static void a_rectangle_without_a_prepared_shader_is_refused(void **state)
{
    (void)state;
    static const struct glint_vec normals[4] = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
    struct glint_source source = {0};
    source.normals = normals;
    assert_int_equal(glint_shade_prepared_rect(NULL, &source, 4, 1, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_prepared_rect(&prepared, NULL, 4, 1, &surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_prepared_rect(&prepared, &source, 4, 1, &nowhere, NULL), GLINT_ERR_ARG);
}

static void an_albedo_span_without_an_argument_is_refused(void **state)
{
    (void)state;
    static uint32_t memory[GLINT_TABLES_ALBEDO_BYTES / 4];
    static const uint16_t albedo[5] = {1, 2, 3, 4, 5};
    struct glint_tables tables;
    for (int k = 0; k < 3; k++) { /* white, which those tables ask for */
        shader.material.ambient_q16[k] = 6000;
        shader.material.diffuse_q16[k] = shader.material.specular_q16[k] = 30000;
    }
    assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_ALBEDO, &shader, memory, sizeof memory), GLINT_OK);
    assert_int_equal(glint_tables_albedo_span(NULL, &span, albedo, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_albedo_span(&tables, NULL, albedo, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_albedo_span(&tables, &span, NULL, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_albedo_span(&tables, &span, albedo, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_albedo_span(&tables, &span, albedo, &nowhere), GLINT_ERR_ARG);
    const void *const odd = (const char *)albedo + 1;
    assert_int_equal(glint_tables_albedo_span(&tables, &span, odd, &surface), GLINT_ERR_ARG);
    tables.kind = GLINT_TABLES_COLOUR;
    assert_int_equal(glint_tables_albedo_span(&tables, &span, albedo, &surface), GLINT_ERR_ARG);
}

static void tables_without_an_argument_are_refused(void **state)
{
    (void)state;
    static uint32_t memory[GLINT_TABLES_SMALL_BYTES / 4];
    const enum glint_tables_kind small = GLINT_TABLES_SMALL;
    struct glint_tables tables;
    assert_int_equal(glint_tables_fill(NULL, small, &shader, memory, sizeof memory), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_fill(&tables, small, &shader, NULL, sizeof memory), GLINT_ERR_ARG);
    shader.format = (uint8_t)GLINT_FORMAT_COUNT;
    assert_int_equal(glint_tables_fill(&tables, small, &shader, memory, sizeof memory), GLINT_ERR_FORMAT);
    assert_int_equal(glint_shade_prepare(NULL, &shader), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_prepare(&prepared, NULL), GLINT_ERR_ARG);
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

static void a_shininess_of_a_lobe_made_by_hand_is_held(void **state)
{
    (void)state;
    static const uint16_t given[] = {0, GLINT_N_MAX + 1}, held[] = {1, GLINT_N_MAX};
    for (int i = 0; i < 2; i++) {
        uint16_t out[2][4];
        const struct glint_surface to[] = {{out[0], 8, 0, 0}, {out[1], 8, 0, 0}};
        shader.lobe.n = given[i];
        assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
        assert_int_equal(glint_shade_prepared_span(&prepared, &span, &to[0], NULL), GLINT_OK);
        shader.lobe.n = held[i];
        assert_int_equal(glint_shade_prepare(&prepared, &shader), GLINT_OK);
        assert_int_equal(glint_shade_prepared_span(&prepared, &span, &to[1], NULL), GLINT_OK);
        assert_memory_equal(out[0], out[1], sizeof out[0]);
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

static void a_mesh_picture_without_an_argument_is_refused(void **state)
{
    (void)state;
    static uint32_t depths[8000], work[8000];
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    const struct glint_light *light = &shader.light;
    struct glint_paint paint = {&glint_mesh_exact, &prepared};
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
    assert_int_equal(glint_mesh_begin(&frame, 4, 8, 4, 0, depths, all), GLINT_OK);
    assert_int_equal(glint_mesh_add(NULL, &drawn, m, pose, light, &paint, work, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, NULL, m, pose, light, &paint, work, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, NULL, pose, light, &paint, work, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, m, NULL, light, &paint, work, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, m, pose, NULL, &paint, work, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, m, pose, light, NULL, work, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, m, pose, light, &paint, NULL, sizeof work), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, m, pose, light, &paint, (char *)work + 2, sizeof work - 4),
                     GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_add(&frame, &drawn, m, pose, light, &paint, work, sizeof work), GLINT_OK);
    assert_int_equal(glint_mesh_strip(NULL, 0, 1, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_strip(&frame, 0, 1, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_strip(&frame, 0, 1, &nowhere), GLINT_ERR_ARG);
    assert_int_equal(glint_mesh_strip(&frame, 8, 1, &surface), GLINT_ERR_ARG);
}

static void a_mesh_path_without_its_tables_or_its_shader_is_refused(void **state)
{
    (void)state;
    static uint32_t depths[8000], work[8000], memory[GLINT_TABLES_SMALL_BYTES / 4];
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    struct glint_tables tables;
    shader.format = GLINT_MONO; /* a span of a mesh starts on a byte */
    assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_SMALL, &shader, memory, sizeof memory), GLINT_OK);
    const struct glint_paint paints[] = {
        {NULL, &prepared}, {&glint_mesh_exact, NULL}, {&glint_mesh_tables, NULL}, {&glint_mesh_tables, &tables}};
    mesh_ball(&mesh, 6, 8);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(glint_mesh_begin(&frame, 4, 8, 4, 0, depths, sizeof depths), GLINT_OK);
        assert_int_equal(
            glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &shader.light, &paints[i], work, sizeof work),
            GLINT_OK);
        assert_int_equal(glint_mesh_strip(&frame, 0, 1, &surface), GLINT_ERR_ARG);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(spans_without_an_argument_are_refused, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(a_span_by_c_of_an_unknown_format_is_refused, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(a_rectangle_without_a_prepared_shader_is_refused, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(an_albedo_span_without_an_argument_is_refused, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(tables_without_an_argument_are_refused, set_up, nothing_drawn),
        cmocka_unit_test(an_unknown_model_gives_0),
        cmocka_unit_test_setup_teardown(a_cutoff_s_shininess_is_held, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(a_shininess_of_a_lobe_made_by_hand_is_held, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(a_picture_takes_any_amount_of_memory, set_up, nothing_drawn),
        cmocka_unit_test(a_mesh_without_what_it_needs_is_refused),
        cmocka_unit_test_setup_teardown(a_mesh_picture_without_an_argument_is_refused, set_up, nothing_drawn),
        cmocka_unit_test_setup_teardown(a_mesh_path_without_its_tables_or_its_shader_is_refused, set_up, nothing_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
