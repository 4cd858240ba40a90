/* SPDX-License-Identifier: MIT
 * argp tells its own errors in two lines, and getopt writes them straight to standard error. So argp is told to be silent
 * (ARGP_NO_ERRS), and a child parser of ours finds out what was wrong when argp gives up. */
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/argp.h"
#include "base/argp_options.h"
#include "base/closest.h"
#include "base/manual.h"
#include "base/memory.h"
#include "base/message.h"

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
    fprintf(stderr, "%s: %s; see `%s --help`\n", state->name, one_line(message), state->name);
    exit(EXIT_USAGE);
}

/* ---- what was wrong ---- */

/* The options of a parser and of its children, without headings. */
static void collect(const struct argp *argp, struct option_list *list)
{
    options_collect(argp, list);
    unsigned count = 0;
    for (unsigned i = 0; i < list->count; i++)
        if (!option_is_heading(list->options[i]))
            list->options[count++] = list->options[i];
    list->count = count;
}

static bool needs_value(const struct argp_option *option)
{
    return option->arg && !(option->flags & OPTION_ARG_OPTIONAL);
}

static void refuse_long_name(const struct argp_state *state, const struct option_list *list, const char *word)
{
    const char *names[OPTIONS_MAX + 1] = {NULL};
    for (unsigned i = 0, count = 0; i < list->count; i++)
        if (list->options[i]->name && !(list->options[i]->flags & OPTION_HIDDEN))
            names[count++] = list->options[i]->name;
    char *name = copied_part(word + 2, strcspn(word + 2, "="));
    const char *closest = closest_name(name, names);
    if (closest)
        refuse(state, "unknown option '--%s' (did you mean '--%s'?)", name, closest);
    refuse(state, "unknown option '--%s'", name);
}

/* "--NAME" or "--NAME=VALUE", of which getopt takes any beginning that only one name has; `all` that have it. */
static const struct argp_option *find_long(const struct option_list *list, const char *word, unsigned *count,
                                           char all[256])
{
    const size_t length = strcspn(word + 2, "=");
    const struct argp_option *found = NULL;
    *count = 0;
    *all = '\0';
    for (unsigned i = 0; i < list->count; i++) {
        const struct argp_option *option = list->options[i];
        if (!option->name || strncmp(option->name, word + 2, length) != 0)
            continue;
        found = option;
        if (!option->name[length]) {
            *count = 1;
            break;
        }
        const size_t at = strlen(all);
        snprintf(all + at, 256 - at, "%s--%s", (*count)++ ? ", " : "", option->name);
    }
    return found;
}

static const struct argp_option *find_letter(const struct option_list *list, char letter)
{
    for (unsigned i = 0; i < list->count; i++)
        if (list->options[i]->key == letter)
            return list->options[i];
    return NULL;
}

/* Returns where it is right. */
static void check_long(const struct argp_state *state, const struct option_list *list, const char *word, bool last)
{
    const size_t length = strcspn(word + 2, "=");
    unsigned count;
    char all[256];
    const struct argp_option *found = find_long(list, word, &count, all);
    if (count == 0)
        refuse_long_name(state, list, word);
    if (count > 1)
        refuse(state, "option '%.*s' is ambiguous; choose from %s", (int)length + 2, word, all);
    const struct argp_option *meant = found;
    while (meant->flags & OPTION_ALIAS)
        meant--;
    if (word[2 + length] && !meant->arg)
        refuse(state, "option '--%s' takes no value", found->name);
    if (!word[2 + length] && needs_value(meant) && last)
        refuse(state, "option '--%s' needs a value: %s", found->name, meant->arg);
}

/* "-abcVALUE". */
static void check_letters(const struct argp_state *state, const struct option_list *list, const char *word, bool last)
{
    for (const char *at = word + 1; *at; at++) {
        const struct argp_option *found = find_letter(list, *at);
        if (!found)
            refuse(state, "unknown option '-%c'%s", *at,
                   strchr("0123456789.", *at) ? " (negative numbers come after the word --)" : "");
        if (needs_value(found) && !at[1] && last)
            refuse(state, "option '-%c' needs a value: %s", *at, found->arg);
        if (found->arg)
            return;
    }
}

/* getopt has stopped behind the word that is wrong, or at it where letters are left. */
static void refuse_option(const struct argp_state *state)
{
    struct option_list list = {.count = 0};
    collect(state->root_argp, &list);
    for (int i = state->next - 1; i <= state->next && i < state->argc; i++) {
        const char *word = state->argv[i];
        const bool last = i + 1 == state->argc;
        if (i > 0 && strncmp(word, "--", 2) == 0 && word[2])
            check_long(state, &list, word, last);
        else if (i > 0 && *word == '-' && word[1] && word[1] != '-')
            check_letters(state, &list, word, last);
    }
    refuse(state, "wrong usage");
}

