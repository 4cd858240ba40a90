/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/message.h"
#include "base/stop.h"
#include "paper/search_best.h"
#include "paper/search_clock.h"
#include "paper/search_grid.h"
#include "paper/search_order.h"
#include "paper/search_rows.h"

#define LENGTH(array) (sizeof(array) / sizeof *(array))

static const double paper_exponents[] = {-3, -2, -1, 0, 1, 2, 3};
static const double paper_coefficients[] = {0.25, 0.5, 1, 1.25, 1.5, 2, 2.5, 3};
static double paper_shininess[1000];

static const char nothing_written[] = "nothing is written";

struct search_options search_options_paper(void)
{
    for (size_t i = 0; i < LENGTH(paper_shininess); i++)
        paper_shininess[i] = (double)(i + 1);
    return (struct search_options){
        .exponents = {paper_exponents, LENGTH(paper_exponents)},
        .coefficients = {paper_coefficients, LENGTH(paper_coefficients)},
        .shininess = {paper_shininess, LENGTH(paper_shininess)},
        .angles = 91,
        .best = 5,
    };
}

/* ---- the stages ---- */

typedef struct candidate (*candidate_at)(const struct search_options *options, const void *set, uint64_t index);

static struct candidate exponents_at(const struct search_options *options, const void *set, uint64_t index)
{
    (void)set;
    size_t b[4];
    pick_four(index, options->exponents.count, b);
    return (struct candidate){b[0], b[1], b[2], b[3], 1, 1};
}

static struct candidate coefficients_at(const struct search_options *options, const void *set, uint64_t index)
{
    struct candidate candidate = *(const struct candidate *)set;
    size_t i[4];
    pick_four(index, options->coefficients.count, i);
    const double *a = options->coefficients.values;
    candidate.scale = a[i[0]] / (a[i[1]] * pow(a[i[2]], options->exponents.values[candidate.b2]));
    candidate.ratio = a[i[3]] / a[i[2]];
    return candidate;
}

/* Compares the functions 0..total-1, each by one thread in a fixed order: the result does not depend on the threads. */
static void compare(const struct search_options *options, const struct grid *grid, candidate_at at, const void *set,
                    uint64_t total, struct search_clock *clock, double done_before, struct best *best)
{
    const uint64_t step = scattered_step(total);
    uint64_t done = 0;
    sigset_t before;
    signals_hold_but_faults(&before); /* the first thread alone takes them, and so can hold them */
#pragma omp parallel
    {
#pragma omp master
        signals_release(&before);
#pragma omp for schedule(dynamic, 16)
        for (uint64_t i = 0; i < total; i++) {
            const uint64_t index = scattered_at(i, step, total);
            const struct candidate candidate = at(options, set, index);
            double limit;
#pragma omp atomic read
            limit = best->limit;
            const double sum = candidate_sum(grid, &candidate, options->exhaustive ? INFINITY : limit);
            if (sum < INFINITY) {
#pragma omp critical(best)
                best_add(best, (struct entry){sum, index});
            }
            uint64_t now;
#pragma omp atomic capture
            now = ++done;
            if (now % 64 == 0) {
#pragma omp critical(clock)
                search_clock_tick(clock, done_before + (double)now);
            }
        }
    }
}

double search_first_size(const struct search_options *options)
{
    return fourth_power(options->exponents.count);
}

double search_second_size(const struct search_options *options)
{
    return (double)options->best * fourth_power(options->coefficients.count);
}

static const double ones[5] = {1, 1, 1, 1, 1};

static void first_stage(const struct search_options *options, const struct grid *grid, struct best *best,
                        struct search_result *result)
{
    const double total = search_first_size(options);
    struct search_clock clock = {
        .what = "stage 1 of 2, exponents", .stop = nothing_written, .total = total, .start = seconds_now()};
    compare(options, grid, exponents_at, NULL, (uint64_t)total, &clock, 0, best);
    result->first_count = best->count;
    result->first = rows_new(best->count);
    for (size_t i = 0; i < best->count; i++) {
        const struct candidate candidate = exponents_at(options, NULL, best->entries[i].index);
        row_set_exponents(options, &candidate, &result->first[i].family);
        memcpy(result->first[i].family.a, ones, sizeof ones);
        result->first[i].deviation = best->entries[i].sum / grid_points(options);
    }
}

/* Behind those of equal deviation, so that the order of stage 1 decides. */
static void insert_row(struct search_result *result, struct search_row row)
{
    size_t at = result->count++;
    for (; at > 0 && row.deviation < result->rows[at - 1].deviation; at--)
        result->rows[at] = result->rows[at - 1];
    result->rows[at] = row;
}

static void second_stage(const struct search_options *options, const struct grid *grid, const struct best *sets,
                         struct search_result *result)
{
    const double each = fourth_power(options->coefficients.count);
    struct search_clock clock = {.what = "stage 2 of 2, coefficients",
                                 .stop = nothing_written,
                                 .total = each * (double)sets->count,
                                 .start = seconds_now()};
    result->rows = rows_new(sets->count);
    for (size_t i = 0; i < sets->count; i++) {
        const struct candidate set = exponents_at(options, NULL, sets->entries[i].index);
        struct best best;
        best_init(&best, 1);
        compare(options, grid, coefficients_at, &set, (uint64_t)each, &clock, each * (double)i, &best);
        if (best.count) {
            struct search_row row = {.deviation = best.entries[0].sum / grid_points(options)};
            row_set_exponents(options, &set, &row.family);
            row_set_coefficients(options, best.entries[0].index, &row.family);
            insert_row(result, row);
        }
        best_free(&best);
    }
}

void search_run(const struct search_options *options, int stages, struct search_result *result)
{
    *result = (struct search_result){0};
    struct grid grid;
    struct best best;
    grid_init(&grid, options, options->exponents);
    best_init(&best, options->best);
    first_stage(options, &grid, &best, result);
    if (stages == 2)
        second_stage(options, &grid, &best, result);
    progress_end();
    best_free(&best);
    grid_free(&grid);
}

void search_free(struct search_result *result)
{
    free(result->first);
    free(result->rows);
}

double search_deviation(const struct search_options *options, const struct family *family)
{
    const double *a = family->a, *b = family->b;
    struct grid grid;
    grid_init(&grid, options, (struct search_list){b, 5});
    const struct candidate candidate = {0, 1, 2, 4, a[0] / (a[1] * pow(a[2], b[1])), a[4] / a[2]};
    const double sum = candidate_sum(&grid, &candidate, INFINITY);
    grid_free(&grid);
    return sum / grid_points(options);
}
