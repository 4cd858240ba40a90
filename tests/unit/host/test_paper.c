/* SPDX-License-Identifier: MIT
 * glint paper: its numbers, claims, files, and what it does without gnuplot. */
#include <jansson.h>
#include <math.h>
#include <signal.h>
#include <sys/stat.h>

#include "files.h"

#include "models/models.h"
#include "paper/paper.h"

/* claims.json of a whole run without plots, in the folder "report". */
static json_t *summary;

static int make_report(void **state)
{
    if (scratch_make(state) != 0 || run("$GLINT paper -o report --no-plots")->status != 0)
        return -1;
    summary = json_load_file("report/claims.json", 0, NULL);
    return summary ? 0 : -1;
}

static int remove_report(void **state)
{
    json_decref(summary);
    return scratch_remove(state);
}

static char *whole_file(const char *path)
{
    FILE *file = fopen(path, "rb");
    char *text = NULL;
    size_t size = 0;
    assert_non_null(file);
    assert_true(getdelim(&text, &size, EOF, file) > 0);
    fclose(file);
    return text;
}

static double number(const char *name)
{
    const json_t *value = json_object_get(summary, "numbers");
    value = json_object_get(value, name);
    if (!json_is_number(value))
        fail_msg("no number %s", name);
    return json_number_value(value);
}

/* ---- the numbers ---- */

static void a_verdict_follows_from_what_holds(void **state)
{
    (void)state;
    assert_int_equal(verdict_of(true, true), CONFIRMED);
    assert_int_equal(verdict_of(false, true), WITH_LIMITS);
    assert_int_equal(verdict_of(false, false), NOT_CONFIRMED);
}

static void the_papers_numbers_come_out(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double value, tolerance;
    } wanted[] = {
        {"deviation_msh", 0.006555, 0.5e-6},
        {"deviation_best_of_table", 0.006223, 0.5e-6},
        {"epicentre_msh_percent", 15.6, 0.05},
        {"epicentre_msh_n", 2, 0},
        {"epicentre_schlick_percent", 50.9, 0.05},
        {"epicentre_schlick_n", 1000, 0},
        {"epicentre_exact_msh_percent", 15.7, 0.05},
        {"epicentre_exact_schlick_percent", 51.2, 0.05},
        {"largest_error_msh", 0.0840, 0.00005},
        {"largest_error_schlick", 0.2034, 0.00005},
        {"largest_error_ratio", 0.41, 0.005},
        {"largest_error_msh_from_n1", 0.1322, 0.00005},
        {"largest_error_ratio_from_n1", 0.65, 0.005},
        {"msh_zero_angle", 1.570796, 0.5e-6},
        {"derivative_points_not_negative", 0, 0},
        {"spot_ratio_msh_q8_n704", 1.85, 0.005},
        {"spot_ratio_schlick_q8_n704", 5.96, 0.005},
        {"fig9_least_of_all_q", 1.26, 0.005},
        {"fig9_most_of_all_q_lowest", 4.6, 0.05},
        {"equation_12_wrong_in_single_precision", 119, 0},
        {"equation_12_wrong_in_double_precision", 0, 0},
        {"mean_msh", 0.00656, 0.00001},
        {"mean_schlick", 0.0288, 0.00005},
        {"mean_spherical_gaussian", 0.0003, 0.00005},
        {"wider_best_100", 0.003999, 0.5e-6},
        {"joint_best", 0.003999, 0.5e-6},
        {"deviation_msh_q16", 0.006555, 1e-6},
        {"fig3_q16_t_largest_ulp", 0.5, 0.01},
    };
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        print_message("%s\n", wanted[i].name);
        assert_near(number(wanted[i].name), wanted[i].value, wanted[i].tolerance);
    }
}

