/* SPDX-License-Identifier: MIT
 * Bytes to standard output, a pipe or a file, whole even where a signal ends the stream. */
#ifndef GLINT_SINK_WRITE_H
#define GLINT_SINK_WRITE_H

#include "sinks/sink.h"

/* All of it; `name` is for the message where that fails, which ends the program. After a signal the rest is still written
 * as long as somebody takes it; SINK_INTERRUPTED where nobody does. */
enum sink_result sink_write(int descriptor, const char *name, const void *bytes, size_t count);
/* The same, where a failure does not end the program: 0, EINTR where nobody takes it after a signal, or what errno would be. */
int sink_write_error(int descriptor, const void *bytes, size_t count);

#endif
