/* SPDX-License-Identifier: MIT
 * Memory that is there: where there is none, these end the program. What they return is for free(). */
#ifndef GLINT_BASE_MEMORY_H
#define GLINT_BASE_MEMORY_H

#include <stddef.h>

/* Zeroed. count * size must not overflow. */
void *allocate(size_t count, size_t size);

/* The same bytes, with room for `count` of `size`; what is new is not set. */
void *enlarge(void *memory, size_t count, size_t size);

char *copied(const char *text);

/* At most the first `length` bytes. */
char *copied_part(const char *text, size_t length);

__attribute__((format(printf, 1, 2))) char *formatted(const char *format, ...);

#endif
