/* SPDX-License-Identifier: MIT
 * glint eval, cutoff and table. */
#include <jansson.h>
#include <math.h>

#include "run.h"

#include "models/models.h"

/* Lines of CSV after the header, with all fields numbers but the first. */
static int read_rows(const char *text, double rows[][8], int limit)
{
    int count = 0;
    for (const char *line = strchr(text, '\n'); line && line[1] && count < limit;
         line = strchr(line + 1, '\n'), count++) {
        const char *at = line;
        for (int i = 1; i < 8; i++) {
            at = strchr(at + 1, ',');
            rows[count][i] = strtod(at + 1, NULL);
        }
    }
    return count;
}

static void eval_prints_the_librarys_value_and_the_formulas(void **state)
{
    (void)state;
    double rows[8][8];
    assert_int_equal(read_rows(run("$GLINT eval --model msh -n 60 0.99 0.5 --csv")->out, rows, 8), 2);
    assert_near(rows[0][3], 64881, 0);
    assert_near(rows[0][4], glint_eval(GLINT_MSH, 60, 64881), 0);
    assert_near(rows[1][4], glint_eval(GLINT_MSH, 60, 32768), 0);
    assert_near(rows[1][6], model_double(GLINT_MSH, 60, 0.5), 1e-11);
    assert_near(rows[1][7], rows[1][4] - rows[1][6] * 65536, 1e-6);
}

static void eval_is_within_half_an_ulp_of_the_formula_for_every_model(void **state)
{
    (void)state;
    static double rows[2000][8];
    const int count = read_rows(run("$GLINT eval --model all -n 1,35,1000 0:1:0.05 --csv")->out, rows, 2000);
    assert_int_equal(count, GLINT_MODEL_COUNT * 3 * 21);
    for (int i = 0; i < count; i++)
        assert_true(fabs(rows[i][7]) <= 0.5000001);
}

static void eval_takes_t_and_raw_integers(void **state)
{
    (void)state;
    double rows[8][8];
    assert_int_equal(read_rows(run("$GLINT eval --model cayley -n 1000 --t 0.001 --csv")->out, rows, 8), 1);
    assert_near(rows[0][3], 1073742, 0);
    assert_near(rows[0][4], glint_eval_t(GLINT_CAYLEY, 1000, 1073742), 0);
    assert_int_equal(read_rows(run("$GLINT eval --model gauss -n 7 --raw 65535,65536 --csv")->out, rows, 8), 2);
    assert_near(rows[0][4], glint_eval(GLINT_GAUSS, 7, 65535), 0);
    assert_int_equal(read_rows(run("$GLINT eval --model gauss -n 7 --raw --t 12345 --csv")->out, rows, 8), 1);
    assert_near(rows[0][4], glint_eval_t(GLINT_GAUSS, 7, 12345), 0);
    assert_int_equal(read_rows(run("$GLINT eval --csv -- -0.5")->out, rows, 8), 1);
    assert_near(rows[0][4], 0, 0);
}

static void eval_applies_the_cutoff_that_cutoff_prints(void **state)
{
    (void)state;
    double rows[8][8];
    char command[96];
    assert_int_equal(read_rows(run("$GLINT cutoff --model blinn -n 60 -q 8 --csv")->out, rows, 8), 1);
    const uint32_t c = glint_cutoff(GLINT_BLINN, 60, 8);
    assert_near(rows[0][3], c, 0);
    assert_near(rows[0][6], glint_cutoff_t(GLINT_BLINN, 60, 8), 0);
    snprintf(command, sizeof command, "$GLINT eval --model blinn -n 60 -q 8 --raw --csv %u,%u", c - 1, c);
    assert_int_equal(read_rows(run(command)->out, rows, 8), 2);
    assert_near(rows[0][4], 0, 0);
    assert_near(rows[1][4], 256, 1);
}

static void the_cutoff_angle_is_the_papers(void **state)
{
    (void)state;
    double rows[32][8];
    assert_int_equal(read_rows(run("$GLINT cutoff --model schlick -n 1:1000:111 -q 6,8 --csv")->out, rows, 32), 20);
    for (int i = 0; i < 20; i++) /* (10) */
        assert_near(rows[i][5], acos(rows[i][1] / (exp2(rows[i][2]) + rows[i][1] - 1)) * 180 / M_PI, 1e-5);
}

