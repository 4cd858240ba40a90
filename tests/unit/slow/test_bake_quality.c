/* SPDX-License-Identifier: MIT
 * glint bake: what each format costs in quality, on the whole rock wall. */
#include <jansson.h>

#include "compare/quality.h"
#include "files.h"

struct figures {
    int n;
    double largest, mean, psnr_db;
};

static void read_figures(const char *options, struct figures figures[QUALITY_ROWS])
{
    char line[300];
    snprintf(line, sizeof line, "$GLINT bake %s --json", options);
    const struct run *result = run(line);
    assert_int_equal(result->status, 0);
    json_t *root = json_loads(result->out, 0, NULL), *rows = json_object_get(root, "quality");
    assert_int_equal(json_array_size(rows), QUALITY_ROWS);
    for (size_t i = 0; i < QUALITY_ROWS; i++) {
        const json_t *row = json_array_get(rows, i);
        const json_t *psnr = json_object_get(row, "psnr_db");
        figures[i] = (struct figures){
            (int)json_integer_value(json_object_get(row, "n")), json_real_value(json_object_get(row, "largest")),
            json_real_value(json_object_get(row, "mean")), json_is_null(psnr) ? 0 : json_real_value(psnr)};
    }
    json_decref(root);
}

static void the_quality_of_each_format_is_within_its_limits_on_the_rock_wall(void **state)
{
    (void)state;
    static const struct {
        const char *format;
        double largest[QUALITY_ROWS], psnr_db; /* at n = 10, 60, 200, 1000; of the worst */
    } limits[] = {
        {"int16", {0, 0, 0, 0}, 0},
        {"int8", {6, 8, 12, 27}, 52},
        {"palette", {15, 21, 38, 80}, 43},
        {"palette:32767", {0, 0, 0, 0}, 0},
    };
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++) {
        char options[200];
        struct figures figures[QUALITY_ROWS];
        static const int shininess[] = {10, 60, 200, 1000};
        snprintf(options, sizeof options, "--height \"$GLINT_SOURCE/tests/data/rockwall-height.png\" --to %s",
                 limits[i].format);
        read_figures(options, figures);
        for (int k = 0; k < QUALITY_ROWS; k++) {
            assert_int_equal(figures[k].n, shininess[k]);
            if (figures[k].largest > limits[i].largest[k] || figures[k].psnr_db < limits[i].psnr_db ||
                figures[k].mean > figures[k].largest)
                fail_msg("%s, n = %d: largest %g, mean %g, PSNR %g dB", limits[i].format, figures[k].n,
                         figures[k].largest, figures[k].mean, figures[k].psnr_db);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_quality_of_each_format_is_within_its_limits_on_the_rock_wall),
    };
    return cmocka_run_group_tests_name("bake quality", tests, scratch_make, scratch_remove);
}
