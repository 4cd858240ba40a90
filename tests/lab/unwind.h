/* SPDX-License-Identifier: MIT
 * For fuzzers of what ends the program through fail() or exit(), or leaves its memory to the system, as a child process does: it comes back, and what was
 * allocated in between is freed. tests/lab/fuzzer links such a fuzzer with --wrap=exit and --wrap=_exit. */
#ifndef LAB_UNWIND_H
#define LAB_UNWIND_H

#include <sanitizer/allocator_interface.h>
#include <setjmp.h>

#include "fuzz.h"

/* ---- memory: a table by address ---- */

enum { UNWIND_SLOTS = 1 << 16 };
static struct {
    const volatile void *slots[UNWIND_SLOTS];
    uint32_t used[UNWIND_SLOTS / 2];
    unsigned count;
    jmp_buf back;
} unwind;
/* In the thread that came in, and in no other: libFuzzer has one, whose memory is its own. */
static _Thread_local bool unwind_on;
static const char unwind_gone; /* stands for what was freed: a place that is not empty, so that the search goes on */

static unsigned unwind_find(const volatile void *memory)
{
    unsigned i = (unsigned)(((uintptr_t)memory >> 4) * 2654435761U >> 8) % UNWIND_SLOTS;
    while (unwind.slots[i] && unwind.slots[i] != memory)
        i = (i + 1) % UNWIND_SLOTS;
    return i;
}

static void unwind_on_malloc(const volatile void *memory, size_t size)
{
    (void)size;
    if (!unwind_on || !memory || unwind.count == UNWIND_SLOTS / 2)
        return;
    const unsigned i = unwind_find(memory);
    if (!unwind.slots[i])
        unwind.used[unwind.count++] = i;
    unwind.slots[i] = memory;
}

static void unwind_on_free(const volatile void *memory)
{
    if (!unwind_on || !memory)
        return;
    const unsigned i = unwind_find(memory);
    if (unwind.slots[i])
        unwind.slots[i] = &unwind_gone;
}

static void unwind_memory(void)
{
    unwind_on = false;
    for (unsigned k = 0; k < unwind.count; k++) {
        const volatile void **slot = &unwind.slots[unwind.used[k]];
        if (*slot != &unwind_gone)
            free((void *)*slot);
        *slot = NULL;
    }
    unwind.count = 0;
}

/* ---- ends ---- */

_Noreturn void __real_exit(int status);
_Noreturn void __real__exit(int status);
_Noreturn void __wrap_exit(int status);
_Noreturn void __wrap__exit(int status);

_Noreturn void __wrap_exit(int status)
{
    if (!unwind_on)
        __real_exit(status);
    longjmp(unwind.back, 1);
}

_Noreturn void __wrap__exit(int status)
{
    if (!unwind_on)
        __real__exit(status);
    longjmp(unwind.back, 1);
}

/* Reads these bytes. Opened and closed outside: the C library keeps a list of streams; nor is its buffer allocated in between. */
static inline FILE *unwind_stream(const void *bytes, size_t len)
{
    static char buffer[4096];
    FILE *const stream = fmemopen((void *)bytes, len, "r");
    check(stream && setvbuf(stream, buffer, _IOFBF, sizeof buffer) == 0);
    return stream;
}

/* Runs body(of); false: it ended the program. What it says is not shown. */
static bool unwind_run(void (*body)(void *of), void *of)
{
    static FILE *null;
    FILE *const shown = stderr;
    if (!null) {
        null = fopen("/dev/null", "w");
        __sanitizer_install_malloc_and_free_hooks(unwind_on_malloc, unwind_on_free);
        check(null && setvbuf(null, NULL, _IONBF, 0) ==
                          0); /* a buffer would be allocated in between, and used when it is freed */
    }
    stderr = null;
    unwind_on = true;
    const bool ends = setjmp(unwind.back) == 0;
    if (ends)
        body(of);
    unwind_memory();
    stderr = shown;
    return ends;
}

#endif
