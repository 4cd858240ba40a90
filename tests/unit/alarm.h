/* SPDX-License-Identifier: MIT
 * An interrupt for tests of code that waits for one: the alarm, half a millisecond later. */
#ifndef GLINT_UNIT_ALARM_H
#define GLINT_UNIT_ALARM_H

#include <signal.h>
#include <stddef.h>
#include <sys/time.h>

static struct {
    void (*job)(void *);
    void *argument;
    unsigned count;
} alarms;

static void on_alarm(int number)
{
    (void)number;
    alarms.count++;
    alarms.job(alarms.argument);
}

static inline void set_alarm(void (*job)(void *), void *argument)
{
    alarms.job = job;
    alarms.argument = argument;
    signal(SIGALRM, on_alarm);
    setitimer(ITIMER_REAL, &(struct itimerval){.it_value = {.tv_usec = 500}}, NULL);
}

/* Where what follows must not be interrupted. */
static inline void stop_alarm(void)
{
    setitimer(ITIMER_REAL, &(struct itimerval){.it_value = {0}}, NULL);
}

#endif
