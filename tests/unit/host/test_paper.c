/* SPDX-License-Identifier: MIT
 * glint paper: the numbers, claims and files of a report, which is made once. */
#include <jansson.h>
#include <math.h>

#include "files.h"

#include "paper/formula.h"

#include "models/models.h"
#include "paper/paper.h"

/* All but the wider search, which has no claim and takes most of the time: slow/test_paper_whole.c has it. */
#define PARTS "table1,joint,models,fig3,fig4,fig5,fig6,fig7a,fig7b,fig9,grain"

/* claims.json of a run without plots, in the folder "report". */
static json_t *summary;

static int make_report(void **state)
{
    if (scratch_make(state) != 0 || run("$GLINT paper -o report --no-plots --only " PARTS)->status != 0)
        return -1;
    summary = json_load_file("report/claims.json", 0, NULL);
    return summary ? 0 : -1;
}

static int remove_report(void **state)
{
    json_decref(summary);
    return scratch_remove(state);
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
        {"joint_best", 0.003999, 0.5e-6},
        {"deviation_msh_q16", 0.006555, 1e-6},
        {"fig3_q16_t_largest_ulp", 0.5, 0.01},
        {"grain_largest_ggx_by_m", 0, 1e-12},
    };
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        print_message("%s\n", wanted[i].name);
        assert_near(number(wanted[i].name), wanted[i].value, wanted[i].tolerance);
    }
}

/* Along the lines of a turned surface every direction is met: where n_across = n it is the paper's function, which is apart from c^n by
 * no more than figure 5 says. */
static void by_grain_the_function_is_apart_from_others_about_as_it_is_without(void **state)
{
    (void)state;
    static const char *const shapes[] = {"disc", "sphere", "plate"}, *const others[] = {"ashikhmin", "ward", "ggx"};
    for (int i = 0; i < 3; i++) {
        char name[64];
        snprintf(name, sizeof name, "grain_largest_%s_blinn", shapes[i]);
        assert_true(number(name) > 0.01 && number(name) < number("largest_error_msh"));
        for (int k = 0; k < 3; k++) {
            snprintf(name, sizeof name, "grain_largest_%s_%s", shapes[i], others[k]);
            assert_true(number(name) > 0.01 && number(name) < 0.1);
        }
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
    static const char *const parts[] = {"16<i>n</i><sup>2</sup> &minus; 40<i>n</i> + 25",
                                        "<i>F</i> &le; 2<sup>&minus;<i>q</i></sup>",
                                        "whose cutoff bounds the loop",
                                        "e<sup>&minus;1.2</sup> = 0.3012",
                                        "Lyon 1993, gamma 4",
                                        "Spherical Gaussian",
                                        "Cayley (ours)",
                                        "id=\"fig3\"",
                                        "id=\"fig4\"",
                                        "id=\"fig5\"",
                                        "id=\"fig6\"",
                                        "id=\"fig7a\"",
                                        "id=\"fig7b\"",
                                        "id=\"fig9\"",
                                        "id=\"grain\"",
                                        "anisotropy for one dot product more"};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        assert_contains(report, parts[i]);
    free(report);
}

static void formulas_are_set_and_other_text_stays(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"F_B = c^n", "<i>F</i><sub>B</sub> = <i>c</i><sup><i>n</i></sup>"},
        {"F_MSH, n_across", "<i>F</i><sub>MSH</sub>, <i>n</i><sub>across</sub>"},
        {"2^-q, e^-1.2.", "2<sup>&minus;<i>q</i></sup>, e<sup>&minus;1.2</sup>."},
        {"x^(1 + n)^2", "x<sup>1 + <i>n</i></sup><sup>2</sup>"},
        {"a1 c^b1 - a2", "<i>a</i><sub>1</sub> <i>c</i><sup><i>b</i><sub>1</sub></sup> &minus; <i>a</i><sub>2</sub>"},
        {"R. F. Lyon has F.", "R. F. Lyon has <i>F</i>."},
        {"N.H, (H.T)^2; U.K.", "N&middot;H, (H&middot;T)<sup>2</sup>; U.K."},
        {"1.19e+10 of 4e-07, e-7, 2e",
         "1.19&nbsp;&times;&nbsp;10<sup>10</sup> of 4&nbsp;&times;&nbsp;10<sup>&minus;7</sup>, e-7, 2e"},
        {"16n^2 <= sqrt(k)", "16<i>n</i><sup>2</sup> &le; &radic;(<i>k</i>)"},
        {"`a1 < n` & \"", "<code>a1 &lt; n</code> &amp; &quot;"},
        {"fig9_n.csv, an, F's, a ^ b, n^", "fig9_n.csv, an, F's, a ^ b, <i>n</i>^"},
        {"open ` and (n^(2", "open ` and (<i>n</i>^(2"},
        {"", ""}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *html = NULL;
        size_t size = 0;
        FILE *stream = open_memstream(&html, &size);
        assert_non_null(stream);
        formula_put(stream, cases[i][0]);
        assert_int_equal(fclose(stream), 0);
        assert_string_equal(html, cases[i][1]);
        free(html);
    }
}

/* ---- the CSV files ---- */

static void each_csv_has_its_rows_of_equal_length(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int rows, columns;
    } files[] = {
        {"table1", 5, 15},     {"joint", 5, 11},         {"models", GLINT_MODEL_COUNT - 1, 17},
        {"fig3", 361, 10},     {"fig4", 1000, 7},        {"fig5", 38 * 361, 6},
        {"fig6", 38 * 360, 5}, {"fig7a", 28 * 16, 7},    {"fig7b", 28 * 16, 7},
        {"fig9", 1000, 7},     {"fig9_readings", 24, 7}, {"grain", 160 * 160, 14},
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

static void a_folders_name_is_printed_without_control_characters(void **state)
{
    (void)state;
    assert_contains(run("$GLINT paper -o \"$(printf 'a\\033b')\" --no-plots --only fig9")->out, "\na?b/report.html\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_verdict_follows_from_what_holds),
        cmocka_unit_test(the_papers_numbers_come_out),
        cmocka_unit_test(by_grain_the_function_is_apart_from_others_about_as_it_is_without),
        cmocka_unit_test(a_count_is_a_whole_number_in_json),
        cmocka_unit_test(every_claim_has_its_verdict),
        cmocka_unit_test(formulas_are_set_and_other_text_stays),
        cmocka_unit_test(the_report_holds_every_claim_choice_and_part),
        cmocka_unit_test(each_csv_has_its_rows_of_equal_length),
        cmocka_unit_test(the_librarys_values_in_figure_3_are_the_formulas_rounded),
        cmocka_unit_test(the_reading_of_figure_9_counts_what_its_curves_show),
        cmocka_unit_test(a_folders_name_is_printed_without_control_characters),
    };
    return cmocka_run_group_tests_name("paper", tests, make_report, remove_report);
}