static void a_count_is_a_whole_number_in_json(void **state)
{
    (void)state;
    static const char *const counts[] = {
        "epicentre_msh_n",
        "epicentre_schlick_n",
        "operations_msh",
        "operations_fewer_than_squaring_of_1000",
        "fig9_q",
        "shorter_from_n",
        "equation_12_wrong_in_single_precision",
        "equation_12_wrong_in_double_precision",
        "derivative_points_not_negative",
        "finer_grid_same_sets_of_5",
        "finer_grid_same_rows_of_5",
    };
    const json_t *numbers = json_object_get(summary, "numbers");
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        print_message("%s\n", counts[i]);
        assert_true(json_is_integer(json_object_get(numbers, counts[i])));
    }
    assert_true(json_is_real(json_object_get(numbers, "deviation_msh")));
}

static const struct {
    const char *where, *part, *verdict;
} wanted_verdicts[] = {
    {"table 1", "two-stage search", "confirmed"},
    {"table 1", "most accurate", "confirmed"},
    {"text", "high powers", "confirmed"},
    {"text", "fewer operations", "confirmed with limits"},
    {"fig. 3", "fading zone", "confirmed"},
    {"fig. 4", "16 % (MSH) and 52 %", "confirmed"},
    {"fig. 5", "about half", "confirmed with limits"},
    {"text", "zero at x = 1.570796", "confirmed"},
    {"fig. 6", "monotonically", "confirmed"},
    {"fig. 7", "shorter interval", "confirmed with limits"},
    {"fig. 9", "1.5 to 7 times", "confirmed with limits"},
};
enum { VERDICTS = sizeof wanted_verdicts / sizeof *wanted_verdicts };

static void every_claim_has_its_verdict(void **state)
{
    (void)state;
    const json_t *claims = json_object_get(summary, "claims");
    assert_int_equal(json_array_size(claims), VERDICTS);
    for (size_t i = 0; i < VERDICTS; i++) {
        const json_t *claim = json_array_get(claims, i);
        assert_string_equal(json_string_value(json_object_get(claim, "where")), wanted_verdicts[i].where);
        assert_contains(json_string_value(json_object_get(claim, "claim")), wanted_verdicts[i].part);
        assert_string_equal(json_string_value(json_object_get(claim, "verdict")), wanted_verdicts[i].verdict);
    }
}

static void the_report_holds_every_claim_choice_and_part(void **state)
{
    (void)state;
    char *report = whole_file("report/report.html");
    for (size_t i = 0; i < VERDICTS; i++)
        assert_contains(report, wanted_verdicts[i].part);
    assert_contains(report, "11 claims: 7 confirmed, 4 confirmed with limits, 0 not confirmed.");
    for (int model = 0; model < GLINT_MODEL_COUNT; model++) { /* the table of models has them all but c^n */
        char key[40];
        snprintf(key, sizeof key, "largest_%s_from_n2", model_names[model]);
        if (model != GLINT_BLINN && model != GLINT_PHONG)
            assert_true(number(key) > 0);
    }
    static const char *const parts[] = {"16n^2 - 40n + 25", "F &lt;= 2^-q",       "whose cutoff bounds the loop",
                                        "e^-1.2 = 0.3012",  "Lyon 1993, gamma 4", "Spherical Gaussian",
                                        "Cayley (ours)",    "--best 100",         "id=\"fig3\"",
                                        "id=\"fig4\"",      "id=\"fig5\"",        "id=\"fig6\"",
                                        "id=\"fig7a\"",     "id=\"fig7b\"",       "id=\"fig9\""};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        assert_contains(report, parts[i]);
    free(report);
}

/* ---- the CSV files ---- */

