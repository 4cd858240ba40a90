/* SPDX-License-Identifier: MIT
 * The sinks compiled in. */
#include "sink.h"

const struct sink_kind *const sink_kinds[] = {
    &sink_png,      &sink_ppm, &sink_raw,
#if GLINT_WITH_TERMINAL
    &sink_terminal,
#endif
    &sink_none,     NULL,
};
