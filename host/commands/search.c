/* SPDX-License-Identifier: MIT
 * glint search: the paper's search, and wider ones. */
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "base/argp.h"
#include "base/message.h"
#include "base/output.h"
#include "base/parse.h"
#include "commands/commands.h"
#include "paper/search_joint.h"

enum {
    OPTION_EXPONENTS = 256,
    OPTION_COEFFICIENTS,
    OPTION_ANGLES,
    OPTION_SHININESS,
    OPTION_BEST,
    OPTION_STAGE,
    OPTION_JOINT,
    OPTION_CHECKPOINT,
    OPTION_JSON
};

/* 160 MB each of grid points and of powers. */
enum { BEST_MAX = 1000, ANGLES_MAX = 90001, VALUES_MAX = 1000, POINTS_MAX = 20000000, POWERS_MAX = 20000000 };

struct settings {
    struct search_options search;
    double *exponents, *coefficients, *shininess; /* lists from the command line; NULL where the paper's are used */
    const char *output, *checkpoint;
    bool stage_given, first_only, joint, json;
};

static const struct argp_option option_list[] = {
    {"exponents", OPTION_EXPONENTS, "LIST", 0, "Exponents tried for b1 b2 b3 b5, -16 to 16 (default: -3:3)", 0},
    {"coefficients", OPTION_COEFFICIENTS, "LIST", 0,
     "Coefficients tried for a1 a2 a3 a5, 0.001 to 1000 (default: 0.25,0.5,1,1.25,1.5,2,2.5,3)", 0},
    {"angles", OPTION_ANGLES, "COUNT", 0, "Angles in the grid, evenly from 0 to 90 degrees, 2 to 90001 (default: 91)",
     0},
    {"shininess", OPTION_SHININESS, "LIST", 0, "Shininess n in the grid, 0.01 to 100000 (default: 1:1000)", 0},
    {"best", OPTION_BEST, "COUNT", 0, "Exponent sets kept after stage 1, or rows of --joint, 1 to 1000 (default: 5)",
     0},
    {"stage", OPTION_STAGE, "1|2", 0, "Print the rows of this stage; 1 ends there, all coefficients 1 (default: 2)", 0},
    {"joint", OPTION_JOINT, NULL, 0,
     "Every set of exponents with every set of coefficients, in place of the two stages (default lists: -4:4:0.25 and "
     "0.25:2.5:0.25); under mpirun all ranks share the grid",
     0},
    {"checkpoint", OPTION_CHECKPOINT, "FILE", 0,
     "With --joint: keep there what is done, every few seconds, and go on from it", 0},
    {"json", OPTION_JSON, NULL, 0, "Print JSON: the sizes, the rows of each stage", 0},
    {"output", 'o', "FILE", 0, "Write there (default: standard output)", 0},
    {0}};

static const char documentation[] =
    "Searches for functions near Blinn's c^n as the paper does (fig. 2), in its family (4):\n"
    "F = a1 c^b1 / (a2 (a3 n^b3 - a4 (n c)^b4 + a5 c^b5)^b2)\n"
    "with b4 = b3 and a4 = a3.\n"
    "Stage 1 varies the exponents with all coefficients 1 and keeps the best sets; stage 2 varies the coefficients of "
    "each of these and keeps the best."
    "\v"
    "Rows: b1 b2 b3 b4 b5 a1 a2 a3 a4 a5 deviation, with spaces between, the smallest deviation first; deviation is "
    "the mean of |F - c^n| over the grid of angles and shininess. A LIST is A, A:B (step 1) or A:B:STEP, or several "
    "with commas between.\n"
    "A function that is not a finite number somewhere on the grid (0/0, an overflow, a fractional power of a negative "
    "number) is passed over. cos 90 degrees is 6.1e-17, as computed: negative powers of c take their limits from below "
    "90 degrees. Of functions with equal deviation the first in the order of the lists is kept.\n"
    "The time grows with the fourth power of each list's length; where it is going to be over a minute, a line on "
    "standard error says so. Ctrl-C ends the search, and no file is written.\n"
    "\nExamples:\n"
    "  glint search                                   the paper's Table 1\n"
    "  glint search --stage 1 --best 10               ten sets before stage 2\n"
    "  glint search --exponents -3:3:0.5 --json       half steps\n"
    "  glint search --coefficients 0.25:3:0.25 --best 20 -o wide.txt\n"
    "  glint search --joint --exponents 0:3:0.5       both at once, smaller grid\n"
    "  mpirun -n 8 glint search --joint --checkpoint joint.json";

