/* SPDX-License-Identifier: MIT
 * base/child.h in one process: the child's body runs first, and what it sent is then received; or the input is what it sent. */
#ifndef LAB_FUZZ_CHILD_H
#define LAB_FUZZ_CHILD_H

#include <string.h>

#include "base/child.h"
#include "unwind.h"

static struct {
    uint8_t *sent;
    size_t len, room, at;
    bool answers; /* what is sent is there already */
} child;

static inline void child_answers(const uint8_t *bytes, size_t len)
{
    child.sent = malloc(len + 1);
    memcpy(child.sent, bytes, child.len = len);
    child.answers = true;
}

static void child_forget(void)
{
    child.sent = NULL; /* it is freed with all that was allocated */
    child.len = child.room = child.at = 0;
    child.answers = false;
}

void child_send(int out, const void *from, size_t bytes)
{
    (void)out;
    if (child.len + bytes > child.room)
        child.sent = realloc(child.sent, child.room = 2 * (child.len + bytes));
    if (bytes)
        memcpy(child.sent + child.len, from, bytes);
    child.len += bytes;
}

void child_start(struct child *of, const char *name, const char *reader, void (*body)(const void *of, int out),
                 const void *argument)
{
    jmp_buf back;
    *of = (struct child){.reader = reader};
    check(name);
    memcpy(back, unwind.back, sizeof back);
    if (!child.answers && setjmp(unwind.back) == 0)
        body(argument, -1); /* _exit leads back */
    memcpy(unwind.back, back, sizeof back);
}

const char *child_receive(struct child *of, void *to, size_t bytes)
{
    (void)of;
    if (child.len - child.at < bytes)
        return "broke off";
    if (bytes)
        memcpy(to, child.sent + child.at, bytes);
    child.at += bytes;
    return NULL;
}

void child_end(struct child *of)
{
    (void)of;
}

#endif
