/* SPDX-License-Identifier: MIT */
#include "base/argp_options.h"

#include <limits.h>

bool option_is_heading(const struct argp_option *option)
{
    return !option->name && !option->key;
}

static bool ends(const struct argp_option *o)
{
    return !o->name && !o->key && !o->doc && !o->group;
}

/* An option without a group has that of the one before it, a heading without one begins the next. */
static void add(const struct argp *argp, struct option_list *list)
{
    int group = 0;
    for (const struct argp_option *o = argp->options; o && !ends(o); o++) {
        group = o->group ? o->group : option_is_heading(o) ? group + 1 : group;
        if (!(o->flags & OPTION_DOC) && list->count < OPTIONS_MAX) {
            list->groups[list->count] = group;
            list->options[list->count++] = o;
        }
    }
    for (const struct argp_child *child = argp->children; child && child->argp; child++)
        add(child->argp, list);
}

static long rank(const struct option_list *list, unsigned i)
{
    const long group = list->groups[i];
    return 2 * (group < 0 ? group + INT_MAX : group) + !option_is_heading(list->options[i]);
}

void options_collect(const struct argp *argp, struct option_list *list)
{
    list->count = 0;
    add(argp, list);
    for (unsigned i = 1; i < list->count; i++) /* by insertion: in the tables they are nearly in order */
        for (unsigned k = i; k > 0 && rank(list, k - 1) > rank(list, k); k--) {
            const struct argp_option *option = list->options[k];
            const int group = list->groups[k];
            list->options[k] = list->options[k - 1];
            list->groups[k] = list->groups[k - 1];
            list->options[k - 1] = option;
            list->groups[k - 1] = group;
        }
}

size_t options_sentence(const char *text, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if (text[i] == '.' && (i + 1 == length || text[i + 1] == ' '))
            return i;
    return length;
}
