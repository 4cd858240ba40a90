/* SPDX-License-Identifier: MIT
 * Inside `glint paper`: what its parts share. Each part computes, writes its CSV and plot, and hands in claims, choices and
 * numbers; all of that is one JSON object, from which claims.json and the report are written. */
#ifndef GLINT_PAPER_H
#define GLINT_PAPER_H

#include <jansson.h>
#include <stdio.h>

#include "base/output.h"
#include "glint.h"
#include "models/formulas.h"
#include "paper/search.h"

#define PI 3.14159265358979323846

struct paper {
    const char *directory;
    bool complete;        /* all parts are wanted */
    const char *terminal; /* "pngcairo" or "svg"; NULL: no plots */
    json_t *claims;       /* [{part, where, claim, computed, verdict}] */
    json_t *choices;      /* [{part, silent, chosen, other}] */
    json_t *numbers;      /* {name: value}: what the texts quote, at full precision */
    json_t *tables;       /* {part: {title, head: [text], rows: [[text]], note}} */
    json_t *figures;      /* [{part, title, caption, csv, image, data}] */
};

/* ---- the parts; each in the file named ---- */
void paper_table1(struct paper *paper); /* paper_table.c */
void paper_wider(struct paper *paper);
void paper_figure3(struct paper *paper); /* paper_lobes.c */
void paper_figure4(struct paper *paper);
void paper_figure5(struct paper *paper); /* paper_surfaces.c */
void paper_figure6(struct paper *paper);
void paper_figure7a(struct paper *paper); /* paper_spots.c */
void paper_figure7b(struct paper *paper);
void paper_figure9(struct paper *paper); /* paper_relative.c */
void paper_models(struct paper *paper);  /* paper_models.c */

/* ---- what becomes of it (paper_report.c) ---- */
void paper_report(const struct paper *paper);     /* report.html, with the plots in it, and claims.json */
json_t *paper_summary(const struct paper *paper); /* what claims.json holds */

/* ---- what they hand in (paper.c) ---- */

enum verdict { CONFIRMED, WITH_LIMITS, NOT_CONFIRMED };
extern const char *const verdict_names[];
/* Confirmed where it holds in full, with limits where only in part. */
enum verdict verdict_of(bool in_full, bool in_part);

/* Texts are json_sprintf() values, and are taken over. */
void paper_claim(struct paper *paper, const char *part, const char *where, const char *claim, enum verdict verdict,
                 json_t *computed);
void paper_choice(struct paper *paper, const char *part, const char *silent, json_t *chosen, json_t *other);
void paper_number(struct paper *paper, const char *name, double value);
void paper_count(struct paper *paper, const char *name, long value);
json_t *paper_table_new(struct paper *paper, const char *part, const char *title, const char *const *head);
void paper_table_row(json_t *table, int count, ...); /* `count` json_t * of text */

/* DIR/NAME, replaced when closed by output_close(). */
struct output *paper_file(const struct paper *paper, const char *name);
/* Keeps the script as DIR/PART.gp, runs gnuplot on it, keeps the picture, and enters the figure with DIR/PART.csv. The
 * script's terminal is set in front of it: size in pixels. */
void paper_figure(struct paper *paper, const char *part, const char *title, int width, int height, const char *script,
                  json_t *caption);

/* ---- the library's values at an angle in radians, as doubles ---- */
double q16_from_t(enum glint_model model, double n, double x); /* glint_eval_t, t = 2 sin^2(x/2) to the nearest 2^-30 */
double q16_from_c(enum glint_model model, double n, double x); /* glint_eval, c to the nearest 2^-16 */
double q16_cutoff_angle_t(enum glint_model model, double n, unsigned q);
double q16_cutoff_angle_c(enum glint_model model, double n, unsigned q);

/* ---- gnuplot (plot.c) ---- */

/* "pngcairo" or "svg", whichever gnuplot offers; fails where there is no gnuplot. */
const char *plot_terminal(void);
/* Runs `gnuplot SCRIPT` in the directory; what it writes to standard output is returned, malloc'd. */
char *plot_run(const char *directory, const char *script, size_t *size);

#endif
