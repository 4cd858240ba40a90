/* SPDX-License-Identifier: MIT
 * Which sinks there are: those that sinks.def names. */
#ifndef GLINT_SINKS_H
#define GLINT_SINKS_H

#include "sinks/sink.h"

/* sink_NAME, each defined in its own file. */
#define SINK(name) extern const struct sink_kind sink_##name;
#define LEFT_OUT(name, packages)
#include "sinks/sinks.def"
#undef SINK
#undef LEFT_OUT

enum { SINKS_MAX = 16 };
/* The default first; ends with NULL. */
extern const struct sink_kind *const sink_kinds[];
/* Those that this build is without; ends with a NULL name. */
extern const struct sink_left_out {
    const char *name, *packages;
} sinks_left_out[];

/* "raw, y4m": the sinks for which `is` holds; the text stays until the next call. */
const char *sink_names(bool (*is)(const struct sink_kind *kind));

#endif
