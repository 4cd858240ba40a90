/* SPDX-License-Identifier: MIT */
#include "base/stop.h"

#include <errno.h>
#include <poll.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static volatile sig_atomic_t asked; /* the signal that asked the stream to end */
enum { UNDO_MAX = 4 };
static void (*volatile undos[UNDO_MAX])(void);
static volatile sig_atomic_t undo_count;
static const char *volatile last_words;
static volatile sig_atomic_t resumed;
static pthread_t first_thread; /* which alone works on what the undos read, and holds signals meanwhile */

/* All that end a program and can be caught; those that tell of a bug, which no program goes on after, stand below. */
static const int ends[] = {SIGHUP,  SIGINT,    SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2,
                           SIGALRM, SIGVTALRM, SIGPROF, SIGXCPU, SIGPIPE, SIGXFSZ};
enum { ENDS = sizeof ends / sizeof *ends };
static const int faults[] = {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGSYS, SIGTRAP};
enum { FAULTS = sizeof faults / sizeof *faults };

/* A closed pipe and a limit on the size of files are reported by the write that fails. */
static bool write_reports(int number)
{
    return number == SIGPIPE || number == SIGXFSZ;
}

static void end_by(int number)
{
    for (int i = undo_count; i-- > 0;)
        undos[i]();
    signal(number, SIG_DFL);
    raise(number);
}

/* A thread's own fault ends the program there. One that somebody sent to the process comes to any thread that does not hold
 * it: the first takes it, when it can. What a thread sends itself, as abort() does, is its own (SI_TKILL). */
static void end_by_fault(int number, siginfo_t *info, void *context)
{
    (void)context;
    const bool is_sent = info->si_code == SI_USER || info->si_code == SI_QUEUE;
    if (!is_sent || pthread_equal(pthread_self(), first_thread) || pthread_kill(first_thread, number) != 0)
        end_by(number);
}

/* A stack that is full has no room for a handler. */
static void set_handlers_stack(void)
{
    static char room[1 << 16];
    stack_t now;
    if (sigaltstack(NULL, &now) == 0 && (now.ss_flags & SS_DISABLE)) /* else a sanitizer's */
        sigaltstack(&(stack_t){.ss_sp = room, .ss_size = sizeof room}, NULL);
}

void stop_at_signals(void)
{
    first_thread = pthread_self();
    set_handlers_stack();
    for (int i = 0; i < ENDS; i++) {
        if (write_reports(ends[i]))
            signal(ends[i], SIG_IGN);
        else if (signal(ends[i], SIG_IGN) != SIG_IGN) /* as nohup asked */
            signal(ends[i], end_by);
    }
    for (int i = 0; i < FAULTS; i++) {
        struct sigaction now;
        if (sigaction(faults[i], NULL, &now) == 0 && now.sa_handler == SIG_DFL) /* else a sanitizer's */
            sigaction(
                faults[i],
                &(struct sigaction){.sa_sigaction = end_by_fault, .sa_flags = SA_SIGINFO | SA_RESTART | SA_ONSTACK},
                NULL);
    }
}

/* A terminal that is held up takes nothing. */
static void say_last_words(void)
{
    enum { PATIENCE_MS = 1000 };
    const char *words = last_words;
    struct pollfd out = {.fd = STDOUT_FILENO, .events = POLLOUT};
    if (words && poll(&out, 1, PATIENCE_MS) > 0 && write(STDOUT_FILENO, words, strlen(words)) < 0)
        return; /* there is nothing more to do */
}

/* A closed terminal and timeout send a signal to the program and to its group: what follows within ECHO_MS is the same one. */
static void on_stop(int number)
{
    enum { ECHO_MS = 500 };
    static volatile struct timespec first;
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    if (!asked) {
        first = now;
        asked = number;
        return;
    }
    if (write_reports(number) ||
        (now.tv_sec - first.tv_sec) * 1000L + (now.tv_nsec - first.tv_nsec) / 1000000 < ECHO_MS)
        return;
    say_last_words();
    end_by(number);
}

/* The terminal gets its cursor back, then the system stops the program: its own action is put in place and the signal sent
 * again, which takes effect where it is no longer blocked, as it is in its handler. The next line runs when it goes on. */
static void on_suspend(int number)
{
    const int error = errno;
    struct sigaction ours;
    sigset_t only, before;
    say_last_words();
    sigaction(number, &(struct sigaction){.sa_handler = SIG_DFL}, &ours);
    sigemptyset(&only);
    sigaddset(&only, number);
    raise(number);
    pthread_sigmask(SIG_UNBLOCK, &only, &before);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    sigaction(number, &ours, NULL);
    resumed++;
    errno = error;
}

static void on_continue(int number)
{
    (void)number;
    resumed++;
}

static bool is_ignored(int number)
{
    struct sigaction now;
    return sigaction(number, NULL, &now) == 0 && now.sa_handler == SIG_IGN;
}

void stop_when_asked(void)
{
    for (int i = 0; i < ENDS; i++)
        if (write_reports(ends[i]) || !is_ignored(ends[i]))
            sigaction(ends[i], &(struct sigaction){.sa_handler = on_stop}, NULL); /* no SA_RESTART: waiting ends */
    if (!is_ignored(SIGTSTP))
        sigaction(SIGTSTP, &(struct sigaction){.sa_handler = on_suspend, .sa_flags = SA_RESTART}, NULL);
    sigaction(SIGCONT, &(struct sigaction){.sa_handler = on_continue, .sa_flags = SA_RESTART}, NULL);
}

unsigned stop_resumed(void)
{
    return (unsigned)resumed;
}

bool stream_stopped(void)
{
    return asked != 0;
}

int stop_status(void)
{
    return asked ? 128 + asked : 0;
}

void stop_if_interrupted(int error)
{
    if (error == EINTR && asked)
        exit(stop_status());
}

void stop_undo(void (*undo)(void))
{
    if (undo_count == UNDO_MAX)
        abort(); /* each file of base that needs it calls this once */
    undos[undo_count] = undo;
    undo_count = undo_count + 1;
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

void signals_hold_but_faults(sigset_t *before)
{
    sigset_t held;
    sigfillset(&held);
    for (int i = 0; i < FAULTS; i++)
        sigdelset(&held, faults[i]);
    pthread_sigmask(SIG_BLOCK, &held, before);
}

void signals_release(const sigset_t *before)
{
    pthread_sigmask(SIG_SETMASK, before, NULL);
}