static void standard_input_is_read_and_its_errors_name_the_line(void **state)
{
    (void)state;
    double rows[8][8];
    assert_int_equal(read_rows(run("printf '1 0.5\\n\\n0.25,0.125\\r\\n' | $GLINT eval - --csv")->out, rows, 8), 4);
    assert_near(rows[3][3], 8192, 0);
    assert_int_equal(read_rows(run("printf '\\357\\273\\2770.125\\n' | $GLINT eval - --csv")->out, rows, 8), 1);
    assert_near(rows[0][3], 8192, 0);
    assert_fails("printf '1\\n2\\n' | $GLINT eval -", "standard input, line 2: '2' is not a list from -1 to 1");
    assert_fails("printf '1\\0\\n' | $GLINT eval -", "standard input, line 1: this is not text");
    assert_fails("$GLINT eval - <.", "standard input: could not be read: Is a directory");
    assert_refused("$GLINT eval", "no value");
    assert_refused("$GLINT eval 0:0.6:1e-6,0:0.6:1e-6", "has more than 1000000 values");
    assert_refused("$GLINT eval 1.5", "VALUE: '1.5' is not a list from -1 to 1");
    assert_refused("$GLINT eval --raw 0.5", "VALUE: '0.5' is not a list of whole numbers from -65536 to 65536");
    assert_refused("$GLINT cutoff -q 17", "-q: '17' is not a list from 0 to 16");
}

static void json_holds_the_same_as_csv(void **state)
{
    (void)state;
    double rows[8][8];
    assert_int_equal(read_rows(run("$GLINT eval -n 5,50 -q 4 0.99,0.2 --csv")->out, rows, 8), 4);
    json_t *array = json_loads(run("$GLINT eval -n 5,50 -q 4 0.99,0.2 --json")->out, 0, NULL);
    assert_int_equal(json_array_size(array), 4);
    for (int i = 0; i < 4; i++) {
        const json_t *row = json_array_get(array, (size_t)i);
        assert_string_equal(json_string_value(json_object_get(row, "model")), "msh");
        assert_near(json_number_value(json_object_get(row, "F_q16")), rows[i][4], 0);
        assert_near(json_number_value(json_object_get(row, "formula")), rows[i][6], 0);
    }
    assert_true(json_is_null(json_object_get(json_array_get(array, 3), "error_ulp"))); /* cut off */
    json_decref(array);
}

static void two_forms_at_once_are_refused(void **state)
{
    (void)state;
    assert_refused("$GLINT eval --csv --json 1", "give only one of --csv and --json");
    assert_refused("$GLINT eval --json 1 --csv", "give only one of --csv and --json");
    assert_refused("$GLINT cutoff --csv --json", "give only one of --csv and --json");
    assert_int_equal(run("$GLINT cutoff --csv --csv")->status, 0);
}

static void an_error_in_the_first_line_of_standard_input_comes_before_any_output(void **state)
{
    (void)state;
    assert_fails("echo five | $GLINT eval -", "standard input, line 1: 'five'");
    assert_string_equal(run("echo five | $GLINT eval -")->out, "");
    assert_string_equal(run("echo five | $GLINT eval - --csv")->out, "");
    assert_string_equal(run("echo five | $GLINT eval - --json")->out, "");
    const struct run *none = run("$GLINT eval - --csv </dev/null");
    assert_int_equal(none->status, 0);
    assert_string_equal(none->out, "model,n,c,c_q16,F_q16,F,formula,error_ulp\n");
    assert_string_equal(run("$GLINT eval - --json </dev/null")->out, "[]\n");
}

/* ---- tables ---- */

#define COMPILE "${CC:-cc} -std=c99 -Wall -Wextra -Wconversion -Wshadow -Wundef -pedantic -Werror -x c "

static void a_table_is_strict_c99_without_a_warning(void **state)
{
    (void)state;
    static const char *const options[] = {
        "--model msh -n 60 --bits 16",
        "--model msh -n 1 --bits 16 -q 16 --entries 2000",
        "--model gauss -n 200 --bits 8 --of c --entries 64",
        "--model blinn -n 1000 --bits 32 --entries 5000",
        "--model schlick -n 3 --bits 32 --of c --entries 65536 -q 16",
        "--model cayley -n 700 --bits 8 --entries 2",
        "--model msh -n 10 --bits 16 --clamp-peak -q 0",
    };
    for (size_t i = 0; i < sizeof options / sizeof *options; i++) {
        char command[512];
        snprintf(command, sizeof command,
                 "$GLINT table %s --name t -o t.h && printf '#include \"t.h\"\\n#include <stdio.h>\\nint main(void) {"
                 "for (uint32_t x = 0; x <= 65536u; x += 16u) printf(\"%%%%ld %%%%ld\\\\n\", (long)t_nearest(x * 9u),"
                 " (long)t_linear(x * 9u)); return 0; }' >t.c && " COMPILE "t.c -o t && ./t >looked-up",
                 options[i]);
        const struct run *result = run(command);
        assert_string_equal(result->err, "");
        assert_int_equal(result->status, 0);
    }
}

