/* SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "base/parse.h"
#include "models/models.h"
#include "options/lobe_options.h"

/* Beyond those of the commands, whose keys begin at 256. */
enum key { KEY_MODEL = 512, KEY_CSV, KEY_JSON };

static const struct argp_option argp_options[] = {
    {"model", KEY_MODEL, "NAME", 0, MODEL_WORDS "or all; default: msh", 0},
    {"shininess", 'n', "LIST", 0, "Shininess, whole numbers from 1 to 1000; default 60", 0},
    {"csv", KEY_CSV, NULL, 0, "Print comma-separated values instead of aligned text", 1},
    {"json", KEY_JSON, NULL, 0, "Print JSON: an array with one object per row", 1},
    {"output", 'o', "FILE", 0, "Write to FILE (default: -, standard output)", 1},
    {0}};

static void parse_shininess(const struct argp_state *state, const char *text, struct lobe_options *options)
{
    free(options->shininess);
    options->shininess_count = parse_integer_list(state, "-n", text, 1, GLINT_N_MAX, &options->shininess);
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct lobe_options *options = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        *options = (struct lobe_options){.model_given = {[GLINT_MSH] = true}, .path = "-"};
        parse_shininess(state, "60", options);
        return 0;
    case KEY_MODEL:
        parse_models(state, "--model", text, options->model_given);
        return 0;
    case 'n':
        parse_shininess(state, text, options);
        return 0;
    case KEY_CSV:
        parse_rows_format(state, &options->format, ROWS_CSV);
        return 0;
    case KEY_JSON:
        parse_rows_format(state, &options->format, ROWS_JSON);
        return 0;
    case 'o':
        options->path = parse_output(state, "-o", text);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp lobe_options_argp = {argp_options, parse_option, NULL, NULL, NULL, NULL, NULL};
