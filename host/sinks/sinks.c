/* SPDX-License-Identifier: MIT */
#include "sinks/sinks.h"

#include <string.h>

const struct sink_kind *const sink_kinds[] = {
#define SINK(name) &sink_##name,
#define LEFT_OUT(name, packages)
#include "sinks/sinks.def"
#undef SINK
#undef LEFT_OUT
    NULL,
};
_Static_assert(sizeof sink_kinds / sizeof *sink_kinds <= SINKS_MAX + 1, "SINKS_MAX");

const struct sink_left_out sinks_left_out[] = {
#define SINK(name)
#define LEFT_OUT(name, packages) {#name, packages},
#include "sinks/sinks.def"
#undef SINK
#undef LEFT_OUT
    {NULL, NULL},
};

const char *sink_names(bool (*is)(const struct sink_kind *kind))
{
    static char names[128];
    *names = '\0';
    for (unsigned i = 0; sink_kinds[i]; i++)
        if (is(sink_kinds[i]))
            snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", *names ? ", " : "",
                     sink_kinds[i]->name);
    return names;
}
