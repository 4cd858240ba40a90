/* SPDX-License-Identifier: MIT */
#include "sinks/options.h"

#include "base/argp.h"
#include "base/message.h"

/* The options that a sink, or several, take; argp hands it to parse_one() as its input. */
static struct group {
    const struct argp *argp;
    struct argp watched; /* the same with parse_one() for its parser */
    const char *given;   /* the first of them on the command line, or NULL */
} groups[SINK_OPTIONS_MAX];
static unsigned group_count;

static const char *option_name(const struct argp_option *options, int key)
{
    for (; options->name || options->key || options->doc; options++) /* as argp finds the end */
        if (options->name && options->key == key)
            return options->name;
    return NULL;
}

static error_t parse_one(int key, char *text, struct argp_state *state)
{
    struct group *group = state->input;
    const error_t result = group->argp->parser(key, text, state);
    if (result == 0 && !group->given)
        group->given = option_name(group->argp->options, key);
    return result;
}

static bool takes(const struct sink_kind *kind, const struct argp *argp)
{
    for (const struct argp *const *own = kind->options; own && *own; own++)
        if (*own == argp)
            return true;
    return false;
}

static const struct argp *asked;

static bool takes_asked(const struct sink_kind *kind)
{
    return takes(kind, asked);
}

static void add_group(const struct argp *argp)
{
    for (unsigned i = 0; i < group_count; i++)
        if (groups[i].argp == argp)
            return;
    if (group_count == SINK_OPTIONS_MAX)
        fail("more than %d groups of options", SINK_OPTIONS_MAX);
    struct group *group = &groups[group_count++];
    *group = (struct group){.argp = argp, .watched = *argp};
    group->watched.parser = parse_one;
}

void sink_options_children(struct argp_child children[SINK_OPTIONS_MAX])
{
    for (unsigned i = 0; sink_kinds[i]; i++)
        for (const struct argp *const *own = sink_kinds[i]->options; own && *own; own++)
            add_group(*own);
    for (unsigned i = 0; i < group_count; i++)
        children[i] = (struct argp_child){.argp = &groups[i].watched};
}

void sink_options_inputs(void **inputs)
{
    for (unsigned i = 0; i < group_count; i++)
        inputs[i] = &groups[i];
}

void sink_options_check(const struct argp_state *state, const struct sink_kind *kind)
{
    for (unsigned i = 0; i < group_count; i++) {
        if (!groups[i].given || takes(kind, groups[i].argp))
            continue;
        asked = groups[i].argp;
        refuse(state, "--%s: is for --to %s; leave it out for --to %s", groups[i].given, sink_names(takes_asked),
               kind->name);
    }
}
