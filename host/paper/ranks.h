/* SPDX-License-Identifier: MIT
 * The processes of an MPI run that share a search; alone where the command was not started by mpirun. */
#ifndef GLINT_RANKS_H
#define GLINT_RANKS_H

#include <stdbool.h>
#include <stddef.h>

struct ranks {
    int index, count;
};

/* Was the command started as one of several by mpirun? Known before ranks_begin(), from the environment. */
bool ranks_launched(struct ranks *ranks);
/* In the others, whatever rank 0 says by itself stays unsaid: usage errors, which all of them find, are one line. */
void ranks_let_first_speak(void);
/* Joins the other ranks; ends the program through fail() if there are any and this build has no MPI. */
struct ranks ranks_begin(void);
/* `bytes` of every rank, in order of their index, to every rank. */
void ranks_gather(const struct ranks *ranks, const void *mine, size_t bytes, void *all);
/* Rank 0's bytes to every rank. */
void ranks_share(const struct ranks *ranks, void *value, size_t bytes);
void ranks_end(const struct ranks *ranks);
/* The library's name and version, malloc'd; NULL where this build has none. */
char *ranks_library(void);

#endif
