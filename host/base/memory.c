/* SPDX-License-Identifier: MIT */
#include "base/memory.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"

void *allocate(size_t count, size_t size)
{
    void *memory = calloc(count ? count : 1, size);
    if (!memory)
        fail("out of memory: cannot get %zu bytes", count * size);
    return memory;
}

void *enlarge(void *memory, size_t count, size_t size)
{
    memory = reallocarray(memory, count, size);
    if (!memory)
        fail("out of memory: cannot get %zu times %zu bytes", count, size);
    return memory;
}

char *copied_part(const char *text, size_t length)
{
    length = strnlen(text, length);
    return memcpy(allocate(length + 1, 1), text, length);
}

char *copied(const char *text)
{
    return copied_part(text, strlen(text));
}

char *formatted(const char *format, ...)
{
    char *text;
    va_list arguments;
    va_start(arguments, format);
    const int length = vasprintf(&text, format, arguments);
    va_end(arguments);
    if (length < 0)
        fail("out of memory");
    return text;
}
