/* SPDX-License-Identifier: MIT */
/* Output lines by libgpiod: lines1.c by its version 1, lines2.c by 2. They return NULL or -1 with errno. */
#ifndef LAB_LINES_H
#define LAB_LINES_H

#include <stddef.h>

enum { LINES_MAX = 16 };

struct lines;
/* The first lines of the chip, with these values. */
struct lines *lines_open(const char *chip_path, const int *values, size_t count);
/* All of them in one call to the kernel. */
int lines_set(struct lines *lines, const int *values);
void lines_close(struct lines *lines);

#endif
