/* SPDX-License-Identifier: MIT
 * Child processes in which libraries read what strangers made: they may crash, hang, or take all memory. */
#ifndef GLINT_BASE_CHILD_H
#define GLINT_BASE_CHILD_H

#include <stddef.h>
#include <sys/types.h>

struct child {
    const char *reader; /* for messages: "libassimp" */
    int in;
    pid_t process;
    double used_s;   /* of the processor's time, when last asked */
    unsigned idle_s; /* it neither worked nor sent */
};
/* The child runs body(of, out), whose `out` leads to here, with limits of time and memory, without standard input, output and errors. It dies with the
 * thread that starts it, which is the main one. `name`: of what is read, for messages. */
void child_start(struct child *child, const char *name, const char *reader, void (*body)(const void *of, int out),
                 const void *of);
/* NULL, or what became of the child, as the end of a message; then it is gone. */
const char *child_receive(struct child *child, void *to, size_t bytes);
void child_end(struct child *child); /* it has nothing more to say */

/* First of all in a child, also in one that becomes another program: signals do what the system does, and it dies with the parent's main
 * thread, which made it. */
void child_begin(pid_t parent);
/* In the child: the parent may be gone, and then there is nobody to tell. */
void child_send(int out, const void *from, size_t bytes);

#endif
