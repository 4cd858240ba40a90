/* SPDX-License-Identifier: MIT
 * `glint render --compare`, --json and --error-map. */
#include <jansson.h>
#include <string.h>

#include "render_maps.h"

#include "image.h"

static double number_at(const json_t *root, const char *against, const char *how, const char *what)
{
    const json_t *value = json_object_get(json_object_get(json_object_get(root, against), how), what);
    assert_true(json_is_number(value));
    return json_number_value(value);
}

static void the_comparison_as_json_has_every_figure(void **state)
{
    (void)state;
    assert_int_equal(glint("render --scene sphere --size 100x80 --json"), 0);
    json_t *root = json_loads(said, 0, NULL);
    assert_non_null(root);
    assert_int_equal(json_integer_value(json_object_get(root, "width")), 100);
    assert_int_equal(json_integer_value(json_object_get(root, "height")), 80);
    assert_string_equal(json_string_value(json_object_get(root, "model")), "msh");
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

static void the_comparison_as_text_names_both_references(void **state)
{
    (void)state;
    assert_int_equal(glint("render --scene sphere --size 64x64 --model cayley --compare"), 0);
    assert_true(says("cayley in double") && says("blinn in double") && says("PSNR"));
    assert_int_equal(glint("render --scene sphere --size 64x64 --model blinn --compare"), 0);
    assert_true(says("blinn in double") && !says("msh"));
    assert_int_equal(glint("render --scene sphere --size 64x64 --model phong --compare"), 0);
    assert_true(says("V.R"));
}

static void a_picture_on_standard_output_is_not_mixed_with_words(void **state)
{
    (void)state;
    assert_quiet_success("render --scene sphere --size 64x64 -o out/alone.png");
    char line[512];
    snprintf(line, sizeof line, "'%s' render --scene sphere --size 64x64 --compare -o - 2>words >out/with.png",
             from_environment("GLINT"));
    assert_int_equal(system(line), 0);
    assert_same_file("out/alone.png", "out/with.png");
    read_words("words");
    assert_true(says("msh in double"));
}

static void the_error_map_is_a_picture_whose_factor_is_said(void **state)
{
    (void)state;
    assert_int_equal(glint("render --scene sphere --size 64x48 --error-map out/e.png --against blinn"), 0);
    const char *line = strstr(said, "out/e.png");
    assert_non_null(line);
    unsigned times = 0;
    assert_int_equal(sscanf(strstr(line, "times"), "times %u", &times), 1);
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
    assert_int_equal(glint("render --height heights.png --mask none.png --compare"), 0);
    assert_true(says("nothing is drawn"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_comparison_as_json_has_every_figure),
        cmocka_unit_test(the_comparison_as_text_names_both_references),
        cmocka_unit_test(a_picture_on_standard_output_is_not_mixed_with_words),
        cmocka_unit_test(the_error_map_is_a_picture_whose_factor_is_said),
        cmocka_unit_test(a_mask_that_leaves_nothing_is_said),
    };
    return cmocka_run_group_tests_name("render compare", tests, make_maps, leave_own_directory);
}
