/* SPDX-License-Identifier: MIT
 * Built in by SECOND_CORE=1: the other core runs the jobs that this one sends it through the FIFO between them. What a job
 * touches is the other core's from the push until the answer is popped; the barriers hold the compiler to that. */
#include "second_core.h"

#if SECOND_CORE
#include <hardware/sync.h>
#include <pico/multicore.h>

static struct {
    void (*job)(void *);
    void *argument;
} posted;

/* In RAM, so that it may wait while flash is busy. */
static void __not_in_flash_func(serve)(void)
{
    for (;;) {
        (void)multicore_fifo_pop_blocking_inline();
        __dmb();
        posted.job(posted.argument);
        __dmb();
        multicore_fifo_push_blocking_inline(0);
    }
}

void second_core_start(void)
{
    multicore_launch_core1(serve);
}

void second_core_fork(void *context, void (*job)(void *), void *argument)
{
    (void)context;
    posted.job = job;
    posted.argument = argument;
    __dmb();
    multicore_fifo_push_blocking_inline(0);
}

/* Where the other core hangs, the watchdog ends the wait. */
void second_core_join(void *context)
{
    (void)context;
    (void)multicore_fifo_pop_blocking_inline();
    __dmb();
}
#endif
