/* SPDX-License-Identifier: MIT */
#include "base/stop.h"

#include <string.h>
#include <unistd.h>

static volatile sig_atomic_t asked; /* the signal that asked the stream to end */
static void (*volatile undo_all)(void);
static const char *volatile last_words;

static void end_by(int number)
{
    if (undo_all)
        undo_all();
    signal(number, SIG_DFL);
    raise(number);
}

void stop_at_signals(void)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGALRM, SIGUSR1, SIGUSR2};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
        if (signal(signals[i], SIG_IGN) != SIG_IGN) /* as nohup asked */
            signal(signals[i], end_by);
}

static void on_stop(int number)
{
    if (asked) {
        const char *words = last_words;
        if (words && write(STDOUT_FILENO, words, strlen(words)) < 0)
            words = NULL; /* there is nothing more to do */
        end_by(number);
    }
    asked = number;
}

void stop_when_asked(void)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        struct sigaction now;
        sigaction(signals[i], NULL, &now);
        if (now.sa_handler == SIG_IGN)
            continue;
        now = (struct sigaction){.sa_handler = on_stop}; /* without SA_RESTART: waiting ends */
        sigaction(signals[i], &now, NULL);
    }
}

bool stream_stopped(void)
{
    return asked != 0;
}

int stop_status(void)
{
    return asked ? 128 + asked : 0;
}

void stop_undo(void (*undo)(void))
{
    undo_all = undo;
}

void stop_last_words(const char *words)
{
    last_words = words;
}

void signals_hold(sigset_t *before)
{
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, before);
}

void signals_release(const sigset_t *before)
{
    pthread_sigmask(SIG_SETMASK, before, NULL);
}
