/* SPDX-License-Identifier: MIT
 * Numbers from the command line: the whole text counts, and an error says what is allowed. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host.h"

enum { LIST_MAX = 1000000 };

long parse_integer(const struct argp_state *state, const char *option, const char *text, long low, long high)
{
    char *end;
    errno = 0;
    const long value = strtol(text, &end, 10);
    if (end == text || *end || errno || value < low || value > high)
        argp_error(state, "%s: '%s' is not a whole number from %ld to %ld", option, text, low, high);
    return value;
}

static bool real(const char *text, char **end, double *value)
{
    *value = strtod(text, end);
    return *end != text && isfinite(*value);
}

double parse_real(const struct argp_state *state, const char *option, const char *text, double low, double high)
{
    double value;
    parse_reals(state, option, text, &value, 1, low, high);
    return value;
}

void parse_reals(const struct argp_state *state, const char *option, const char *text, double *values, int count,
                 double low, double high)
{
    const char *at = text;
    bool good = true;
    for (int i = 0; i < count && good; i++) {
        char *end;
        good = real(at, &end, &values[i]) && values[i] >= low && values[i] <= high;
        good = good && *end == (i + 1 < count ? ',' : '\0');
        at = end + 1;
    }
    if (good)
        return;
    if (count == 1)
        argp_error(state, "%s: '%s' is not a number from %g to %g", option, text, low, high);
    argp_error(state, "%s: '%s' is not %d numbers from %g to %g with commas between", option, text, count, low, high);
}

size_t parse_list(const struct argp_state *state, const char *option, const char *text, double low, double high,
                  double **values)
{
    size_t count = 0, room = 16;
    double *list = malloc(room * sizeof *list);
    if (!list)
        fail("out of memory");
    for (const char *at = text;; at++) {
        double from, to, step = 1;
        char *end;
        bool good = real(at, &end, &from);
        to = from;
        if (good && *end == ':') {
            good = real(end + 1, &end, &to);
            if (good && *end == ':')
                good = real(end + 1, &end, &step) && step > 0;
        }
        if (!good || (*end && *end != ',') || from < low || to > high || to < from)
            argp_error(state, "%s: '%s' is not a list: A, A:B or A:B:STEP, rising, with commas between, from %g to %g",
                       option, text, low, high);
        const double steps = floor((to - from) / step + 1e-9);
        if (steps + (double)count >= LIST_MAX)
            argp_error(state, "%s: '%s' names more than %d values", option, text, LIST_MAX);
        for (size_t i = 0; i <= (size_t)steps; i++) {
            if (count == room && !(list = realloc(list, (room *= 2) * sizeof *list)))
                fail("out of memory");
            list[count++] = from + (double)i * step;
        }
        if (!*end)
            break;
        at = end;
    }
    *values = list;
    return count;
}
