/* SPDX-License-Identifier: MIT */
#include "mesh/lines.h"

#include <ctype.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/memory.h"

static const char blanks[] = " \t\v\f";

void lines_begin(struct lines *lines, const char *text, size_t len)
{
    const size_t mark = len >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0; /* of UTF-8 */
    *lines = (struct lines){.at = text + mark, .end = text + len, .room = 256};
    lines->line = allocate(lines->room, 1);
}

void lines_end(struct lines *lines)
{
    free(lines->line);
}

static bool ends_line(const struct lines *lines)
{
    return lines->at == lines->end || *lines->at == '\n' || *lines->at == '\r';
}

static void skip_end(struct lines *lines)
{
    if (lines->at < lines->end && *lines->at == '\r' && lines->at + 1 < lines->end && lines->at[1] == '\n')
        lines->at++;
    if (lines->at < lines->end)
        lines->at++;
    lines->number++;
}

static void keep(struct lines *lines, size_t *len, char byte)
{
    if (*len + 1 >= lines->room)
        lines->line = enlarge(lines->line, lines->room *= 2, 1);
    lines->line[(*len)++] = byte;
}

bool lines_next(struct lines *lines)
{
    size_t len = 0;
    if (lines->at == lines->end)
        return false;
    for (;; lines->at++) {
        if (ends_line(lines)) {
            skip_end(lines);
            if (len == 0 || lines->line[len - 1] != '\\' || lines->line[0] == '#' || lines->at == lines->end)
                break;
            if (--len > 0)
                lines->line[len++] = ' ';
            lines->at--;
        } else if (len > 0 || !isspace((unsigned char)*lines->at)) {
            keep(lines, &len, *lines->at);
        }
    }
    while (len > 0 && isspace((unsigned char)lines->line[len - 1]))
        len--;
    lines->line[len] = 0;
    return true;
}

char *lines_word(char **at)
{
    char *word = *at + strspn(*at, blanks);
    if (!*word || *word == '#')
        return NULL;
    *at = word + strcspn(word, blanks);
    if (**at)
        *(*at)++ = 0;
    return word;
}

bool lines_begins(const struct lines *lines, const char *word, char **rest)
{
    const size_t len = strlen(word);
    if (strncasecmp(lines->line, word, len) != 0 || (lines->line[len] && !strchr(blanks, lines->line[len])))
        return false;
    *rest = lines->line + len + strspn(lines->line + len, blanks);
    return true;
}

bool lines_number(const char *word, double *out)
{
    const char *at = word + (*word == '-' || *word == '+');
    const size_t before = strspn(at, "0123456789"), point = at[before] == '.';
    const size_t behind = point ? strspn(at + before + 1, "0123456789") : 0;
    const char *end = at + before + point + behind;
    if (strncasecmp(at, "nan", 3) == 0 || strncasecmp(at, "inf", 3) == 0 ||
        strncmp(at, "1.#", 3) == 0) { /* the last on Windows */
        *out = NAN;
        return true;
    }
    if (*end == 'e' || *end == 'E') {
        end += 1 + (end[1] == '-' || end[1] == '+');
        const size_t digits = strspn(end, "0123456789");
        end += digits;
        if (digits == 0)
            return false;
    }
    if (*end || before + behind == 0)
        return false;
    *out = strtod(word, NULL);
    if (fabs(*out) > (double)FLT_MAX)
        *out = copysign(INFINITY, *out);
    return true;
}