static void each_csv_has_its_rows_of_equal_length(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int rows, columns;
    } files[] = {
        {"table1", 5, 15},     {"wider", 130, 12},    {"joint", 5, 11},      {"models", GLINT_MODEL_COUNT - 1, 17},
        {"fig3", 361, 10},     {"fig4", 1000, 7},     {"fig5", 38 * 361, 6}, {"fig6", 38 * 360, 5},
        {"fig7a", 28 * 16, 7}, {"fig7b", 28 * 16, 7}, {"fig9", 1000, 7},     {"fig9_readings", 24, 7},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        char path[64];
        snprintf(path, sizeof path, "report/%s.csv", files[i].name);
        char *text = whole_file(path);
        int rows = -1; /* the head */
        for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n"), rows++) {
            int columns = 1;
            bool quoted = false;
            for (const char *at = line; *at; at++) {
                quoted ^= *at == '"';
                columns += *at == ',' && !quoted;
            }
            if (columns != files[i].columns)
                fail_msg("%s: %d columns in '%s'", path, columns, line);
        }
        if (rows != files[i].rows)
            fail_msg("%s: %d rows, not %d", path, rows, files[i].rows);
        free(text);
    }
}

static void the_librarys_values_in_figure_3_are_the_formulas_rounded(void **state)
{
    (void)state;
    char *text = whole_file("report/fig3.csv");
    strtok(text, "\n");
    int rows = 0;
    for (char *line; (line = strtok(NULL, "\n")); rows++) {
        double angle, value[3], from_t[3], from_c[3];
        assert_int_equal(sscanf(line, "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &angle, &value[0], &value[1],
                                &value[2], &from_t[0], &from_t[1], &from_t[2], &from_c[0], &from_c[1], &from_c[2]),
                         10);
        for (int k = 0; k < 3; k++)
            assert_near(from_t[k], value[k], 0.51 / 65536);
    }
    assert_int_equal(rows, 361);
    free(text);
}

/* Rows of numbers after the head of a CSV file; text counts as 0. */
static size_t numbers_of(const char *path, double rows[][8], size_t limit)
{
    char *text = whole_file(path), *next = strchr(text, '\n');
    size_t count = 0;
    for (; next && next[1] && count < limit; count++) {
        char *at = next;
        next = strchr(at + 1, '\n');
        for (int i = 0; i < 8 && at && at < next; i++, at = strpbrk(at + 1, ",\n"))
            rows[count][i] = strtod(at + 1, NULL);
    }
    free(text);
    return count;
}

static void the_reading_of_figure_9_counts_what_its_curves_show(void **state)
{
    (void)state;
    static double curves[1000][8], readings[24][8];
    assert_int_equal(numbers_of("report/fig9.csv", curves, 1000), 1000);
    assert_int_equal(numbers_of("report/fig9_readings.csv", readings, 24), 24);
    double least = INFINITY, most = 0;
    int within = 0, last_outside = 0;
    for (size_t i = 1; i < 1000; i++) { /* n from 2 */
        const double ratio = curves[i][4] / curves[i][3];
        least = fmin(least, ratio);
        most = fmax(most, ratio);
        within += ratio >= 1.5 && ratio <= 7;
        last_outside = ratio >= 1.5 && ratio <= 7 ? last_outside : (int)curves[i][0];
    }
    size_t row = 0; /* Blinn's cutoff comes first, a row a q */
    while (readings[row][1] < number("fig9_q"))
        row++;
    assert_near(readings[row][1], curves[0][1], 0);
    assert_near(readings[row][2], least, 1e-8);
    assert_near(readings[row][4], most, 1e-8);
    assert_near(readings[row][6], within, 0);
    char part[96];
    snprintf(part, sizeof part, "1.5 to 7 times for %d of the 999 n in 2..1000, all from n = %d on", within,
             last_outside + 1);
    const json_t *claims = json_object_get(summary, "claims"),
                 *last = json_array_get(claims, json_array_size(claims) - 1);
    assert_contains(json_string_value(json_object_get(last, "computed")), part);
}

/* ---- the command ---- */

static void only_the_parts_named_are_written(void **state)
{
    (void)state;
    const struct run *result =
        run("$GLINT paper -o some/deep/folder --no-plots --only fig4,models && ls some/deep/folder");
    assert_int_equal(result->status, 0);
    assert_contains(result->out, "fig4.csv\nmodels.csv\nreport.html\n");
    assert_null(strstr(result->out, "fig3"));
    char *report = whole_file("some/deep/folder/report.html");
    assert_contains(report, "this report is not complete");
    free(report);
}

