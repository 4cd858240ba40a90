/* SPDX-License-Identifier: MIT
 * Results as rows: aligned text for people, CSV or JSON for programs. */
#ifndef GLINT_BASE_ROWS_H
#define GLINT_BASE_ROWS_H

#include <argp.h>
#include <stddef.h>
#include <stdio.h>

enum rows_format { ROWS_TEXT, ROWS_CSV, ROWS_JSON };
struct column {
    const char *name;
    int width, decimals; /* of the text form; a width below 0 aligns to the left */
};
struct cell {
    enum { CELL_NONE, CELL_TEXT, CELL_INTEGER, CELL_REAL } kind;
    union {
        const char *text;
        long long integer;
        double real;
    };
};
/* For --csv and --json, of which only one may be given. */
void parse_rows_format(const struct argp_state *state, enum rows_format *format, enum rows_format wanted);
/* The names of the columns come with the first row, or at the end. */
struct rows *rows_begin(FILE *stream, enum rows_format format, const struct column *columns, size_t count);
void rows_add(struct rows *rows, const struct cell *cells);
void rows_end(struct rows *rows);

#endif
