/* SPDX-License-Identifier: MIT
 * A board for tests of the display loop: its transfers end when the test lets them, its second core runs as early or as late as it can. */
#ifndef GLINT_RELIGHT_BOARD_H
#define GLINT_RELIGHT_BOARD_H

#include <string.h>

#include "hal.h"
#include "unit.h"

enum { WIDTH = 37, HEIGHT = 11 };

static struct {
    uint16_t screen[WIDTH * HEIGHT];
    size_t at; /* pixels since the window */
    const uint16_t *pixels;
    size_t count;
    void (*done)(void *);
    void *argument;
    uint32_t *to;
    const uint32_t *from;
    size_t words;
    unsigned windows, asked, waits; /* waits: so many more questions until a frame may begin */
    unsigned polls;                 /* after so many questions the fetched words are there; 0: when the test says so */
    bool broken;
} board;

static bool on_command(void *context, uint8_t command)
{
    (void)context;
    if (command == PANEL_MEMORY_WRITE) {
        assert_null(board.done); /* or pixels would go to the new window */
        board.at = 0;
        board.windows++;
    }
    return !board.broken;
}

static bool on_data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    (void)bytes;
    (void)count;
    return true;
}

static void end_flush(void)
{
    void (*const done)(void *) = board.done;
    if (!done)
        return;
    assert_true(board.at + board.count <= WIDTH * HEIGHT);
    memcpy(board.screen + board.at, board.pixels, board.count * sizeof *board.pixels); /* as late as possible */
    board.at += board.count;
    board.done = NULL;
    done(board.argument);
}

static void on_wait(void *context, unsigned ms)
{
    (void)context;
    (void)ms;
}

static void on_flush(void *context, const uint16_t *pixels, size_t count, void (*done)(void *), void *argument)
{
    (void)context;
    assert_null(board.done);
    board.pixels = pixels;
    board.count = count;
    board.argument = argument;
    board.done = done;
}

static void end_fetch(void)
{
    if (board.to)
        memcpy(board.to, board.from, board.words * sizeof *board.to);
    board.to = NULL;
}

static void on_fetch(void *context, uint32_t *to, const uint32_t *from, size_t words)
{
    (void)context;
    assert_null(board.to);
    memset(to, 0x55, words * sizeof *to); /* the old words are gone from now on */
    board.to = to;
    board.from = from;
    board.words = words;
}

/* At any time, where `waits` is 0. */
static bool on_may_begin(void *context)
{
    (void)context;
    board.asked++;
    return board.waits == 0 || --board.waits == 0;
}

static bool on_fetched(void *context)
{
    (void)context;
    if (board.polls && --board.polls == 0)
        end_fetch();
    return !board.to;
}

/* The window's command waits for pixels that are on their way, as on a real bus. */
static bool on_command_waiting(void *context, uint8_t command)
{
    while (board.done)
        end_flush();
    return on_command(context, command);
}

static const struct hal hal = {{on_command_waiting, on_data, NULL, NULL, on_wait, NULL},
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

static const struct hal two_cores = {{on_command_waiting, on_data, NULL, NULL, on_wait, NULL},
                                     on_flush,
                                     on_fetch,
                                     on_fetched,
                                     NULL,
                                     on_fork,
                                     on_join,
                                     NULL};

#endif