static void json_is_what_claims_json_holds(void **state)
{
    (void)state;
    const struct run *result =
        run("$GLINT paper -o j --no-plots --only fig4 --json >j.json && cmp j.json j/claims.json && cat j.json");
    assert_int_equal(result->status, 0);
    json_t *root = json_loads(result->out, 0, NULL);
    assert_int_equal(json_array_size(json_object_get(root, "claims")), 1);
    json_decref(root);
}

static void wrong_usage_is_named(void **state)
{
    (void)state;
    assert_refused("$GLINT paper", "-o DIR");
    assert_refused("$GLINT paper -o ''", "-o DIR");
    assert_refused("$GLINT paper -o x --only fig8", "--only: unknown part 'fig8'; choose from table1, wider");
    assert_refused("$GLINT paper -o x --only fig3,", "unknown part ''");
    assert_refused("$GLINT paper x", "'x'");
}

static void a_folder_that_cannot_be_is_named_in_one_line(void **state)
{
    (void)state;
    assert_fails("echo >file; $GLINT paper -o file --no-plots", "file: this is a file; name a folder");
    assert_fails("$GLINT paper -o file/below --no-plots", "file: this is a file; name a folder");
    assert_fails("$GLINT paper -o /proc/glint --no-plots", "/proc/glint");
}

static void without_gnuplot_it_says_what_to_do_and_writes_nothing(void **state)
{
    (void)state;
    assert_fails("PATH=/nonexistent; $GLINT paper -o unplotted", "install gnuplot-nox, or pass --no-plots");
    assert_true(access("unplotted", F_OK) != 0);
}

static void a_gnuplot_that_fails_is_quoted(void **state)
{
    (void)state;
    assert_fails("mkdir fake; printf '#!/bin/sh\ncase \"$*\" in *print*) echo \" pngcairo \";; *) printf "
                 "\"\\n  ^\\n\\\"fig3.gp\\\" line 7: undefined variable: f\\n\\n\" >&2; exit 3;; esac\n' "
                 ">fake/gnuplot; chmod +x fake/gnuplot; PATH=$PWD/fake:$PATH; $GLINT paper -o unplotted --only fig3",
                 "gnuplot: no picture from fig3.gp: \"fig3.gp\" line 7: undefined variable: f; ");
    assert_false(exists("unplotted"));
}

/* ---- whole or not at all ---- */

static void when_the_disk_is_full_no_folder_is_left(void **state)
{
    (void)state;
    run("mkdir disk");
    assert_fails("ulimit -f 200; $GLINT paper -o disk/full/report --no-plots", "disk/full/report/fig5.csv: ");
    assert_int_equal(files_in("disk"), 0);
}

static void when_the_disk_is_full_a_folder_that_exists_keeps_its_files(void **state)
{
    (void)state;
    run("mkdir kept; echo mine >kept/mine; echo old >kept/fig3.csv");
    assert_fails("ulimit -f 200; $GLINT paper -o kept --no-plots", "kept/fig5.csv: ");
    assert_quiet("echo old | cmp - kept/fig3.csv && echo mine | cmp - kept/mine");
    assert_int_equal(files_in("kept"), 2);
}

static void a_signal_leaves_nothing(void **state)
{
    (void)state;
    run("mkdir cut; printf '#!/bin/sh\ncase \"$*\" in *print*) echo \" pngcairo \";; *) kill -INT $PPID; sleep 5;; "
        "esac\n' >cut/gnuplot; chmod +x cut/gnuplot; mkdir cut/old; echo old >cut/old/fig3.csv");
    assert_int_equal(run("PATH=$PWD/cut:$PATH; $GLINT paper -o cut/new --only fig3")->status, 128 + SIGINT);
    assert_int_equal(run("PATH=$PWD/cut:$PATH; $GLINT paper -o cut/old --only fig3")->status, 128 + SIGINT);
    assert_quiet("echo old | cmp - cut/old/fig3.csv");
    assert_int_equal(files_in("cut/old"), 1);
    assert_int_equal(files_in("cut"), 2);
}