/* Then `name` is the option's. */
static bool is_among(const struct option_list *its, const struct argp_option *option, const char *but,
                     char name[OPTION_NAME_MAX])
{
    for (unsigned i = 0; i < its->count; i++)
        if (its->options[i] == option && !(option->name && strcmp(option->name, but) == 0)) {
            if (option->name)
                snprintf(name, OPTION_NAME_MAX, "--%s", option->name);
            else
                snprintf(name, OPTION_NAME_MAX, "-%c", option->key);
            return true;
        }
    return false;
}

bool option_given(const struct argp_state *state, const struct argp *of, const char *but, char name[OPTION_NAME_MAX])
{
    struct option_list all = {.count = 0}, its = {.count = 0};
    collect(state->root_argp, &all);
    collect(of, &its);
    for (int i = 1; i < state->argc && strcmp(state->argv[i], "--") != 0; i++) {
        const char *word = state->argv[i];
        unsigned count;
        char names[256];
        bool value_follows = false;
        if (strncmp(word, "--", 2) == 0) {
            const struct argp_option *found = find_long(&all, word, &count, names), *meant = found;
            if (found && is_among(&its, found, but, name))
                return true;
            while (meant && meant->flags & OPTION_ALIAS)
                meant--;
            value_follows = meant && needs_value(meant) && !strchr(word, '=');
        } else if (*word == '-') {
            const struct argp_option *found = NULL;
            for (const char *at = word + 1; *at && !(found && found->arg); at++) {
                found = find_letter(&all, *at);
                if (found && is_among(&its, found, but, name))
                    return true;
                value_follows = found && needs_value(found) && !at[1];
            }
        }
        i += value_follows;
    }
    return false;
}

/* ---- what argp would have given ---- */

enum { KEY_HELP = '?', KEY_USAGE = 1024, KEY_MAN, KEY_OPTIONS, KEY_CHOICES, KEY_VERSION = 'V' };

void (*version_print)(FILE *stream);
bool choices_wanted;

static const struct argp_option common_options[] = {{"help", KEY_HELP, NULL, 0, "Give this help list", -1},
                                                    {"usage", KEY_USAGE, NULL, 0, "Give a short usage message", 0},
                                                    {"version", KEY_VERSION, NULL, 0, "Print program version", -1},
                                                    {"_man", KEY_MAN, NULL, OPTION_HIDDEN, NULL, -1},
                                                    {"_options", KEY_OPTIONS, NULL, OPTION_HIDDEN, NULL, -1},
                                                    {"_choices", KEY_CHOICES, NULL, OPTION_HIDDEN, NULL, -1},
                                                    {0}};

static error_t parse_common(int key, char *text, struct argp_state *state)
{
    switch (key) {
    case KEY_HELP:
    case KEY_USAGE:
        state->flags &= ~(unsigned)ARGP_NO_ERRS; /* which would silence help, too */
        argp_state_help(state, state->out_stream, key == KEY_HELP ? ARGP_HELP_STD_HELP : ARGP_HELP_USAGE);
        exit(EXIT_GOOD);
    case KEY_VERSION:
        if (version_print)
            version_print(state->out_stream);
        exit(EXIT_GOOD);
    case KEY_MAN:
        manual_write(state->root_argp, state->name, state->out_stream);
        exit(EXIT_GOOD);
    case KEY_OPTIONS:
        manual_list_options(state->root_argp, state->out_stream);
        exit(EXIT_GOOD);
    case KEY_CHOICES:
        choices_wanted = true;
        return 0;
    case ARGP_KEY_END: /* comes here before it comes to the command */
        if (choices_wanted)
            exit(EXIT_GOOD);
        return 0;
    case ARGP_KEY_ARG: /* which no other parser took */
        refuse(state, "unexpected argument '%s'", text);
    case ARGP_KEY_ERROR:
        refuse_option(state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

void parse_command(const struct argp *argp, unsigned flags, int argc, char **argv, void *input)
{
    static const struct argp common = {common_options, parse_common, NULL, NULL, NULL, NULL, NULL};
    const struct argp_child children[] = {{argp, 0, NULL, 0}, {&common, 0, NULL, 0}, {NULL, 0, NULL, 0}};
    const struct argp all = {NULL, NULL, NULL, NULL, children, NULL, NULL};
    unsetenv("ARGP_HELP_FMT"); /* with some margins argp writes without end */
    argp_parse(&all, argc, argv, flags | ARGP_NO_ERRS | ARGP_NO_HELP, NULL, input);
}

char *help_text(const char *text, void (*print)(FILE *stream))
{
    char *out = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&out, &size);
    if (!stream)
        return (char *)text;
    print(stream);
    fclose(stream);
    return out;
}
