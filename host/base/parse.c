/* SPDX-License-Identifier: MIT
 * Values from the command line: the whole text counts, and an error says what is allowed. */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/argp.h"
#include "base/memory.h"
#include "base/parse.h"
#include "base/unknown.h"

enum { LIST_MAX = 1000000 };

static const char *unsigned_part(const char *text)
{
    return text + (*text == '-' || *text == '+');
}

/* strtod also takes leading blanks, hexadecimal, nan and inf. */
bool read_real(const char *text, char **end, double *value)
{
    const char *digits = unsigned_part(text);
    if (!isdigit((unsigned char)digits[*digits == '.']))
        return false;
    if (digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X'))
        return false;
    *value = strtod(text, end);
    return isfinite(*value);
}

long parse_integer(const struct argp_state *state, const char *option, const char *text, long low, long high)
{
    char *end;
    errno = 0;
    const long value = strtol(text, &end, 10);
    if (!isdigit((unsigned char)*unsigned_part(text)) || *end || errno || value < low || value > high)
        refuse(state, "%s: '%s' is not a whole number from %ld to %ld", option, text, low, high);
    return value;
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
        good = read_real(at, &end, &values[i]) && values[i] >= low && values[i] <= high &&
               *end == (i + 1 < count ? ',' : '\0');
        at = good ? end + 1 : at;
    }
    if (good)
        return;
    if (count == 1)
        refuse(state, "%s: '%s' is not a number from %.10g to %.10g", option, text, low, high);
    else
        refuse(state, "%s: '%s' is not %d numbers from %.10g to %.10g separated by commas", option, text, count, low,
               high);
}

unsigned parse_choice(const struct argp_state *state, const char *option, const char *what, const char *text,
                      const char *const *names)
{
    for (unsigned i = 0; names[i]; i++)
        if (strcmp(text, names[i]) == 0)
            return i;
    refuse_unknown(state, option, what, text, names);
}

const char *parse_output(const struct argp_state *state, const char *option, const char *text)
{
    if (!*text)
        refuse(state, "%s: the file name is empty", option);
    return text;
}

char *after_byte_order_mark(char *text)
{
    static const char mark[] = "\xEF\xBB\xBF";
    return text + (strncmp(text, mark, strlen(mark)) == 0 ? strlen(mark) : 0);
}

/* ---- lists ---- */

struct range {
    double from, to, step;
};

/* A, A:B or A:B:STEP up to a comma or the end. */
static bool parse_range(const char *text, const char **end, struct range *range)
{
    char *at;
    if (!read_real(text, &at, &range->from))
        return false;
    range->to = range->from;
    range->step = 1;
    if (*at == ':') {
        if (!read_real(at + 1, &at, &range->to))
            return false;
        if (*at == ':' && !read_real(at + 1, &at, &range->step))
            return false;
    }
    *end = at;
    return (*at == '\0' || *at == ',') && range->step > 0 && range->to >= range->from;
}

size_t parse_list(const struct argp_state *state, const char *option, const char *text, double low, double high,
                  double **values)
{
    size_t count = 0;
    double *list = NULL;
    const char *end;
    for (const char *at = text;; at = end + 1) {
        struct range range;
        if (!parse_range(at, &end, &range) || range.from < low || range.to > high)
            refuse(state, "%s: '%s' is not a list from %.10g to %.10g: A, A:B or A:B:STEP, rising, separated by commas",
                   option, text, low, high);
        const double last = floor((range.to - range.from) / range.step + 1e-9);
        if (last + (double)count >= LIST_MAX)
            refuse(state, "%s: '%s' has more than %d values", option, text, LIST_MAX);
        list = enlarge(list, count + (size_t)last + 1, sizeof *list);
        for (size_t i = 0; i <= (size_t)last; i++)
            list[count++] = fmin(range.from + (double)i * range.step, range.to);
        if (!*end)
            break;
    }
    *values = list;
    return count;
}

size_t parse_integer_list(const struct argp_state *state, const char *option, const char *text, long low, long high,
                          long **values)
{
    double *reals;
    const size_t count = parse_list(state, option, text, (double)low, (double)high, &reals);
    long *list = allocate(count, sizeof *list);
    for (size_t i = 0; i < count; i++) {
        if (reals[i] != floor(reals[i]))
            refuse(state, "%s: '%s' is not a list of whole numbers from %ld to %ld", option, text, low, high);
        list[i] = (long)reals[i];
    }
    free(reals);
    *values = list;
    return count;
}
