/* SPDX-License-Identifier: MIT
 * `glint render --compare`, --json and --error-map. */
#include <jansson.h>
#include <string.h>

#include "image/read.h"
#include "files.h"

#include "image/image.h"

static double number_at(const json_t *root, const char *against, const char *how, const char *what)
{
    const json_t *value = json_object_get(json_object_get(json_object_get(root, against), how), what);
    assert_true(json_is_number(value));
    return json_number_value(value);
}

static void the_comparison_as_json_has_every_figure(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT render --scene sphere --size 100x80 --json");
    assert_int_equal(result->status, 0);
    json_t *root = json_loads(result->out, 0, NULL);
    assert_non_null(root);
    assert_int_equal(json_integer_value(json_object_get(root, "width")), 100);
    assert_int_equal(json_integer_value(json_object_get(root, "height")), 80);
    assert_string_equal(json_string_value(json_object_get(root, "model")), "msh");
    assert_string_equal(json_string_value(json_object_get(root, "format")), "rgb888");
    assert_string_equal(json_string_value(json_object_get(root, "space")), "gamma");
    assert_int_equal(json_integer_value(json_object_get(root, "n")), 60);
    assert_int_equal(json_integer_value(json_object_get(root, "q")), 8);
    assert_true(number_at(root, "same_model", "rounded", "largest") <= 1);
    assert_true(number_at(root, "same_model", "rounded", "differing") < .02 * 24000);
    assert_true(number_at(root, "same_model", "unrounded", "psnr_db") > 55);
    assert_true(number_at(root, "same_model", "rounding_alone", "largest") <= .5);
    const double blinn = number_at(root, "blinn", "unrounded", "largest");
    assert_true(blinn > 10 && blinn < 22);
    const json_t *at = json_object_get(json_object_get(json_object_get(root, "blinn"), "rounded"), "at");
    assert_true(json_integer_value(json_object_get(at, "x")) < 100);
    assert_true(json_is_string(json_object_get(at, "channel")));
    json_decref(root);
}

static void the_comparison_of_a_mesh_as_json_has_its_coverage(void **state)
{
    (void)state;
    const char *text = run("$GLINT render --scene teapot --size 60x60 --compare")->out, *line;
    long long covered = 0, different = 0;
    assert_non_null(line = strstr(text, "the mesh covers "));
    assert_int_equal(sscanf(line, "the mesh covers %lld pixels; %lld,", &covered, &different), 2);
    assert_in_range(covered, 500, 2000);
    json_t *root = json_loads(run("$GLINT render --scene teapot --size 60x60 --json")->out, 0, NULL);
    const json_t *mesh = json_object_get(root, "mesh");
    assert_int_equal(json_integer_value(json_object_get(mesh, "covered")), covered);
    assert_int_equal(json_integer_value(json_object_get(mesh, "not_compared")), different);
    json_decref(root);
    root = json_loads(run("$GLINT render --scene coin --size 20x20 --json")->out, 0, NULL);
    assert_true(json_is_object(root) && !json_object_get(root, "mesh"));
    json_decref(root);
}

static void the_comparison_as_text_names_both_references(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT render --scene sphere --size 64x64 --model cayley --compare");
    assert_int_equal(result->status, 0);
    assert_contains(result->out, "cayley in double");
    assert_contains(result->out, "blinn in double");
    assert_contains(result->out, "PSNR");
    result = run("$GLINT render --scene sphere --size 64x64 --model blinn --compare");
    assert_contains(result->out, "blinn in double");
    assert_null(strstr(result->out, "msh"));
    assert_contains(run("$GLINT render --scene sphere --size 64x64 --model phong --compare")->out, "V.R");
}

static void a_picture_on_standard_output_is_not_mixed_with_words(void **state)
{
    (void)state;
    assert_quiet("$GLINT render --scene sphere --size 64x64 -o out/alone.png");
    const struct run *result =
        run("$GLINT render --scene sphere --size 64x64 --compare -o - | cat >out/with.png; exit $?");
    assert_same_file("out/alone.png", "out/with.png");
    assert_contains(result->err, "msh in double");
}

static void the_error_map_is_a_picture_whose_factor_is_said(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT render --scene sphere --size 64x48 --error-map out/e.png --against blinn");
    assert_int_equal(result->status, 0);
    assert_contains(result->out, "out/e.png: errors against blinn in double, times ");
    unsigned times = 0;
    assert_int_equal(sscanf(strstr(result->out, "times "), "times %u", &times), 1);
    assert_true(times >= 8 && (times & (times - 1)) == 0); /* Blinn is within 22 levels */
    struct image *map = image_read("out/e.png");
    assert_int_equal(map->width, 64);
    assert_int_equal(map->height, 48);
    image_free(map);
}

static void a_mask_that_leaves_nothing_is_said(void **state)
{
    (void)state;
    const uint16_t none[12 * 8] = {0};
    make_png("none.png", &(struct made_png){.width = 12, .height = 8, .bits = 8, .samples = none});
    assert_contains(run("$GLINT render --height heights.png --mask none.png --compare")->out, "nothing is drawn");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_comparison_as_json_has_every_figure),
        cmocka_unit_test(the_comparison_of_a_mesh_as_json_has_its_coverage),
        cmocka_unit_test(the_comparison_as_text_names_both_references),
        cmocka_unit_test(a_picture_on_standard_output_is_not_mixed_with_words),
        cmocka_unit_test(the_error_map_is_a_picture_whose_factor_is_said),
        cmocka_unit_test(a_mask_that_leaves_nothing_is_said),
    };
    return cmocka_run_group_tests_name("$GLINT render compare", tests, make_maps, scratch_remove);
}
