/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>

#include "base/clock.h"
#include "base/message.h"
#include "paper/search_clock.h"

static void describe_time(char *text, size_t size, double time)
{
    if (time < 90)
        snprintf(text, size, "%.0f s", ceil(time));
    else if (time < 90 * 60)
        snprintf(text, size, "%.0f min", time / 60);
    else
        snprintf(text, size, "%.1f h", time / 3600);
}

void search_clock_tick(struct search_clock *clock, double done)
{
    const double now = seconds_now(), passed = now - clock->start;
    if (now - clock->shown < 0.2 || done <= clock->before)
        return;
    clock->shown = now;
    const double time_left = passed * (clock->total - done) / (done - clock->before);
    char left[32];
    describe_time(left, sizeof left, time_left);
    if (clock->stop && !clock->warned && passed > 2 && time_left > 60) {
        clock->warned = true;
        warn("search: %s of %.0f functions will take about %s; Ctrl-C stops, and %s", clock->what, clock->total, left,
             clock->stop);
    }
    progress("search: %s, %.0f %% of %.0f functions, %s left", clock->what, 100 * done / clock->total, clock->total,
             left);
}
