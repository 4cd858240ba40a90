/* SPDX-License-Identifier: MIT
 * The `glint` command: picks the subcommand. */
#include <errno.h>
#include <fcntl.h>
#include <lz4.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#include "base/argp.h"
#include "base/message.h"
#include "base/parse.h"
#include "base/stop.h"
#include "commands/commands.h"
#include "image/svg.h"
#include "mesh/import.h"
#include "mesh/import_picture.h"
#include "paper/ranks.h"
#include "sinks/sinks.h"

static const struct command {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *summary;
} commands[] = {
    {"render", command_render, "Shade a map, a mesh or a built-in scene into a picture"},
    {"eval", command_eval, "Print values of a highlight function"},
    {"cutoff", command_cutoff, "Print where a highlight falls below 2^-q"},
    {"table", command_table, "Write a material's table as C source or raw"},
    {"bake", command_bake, "Turn normals or a mesh into data for the library, print the quality"},
    {"material", command_material, "Print a material and a light as C source or JSON"},
    {"stream", command_stream, "Shade frame after frame, send what changed to a display or files"},
    {"list", command_list, "List the displays, chips and ports that frames can be sent to"},
    {"search", command_search, "Search for highlight functions as the modified Schlick paper does"},
    {"paper", command_paper, "Reproduce the paper: table, figures, claims, report"},
    {"page", command_page, "Serve the page on which the library shades in a browser"},
};
enum { COMMAND_COUNT = sizeof commands / sizeof *commands, THREADS_MAX = 256 };

/* The version, and what this build can send frames to, with the libraries behind it. */
static void print_version(FILE *stream)
{
    char *mpi = ranks_library();
    const char *svg = svg_library(), *mesh = import_library(), *jpeg = import_picture_library();
    fprintf(stream, "glint %s\nlibpng %s, liblz4 %s, jansson %s%s%s%s%s%s%s%s%s\nsinks:", GLINT_VERSION_STRING,
            png_get_libpng_ver(NULL), LZ4_versionString(), JANSSON_VERSION, svg ? ", " : "", svg ? svg : "",
            mesh ? ", " : "", mesh ? mesh : "", jpeg ? ", " : "", jpeg ? jpeg : "", mpi ? ", " : "", mpi ? mpi : "");
    free(mpi);
    for (unsigned i = 0; sink_kinds[i]; i++) {
        char *library = sink_kinds[i]->library ? sink_kinds[i]->library() : NULL;
        fprintf(stream, "%s %s", i ? "," : "", sink_kinds[i]->name);
        if (library)
            fprintf(stream, " (%s)", library);
        free(library);
    }
    const char *before = "\nnot built: ";
    for (const struct sink_left_out *out = sinks_left_out; out->name; out++, before = ", ")
        fprintf(stream, "%s%s", before, out->name);
    if (!svg) {
        fprintf(stream, "%sSVG", before);
        before = ", ";
    }
    if (!mesh) {
        fprintf(stream, "%smesh files", before);
        before = ", ";
    }
    if (!jpeg)
        fprintf(stream, "%sJPEG", before);
    fputc('\n', stream);
}

struct call {
    const struct command *command;
    int first; /* of its own words in argv */
    bool help; /* glint help, or glint help COMMAND: as --help */
};

static error_t parse_option(int key, char *argument, struct argp_state *state)
{
    if (key == ARGP_KEY_NO_ARGS)
        refuse(state, "no command; choose one");
    struct call *call = state->input;
    if (key == ARGP_KEY_ARG && strcmp(argument, "help") == 0 && !call->command) {
        call->help = true;
        return 0;
    }
    if (key == ARGP_KEY_ARG && call->command)
        refuse(state, "unexpected argument '%s'; `glint help` takes one command", argument);
    if (key == ARGP_KEY_ARG) {
        const char *names[COMMAND_COUNT + 1] = {NULL};
        for (int i = 0; i < COMMAND_COUNT; i++)
            names[i] = commands[i].name;
        call->command = &commands[parse_choice(state, NULL, "command", argument, names)];
        call->first = state->next - 1;
        if (!call->help)
            state->next = state->argc; /* the command parses the rest */
        return 0;
    }
    return ARGP_ERR_UNKNOWN;
}

static void print_help(FILE *stream)
{
    fputs("Commands:\n", stream); /* argp would break longer lines */
    for (int i = 0; i < COMMAND_COUNT; i++)
        fprintf(stream, "  %-8s %s\n", commands[i].name, commands[i].summary);
    fputs("\n`glint COMMAND --help` and `glint help COMMAND` explain each.\n"
          "Exit status: 0 good, 1 failed, 2 wrong usage.\n"
          "\nExamples:\n"
          "  glint render --scene watchface -o dial.png --model msh -n 60\n"
          "  glint eval --model msh -n 60 0.99\n"
          "  glint paper -o report",
          stream);
}

static char *describe(int key, const char *text, void *input)
{
    (void)input;
    return key == ARGP_KEY_HELP_POST_DOC ? help_text(text, print_help) : (char *)text;
}

/* A file opened later must not get the number of a standard stream that the caller closed: its place is taken by one
 * that fails as the closed one would. */
static void occupy_standard_streams(void)
{
    for (int number = 0; number <= STDERR_FILENO; number++)
        if (fcntl(number, F_GETFD) < 0 && open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY) != number)
            _exit(EXIT_FAILED);
}

/* Help is written by argp, which does not look whether it could be. */
static void check_standard_output(int status, void *unused)
{
    (void)unused;
    if (status != EXIT_GOOD || (fflush(stdout) == 0 && !ferror(stdout)))
        return;
    warn("standard output: could not be written: %s", strerror(errno));
    _exit(EXIT_FAILED);
}

/* OpenMP's library keeps what it knows of its threads on the stack, which OMP_NUM_THREADS may overflow. */
static void limit_threads(void)
{
#ifdef _OPENMP
    if (omp_get_max_threads() > THREADS_MAX)
        omp_set_num_threads(THREADS_MAX);
#endif
}

int main(int argc, char **argv)
{
    occupy_standard_streams();
    stop_at_signals();
    limit_threads();
    on_exit(check_standard_output, NULL);

    static const struct argp argp = {
        NULL,     parse_option, "COMMAND [OPTION...]", "glint: specular highlights with integers only.\vCommands", NULL,
        describe, NULL};
    static char own_name[] = "glint", help[] = "--help", *asked[] = {own_name, help, NULL};
    struct call call = {NULL, 0, false};
    version_print = print_version;
    argv[0] = own_name; /* without its folder, in messages */
    parse_command(&argp, ARGP_IN_ORDER, argc, argv, &call);
    if (call.help && !call.command)
        parse_command(&argp, ARGP_IN_ORDER, 2, asked, &call);
    static char name[32];
    snprintf(name, sizeof name, "glint %s", call.command->name);
    asked[0] = argv[call.first] = name; /* so that help and errors name the subcommand */
    if (call.help)
        return call.command->run(2, asked);
    return call.command->run(argc - call.first, argv + call.first);
}
