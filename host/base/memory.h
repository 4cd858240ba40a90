/* SPDX-License-Identifier: MIT
 * Memory that is there. */
#ifndef GLINT_BASE_MEMORY_H
#define GLINT_BASE_MEMORY_H

#include <stddef.h>

/* Zeroed memory, for free(); ends the program where there is none. count * size must not overflow. */
void *allocate(size_t count, size_t size);

#endif
