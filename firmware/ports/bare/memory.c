/* SPDX-License-Identifier: MIT
 * In place of a C library: initial static data, and the functions that compilers call by themselves. */
#include "memory.h"

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

/* From the linker script. */
extern unsigned char data_load[], data_start[], data_end[], bss_start[], bss_end[];

void bare_memory(void)
{
    memcpy(data_start, data_load, (size_t)(data_end - data_start));
    memset(bss_start, 0, (size_t)(bss_end - bss_start));
}
