/* SPDX-License-Identifier: MIT
 * The sinks compiled in. */
#include "sink.h"

const struct sink_kind *const sink_kinds[] = {
    &sink_png, &sink_ppm, &sink_raw, &sink_none, NULL,
};
