/* SPDX-License-Identifier: MIT
 * What compilers ask for by themselves, where there is no C library. */
#include <stddef.h>

void *memset(void *to, int value, size_t count);
void *memcpy(void *to, const void *from, size_t count);

__attribute__((optimize("no-tree-loop-distribute-patterns"))) void *memset(void *to, int value, size_t count)
{
    for (unsigned char *at = to; count--; at++)
        *at = (unsigned char)value;
    return to;
}

__attribute__((optimize("no-tree-loop-distribute-patterns"))) void *memcpy(void *to, const void *from, size_t count)
{
    const unsigned char *source = from;
    for (unsigned char *at = to; count--; at++, source++)
        *at = *source;
    return to;
}
