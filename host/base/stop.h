/* SPDX-License-Identifier: MIT
 * Signals that end the program, and how a stream is asked to end. */
#ifndef GLINT_BASE_STOP_H
#define GLINT_BASE_STOP_H

#include <signal.h>
#include <stdbool.h>

/* The signals that end a program, a crash too, end it at once, after stop_undo's functions have run. Ignored signals stay ignored.
 * The first thread calls it. */
void stop_at_signals(void);
/* From now on the first signal that would end the program only asks: stream_stopped() becomes true and waiting ends. One
 * that comes half a second later, or more, ends the program at once. SIGTSTP stops it after the last words. */
void stop_when_asked(void);
/* Has a signal asked the stream to end? For loops that wait. */
bool stream_stopped(void);
/* The exit status: 0, or 128 and the signal that asked. */
int stop_status(void);
/* Ends the program with that status if the error (errno) is only that such a signal came; else returns. */
void stop_if_interrupted(int error);

/* Runs where a signal ends the program at once: it may call only what a signal handler may. The last one added runs
 * first, as with atexit(). */
void stop_undo(void (*undo)(void));
/* Goes to standard output where a signal stops the program or a second one ends it at once; NULL: nothing. The text must
 * stay. */
void stop_last_words(const char *words);
/* How often the program went on after it was stopped: what it showed on the terminal may be gone. */
unsigned stop_resumed(void);

/* Holds signals back until they are released: in this thread, and in threads it starts in between. All of them: short work on what
 * stop_undo's functions read. For threads that draw, all but faults: a fault that is held ends the program without stop_undo's. Where one
 * is sent to the process, such a thread hands it on to the first. */
void signals_hold(sigset_t *before);
void signals_hold_but_faults(sigset_t *before);
void signals_release(const sigset_t *before);

#endif
