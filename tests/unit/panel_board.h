/* SPDX-License-Identifier: MIT
 * A panel for tests of display loops: its transfers end when the test lets them. Before it: enum { WIDTH, HEIGHT }, its pixels. */
#ifndef GLINT_PANEL_BOARD_H
#define GLINT_PANEL_BOARD_H

#include <string.h>

#include "hal.h"
#include "unit.h"

static struct {
    uint16_t screen[WIDTH * HEIGHT];
    size_t at; /* pixels since the window */
    const uint16_t *pixels;
    size_t count;
    void (*done)(void *);
    void *argument;
    unsigned windows;
    bool broken;
} board;

static bool on_command(void *context, uint8_t command)
{
    (void)context;
    assert_null(board.done); /* commands would go among pixels */
    if (command == PANEL_MEMORY_WRITE) {
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

static void on_flush(void *context, const uint16_t *pixels, size_t count, void (*done)(void *), void *argument)
{
    (void)context;
    assert_null(board.done);
    board.pixels = pixels;
    board.count = count;
    board.argument = argument;
    board.done = done;
}

static bool end_flush(void)
{
    void (*const done)(void *) = board.done;
    if (!done)
        return false;
    assert_true(board.at + board.count <= WIDTH * HEIGHT);
    memcpy(board.screen + board.at, board.pixels, board.count * sizeof *board.pixels); /* as late as possible */
    board.at += board.count;
    board.done = NULL;
    done(board.argument);
    return true;
}

#endif
