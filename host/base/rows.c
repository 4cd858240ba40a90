/* SPDX-License-Identifier: MIT
 * Results as rows: aligned text for people, CSV or JSON for programs. */
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "base/argp.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/rows.h"

struct rows {
    FILE *stream;
    const struct column *columns;
    size_t count, printed;
    enum rows_format format;
};

void parse_rows_format(const struct argp_state *state, enum rows_format *format, enum rows_format wanted)
{
    if (*format != ROWS_TEXT && *format != wanted)
        refuse(state, "give only one of --csv and --json");
    *format = wanted;
}

struct rows *rows_begin(FILE *stream, enum rows_format format, const struct column *columns, size_t count)
{
    struct rows *rows = allocate(1, sizeof *rows);
    *rows = (struct rows){stream, columns, count, 0, format};
    return rows;
}

static void print_head(const struct rows *rows)
{
    if (rows->format == ROWS_JSON) {
        fputc('[', rows->stream);
        return;
    }
    for (size_t i = 0; i < rows->count; i++) {
        if (rows->format == ROWS_CSV)
            fprintf(rows->stream, "%s%s", i ? "," : "", rows->columns[i].name);
        else
            fprintf(rows->stream, "%s%*s", i ? "  " : "", rows->columns[i].width, rows->columns[i].name);
    }
    fputc('\n', rows->stream);
}

static void print_text(FILE *stream, const struct column *column, const struct cell *cell)
{
    switch (cell->kind) {
    case CELL_TEXT:
        fprintf(stream, "%*s", column->width, cell->text);
        break;
    case CELL_INTEGER:
        fprintf(stream, "%*lld", column->width, cell->integer);
        break;
    case CELL_REAL:
        fprintf(stream, "%*.*f", column->width, column->decimals, cell->real);
        break;
    case CELL_NONE:
        fprintf(stream, "%*s", column->width, "-");
        break;
    }
}

static void print_csv(FILE *stream, const struct cell *cell)
{
    switch (cell->kind) {
    case CELL_TEXT: /* our own words: nothing to quote */
        fputs(cell->text, stream);
        break;
    case CELL_INTEGER:
        fprintf(stream, "%lld", cell->integer);
        break;
    case CELL_REAL:
        fprintf(stream, "%.12g", cell->real);
        break;
    case CELL_NONE:
        break;
    }
}

static json_t *json_cell(const struct cell *cell)
{
    switch (cell->kind) {
    case CELL_TEXT:
        return json_string(cell->text);
    case CELL_INTEGER:
        return json_integer(cell->integer);
    case CELL_REAL:
        return json_real(cell->real);
    case CELL_NONE:
        break;
    }
    return json_null();
}

static void print_json(struct rows *rows, const struct cell *cells)
{
    json_t *row = json_object();
    for (size_t i = 0; i < rows->count; i++)
        if (json_object_set_new(row, rows->columns[i].name, json_cell(&cells[i])) != 0)
            fail("out of memory");
    fputs(rows->printed ? ",\n " : "\n ", rows->stream);
    json_dumpf(row, rows->stream, JSON_REAL_PRECISION(12)); /* a failed write shows in the stream */
    json_decref(row);
}

void rows_add(struct rows *rows, const struct cell *cells)
{
    if (!rows->printed)
        print_head(rows);
    if (rows->format == ROWS_JSON) {
        print_json(rows, cells);
        rows->printed++;
        return;
    }
    for (size_t i = 0; i < rows->count; i++) {
        if (i)
            fputs(rows->format == ROWS_CSV ? "," : "  ", rows->stream);
        if (rows->format == ROWS_CSV)
            print_csv(rows->stream, &cells[i]);
        else
            print_text(rows->stream, &rows->columns[i], &cells[i]);
    }
    fputc('\n', rows->stream);
    rows->printed++;
}

void rows_end(struct rows *rows)
{
    if (!rows->printed)
        print_head(rows);
    if (rows->format == ROWS_JSON)
        fputs(rows->printed ? "\n]\n" : "]\n", rows->stream);
    free(rows);
}
