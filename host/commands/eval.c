/* SPDX-License-Identifier: MIT
 * glint eval: values of the lobe beside those of the double-precision formula. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/argp.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "base/parse.h"
#include "base/rows.h"
#include "commands/commands.h"
#include "models/models.h"
#include "options/lobe_options.h"

enum { KEY_T = 256, KEY_RAW };

struct request {
    struct lobe_options lobes;
    int q; /* -1: no cutoff */
    bool of_t, raw;
    char **values; /* the words as given */
    size_t value_count;
};

static const struct argp_option options[] = {
    {"cutoff", 'q', "Q", 0, "Apply the cutoff: values below 2^-Q become 0; 0 to 16; default: no cutoff", 0},
    {"t", KEY_T, NULL, 0, "The values are t = 1 - c, 0 to 2: finer than c near the peak", 0},
    {"raw", KEY_RAW, NULL, 0, "The values are the library's integers: c times 2^16, or t times 2^30", 0},
    {0}};

static const char doc[] =
    "Prints values of a highlight function, from the integer library and from the double-precision formula at the same "
    "argument, with the difference in units of 2^-16.\v"
    "A VALUE is a cosine c from -1 to 1, a range A:B (step 1) or A:B:STEP, or several of these separated by commas; "
    "- reads values from standard input, separated by blanks or new lines. Write -- before values that begin with a "
    "minus. c is first rounded to Q16.16, t to Q2.30: all columns are for the rounded argument. A row that the "
    "cutoff makes 0 has no error.\n"
    "\n"
    "Examples:\n"
    "  glint eval --model msh -n 60 0.99 0.5\n"
    "  glint eval --model all -n 10,60,1000 0.9:1:0.01 --csv -o lobes.csv\n"
    "  glint eval --model gauss -n 1000 -q 8 --t 0:0.01:0.0005\n"
    "  glint eval --raw 65535 65536 --json\n"
    "  seq 0 0.1 1 | glint eval -n 20 -";

/* ---- one value ---- */

static const struct column columns_of_c[] = {{"model", -7, 0}, {"n", 4, 0},  {"c", 12, 9},       {"c_q16", 10, 0},
                                             {"F_q16", 6, 0},  {"F", 11, 9}, {"formula", 11, 9}, {"error_ulp", 9, 4}};
static const struct column columns_of_t[] = {{"model", -7, 0}, {"n", 4, 0},  {"t", 12, 9},       {"t_q30", 10, 0},
                                             {"F_q16", 6, 0},  {"F", 11, 9}, {"formula", 11, 9}, {"error_ulp", 9, 4}};
enum { COLUMN_COUNT = sizeof columns_of_c / sizeof *columns_of_c };

static void add_row(struct rows *rows, const struct request *request, enum glint_model model, uint32_t n, double value)
{
    const double one = request->of_t ? GLINT_T_ONE : GLINT_C_ONE;
    const double integer = request->raw ? value : round(value * one);
    const double argument = integer / one;
    const double c = request->of_t ? 1 - argument : argument;
    const uint32_t whole =
        request->of_t ? glint_eval_t(model, n, (uint32_t)integer) : glint_eval(model, n, (int32_t)integer);
    uint32_t f = whole;
    if (request->q >= 0) {
        struct glint_lobe lobe;
        glint_lobe_init(&lobe, model, n, (unsigned)request->q);
        f = request->of_t ? glint_lobe_eval_t(&lobe, (uint32_t)integer) : glint_lobe_eval(&lobe, (int32_t)integer);
    }
    const double formula = c < 0 ? 0 : model_double(model, n, c);
    const struct cell cells[COLUMN_COUNT] = {
        {CELL_TEXT, {.text = model_names[model]}},
        {CELL_INTEGER, {.integer = n}},
        {CELL_REAL, {.real = argument}},
        {CELL_INTEGER, {.integer = (long long)integer}},
        {CELL_INTEGER, {.integer = f}},
        {CELL_REAL, {.real = f / (double)GLINT_C_ONE}},
        {CELL_REAL, {.real = formula}},
        {f == whole ? CELL_REAL : CELL_NONE, {.real = f - formula * GLINT_C_ONE}},
    };
    rows_add(rows, cells);
}

/* ---- values from words ---- */

