/* SPDX-License-Identifier: MIT
 * glint cutoff: where a highlight falls below 2^-q. */
#include <math.h>
#include <stdlib.h>

#include "base/argp.h"
#include "base/message.h"
#include "base/output.h"
#include "base/parse.h"
#include "base/rows.h"
#include "commands/commands.h"
#include "models/models.h"
#include "options/lobe_options.h"

struct request {
    struct lobe_options lobes;
    long *q;
    size_t q_count;
};

static const struct argp_option options[] = {
    {"cutoff", 'q', "LIST", 0, "The cutoff is 2^-Q; whole numbers from 0 to 16; default 8", 0}, {0}};

static const char doc[] =
    "Prints where a highlight falls below 2^-Q: the smallest cosine and the largest t = 1 - c with a value of at least "
    "2^-Q, and the angle from the peak.\v"
    "A LIST is A, A:B (step 1), A:B:STEP, or several of these separated by commas. c_q16 is the cosine times 2^16, "
    "t_q30 is t times 2^30, the angle belongs to t_q30 and is in degrees.\n"
    "\n"
    "Examples:\n"
    "  glint cutoff --model msh -n 60 -q 8\n"
    "  glint cutoff --model all -n 10,100,1000 -q 6,8,12\n"
    "  glint cutoff --model blinn -n 1:1000 -q 8 --csv -o cutoffs.csv";

static const struct column columns[] = {{"model", -7, 0}, {"n", 4, 0},      {"q", 2, 0},      {"c_q16", 6, 0},
                                        {"c", 9, 6},      {"angle", 10, 6}, {"t_q30", 10, 0}, {"t", 11, 9}};
enum { COLUMN_COUNT = sizeof columns / sizeof *columns };

static void add_row(struct rows *rows, enum glint_model model, uint32_t n, unsigned q)
{
    const uint32_t c_q16 = glint_cutoff(model, n, q), t_q30 = glint_cutoff_t(model, n, q);
    const double t = t_q30 / (double)GLINT_T_ONE;
    const double angle = 2 * asin(sqrt(t / 2)) * 180 / M_PI; /* 1 - cos x = 2 sin^2(x / 2) */
    const struct cell cells[COLUMN_COUNT] = {
        {CELL_TEXT, {.text = model_names[model]}},
        {CELL_INTEGER, {.integer = n}},
        {CELL_INTEGER, {.integer = q}},
        {CELL_INTEGER, {.integer = c_q16}},
        {CELL_REAL, {.real = c_q16 / (double)GLINT_C_ONE}},
        {CELL_REAL, {.real = angle}},
        {CELL_INTEGER, {.integer = t_q30}},
        {CELL_REAL, {.real = t}},
    };
    rows_add(rows, cells);
}

static error_t parse_option(int key, char *argument, struct argp_state *state)
{
    struct request *request = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &request->lobes;
        return 0;
    case 'q':
        free(request->q);
        request->q_count = parse_integer_list(state, "-q", argument, 0, GLINT_Q_MAX, &request->q);
        return 0;
    case ARGP_KEY_ARG:
        refuse(state, "unexpected argument '%s'; give -n LIST and -q LIST", argument);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

int command_cutoff(int argc, char **argv)
{
    static const struct argp_child children[] = {{&lobe_options_argp, 0, NULL, 0}, {NULL, 0, NULL, 0}};
    static const struct argp argp = {options, parse_option, NULL, doc, children, NULL, NULL};
    struct request request = {.q = NULL};
    request.q_count = parse_integer_list(NULL, "-q", "8", 0, GLINT_Q_MAX, &request.q);
    parse_command(&argp, 0, argc, argv, &request);

    const struct lobe_options *lobes = &request.lobes;
    struct output *output = output_open(lobes->path);
    struct rows *rows = rows_begin(output->stream, lobes->format, columns, COLUMN_COUNT);
    for (int model = 0; model < GLINT_MODEL_COUNT; model++)
        for (size_t i = 0; lobes->model_given[model] && i < lobes->shininess_count; i++)
            for (size_t k = 0; k < request.q_count; k++)
                add_row(rows, (enum glint_model)model, (uint32_t)lobes->shininess[i], (unsigned)request.q[k]);
    rows_end(rows);
    output_close(output);
    free(lobes->shininess);
    free(request.q);
    return EXIT_GOOD;
}
