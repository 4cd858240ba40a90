/* SPDX-License-Identifier: MIT
 * base/stop.h for one thread without signals. */
#include "base/stop.h"

void signals_hold(sigset_t *before)
{
    *before = 0;
}

void signals_hold_but_faults(sigset_t *before)
{
    *before = 0;
}

void signals_release(const sigset_t *before)
{
    (void)before;
}
