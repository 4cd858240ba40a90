/* SPDX-License-Identifier: MIT */
#include "sinks/gud/link.h"

#include <stdarg.h>
#include <stdio.h>

bool gud_problem_is(struct gud_problem *problem, enum gud_link_fault fault, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(problem->text, sizeof problem->text, format, arguments);
    va_end(arguments);
    problem->fault = fault;
    problem->busy = false;
    return false;
}

const char *gud_fault_words(enum gud_link_fault fault)
{
    switch (fault) {
    case GUD_LINK_STALL:
        return "it refuses (STALL)";
    case GUD_LINK_GONE:
        return "it is no longer there";
    case GUD_LINK_STOPPED:
        return "stopped";
    case GUD_LINK_TIMEOUT:
        return "it does not answer";
    case GUD_LINK_ERROR:
        break;
    }
    return "the transfer failed";
}
