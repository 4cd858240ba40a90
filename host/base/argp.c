/* SPDX-License-Identifier: MIT
 * What every command line has in common. Not in main.c: the unit tests link all of the host but that. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/argp.h"
#include "base/message.h"

/* What argp itself refuses it tells in two lines; so that they become one, standard error is held while it parses. */
static FILE *standard_error; /* NULL: it is not held */
static char *held;
static size_t held_bytes;
static const char *held_name; /* the command's */

static void show_held(void)
{
    if (!standard_error)
        return;
    fclose(stderr);
    stderr = standard_error;
    standard_error = NULL;
    char *hint = strstr(held, "\nTry `");
    if (hint) {
        *hint = '\0';
        fprintf(stderr, "%s; see `%s --help`\n", one_line(held), held_name);
    } else {
        fputs(held, stderr);
    }
    free(held);
}

void parse_command(const struct argp *argp, unsigned flags, int argc, char **argv, void *input)
{
    FILE *stream = open_memstream(&held, &held_bytes);
    if (!stream)
        fail("out of memory");
    standard_error = stderr;
    stderr = stream;
    held_name = argv[0];
    atexit(show_held); /* argp ends the program by itself, for --help, too */
    argp_parse(argp, argc, argv, flags, NULL, input);
    show_held();
}

void refuse(const struct argp_state *state, const char *format, ...)
{
    char *message;
    va_list arguments;
    va_start(arguments, format);
    if (vasprintf(&message, format, arguments) < 0)
        fail("out of memory");
    va_end(arguments);
    if (!state)
        fail("%s", message);
    argp_failure(state, EXIT_USAGE, 0, "%s; see `%s --help`", one_line(message), state->name);
    exit(EXIT_USAGE);
}
