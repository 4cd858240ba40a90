/* SPDX-License-Identifier: MIT */
#include "base/closest.h"

#include <ctype.h>
#include <string.h>

enum { LENGTH_MAX = 31, FAR = 99 };

static unsigned least(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

/* What it costs to replace a letter. Digits are no slips: st7735 is another chip than st7789. */
static unsigned replacing(char a, char b)
{
    if (tolower((unsigned char)a) == tolower((unsigned char)b))
        return 0;
    return isdigit((unsigned char)a) || isdigit((unsigned char)b) ? FAR : 1;
}

/* Edits that turn a into b: a letter left out, put in, replaced, or exchanged with its neighbour; case does not count. Row i
 * of the table holds the edits from the first i letters of a to each beginning of b; three rows are enough. */
static unsigned edits(const char *a, const char *b)
{
    const size_t len_a = strlen(a), len_b = strlen(b);
    if (len_a > LENGTH_MAX || len_b > LENGTH_MAX)
        return FAR;
    unsigned rows[3][LENGTH_MAX + 1];
    for (size_t i = 0; i <= len_a; i++) {
        unsigned *row = rows[i % 3];
        const unsigned *above = rows[(i + 2) % 3], *two_above = rows[(i + 1) % 3];
        for (size_t j = 0; j <= len_b; j++) {
            if (i == 0 || j == 0) {
                row[j] = (unsigned)(i + j);
                continue;
            }
            row[j] = least(least(above[j], row[j - 1]) + 1, above[j - 1] + replacing(a[i - 1], b[j - 1]));
            if (i > 1 && j > 1 && replacing(a[i - 1], b[j - 2]) == 0 && replacing(a[i - 2], b[j - 1]) == 0)
                row[j] = least(row[j], two_above[j - 2] + 1);
        }
    }
    return rows[len_a % 3][len_b];
}

/* One edit, or two in names of six letters and more. Of two as close, the first. */
const char *closest_name(const char *text, const char *const *names)
{
    const char *closest = NULL;
    unsigned fewest = FAR;
    for (; *names; names++) {
        const unsigned count = edits(text, *names);
        if (count < fewest && count <= (strlen(*names) < 6 ? 1 : 2) && count < strlen(*names)) {
            closest = *names;
            fewest = count;
        }
    }
    return closest;
}