static void any_name_that_is_taken_compiles(void **state)
{
    (void)state;
    static const char *const names[] = {"x", "i", "a", "b", "fraction", "t", "X2", "nearest", "int_shine", "uint"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char command[512];
        snprintf(command, sizeof command,
                 "$GLINT table --name %s -o t.h && printf '#include \"t.h\"\nint main(void) {"
                 "return %s[0] + %s_nearest(1) + %s_linear(1) == 0; }' >t.c && " COMPILE "t.c -o t && ./t",
                 names[i], names[i], names[i], names[i]);
        const struct run *result = run(command);
        assert_string_equal(result->err, "");
        assert_int_equal(result->status, 0);
    }
}

static void a_name_that_cannot_be_one_in_c_or_cxx_is_refused(void **state)
{
    (void)state;
    static const char *const names[] = {
        "",         "9lives",    "a-b",      "int",      "for",       "inline",      "static_assert",
        "class",    "nullptr",   "co_await", "alignas",  "uint16_t",  "uint32_t",    "intptr_t",
        "size_t",   "INT8_MAX",  "UINT32_C", "SIZE_MAX", "WCHAR_MIN", "main",        "_x",
        "__x",      "_X",        "a__b",     "x_",       "asm",       "PTRDIFF_MAX", "WINT_WIDTH",
        "\303\244", "two words", "typeof",   "unix",
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char command[96];
        snprintf(command, sizeof command, "$GLINT table --name \"$(printf '%s')\"", names[i]);
        const struct run *result = run(command);
        if (result->status != 2)
            fail_msg("--name %s: status %d", names[i], result->status);
        assert_contains(result->err, "--name: '");
        assert_one_line(result->err);
        assert_string_equal(result->out, "");
    }
    assert_int_equal(run("$GLINT table --name $(printf %063d 0 | tr 0 n)")->status, 0);
    assert_refused("$GLINT table --name $(printf %064d 0 | tr 0 n)", "at most 63");
}

/* Reads the little-endian entries of a raw table. */
static int raw_entries(const char *options, int bytes, uint32_t *entries, int limit)
{
    char command[256];
    snprintf(command, sizeof command, "$GLINT table %s --raw -o raw", options);
    assert_int_equal(run(command)->status, 0);
    FILE *file = fopen("raw", "rb");
    assert_non_null(file);
    int count = 0, byte;
    for (; count < limit && (byte = fgetc(file)) != EOF; count++) {
        entries[count] = (uint32_t)byte;
        for (int i = 1; i < bytes; i++)
            entries[count] |= (uint32_t)fgetc(file) << (8 * i);
    }
    fclose(file);
    return count;
}

static void entries_are_the_librarys_values(void **state)
{
    (void)state;
    uint32_t entries[300];
    assert_int_equal(raw_entries("--model blinn -n 60 -q 16 --bits 32", 4, entries, 300), 256);
    const uint32_t t_max = glint_cutoff_t(GLINT_BLINN, 60, 16);
    unsigned shift = 0;
    while (((uint64_t)255 << shift) <= t_max)
        shift++;
    for (uint32_t i = 0; i < 256; i++)
        assert_int_equal(entries[i], i << shift <= t_max ? glint_eval_t(GLINT_BLINN, 60, i << shift) : 0);

    assert_int_equal(raw_entries("--model gauss -n 20 -q 8 --bits 8 --of c --entries 100", 1, entries, 300), 100);
    assert_int_equal(entries[0], 255);
    const uint32_t one_step = glint_eval(GLINT_GAUSS, 20, 65536 - 256); /* acos(c) = .77 at the cutoff: x / 256 < 100 */
    assert_int_equal(entries[1], (one_step * 255 + 32768) >> 16);
}

static void no_entry_overflows_at_the_peak_of_msh(void **state)
{
    (void)state;
    uint32_t entries[4];
    assert_int_equal(raw_entries("--entries 4 --bits 8", 1, entries, 4), 4);
    assert_int_equal(entries[0], 255);
    assert_int_equal(raw_entries("--entries 4 --bits 16", 2, entries, 4), 4);
    assert_int_equal(entries[0], (67109 + 1) / 2);
    assert_int_equal(raw_entries("--entries 4 --bits 16 --clamp-peak", 2, entries, 4), 4);
    assert_int_equal(entries[0], 32768);
    assert_int_equal(raw_entries("--entries 4 --bits 32", 4, entries, 4), 4);
    assert_int_equal(entries[0], 67109);
}

