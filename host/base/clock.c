/* SPDX-License-Identifier: MIT */
#include "base/clock.h"

#include <math.h>
#include <time.h>

#include "base/stop.h"

double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* In short sleeps: a signal that comes just before a sleep would not end it. */
void wait_until(double seconds)
{
    for (double now = seconds_now(); now < seconds && !stream_stopped(); now = seconds_now()) {
        const double sleep = fmin(seconds - now, .2);
        nanosleep(&(struct timespec){0, (long)(1e9 * sleep)}, NULL);
    }
}
