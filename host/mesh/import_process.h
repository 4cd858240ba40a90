/* SPDX-License-Identifier: MIT
 * Child processes in which libraries read what strangers made: they may crash, hang, or take all memory. */
#ifndef GLINT_MESH_IMPORT_PROCESS_H
#define GLINT_MESH_IMPORT_PROCESS_H

#include <stddef.h>
#include <sys/types.h>

struct import_process {
    const char *reader; /* for messages: "libassimp" */
    int in;
    pid_t child;
    double end; /* of its time */
};
/* The child runs body(of, out), whose `out` leads to here, with limits of time and memory. `name`: of what is read, for messages. */
void import_process_start(struct import_process *process, const char *name, const char *reader,
                          void (*body)(const void *of, int out), const void *of);
/* NULL, or what became of the child, as the end of a message; then it is gone. */
const char *import_process_receive(struct import_process *process, void *to, size_t bytes);
void import_process_end(struct import_process *process); /* it has nothing more to say */

/* In the child: the parent may be gone, and then there is nobody to tell. */
void import_process_send(int out, const void *from, size_t bytes);

#endif
