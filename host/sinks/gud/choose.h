/* SPDX-License-Identifier: MIT
 * Which of a display's formats and modes: what the user named, else the display's own preference. */
#ifndef GLINT_GUD_CHOOSE_H
#define GLINT_GUD_CHOOSE_H

#include "sinks/gud/host.h"

struct gud_choice {
    enum gud_format format;
    enum glint_format pixels; /* what the library is to write for it */
    struct gud_mode mode;
    size_t max_bytes; /* of a rectangle */
    bool lz4;
};

/* False with a problem. */
bool gud_choose(const struct gud_display *display, const struct sink_wish *wish, struct gud_choice *choice,
                struct gud_problem *problem);

#endif
