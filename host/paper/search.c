/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/message.h"
#include "base/stop.h"
#include "paper/search_grid.h"

#define LENGTH(array) (sizeof(array) / sizeof *(array))

static const double paper_exponents[] = {-3, -2, -1, 0, 1, 2, 3};
static const double paper_coefficients[] = {0.25, 0.5, 1, 1.25, 1.5, 2, 2.5, 3};
static double paper_shininess[1000];

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

/* ---- the best so far ---- */

struct entry {
    double sum;
    uint64_t index;
};

struct best {
    struct entry *entries; /* sorted, smallest first */
    size_t count, room;
    double limit; /* the last entry's sum once there is no more room; read by all threads while one writes */
};

static void best_init(struct best *best, size_t room)
{
    *best = (struct best){.room = room, .limit = INFINITY};
    best->entries = calloc(room, sizeof *best->entries);
    if (!best->entries)
        fail("out of memory");
}

static bool before(struct entry a, struct entry b)
{
    return a.sum < b.sum || (a.sum == b.sum && a.index < b.index);
}

static void best_add(struct best *best, struct entry entry)
{
    if (best->count == best->room && !before(entry, best->entries[best->count - 1]))
        return;
    size_t at = best->count < best->room ? best->count++ : best->count - 1;
    for (; at > 0 && before(entry, best->entries[at - 1]); at--)
        best->entries[at] = best->entries[at - 1];
    best->entries[at] = entry;
    if (best->count == best->room) {
#pragma omp atomic write
        best->limit = best->entries[best->count - 1].sum;
    }
}

/* ---- progress ---- */

struct clock {
    const char *what;
    double total, start, shown;
    bool warned;
};

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void describe_time(char *text, size_t size, double time)
{
    if (time < 90)
        snprintf(text, size, "%.0f s", ceil(time));
    else if (time < 90 * 60)
        snprintf(text, size, "%.0f min", time / 60);
    else
        snprintf(text, size, "%.1f h", time / 3600);
}

static void clock_tick(struct clock *clock, double done)
{
    const double now = seconds(), passed = now - clock->start;
    if (now - clock->shown < 0.2 || done <= 0)
        return;
    clock->shown = now;
    char left[32];
    describe_time(left, sizeof left, passed * (clock->total - done) / done);
    if (!clock->warned && passed > 2 && passed * (clock->total - done) / done > 60) {
        clock->warned = true;
        warn("search: %s of %.0f functions will take about %s; Ctrl-C stops, and nothing is written", clock->what,
             clock->total, left);
    }
    progress("search: %s, %.0f %% of %.0f functions, %s left", clock->what, 100 * done / clock->total, clock->total,
             left);
}

/* ---- the stages ---- */

/* The index-th of all ways to pick four from `count`, the last one changing fastest. */
static void pick_four(uint64_t index, size_t count, size_t picked[4])
{
    for (int i = 3; i >= 0; i--) {
        picked[i] = (size_t)(index % count);
        index /= count;
    }
}

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

/* A step through 0..total-1 that visits each once, far from the one before: a good limit comes early, and what is done
 * is a fair sample of what is left, for the clock. */
static uint64_t scattered_step(uint64_t total)
{
    uint64_t step = (uint64_t)((double)total * 0.6180339887) | 1;
    for (;; step += 2) {
        uint64_t a = total, b = step;
        while (b) {
            const uint64_t rest = a % b;
            a = b;
            b = rest;
        }
        if (a == 1)
            return step;
    }
}

/* Compares the functions 0..total-1, each by one thread in a fixed order: the result does not depend on the threads. */
static void compare(const struct search_options *options, const struct grid *grid, candidate_at at, const void *set,
                    uint64_t total, struct clock *clock, double done_before, struct best *best)
{
    const uint64_t step = scattered_step(total);
    uint64_t done = 0;
    sigset_t before;
    signals_hold(&before); /* the first thread alone takes them, and so can hold them */
#pragma omp parallel
    {
#pragma omp master
        signals_release(&before);
#pragma omp for schedule(dynamic, 16)
        for (uint64_t i = 0; i < total; i++) {
            const uint64_t index = (uint64_t)((unsigned __int128)i * step % total);
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
                clock_tick(clock, done_before + (double)now);
            }
        }
    }
}

static double grid_points(const struct search_options *options)
{
    return (double)options->angles * (double)options->shininess.count;
}

static double fourth_power(size_t count)
{
    return (double)count * (double)count * (double)count * (double)count;
}

double search_first_size(const struct search_options *options)
{
    return fourth_power(options->exponents.count);
}

double search_second_size(const struct search_options *options)
{
    return (double)options->best * fourth_power(options->coefficients.count);
}

static struct search_row *rows_new(size_t count)
{
    struct search_row *rows = calloc(count ? count : 1, sizeof *rows);
    if (!rows)
        fail("out of memory");
    return rows;
}

static void set_exponents(const struct search_options *options, const struct candidate *at, struct family *family)
{
    const double *b = options->exponents.values;
    const double chosen[5] = {b[at->b1], b[at->b2], b[at->b3], b[at->b3], b[at->b5]};
    memcpy(family->b, chosen, sizeof chosen);
}

static void set_coefficients(const double values[4], struct family *family)
{
    const double chosen[5] = {values[0], values[1], values[2], values[2], values[3]};
    memcpy(family->a, chosen, sizeof chosen);
}

static void first_stage(const struct search_options *options, const struct grid *grid, struct best *best,
                        struct search_result *result)
{
    const double total = search_first_size(options);
    struct clock clock = {.what = "stage 1 of 2, exponents", .total = total, .start = seconds()};
    compare(options, grid, exponents_at, NULL, (uint64_t)total, &clock, 0, best);
    result->first_count = best->count;
    result->first = rows_new(best->count);
    for (size_t i = 0; i < best->count; i++) {
        const struct candidate candidate = exponents_at(options, NULL, best->entries[i].index);
        set_exponents(options, &candidate, &result->first[i].family);
        set_coefficients((const double[4]){1, 1, 1, 1}, &result->first[i].family);
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
    struct clock clock = {
        .what = "stage 2 of 2, coefficients", .total = each * (double)sets->count, .start = seconds()};
    result->rows = rows_new(sets->count);
    for (size_t i = 0; i < sets->count; i++) {
        const struct candidate set = exponents_at(options, NULL, sets->entries[i].index);
        struct best best;
        best_init(&best, 1);
        compare(options, grid, coefficients_at, &set, (uint64_t)each, &clock, each * (double)i, &best);
        if (best.count) {
            size_t a[4];
            pick_four(best.entries[0].index, options->coefficients.count, a);
            const double *list = options->coefficients.values;
            struct search_row row = {.deviation = best.entries[0].sum / grid_points(options)};
            set_exponents(options, &set, &row.family);
            set_coefficients((const double[4]){list[a[0]], list[a[1]], list[a[2]], list[a[3]]}, &row.family);
            insert_row(result, row);
        }
        free(best.entries);
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
    free(best.entries);
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
