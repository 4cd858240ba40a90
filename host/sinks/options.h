/* SPDX-License-Identifier: MIT
 * The options of all sinks in one command line: those of a sink that was not chosen are refused. */
#ifndef GLINT_SINK_OPTIONS_H
#define GLINT_SINK_OPTIONS_H

#include "sinks/sinks.h"

enum { SINK_OPTIONS_MAX = 2 * SINKS_MAX };
/* Those of all sinks compiled in, as children of the stream's argp. */
void sink_options_children(struct argp_child children[SINK_OPTIONS_MAX]);
void sink_options_inputs(void **inputs); /* for argp's child_inputs, in the same order */
/* Refuses what was given for another sink. */
void sink_options_check(const struct argp_state *state, const struct sink_kind *kind);

#endif
