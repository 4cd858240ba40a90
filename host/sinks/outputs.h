/* SPDX-License-Identifier: MIT
 * Where the bytes of a sink go, which decides what -o means. A kind that is not here a sink has in its own file. */
#ifndef GLINT_SINK_OUTPUTS_H
#define GLINT_SINK_OUTPUTS_H

#include "sinks/sink.h"

extern const struct sink_output output_file_a_frame; /* files named by -o, which has a place for the frame's number */
extern const struct sink_output output_one_file;     /* all frames in the file that -o names; -: standard output */
extern const struct sink_output output_standard;     /* standard output, bytes for another program; no -o */
extern const struct sink_output output_terminal;     /* standard output, which must be a terminal; no -o */

#endif
