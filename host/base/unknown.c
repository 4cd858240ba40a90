/* SPDX-License-Identifier: MIT */
#include "base/unknown.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/argp.h"
#include "base/closest.h"
#include "base/message.h"

void refuse_unknown(const struct argp_state *state, const char *origin, const char *what, const char *text,
                    const char *const *names)
{
    if (choices_wanted) {
        for (size_t i = 0; names[i]; i++)
            puts(names[i]);
        exit(EXIT_GOOD);
    }
    char all[256] = "", question[64] = "";
    for (size_t i = 0, at = 0; names[i] && at < sizeof all; i++)
        at += (size_t)snprintf(all + at, sizeof all - at, "%s%s", i ? ", " : "", names[i]);
    const char *closest = closest_name(text, names);
    if (closest)
        snprintf(question, sizeof question, " did you mean '%s'?", closest);
    refuse(state, "%s%sunknown %s '%s';%s choose from %s", origin ? origin : "", origin ? ": " : "", what, text,
           question, all);
}