static void the_stated_errors_are_those_of_the_compiled_table(void **state)
{
    (void)state;
    /* Another measurement: the written source, compiled, against the formula at every 1009th t. */
    const char *command =
        "$GLINT table --model cayley -n 60 -q 8 --entries 128 --name t -o t.h && "
        "printf '#include \"t.h\"\\n#include <stdio.h>\\nint main(void) {"
        "for (uint32_t x = 0; x < 100000000u; x += 1009u) printf(\"%%ld %%ld\\\\n\", "
        "(long)t_nearest(x), (long)t_linear(x)); return 0; }' >t.c && " COMPILE "t.c -o t && ./t >looked-up";
    assert_int_equal(run(command)->status, 0);
    FILE *file = fopen("looked-up", "r");
    assert_non_null(file);
    double nearest, linear, worst_nearest = 0, worst_linear = 0;
    const double t_max = glint_cutoff_t(GLINT_CAYLEY, 60, 8);
    for (double x = 0; fscanf(file, "%lf %lf", &nearest, &linear) == 2; x += 1009) {
        const double f = x > t_max ? 0 : model_double(GLINT_CAYLEY, 60, 1 - x / GLINT_T_ONE);
        worst_nearest = fmax(worst_nearest, fabs(nearest / 32768 - f));
        worst_linear = fmax(worst_linear, fabs(linear / 32768 - f));
    }
    fclose(file);
    char text[4096];
    read_text("t.h", text, sizeof text);
    const char *stated = strstr(text, "nearest entry");
    assert_non_null(stated);
    assert_near(strtod(stated + strlen("nearest entry"), NULL), worst_nearest, 6e-5);
    stated = strstr(text, "linear interpolation");
    assert_non_null(stated);
    assert_near(strtod(stated + strlen("linear interpolation"), NULL), worst_linear, 6e-5);
}

static void a_table_that_cannot_be_is_refused(void **state)
{
    (void)state;
    assert_refused("$GLINT table --entries 1", "--entries: '1' is not a whole number from 2 to 65536");
    static const char *const bits[] = {"7", "9", "24", "64", "0x8", "", "8.0"};
    for (size_t i = 0; i < sizeof bits / sizeof *bits; i++) {
        char command[64], part[64];
        snprintf(command, sizeof command, "$GLINT table --bits '%s'", bits[i]);
        snprintf(part, sizeof part, "--bits: '%s' is not 8, 16 or 32", bits[i]);
        assert_refused(command, part);
    }
    assert_refused("$GLINT table --raw --name shine", "--name is for C source");
    assert_refused("$GLINT table --name glint_msh", "--name: 'glint_msh' may be a name of glint.h");
    assert_refused("$GLINT table --name GLINT", "--name: 'GLINT' may be a name of glint.h");
    assert_refused("$GLINT table --name NULL", "--name: 'NULL' has a meaning in C or C++");
    assert_refused("$GLINT table --name shine --raw", "--name is for C source");
    assert_refused("$GLINT table --of x", "--of: unknown argument 'x'; choose from c, t");
    assert_refused("$GLINT table shine.h", "unexpected argument 'shine.h'; name the file by -o");
    assert_refused("$GLINT table --model all", "--model: unknown model 'all'; choose from");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eval_prints_the_librarys_value_and_the_formulas),
        cmocka_unit_test(eval_is_within_half_an_ulp_of_the_formula_for_every_model),
        cmocka_unit_test(eval_takes_t_and_raw_integers),
        cmocka_unit_test(eval_applies_the_cutoff_that_cutoff_prints),
        cmocka_unit_test(the_cutoff_angle_is_the_papers),
        cmocka_unit_test(standard_input_is_read_and_its_errors_name_the_line),
        cmocka_unit_test(json_holds_the_same_as_csv),
        cmocka_unit_test(two_forms_at_once_are_refused),
        cmocka_unit_test(an_error_in_the_first_line_of_standard_input_comes_before_any_output),
        cmocka_unit_test(a_table_is_strict_c99_without_a_warning),
        cmocka_unit_test(any_name_that_is_taken_compiles),
        cmocka_unit_test(a_name_that_cannot_be_one_in_c_or_cxx_is_refused),
        cmocka_unit_test(entries_are_the_librarys_values),
        cmocka_unit_test(no_entry_overflows_at_the_peak_of_msh),
        cmocka_unit_test(the_stated_errors_are_those_of_the_compiled_table),
        cmocka_unit_test(a_table_that_cannot_be_is_refused),
    };
    return cmocka_run_group_tests_name("values", tests, scratch_make, scratch_remove);
}
