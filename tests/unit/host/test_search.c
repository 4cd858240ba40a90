/* SPDX-License-Identifier: MIT
 * glint search: the paper's rows, wider searches, and that giving up early changes nothing. */
#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "family.h"
#include "files.h"

#include "paper/search.h"

/* ---- the paper's search ---- */

static void assert_row(const struct search_row *row, const double b[5], double deviation)
{
    for (int i = 0; i < 5; i++)
        assert_near(row->family.b[i], b[i], 0);
    assert_near(row->deviation, deviation, 0.5e-6);
}

static void the_search_by_itself_finds_table_1(void **state)
{
    (void)state;
    static const double exponents[5][5] = {
        {3, 2, 1, 1, 3}, {2, 2, 1, 1, 2}, {1, 2, 1, 1, 1}, {2, 2, 1, 1, 3}, {1, 2, 1, 1, 2}};
    static const double deviations[5] = {0.006223, 0.006302, 0.006555, 0.006635, 0.007017};
    static const double coefficients[5] = {2, 1.25, 1, 1, 1.25};
    const struct search_options options = search_options_paper();
    struct search_result result;
    search_run(&options, 2, &result);
    assert_int_equal(result.count, 5);
    for (int i = 0; i < 5; i++) {
        assert_row(&result.rows[i], exponents[i], deviations[i]);
        assert_memory_equal(result.rows[i].family.a, coefficients, sizeof coefficients);
    }
    search_free(&result);
}

static void stage_1_ranks_the_exponents_as_the_paper_does(void **state)
{
    (void)state;
    static const double exponents[6][5] = {{2, 2, 1, 1, 3}, {3, 2, 1, 1, 3}, {2, 2, 1, 1, 2},
                                           {1, 2, 1, 1, 2}, {1, 2, 1, 1, 1}, {3, 2, 1, 1, 2}};
    static const double deviations[6] = {0.008545, 0.008628, 0.008640, 0.008717, 0.008722, 0.008904};
    struct search_options options = search_options_paper();
    options.best = 6;
    struct search_result result;
    search_run(&options, 1, &result);
    assert_int_equal(result.first_count, 6);
    assert_int_equal(result.count, 0);
    for (int i = 0; i < 6; i++)
        assert_row(&result.first[i], exponents[i], deviations[i]);
    search_free(&result);
}

/* ---- the engine against plainer ones ---- */

static const double few_exponents[] = {-1, 0, 0.5, 1, 2, 3}, few_coefficients[] = {0.5, 1, 1.25, 2};
static const double few_n[] = {1, 2, 5, 20, 100, 500, 1000};
static const struct search_options reduced = {.exponents = {few_exponents, 6},
                                              .coefficients = {few_coefficients, 4},
                                              .shininess = {few_n, 7},
                                              .angles = 31,
                                              .best = 8};

static void giving_up_early_changes_no_row(void **state)
{
    (void)state;
    struct search_options options = reduced;
    struct search_result early, whole;
    search_run(&options, 2, &early);
    options.exhaustive = true;
    search_run(&options, 2, &whole);
    assert_int_equal(early.first_count, 8);
    assert_int_equal(early.count, whole.count);
    assert_memory_equal(early.first, whole.first, 8 * sizeof *early.first);
    assert_memory_equal(early.rows, whole.rows, early.count * sizeof *early.rows);
    search_free(&early);
    search_free(&whole);
}

/* Formula (3) as it stands, point by point. */
static double plain_deviation(const struct search_options *options, const struct family *family)
{
    double sum = 0;
    for (size_t i = 0; i < options->angles; i++)
        for (size_t j = 0; j < options->shininess.count; j++) {
            const double c = cos(acos(-1) / 2 * (double)i / (double)(options->angles - 1));
            const double n = options->shininess.values[j];
            sum += fabs(family_value(family, n, c) - pow(c, n));
        }
    return isfinite(sum) ? sum / (double)(options->angles * options->shininess.count) : INFINITY;
}

