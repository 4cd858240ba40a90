/* SPDX-License-Identifier: MIT
 * The sinks compiled in. */
#include "sink.h"

/* clang-format off */
const struct sink_kind *const sink_kinds[] = {
    &sink_panel,
    &sink_png,
    &sink_ppm,
    &sink_raw,
#if GLINT_WITH_TERMINAL
    &sink_terminal,
#endif
#if GLINT_WITH_USB
    &sink_usb,
#endif
#if GLINT_WITH_GPIO
    &sink_gpio,
    &sink_spi,
#endif
    &sink_none,
    NULL,
};
/* clang-format on */