/* `state` NULL: the word is from standard input, at the place `where`. */
static size_t parse_values(const struct argp_state *state, const struct request *request, const char *where,
                           const char *word, double **values)
{
    if (!request->raw)
        return parse_list(state, where, word, request->of_t ? 0 : -1, request->of_t ? 2 : 1, values);
    long *integers;
    const long low = request->of_t ? 0 : -GLINT_C_ONE, high = request->of_t ? 2L * GLINT_T_ONE : GLINT_C_ONE;
    const size_t count = parse_integer_list(state, where, word, low, high, &integers);
    *values = allocate(count, sizeof **values);
    for (size_t i = 0; i < count; i++)
        (*values)[i] = (double)integers[i];
    free(integers);
    return count;
}

static void add_word(struct rows *rows, const struct request *request, const char *where, const char *word)
{
    const struct lobe_options *lobes = &request->lobes;
    double *values;
    const size_t count = parse_values(NULL, request, where, word, &values);
    for (int model = 0; model < GLINT_MODEL_COUNT; model++)
        for (size_t i = 0; lobes->model_given[model] && i < lobes->shininess_count; i++)
            for (size_t k = 0; k < count; k++)
                add_row(rows, request, (enum glint_model)model, (uint32_t)lobes->shininess[i], values[k]);
    free(values);
}

static void add_standard_input(struct rows *rows, const struct request *request)
{
    char *line = NULL;
    size_t size = 0;
    ssize_t length;
    for (unsigned long number = 1; (length = getline(&line, &size, stdin)) >= 0; number++) {
        char where[64], *rest = number == 1 ? after_byte_order_mark(line) : line;
        snprintf(where, sizeof where, "standard input, line %lu", number);
        if (strlen(line) != (size_t)length)
            fail("%s: this is not text: it contains a zero byte", where);
        for (char *word; (word = strtok_r(rest, " \t\r\n", &rest));)
            add_word(rows, request, where, word);
    }
    if (ferror(stdin))
        fail("standard input: could not be read: %m");
    free(line);
}

/* ---- the command ---- */

static void check_values(const struct argp_state *state, const struct request *request)
{
    if (request->value_count == 0)
        refuse(state, "no value; give a cosine such as 0.99, a range A:B:STEP, or - for standard input");
    for (size_t i = 0; i < request->value_count; i++) {
        double *values;
        if (strcmp(request->values[i], "-") == 0)
            continue;
        parse_values(state, request, "VALUE", request->values[i], &values);
        free(values);
    }
}

static error_t parse_option(int key, char *argument, struct argp_state *state)
{
    struct request *request = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &request->lobes;
        return 0;
    case 'q':
        request->q = (int)parse_integer(state, "-q", argument, 0, GLINT_Q_MAX);
        return 0;
    case KEY_T:
        request->of_t = true;
        return 0;
    case KEY_RAW:
        request->raw = true;
        return 0;
    case ARGP_KEY_ARGS:
        request->values = state->argv + state->next;
        request->value_count = (size_t)(state->argc - state->next);
        return 0;
    case ARGP_KEY_END: /* only now is it known whether the values are raw or t */
        check_values(state, request);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

int command_eval(int argc, char **argv)
{
    static const struct argp_child children[] = {{&lobe_options_argp, 0, NULL, 0}, {NULL, 0, NULL, 0}};
    static const struct argp argp = {options, parse_option, "VALUE...", doc, children, NULL, NULL};
    struct request request = {.q = -1};
    parse_command(&argp, 0, argc, argv, &request);

    for (size_t i = 0; i < request.value_count; i++)
        if (strcmp(request.values[i], "-") == 0)
            output_never(stdin);
    struct output *output = output_open(request.lobes.path);
    struct rows *rows =
        rows_begin(output->stream, request.lobes.format, request.of_t ? columns_of_t : columns_of_c, COLUMN_COUNT);
    for (size_t i = 0; i < request.value_count; i++) {
        if (strcmp(request.values[i], "-") == 0)
            add_standard_input(rows, &request);
        else
            add_word(rows, &request, "VALUE", request.values[i]);
    }
    rows_end(rows);
    output_close(output);
    free(request.lobes.shininess);
    return EXIT_GOOD;
}