static void no_function_that_was_given_up_is_better_than_those_kept(void **state)
{
    (void)state;
    struct search_result result;
    search_run(&reduced, 1, &result);
    const double last = result.first[result.first_count - 1].deviation;
    size_t better = 0, as_good = 0;
    for (int i = 0; i < 6 * 6 * 6 * 6; i++) {
        const double *b = few_exponents;
        const struct family family = {{b[i / 216], b[i / 36 % 6], b[i / 6 % 6], b[i / 6 % 6], b[i % 6]},
                                      {1, 1, 1, 1, 1}};
        const double deviation = plain_deviation(&reduced, &family);
        better += deviation < last - 1e-12;
        as_good += deviation < last + 1e-12;
    }
    assert_true(better < result.first_count);
    assert_true(as_good >= result.first_count);
    for (size_t i = 0; i < result.first_count; i++)
        assert_near(result.first[i].deviation, plain_deviation(&reduced, &result.first[i].family), 1e-12);
    search_free(&result);
}

static void the_deviation_of_one_function_is_that_of_the_formula(void **state)
{
    (void)state;
    static const struct family families[] = {
        {{1, 2, 1, 1, 1}, {2, 1.25, 1, 1, 1.25}}, {{3, 2.5, 1, 1, 0.5}, {2, 1.25, 0.75, 0.75, 1.25}},
        {{1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}},       {{0, -1.5, 0, 0, -1}, {1, 3, 2, 2, 1}},
        {{2, 2.2, 1.1, 1.1, 1}, {1, 1, 1, 1, 1}},
    };
    for (size_t i = 0; i < sizeof families / sizeof *families; i++) {
        const double plain = plain_deviation(&reduced, &families[i]);
        assert_near(search_deviation(&reduced, &families[i]), plain, 1e-9 * plain);
    }
}

static void a_function_that_is_no_number_somewhere_has_no_deviation(void **state)
{
    (void)state;
    static const double n[] = {0.25};
    const struct search_options options = {.shininess = {n, 1}, .angles = 91};
    const struct family negative_base = {{1, 0.5, -0.5, -0.5, -0.5}, {1, 1, 1, 1, 1}};
    assert_true(isinf(search_deviation(&options, &negative_base)));
    assert_fails("$GLINT search --exponents=-0.5 --shininess 0.25", "no function is a finite number");
}

/* ---- wider ---- */

static void half_steps_are_searched(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT search --exponents -3:3:0.5");
    assert_int_equal(result->status, 0);
    assert_contains(result->out, "2.5 2 1 1 3 2 1.25 1 1 1.25 0.00635017\n");
}

