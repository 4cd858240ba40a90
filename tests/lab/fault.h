/* SPDX-License-Identifier: MIT
 * For fault_NAME.c: each __wrap_FUNCTION takes the place of FUNCTION, and does as it does unless GLINT_FAULT is its name. */
#ifndef LAB_FAULT_H
#define LAB_FAULT_H

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static inline bool fault_is(const char *function)
{
    const char *fault = getenv("GLINT_FAULT");
    return fault && !strcmp(fault, function);
}

#endif
