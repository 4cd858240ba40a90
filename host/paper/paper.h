/* SPDX-License-Identifier: MIT
 * What the parts of `glint paper` share. Each part computes, writes its CSV file and plot, and hands in claims, choices and
 * numbers, from which claims.json and the report are written. */
#ifndef GLINT_PAPER_PAPER_H
#define GLINT_PAPER_PAPER_H

#include <jansson.h>

#include "base/folder.h"
#include "base/output.h"

#define PI 3.14159265358979323846

struct paper {
    const char *directory; /* as the user named it */
    struct folder *folder; /* where its files are written */
    bool complete;         /* all parts are in it */
    const char *terminal;  /* "pngcairo" or "svg"; NULL: no plots */
    json_t *claims;        /* [{part, where, claim, computed, verdict}] */
    json_t *choices;       /* [{part, silent, chosen, other}] */
    json_t *findings;      /* [{part, text}]: what the paper does not have, for the summary */
    json_t *numbers;       /* {name: value}: what the texts quote, at full precision */
    json_t *tables;        /* {part: {title, head: [text], rows: [[text]], note}} */
    json_t *figures;       /* [{part, title, caption, csv, image, data}] */
};

enum verdict { CONFIRMED, WITH_LIMITS, NOT_CONFIRMED };
extern const char *const verdict_names[];
/* Confirmed where it holds in full, with limits where only in part. */
enum verdict verdict_of(bool in_full, bool in_part);

/* Texts are json_sprintf() values, and are taken over. */
void paper_claim(struct paper *paper, const char *part, const char *where, const char *claim, enum verdict verdict,
                 json_t *computed);
void paper_choice(struct paper *paper, const char *part, const char *silent, json_t *chosen, json_t *other);
void paper_finding(struct paper *paper, const char *part, json_t *text);
void paper_number(struct paper *paper, const char *name, double value);
void paper_count(struct paper *paper, const char *name, long value);
json_t *paper_table_new(struct paper *paper, const char *part, const char *title, const char *const *head);
void paper_table_row(json_t *table, int count, ...); /* `count` json_t * of text */

/* A file of the report's folder, to be closed by output_close(). */
struct output *paper_file(const struct paper *paper, const char *name);

#endif