/* `owned` keeps the values; those of an earlier use of the option go. */
static struct search_list list_of(const struct argp_state *state, const char *option, const char *text, double low,
                                  double high, size_t most, double **owned)
{
    free(*owned);
    const size_t count = parse_list(state, option, text, low, high, owned);
    if (count > most)
        refuse(state, "%s: '%s' names %zu values; at most %zu are allowed", option, text, count, most);
    return (struct search_list){*owned, count};
}

static void check_size(const struct argp_state *state, const struct search_options *search)
{
    const double points = (double)search->angles * (double)search->shininess.count;
    if (points > POINTS_MAX)
        refuse(state, "--angles, --shininess: %.0f grid points; at most %d are allowed", points, POINTS_MAX);
    const double powers = ((double)search->angles + (double)search->shininess.count) * (double)search->exponents.count;
    if (powers > POWERS_MAX)
        refuse(state, "--exponents: %zu of %zu angles and %zu shininess are %.0f powers; at most %d are allowed",
               search->exponents.count, search->angles, search->shininess.count, powers, POWERS_MAX);
}

/* --joint has lists of its own where none are given, and limits; what goes with it alone is refused without it. */
static void check_joint(const struct argp_state *state, struct settings *settings)
{
    struct search_options *search = &settings->search;
    struct ranks ranks;
    if (!settings->joint) {
        if (settings->checkpoint)
            refuse(state, "--checkpoint: only --joint writes checkpoints");
        if (ranks_launched(&ranks) && ranks.count > 1)
            refuse(state, "mpirun: only --joint is spread over ranks; add --joint, or leave mpirun out");
        return;
    }
    if (settings->stage_given)
        refuse(state, "--stage: --joint has no stages; leave one of the two out");
    const struct search_options joint = search_options_joint();
    if (!settings->exponents)
        search->exponents = joint.exponents;
    if (!settings->coefficients)
        search->coefficients = joint.coefficients;
    if (search->exponents.count > JOINT_EXPONENTS_MAX)
        refuse(state, "--exponents: %zu values; with --joint at most %d are allowed", search->exponents.count,
               JOINT_EXPONENTS_MAX);
    if (search->coefficients.count > JOINT_COEFFICIENTS_MAX)
        refuse(state, "--coefficients: %zu values; with --joint at most %d are allowed", search->coefficients.count,
               JOINT_COEFFICIENTS_MAX);
    if (settings->checkpoint && strcmp(settings->checkpoint, "-") == 0)
        refuse(state, "--checkpoint: a checkpoint is a file, not standard output");
    if (settings->checkpoint && output_same(settings->checkpoint, settings->output))
        refuse(state, "--checkpoint: this is the file of -o, too; name another");
}

