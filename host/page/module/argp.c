/* SPDX-License-Identifier: MIT
 * Command lines in the page: base/argp.h without help texts, over the same tables and parsers of options.
 *
 * A command's argp and its children become a list, parents first. All get ARGP_KEY_INIT in that order, since parents set
 * their children's inputs; a word goes to the first that knows its option; ARGP_KEY_END comes to children first, and then
 * ARGP_KEY_SUCCESS. */
#include "base/argp.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"

enum { PARSERS_MAX = 8, CHILDREN_MAX = 4 };
struct parser {
    const struct argp *argp;
    void *input, *child_inputs[CHILDREN_MAX];
};
struct parsers {
    struct parser list[PARSERS_MAX];
    unsigned count;
};

bool choices_wanted;

void refuse(const struct argp_state *state, const char *format, ...)
{
    char *message;
    va_list arguments;
    va_start(arguments, format);
    if (vasprintf(&message, format, arguments) < 0)
        fail("out of memory");
    va_end(arguments);
    fprintf(stderr, "%s: %s\n", state ? state->name : "glint", one_line(message));
    exit(EXIT_USAGE);
}

static error_t call(struct parser *parser, int key, char *text, struct argp_state *state)
{
    state->input = parser->input;
    state->child_inputs = parser->child_inputs;
    return parser->argp->parser ? parser->argp->parser(key, text, state) : ARGP_ERR_UNKNOWN;
}

static void begin(struct parsers *parsers, const struct argp *argp, void *input, struct argp_state *state)
{
    if (parsers->count == PARSERS_MAX)
        fail("more than %d parsers of options", PARSERS_MAX);
    struct parser *parser = &parsers->list[parsers->count++];
    *parser = (struct parser){.argp = argp, .input = input};
    call(parser, ARGP_KEY_INIT, NULL, state);
    for (unsigned i = 0; argp->children && argp->children[i].argp && i < CHILDREN_MAX; i++)
        begin(parsers, argp->children[i].argp, parser->child_inputs[i], state);
}

static bool is_named(const struct argp_option *option, const char *word)
{
    const size_t length = strcspn(word + 2, "=");
    return word[1] == '-' ? option->name && strncmp(option->name, word + 2, length) == 0 && !option->name[length]
                          : option->key == word[1];
}

/* Whole names only: "--NAME VALUE", "--NAME=VALUE", "-n VALUE", "-nVALUE". */
static void take_option(struct parsers *parsers, char *word, char **argv, struct argp_state *state)
{
    for (unsigned i = 0; i < parsers->count; i++) {
        const struct argp_option *option = parsers->list[i].argp->options;
        for (; option && (option->name || option->key || option->doc || option->group); option++) {
            if ((!option->name && !option->key) || !is_named(option, word))
                continue;
            const size_t length = word[1] == '-' ? strcspn(word, "=") : 2;
            char *text = word[length] ? word + length + (word[1] == '-') : NULL;
            if (text && !option->arg)
                refuse(state, "option '%.*s' takes no value", (int)length, word);
            const bool needs = option->arg && !(option->flags & OPTION_ARG_OPTIONAL);
            if (!text && needs && state->next == state->argc)
                refuse(state, "option '%s' needs a value: %s", word, option->arg);
            if (!text && needs)
                text = argv[state->next++];
            call(&parsers->list[i], option->key, text, state);
            return;
        }
    }
    refuse(state, "unknown option '%.*s'", (int)strcspn(word, "="), word);
}

void parse_command(const struct argp *argp, unsigned flags, int argc, char **argv, void *input)
{
    (void)flags;
    struct argp_state state = {.name = argv[0], .next = 1, .argc = argc};
    struct parsers parsers = {.count = 0};
    begin(&parsers, argp, input, &state);
    while (state.next < argc) {
        char *word = argv[state.next++];
        if (word[0] == '-' && word[1])
            take_option(&parsers, word, argv, &state);
        else if (call(&parsers.list[0], ARGP_KEY_ARG, word, &state) == ARGP_ERR_UNKNOWN)
            refuse(&state, "unexpected argument '%s'", word);
    }
    for (unsigned i = parsers.count; i-- > 0;)
        call(&parsers.list[i], ARGP_KEY_END, NULL, &state);
    for (unsigned i = parsers.count; i-- > 0;)
        call(&parsers.list[i], ARGP_KEY_SUCCESS, NULL, &state);
}
