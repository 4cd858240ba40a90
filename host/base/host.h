/* SPDX-License-Identifier: MIT
 * What the subcommands share: messages, output files, numbers from the command line, the models by name. */
#ifndef GLINT_HOST_H
#define GLINT_HOST_H

#include <argp.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>

#include "glint.h"

enum { EXIT_GOOD = 0, EXIT_FAILED = 1, EXIT_USAGE = 2 };

/* ---- messages (message.c) ---- */

/* Prints "glint: " and one line (what failed, on what, what to do), removes unfinished output, exits 1. */
_Noreturn void fail(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* One line on standard error, beginning "glint: ". */
void warn(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Control characters, which a quoted text may hold, become '?', and the middle of a long text "..."; in place. */
char *one_line(char *text);
/* A line that overwrites itself, only where standard error is a terminal. */
void progress(const char *format, ...) __attribute__((format(printf, 1, 2)));
void progress_end(void);

/* ---- output files (output.c) ---- */

/* A regular file is written beside its name and renamed when it is whole; "-" is standard output; pipes and devices are
 * written in place. Failure of any step ends the program through fail(), leaving no partial file. One or several at
 * once. */
struct output {
    FILE *stream;
    char *path;      /* as named by the user */
    char *temporary; /* NULL where written in place */
    char *target;    /* what it becomes, where links lead */
};
/* A name from the command line, refused where it is empty. */
const char *parse_output(const struct argp_state *state, const char *option, const char *text);
struct output *output_open(const char *path);
bool output_same(const char *a, const char *b); /* whether two names lead to one file, there or not yet */
void output_close(struct output *output);       /* checks, gives the file its name, frees */
void output_discard_all(void);                  /* unfinished files go; called by fail(), at exit and by signals */

/* Signals wait until they are released: in this thread, and for good in those that it starts meanwhile. */
void signals_hold(sigset_t *before);
void signals_release(const sigset_t *before);

/* ---- numbers (numbers.c) ---- */

/* One line on standard error that ends with where help is, exit 2; where `state` is NULL, fail() (exit 1). */
_Noreturn void refuse(const struct argp_state *state, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Strict: the whole text must be one number within the limits, else refuse() names the option and what is allowed
 * (exit 2). `option` as the user writes it: "-n", "--light". Where `state` is NULL the text is data, not usage:
 * `option` names where it stands, and fail() ends the program (exit 1). */
long parse_integer(const struct argp_state *state, const char *option, const char *text, long low, long high);
double parse_real(const struct argp_state *state, const char *option, const char *text, double low, double high);
/* A number in decimal at the beginning of the text, finite. */
bool read_real(const char *text, char **end, double *value);
/* The first line of a text file may begin with such a mark, in UTF-8. */
char *after_byte_order_mark(char *line);
/* "X,Y,Z": exactly `count` numbers. */
void parse_reals(const struct argp_state *state, const char *option, const char *text, double *values, int count,
                 double low, double high);
/* "A", "A,B,C", "A:B" (step 1), "A:B:STEP" or a mix of them by commas; `values` is malloc'd, the count returned. */
size_t parse_list(const struct argp_state *state, const char *option, const char *text, double low, double high,
                  double **values);
size_t parse_integer_list(const struct argp_state *state, const char *option, const char *text, long low, long high,
                          long **values);

/* The place of `text` in a list that ends with NULL; else a usage error that shows the list. */
unsigned parse_choice(const struct argp_state *state, const char *option, const char *text, const char *const *names);

/* ---- rows of results (rows.c) ---- */

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

/* ---- names for written C source (c_names.c) ---- */

/* For --name: a name that C, C++ and glint.h leave to programs and that has no meaning yet, of at most 63 letters. */
const char *parse_c_name(const struct argp_state *state, const char *text);

/* ---- models (models.c) ---- */

/* The double-precision formulas, as the paper prints them; c in 0..1. */
double model_double(enum glint_model model, double n, double c);
extern const char *const model_names[]; /* "msh" ... "cayley", by enum glint_model */
enum { MODEL_COUNT = 6 };
enum glint_model parse_model(const struct argp_state *state, const char *option, const char *text);
void parse_models(const struct argp_state *state, const char *option, const char *text,
                  bool given[MODEL_COUNT]); /* one, or all */

/* ---- subcommands ---- */

int command_render(int argc, char **argv);
int command_eval(int argc, char **argv);
int command_cutoff(int argc, char **argv);
int command_table(int argc, char **argv);
int command_bake(int argc, char **argv);
int command_stream(int argc, char **argv);
int command_list(int argc, char **argv);
int command_search(int argc, char **argv);
int command_paper(int argc, char **argv);

/* argp_parse with its flags (command.c): usage errors are one line that begins with argv[0] and names its help, and exit
 * with 2. */
void parse_command(const struct argp *argp, unsigned flags, int argc, char **argv, void *input);

#endif
