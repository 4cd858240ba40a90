/* SPDX-License-Identifier: MIT
 * The sinks compiled in and those left out, and what they share. */
#include "sinks/sink.h"

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
