/* SPDX-License-Identifier: MIT
 * What carries GUD's control requests to one interface of a device, and what can go wrong there. */
#ifndef GLINT_GUD_LINK_H
#define GLINT_GUD_LINK_H

#include <stdbool.h>
#include <stdint.h>

struct gud_link {
    void *context;
    /* Returns the bytes moved or an enum gud_link_fault. */
    int (*control)(void *context, bool in, uint8_t request, uint16_t value, uint8_t *data, uint16_t bytes);
    bool status_wanted; /* set by gud_display_read: the device asks for it after each SET */
};

enum gud_link_fault {
    GUD_LINK_STALL = -1,
    GUD_LINK_GONE = -2,
    GUD_LINK_STOPPED = -3, /* by a signal */
    GUD_LINK_TIMEOUT = -4,
    GUD_LINK_ERROR = -5
};

/* Why something failed: for one line, after the device's name. */
struct gud_problem {
    enum gud_link_fault fault; /* GUD_LINK_ERROR where the answer is wrong */
    char text[200];
    bool busy; /* the device says so: it may do it later */
};

/* Always false, for `return`. */
bool gud_problem_is(struct gud_problem *problem, enum gud_link_fault fault, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

const char *gud_fault_words(enum gud_link_fault fault);

#endif