static void a_folder_that_exists_keeps_other_files(void **state)
{
    (void)state;
    run("mkdir again; echo mine >again/mine; echo old >again/fig4.csv");
    assert_int_equal(run("$GLINT paper -o again/ --no-plots --only fig4")->status, 0);
    assert_quiet("echo mine | cmp - again/mine");
    assert_int_equal(run("cmp again/fig4.csv report/fig4.csv")->status, 0);
    assert_int_equal(files_in("again"), 4); /* and report.html, claims.json */
}

static void a_folder_in_a_files_place_is_named(void **state)
{
    (void)state;
    assert_fails("mkdir -p place/fig4.csv; $GLINT paper -o place --no-plots --only fig4",
                 "place/fig4.csv: is a folder");
    assert_int_equal(files_in("place"), 1);
}

static void plots_are_pictures_and_lie_in_the_report(void **state)
{
    (void)state;
    if (run("gnuplot --version")->status != 0)
        skip();
    assert_int_equal(run("$GLINT paper -o plotted --only fig3,fig5,fig6,fig7a,fig9")->status, 0);
    static const char *const names[] = {"fig3", "fig5", "fig6", "fig7a", "fig9"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[64];
        snprintf(path, sizeof path, "plotted/%s.png", names[i]);
        char *picture = whole_file(path);
        struct stat status;
        assert_memory_equal(picture, "\x89PNG", 4);
        assert_int_equal(stat(path, &status), 0);
        assert_true(status.st_size > 20000); /* an empty plot has less */
        free(picture);
    }
    char *report = whole_file("plotted/report.html");
    int pictures = 0;
    for (const char *at = report; (at = strstr(at, "<img src=\"data:image/png;base64,")); at++)
        pictures++;
    assert_int_equal(pictures, 5);
    free(report);
    /* The scripts that are kept draw the same by themselves. */
    assert_int_equal(run("cd plotted && gnuplot fig3.gp | cmp - fig3.png")->status, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_verdict_follows_from_what_holds),
        cmocka_unit_test(the_papers_numbers_come_out),
        cmocka_unit_test(a_count_is_a_whole_number_in_json),
        cmocka_unit_test(every_claim_has_its_verdict),
        cmocka_unit_test(the_report_holds_every_claim_choice_and_part),
        cmocka_unit_test(each_csv_has_its_rows_of_equal_length),
        cmocka_unit_test(the_librarys_values_in_figure_3_are_the_formulas_rounded),
        cmocka_unit_test(the_reading_of_figure_9_counts_what_its_curves_show),
        cmocka_unit_test(only_the_parts_named_are_written),
        cmocka_unit_test(json_is_what_claims_json_holds),
        cmocka_unit_test(wrong_usage_is_named),
        cmocka_unit_test(a_folder_that_cannot_be_is_named_in_one_line),
        cmocka_unit_test(without_gnuplot_it_says_what_to_do_and_writes_nothing),
        cmocka_unit_test(a_gnuplot_that_fails_is_quoted),
        cmocka_unit_test(when_the_disk_is_full_no_folder_is_left),
        cmocka_unit_test(when_the_disk_is_full_a_folder_that_exists_keeps_its_files),
        cmocka_unit_test(a_signal_leaves_nothing),
        cmocka_unit_test(a_folder_that_exists_keeps_other_files),
        cmocka_unit_test(a_folder_in_a_files_place_is_named),
        cmocka_unit_test(plots_are_pictures_and_lie_in_the_report),
    };
    return cmocka_run_group_tests_name("paper", tests, make_report, remove_report);
}
