/* SPDX-License-Identifier: MIT
 * A board for tests of the display loop: its transfers end when the test lets them, its second core runs as early or as late as it can. */
#ifndef GLINT_RELIGHT_BOARD_H
#define GLINT_RELIGHT_BOARD_H

enum { WIDTH = 67, HEIGHT = 11 }; /* wider than the library's runs */
#include "panel_board.h"

static struct {
    uint32_t *to;
    const uint32_t *from;
    size_t words;
    unsigned polls; /* after so many questions the fetched words are there; 0: when the test says so */
} flash;

static struct {
    unsigned asked, waits; /* waits: so many more questions until a frame may begin */
} frames;

static void on_wait(void *context, unsigned ms)
{
    (void)context;
    (void)ms;
}

static void end_fetch(void)
{
    if (flash.to)
        memcpy(flash.to, flash.from, flash.words * sizeof *flash.to);
    flash.to = NULL;
}

static void on_fetch(void *context, uint32_t *to, const uint32_t *from, size_t words)
{
    (void)context;
    assert_null(flash.to);
    memset(to, 0x55, words * sizeof *to); /* the old words are gone from now on */
    flash.to = to;
    flash.from = from;
    flash.words = words;
}

/* At any time, where `waits` is 0. */
static bool on_may_begin(void *context)
{
    (void)context;
    frames.asked++;
    return frames.waits == 0 || --frames.waits == 0;
}

static bool on_fetched(void *context)
{
    (void)context;
    if (flash.polls && --flash.polls == 0)
        end_fetch();
    return !flash.to;
}

/* The window's command waits for pixels that are on their way, as on a real bus. */
static bool on_command_waiting(void *context, uint8_t command)
{
    while (end_flush())
        ;
    return on_command(context, command);
}

static const struct hal hal = {{on_command_waiting, on_data, NULL, NULL, NULL, on_wait, NULL},
                               on_flush,
                               on_fetch,
                               on_fetched,
                               on_may_begin,
                               NULL,
                               NULL,
                               NULL};

/* ---- the second core ---- */

static struct {
    void (*job)(void *);
    void *argument;
    bool late;
    unsigned jobs;
} other;

static void on_fork(void *context, void (*job)(void *), void *argument)
{
    (void)context;
    assert_null(other.job);
    other.job = job;
    other.argument = argument;
    other.jobs++;
    if (!other.late)
        job(argument);
}

static void on_join(void *context)
{
    (void)context;
    assert_non_null(other.job);
    if (other.late)
        other.job(other.argument);
    other.job = NULL;
}

static const struct hal two_cores = {{on_command_waiting, on_data, NULL, NULL, NULL, on_wait, NULL},
                                     on_flush,
                                     on_fetch,
                                     on_fetched,
                                     NULL,
                                     on_fork,
                                     on_join,
                                     NULL};

#endif
