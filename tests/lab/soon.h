/* SPDX-License-Identifier: MIT
 * What comes about in another program's own time. */
#ifndef LAB_SOON_H
#define LAB_SOON_H

#include "unit.h"

#include <stdbool.h>
#include <unistd.h>

/* Seconds. Whatever works is done by then on the busiest machine. */
enum { HANGS = 300 };

/* Between two looks at it; false: it hangs. */
static inline bool wait_more(unsigned *looks)
{
    usleep(20000);
    return ++*looks < 50 * HANGS;
}

#define assert_soon(condition)                                                                                         \
    do {                                                                                                               \
        for (unsigned looks_ = 0; !(condition);)                                                                       \
            if (!wait_more(&looks_))                                                                                   \
                fail_msg("not in %d s: %s", HANGS, #condition);                                                        \
    } while (0)

#endif
