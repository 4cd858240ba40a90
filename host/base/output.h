/* SPDX-License-Identifier: MIT
 * Output files. A regular file is written beside its name and renamed when it is whole; "-" is standard output, and so is
 * any name of the file that it goes to; pipes, devices and files behind names of open descriptors, as /dev/fd/3, are
 * written in place. If a step fails, the program ends through fail() and leaves no partial file. */
#ifndef GLINT_BASE_OUTPUT_H
#define GLINT_BASE_OUTPUT_H

#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

/* One of several that may be open at once. */
struct output {
    FILE *stream;
    char *path;      /* as the user named it */
    char *temporary; /* NULL: written in place */
    char *target;    /* the file's name in the end, behind symbolic links */
};
struct output *output_open(const char *path);
/* No output may replace this file, which is read: output_open of it fails, by whatever name or link. */
void output_never(FILE *input);
void output_never_number(dev_t device, ino_t file); /* the same of one that another process read */
/* Refuses a name that output_open would refuse because it leads to an input. */
void output_check(const char *path);
bool output_same(const char *a, const char *b); /* do two names lead to one file, whether it exists or not? */
/* Does it go to standard output, by whatever name? What is said of it goes to standard error then. */
bool output_is_standard(const char *path);
void output_check_written(struct output *output); /* what was written so far is there, or fail() */
void output_close(struct output *output);         /* checks, gives the file its name, frees */
void output_discard(struct output *output);       /* removes it unfinished, frees */
void output_discard_all(void); /* removes unfinished files; at exit and on signals it runs by itself */

#endif
