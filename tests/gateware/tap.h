/* SPDX-License-Identifier: MIT
 * TAP, as tests/tally reads it: tap::check(name, good) prints a line a check; return tap::done() from main. */
#ifndef TAP_H
#define TAP_H

#include <cstdio>

namespace tap
{

inline int checks, failures;

inline bool check(const char *name, bool good)
{
    failures += !good;
    printf("%sok %d - %s\n", good ? "" : "not ", ++checks, name);
    fflush(stdout);
    return good;
}

inline int done()
{
    printf("1..%d\n", checks);
    return failures ? 1 : 0;
}

} // namespace tap

#endif
