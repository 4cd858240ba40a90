/* SPDX-License-Identifier: MIT
 * glint paper: the paper's table, figures and claims, computed again. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/argp.h"
#include "base/folder.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "base/parse.h"
#include "base/text.h"
#include "commands/commands.h"
#include "paper/grain.h"
#include "paper/joint.h"
#include "paper/lobes.h"
#include "paper/models.h"
#include "paper/paper.h"
#include "paper/plot.h"
#include "paper/relative.h"
#include "paper/report.h"
#include "paper/spots.h"
#include "paper/surfaces.h"
#include "paper/table.h"

enum { OPTION_ONLY = 256, OPTION_NO_PLOTS, OPTION_JSON };

static const struct part {
    const char *name, *what;
    void (*make)(struct paper *paper);
} parts[] = {
    {"table1", "the search, table 1", paper_table1},
    {"wider", "wider searches", paper_wider},
    {"joint", "the joint search", paper_joint},
    {"models", "the table of models", paper_models},
    {"fig3", "figure 3", paper_figure3},
    {"fig4", "figure 4", paper_figure4},
    {"fig5", "figure 5", paper_figure5},
    {"fig6", "figure 6", paper_figure6},
    {"fig7a", "figure 7 A", paper_figure7a},
    {"fig7b", "figure 7 B", paper_figure7b},
    {"fig9", "figure 9", paper_figure9},
    {"grain", "grain", paper_grain},
};
enum { PART_COUNT = sizeof parts / sizeof *parts };

struct settings {
    const char *directory;
    unsigned wanted; /* a bit a part */
    bool plots, json;
};

static const struct argp_option option_list[] = {
    {"output", 'o', "DIR", 0, "The folder to write to; it is created, and files of the same name are replaced", 0},
    {"only", OPTION_ONLY, "PARTS", 0,
     "Only these, separated by commas: table1 wider joint models fig3 fig4 fig5 fig6 fig7a fig7b fig9 grain (default: "
     "all)",
     0},
    {"no-plots", OPTION_NO_PLOTS, NULL, 0, "Write CSV files and a report without plots; this does not need gnuplot", 0},
    {"json", OPTION_JSON, NULL, 0, "Print claims.json instead of the lines", 0},
    {0}};

static const char documentation[] =
    "Computes the results of the modified Schlick paper (Zavalniuk et al. 2022, DOI 10.31649/1999-9941-2022-55-3-4-12) "
    "again: table 1, figures 3 4 5 6 7A 7B 9, every claim with a "
    "verdict, our choices where the paper is silent, wider searches, a comparison of the models, and what grain adds."
    "\v"
    "DIR receives report.html (everything in one file, with plots), claims.json (claims, verdicts and every quoted "
    "number at full precision), and for each part NAME.csv, NAME.gp (the gnuplot script) and NAME.png. The CSV has "
    "every curve twice: from the double formulas and from the Q16 library. One line per claim is printed.\n"
    "gnuplot (Debian: gnuplot-nox) draws the plots; without it glint paper fails unless --no-plots is given.\n"
    "If a step fails, DIR stays as it was.\n"
    "This takes about five seconds on two cores.\n"
    "\nExamples:\n"
    "  glint paper -o report\n"
    "  glint paper -o report --only fig3,fig4\n"
    "  glint paper -o report --no-plots --json | jq '.claims[] | .verdict'";

static unsigned parse_parts(const struct argp_state *state, const char *text)
{
    unsigned wanted = 0;
    char *copy = copied(text), *rest = copy;
    for (char *name; (name = strsep(&rest, ","));) {
        const char *names[PART_COUNT + 1] = {NULL};
        for (int i = 0; i < PART_COUNT; i++)
            names[i] = parts[i].name;
        wanted |= 1u << parse_choice(state, "--only", "part", name, names);
    }
    free(copy);
    return wanted;
}

static error_t parse_option(int key, char *argument, struct argp_state *state)
{
    struct settings *settings = state->input;
    switch (key) {
    case 'o':
        settings->directory = argument;
        return 0;
    case OPTION_ONLY:
        settings->wanted = parse_parts(state, argument);
        return 0;
    case OPTION_NO_PLOTS:
        settings->plots = false;
        return 0;
    case OPTION_JSON:
        settings->json = true;
        return 0;
    case ARGP_KEY_ARG:
        refuse(state, "unexpected argument '%s'; name the folder by -o", argument);
        return 0;
    case ARGP_KEY_END:
        if (!settings->directory || !*settings->directory)
            refuse(state, "no output; give -o DIR, the folder for the report");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void print_claims(const struct paper *paper)
{
    size_t i;
    json_t *claim;
    json_array_foreach(paper->claims, i, claim)
        printf("%-22s %s: %s\n", json_string_value(json_object_get(claim, "verdict")),
               json_string_value(json_object_get(claim, "where")), json_string_value(json_object_get(claim, "claim")));
    text_print(stdout, paper->directory);
    puts("/report.html");
}

static void print_result(const struct paper *paper, bool json)
{
    struct output *output = output_open("-"); /* output_close reports lines that could not be written */
    if (json) {
        json_t *summary = paper_summary(paper);
        json_dumpf(summary, output->stream, JSON_INDENT(2) | JSON_REAL_PRECISION(12));
        fputc('\n', output->stream);
        json_decref(summary);
    } else {
        print_claims(paper);
    }
    output_close(output);
}

int command_paper(int argc, char **argv)
{
    static const struct argp argp = {option_list, parse_option, NULL, documentation, NULL, NULL, NULL};
    struct settings settings = {.wanted = ~0u, .plots = true};
    parse_command(&argp, 0, argc, argv, &settings);

    struct paper paper = {
        .directory = settings.directory,
        .complete = (~settings.wanted & ((1u << PART_COUNT) - 1)) == 0,
        .terminal = settings.plots ? plot_terminal() : NULL,
        .claims = json_array(),
        .choices = json_array(),
        .findings = json_array(),
        .numbers = json_object(),
        .tables = json_object(),
        .figures = json_array(),
    };
    paper.folder = folder_open(settings.directory);
    for (int i = 0; i < PART_COUNT; i++) {
        if (!(settings.wanted >> i & 1))
            continue;
        progress("paper: %s (%d of %d)", parts[i].what, i + 1, PART_COUNT);
        parts[i].make(&paper);
    }
    progress_end();
    paper_report(&paper);
    folder_close(paper.folder);
    print_result(&paper, settings.json);
    json_decref(paper.claims);
    json_decref(paper.choices);
    json_decref(paper.findings);
    json_decref(paper.numbers);
    json_decref(paper.tables);
    json_decref(paper.figures);
    return EXIT_GOOD;
}