static error_t parse_option(int key, char *argument, struct argp_state *state)
{
    struct settings *settings = state->input;
    struct search_options *search = &settings->search;
    switch (key) {
    case OPTION_EXPONENTS:
        search->exponents = list_of(state, "--exponents", argument, -16, 16, VALUES_MAX, &settings->exponents);
        return 0;
    case OPTION_COEFFICIENTS:
        search->coefficients =
            list_of(state, "--coefficients", argument, 0.001, 1000, VALUES_MAX, &settings->coefficients);
        return 0;
    case OPTION_ANGLES:
        search->angles = (size_t)parse_integer(state, "--angles", argument, 2, ANGLES_MAX);
        return 0;
    case OPTION_SHININESS:
        search->shininess = list_of(state, "--shininess", argument, 0.01, 100000, POINTS_MAX, &settings->shininess);
        return 0;
    case OPTION_BEST:
        search->best = (size_t)parse_integer(state, "--best", argument, 1, BEST_MAX);
        return 0;
    case OPTION_STAGE:
        settings->stage_given = true;
        settings->first_only = parse_integer(state, "--stage", argument, 1, 2) == 1;
        return 0;
    case OPTION_JOINT:
        settings->joint = true;
        return 0;
    case OPTION_CHECKPOINT:
        settings->checkpoint = parse_output(state, "--checkpoint", argument);
        return 0;
    case OPTION_JSON:
        settings->json = true;
        return 0;
    case 'o':
        settings->output = parse_output(state, "-o", argument);
        return 0;
    case ARGP_KEY_ARG:
        refuse(state, "unexpected argument '%s'; give options only", argument);
        return 0;
    case ARGP_KEY_END:
        check_joint(state, settings);
        check_size(state, search);
        if (settings->first_only && settings->coefficients)
            refuse(state, "--coefficients: stage 1 has all coefficients 1; leave it out, or ask for --stage 2");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void print_row(FILE *stream, const struct search_row *row)
{
    for (int i = 0; i < 5; i++)
        fprintf(stream, "%g ", row->family.b[i]);
    for (int i = 0; i < 5; i++)
        fprintf(stream, "%g ", row->family.a[i]);
    fprintf(stream, "%.8f\n", row->deviation);
}

static json_t *json_numbers(const double values[5])
{
    return json_pack("[f,f,f,f,f]", values[0], values[1], values[2], values[3], values[4]);
}

static json_t *json_rows(const struct search_row *rows, size_t count)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(array, json_pack("{s:o,s:o,s:f}", "b", json_numbers(rows[i].family.b), "a",
                                               json_numbers(rows[i].family.a), "deviation", rows[i].deviation));
    return array;
}

static void print_json(FILE *stream, const struct settings *settings, const struct search_result *result)
{
    const struct search_options *search = &settings->search;
    json_t *root =
        json_pack("{s:I,s:I}", "angles", (json_int_t)search->angles, "shininess", (json_int_t)search->shininess.count);
    if (!settings->joint)
        json_object_update_new(root, json_pack("{s:I,s:o}", "stage1_functions", (json_int_t)search_first_size(search),
                                               "stage1", json_rows(result->first, result->first_count)));
    if (settings->joint)
        json_object_update_new(root, json_pack("{s:f,s:o}", "joint_functions", search_joint_size(search), "rows",
                                               json_rows(result->rows, result->count)));
    else if (!settings->first_only)
        json_object_update_new(root, json_pack("{s:I,s:o}", "stage2_functions", (json_int_t)search_second_size(search),
                                               "rows", json_rows(result->rows, result->count)));
    json_dumpf(root, stream, JSON_INDENT(2) | JSON_REAL_PRECISION(12));
    fputc('\n', stream);
    json_decref(root);
}

static void print_result(FILE *stream, const struct settings *settings, const struct search_result *result)
{
    const size_t count = settings->first_only ? result->first_count : result->count;
    if (count == 0)
        fail("search: no function is a finite number on the whole grid; widen --exponents or --coefficients");
    if (settings->json)
        print_json(stream, settings, result);
    else
        for (size_t i = 0; i < count; i++)
            print_row(stream, settings->first_only ? &result->first[i] : &result->rows[i]);
}

int command_search(int argc, char **argv)
{
    static const struct argp argp = {option_list, parse_option, NULL, documentation, NULL, NULL, NULL};
    struct settings settings = {.search = search_options_paper(), .output = "-"};
    ranks_let_first_speak();
    parse_command(&argp, 0, argc, argv, &settings);

    const struct ranks ranks = settings.joint ? ranks_begin() : (struct ranks){0, 1};
    /* A name that cannot be written is found out now. */
    struct output *output = ranks.index == 0 ? output_open(settings.output) : NULL;
    struct search_result result;
    if (settings.joint)
        search_joint(&settings.search, &ranks, settings.checkpoint, &result);
    else
        search_run(&settings.search, settings.first_only ? 1 : 2, &result);
    if (output)
        print_result(output->stream, &settings, &result);
    if (output)
        output_close(output);
    if (settings.joint)
        ranks_end(&ranks);
    search_free(&result);
    free(settings.exponents);
    free(settings.coefficients);
    free(settings.shininess);
    return EXIT_GOOD;
}
