/* SPDX-License-Identifier: MIT
 * glint paper whole, with the wider search; and the same search by glint search. */
#include <jansson.h>

#include "files.h"

static void the_whole_report_has_the_wider_search_and_says_nothing_of_parts_left_out(void **state)
{
    (void)state;
    assert_int_equal(run("$GLINT paper -o report --no-plots")->status, 0);
    json_t *summary = json_load_file("report/claims.json", 0, NULL);
    assert_near(json_number_value(json_object_get(json_object_get(summary, "numbers"), "wider_best_100")), 0.003999,
                0.5e-6);
    json_decref(summary);
    char *report = whole_file("report/report.html"), *rows = whole_file("report/wider.csv");
    assert_contains(report, "--best 100");
    /* What is new stands first, before the contents and the claims. */
    const char *found = strstr(report, "has 0.003999, 61 % of MSH's"), *contents = strstr(report, "<nav>");
    assert_true(found && contents && found < contents && contents < strstr(report, "id=claims"));
    assert_null(strstr(report, "this report is not complete"));
    int lines = 0;
    for (const char *at = rows; (at = strchr(at, '\n')); at++)
        lines++;
    assert_int_equal(lines, 1 + 130);
    free(report);
    free(rows);
}

static void keeping_more_sets_finds_better_functions(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT search --best 100 | head -1");
    assert_string_equal(result->out, "3 3 1 1 1 0.5 0.25 0.5 0.5 1.25 0.00399858\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_whole_report_has_the_wider_search_and_says_nothing_of_parts_left_out),
        cmocka_unit_test(keeping_more_sets_finds_better_functions),
    };
    return cmocka_run_group_tests_name("paper whole", tests, scratch_make, scratch_remove);
}