static void the_grid_can_be_chosen(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT search --angles 31 --shininess 10:100:10 --coefficients 1 --best 1");
    assert_int_equal(result->status, 0);
    double row[11];
    char *at = result->out[0] ? (char *)result->out : NULL;
    for (int i = 0; i < 11; i++)
        row[i] = strtod(at, &at);
    assert_string_equal(at, "\n");
    const struct family family = {{row[0], row[1], row[2], row[3], row[4]}, {1, 1, 1, 1, 1}};
    static const double n[] = {10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
    const struct search_options options = {.shininess = {n, 10}, .angles = 31};
    assert_near(row[10], plain_deviation(&options, &family), 0.5e-8);
}

/* ---- the command ---- */

static void json_holds_the_same_rows(void **state)
{
    (void)state;
    json_t *root = json_loads(run("$GLINT search --json")->out, 0, NULL);
    json_t *rows = json_object_get(root, "rows");
    assert_int_equal(json_array_size(rows), 5);
    assert_int_equal(json_array_size(json_object_get(root, "stage1")), 5);
    assert_int_equal(json_integer_value(json_object_get(root, "stage1_functions")), 2401);
    assert_int_equal(json_integer_value(json_object_get(root, "stage2_functions")), 20480);
    const struct run *text = run("$GLINT search");
    char *at = (char *)text->out;
    for (size_t i = 0; i < 5; i++) {
        json_t *row = json_array_get(rows, i);
        for (size_t k = 0; k < 10; k++)
            assert_near(strtod(at, &at),
                        json_number_value(json_array_get(json_object_get(row, k < 5 ? "b" : "a"), k % 5)), 0);
        assert_near(strtod(at, &at), json_real_value(json_object_get(row, "deviation")), 0.5e-8);
    }
    json_decref(root);
}

static void rows_of_stage_1_have_coefficients_1(void **state)
{
    (void)state;
    assert_contains(run("$GLINT search --stage 1 --best 1")->out, "2 2 1 1 3 1 1 1 1 1 0.00854522\n");
}

static void options_that_cannot_be_are_refused_by_name(void **state)
{
    (void)state;
    assert_refused("$GLINT search --exponents one", "--exponents");
    assert_refused("$GLINT search --exponents 3:1", "--exponents");
    assert_refused("$GLINT search --exponents ''", "--exponents");
    assert_refused("$GLINT search --exponents 17", "--exponents");
    assert_refused("$GLINT search --coefficients 0", "--coefficients");
    assert_refused("$GLINT search --coefficients=-1", "--coefficients");
    assert_refused("$GLINT search --angles 1", "--angles");
    assert_refused("$GLINT search --angles 91.5", "--angles");
    assert_refused("$GLINT search --shininess 0", "--shininess");
    assert_refused("$GLINT search --best 0", "--best");
    assert_refused("$GLINT search --stage 3", "--stage");
    assert_refused("$GLINT search --stage 1 --coefficients 1:3", "--coefficients");
    assert_refused("$GLINT search --angles 90001", "at most 20000000");
    assert_refused("$GLINT search --angles 90001 --shininess 1:222 --exponents -3:3:0.01", "54224023 powers; at most");
    assert_refused("$GLINT search --angles 2 --shininess 1:1.9:1e-6 --joint", "29700099 powers; at most 20000000");
    assert_refused("$GLINT search --exponents -3:3:0.001", "at most 1000");
    assert_refused("$GLINT search 5", "'5'");
}

static void an_environment_of_no_launcher_is_no_launcher(void **state)
{
    (void)state;
    static const char *const environments[] = {"PMI_SIZE=0", "PMI_SIZE=5", "PMI_SIZE=0 PMI_RANK=0",
                                               "PMI_SIZE=1 PMI_RANK=3"};
    for (size_t i = 0; i < sizeof environments / sizeof *environments; i++) {
        char line[200];
        snprintf(line, sizeof line, "%s $GLINT search --joint --exponents 0:1 --coefficients 1,2 --best 1",
                 environments[i]);
        assert_quiet(strcat(line, " -o rows.txt"));
        strcpy(strstr(line, "0:1"), "2:1");
        assert_refused(line, "--exponents");
    }
}

static void rows_go_to_the_file_named(void **state)
{
    (void)state;
    assert_string_equal(run("$GLINT search --best 1 -o rows.txt && cat rows.txt")->out,
                        "2 2 1 1 3 2 1.25 1 1 1.25 0.00663454\n");
    assert_fails("$GLINT search -o nowhere/rows.txt", "nowhere/rows.txt");
}

static void an_interrupted_search_leaves_no_file(void **state)
{
    (void)state;
    /* 2.1e8 exponent sets: hours, were it not stopped; 124 is how timeout tells that it had to. */
    const struct run *result =
        run("timeout --foreground -s INT 1 $GLINT search --exponents -3:3:0.05 -o stopped.txt; echo status $?; ls");
    assert_contains(result->out, "status 124");
    assert_null(strstr(result->out, "stopped"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_search_by_itself_finds_table_1),
        cmocka_unit_test(stage_1_ranks_the_exponents_as_the_paper_does),
        cmocka_unit_test(giving_up_early_changes_no_row),
        cmocka_unit_test(no_function_that_was_given_up_is_better_than_those_kept),
        cmocka_unit_test(the_deviation_of_one_function_is_that_of_the_formula),
        cmocka_unit_test(a_function_that_is_no_number_somewhere_has_no_deviation),
        cmocka_unit_test(half_steps_are_searched),
        cmocka_unit_test(the_grid_can_be_chosen),
        cmocka_unit_test(json_holds_the_same_rows),
        cmocka_unit_test(rows_of_stage_1_have_coefficients_1),
        cmocka_unit_test(options_that_cannot_be_are_refused_by_name),
        cmocka_unit_test(an_environment_of_no_launcher_is_no_launcher),
        cmocka_unit_test(rows_go_to_the_file_named),
        cmocka_unit_test(an_interrupted_search_leaves_no_file),
    };
    return cmocka_run_group_tests_name("search", tests, scratch_make, scratch_remove);
}
