/* SPDX-License-Identifier: MIT
 * How far a search is, and how long it will take. */
#ifndef GLINT_SEARCH_CLOCK_H
#define GLINT_SEARCH_CLOCK_H

#include <stdbool.h>

struct search_clock {
    const char *what;
    double total, start; /* functions; seconds_now() when it began */
    double before;       /* functions compared before that, which say nothing about the speed */
    const char *stop;    /* what Ctrl-C leaves behind, for the warning; NULL: no warning */
    double shown;
    bool warned;
};

/* Shows the progress on a terminal, some times a second; once warns of a search that takes over a minute. */
void search_clock_tick(struct search_clock *clock, double done);

#endif
