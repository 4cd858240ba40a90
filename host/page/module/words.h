/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PAGE_WORDS_H
#define GLINT_PAGE_WORDS_H

#include <stddef.h>

/* A command line in one piece of memory: words, each with its 0 at the end. */
enum { WORDS_MAX = 128 };
struct words {
    int count;
    char *list[WORDS_MAX + 1];
};
void words_split(struct words *words, char *text, size_t bytes);

#endif
