/* SPDX-License-Identifier: MIT
 * Texts of lines and words, as OBJ and MTL have them. */
#ifndef GLINT_MESH_LINES_H
#define GLINT_MESH_LINES_H

#include <stdbool.h>
#include <stddef.h>

struct lines {
    const char *at, *end;
    unsigned long number; /* of the last one, from 1; of several that are one, the last */
    char *line;           /* it, without blanks around; ends with 0 */
    size_t room;
};
void lines_begin(struct lines *lines, const char *text, size_t len);
void lines_end(struct lines *lines);
/* False: there is none any more. A backslash at its end joins the next one to a line, but for a comment. */
bool lines_next(struct lines *lines);

/* The first word from *at on, which is ended with 0; *at moves behind it. NULL: there is none, but a comment may be. */
char *lines_word(char **at);
/* Does the line begin with this word, in any case? Then *rest is what follows. */
bool lines_begins(const struct lines *lines, const char *word, char **rest);
/* Decimal digits with a point, if there is one, before, between or behind them, then an exponent, as the nearest double, or one without end where a
 * float has none; "nan" and "inf" are NaN. */
bool lines_number(const char *word, double *out);

#endif
