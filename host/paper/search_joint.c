/* SPDX-License-Identifier: MIT
 * One function of the family (4) is a set of exponents, a ratio a5 / a3 and a scale a1 / (a2 a3^b2). The sets are taken
 * one by one, scattered over the grid; for each ratio, the bound says which scales may come near the best so far, and
 * only for those the whole sum is formed. A round gives each rank a run of sets; after it the ranks exchange their best,
 * so that all go on with the same limit, and rank 0 writes the checkpoint. What is given up is above the limit, whatever
 * the limit was then, so that the rows do not depend on the order. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/stop.h"
#include "paper/search_best.h"
#include "paper/search_bound.h"
#include "paper/search_checkpoint.h"
#include "paper/search_clock.h"
#include "paper/search_joint.h"
#include "paper/search_order.h"
#include "paper/search_rows.h"
#include "paper/search_scales.h"

/* How long a round should take, how long a checkpoint may be old, and how many sets the first round has. */
static const double round_s = 1, checkpoint_s = 5;
enum { FIRST_SETS = 16 };

static const double joint_coefficients[] = {0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2, 2.25, 2.5};
static double joint_exponents[33];

struct search_options search_options_joint(void)
{
    struct search_options options = search_options_paper();
    for (int i = 0; i < 33; i++)
        joint_exponents[i] = -4 + 0.25 * i;
    options.exponents = (struct search_list){joint_exponents, 33};
    options.coefficients = (struct search_list){joint_coefficients, 10};
    return options;
}

double search_joint_size(const struct search_options *options)
{
    return search_first_size(options) * fourth_power(options->coefficients.count);
}

struct joint {
    const struct search_options *options;
    const struct ranks *ranks;
    struct grid grid;
    struct bound_grid bounds;
    struct scales scales;
    struct best best;
    struct search_clock clock;
    uint64_t sets, step, done; /* done: of all ranks, in the scattered order */
    uint64_t each;             /* functions of a set */
};

static struct candidate set_at(const struct joint *joint, uint64_t set)
{
    size_t b[4];
    pick_four(set, joint->options->exponents.count, b);
    return (struct candidate){b[0], b[1], b[2], b[3], 1, 1};
}

/* All functions with these exponents. */
static void compare_set(struct joint *joint, uint64_t set, struct bound *bound)
{
    struct candidate candidate = set_at(joint, set);
    const struct scale_list *lists = scales_of(&joint->scales, candidate.b2);
    for (size_t r = 0; r < joint->scales.ratios; r++) {
        candidate.ratio = lists[r].ratio;
        candidate.scale = 1;
        bound_begin(bound, &candidate);
        for (size_t i = 0; i < lists[r].count && bound->finite; i++) {
            double limit;
#pragma omp atomic read
            limit = joint->best.limit;
            candidate.scale = lists[r].scales[i].scale;
            if (!bound_allows(bound, candidate.scale, limit))
                continue;
            const double sum = candidate_sum(&joint->grid, &candidate, limit);
            if (sum < INFINITY) {
#pragma omp critical(joint_best)
                best_add(&joint->best, (struct entry){sum, set * joint->each + lists[r].scales[i].coefficients});
            }
        }
    }
}

/* This rank's part of a round. */
static void compare_sets(struct joint *joint, uint64_t from, uint64_t to)
{
    uint64_t passed = 0;
    sigset_t before;
    signals_hold_but_faults(&before); /* the first thread alone takes them, and so can hold them */
#pragma omp parallel
    {
#pragma omp master
        signals_release(&before);
        struct bound bound;
        bound_init(&bound, &joint->bounds);
#pragma omp for schedule(dynamic, 1)
        for (uint64_t i = from; i < to; i++) {
            compare_set(joint, scattered_at(i, joint->step, joint->sets), &bound);
            uint64_t now;
#pragma omp atomic capture
            now = ++passed;
            if (joint->ranks->index == 0) {
#pragma omp critical(joint_clock)
                search_clock_tick(&joint->clock,
                                  (double)(joint->done + now * (uint64_t)joint->ranks->count) * (double)joint->each);
            }
        }
        bound_free(&bound);
    }
}

/* The best of every rank become the best of all, in each. */
static void exchange(struct joint *joint)
{
    const size_t room = joint->best.room, bytes = room * sizeof(struct entry);
    struct entry *mine = allocate(room, sizeof *mine), *all = allocate(room * (size_t)joint->ranks->count, sizeof *all);
    for (size_t i = 0; i < room; i++)
        mine[i] = i < joint->best.count ? joint->best.entries[i] : (struct entry){INFINITY, UINT64_MAX};
    ranks_gather(joint->ranks, mine, bytes, all);
    best_free(&joint->best);
    best_init(&joint->best, room);
    for (size_t i = 0; i < room * (size_t)joint->ranks->count; i++)
        if (all[i].sum < INFINITY && !best_has(&joint->best, all[i].index))
            best_add(&joint->best, all[i]);
    free(mine);
    free(all);
}

static void search_rounds(struct joint *joint, const char *checkpoint)
{
    uint64_t sets = FIRST_SETS; /* a rank's, of the next round */
    double written = 0;
    while (joint->done < joint->sets) {
        const double start = seconds_now();
        const uint64_t left = joint->sets - joint->done, ranks = (uint64_t)joint->ranks->count;
        const uint64_t round = sets < left / ranks ? sets * ranks : left;
        const uint64_t index = (uint64_t)joint->ranks->index;
        compare_sets(joint, joint->done + round * index / ranks, joint->done + round * (index + 1) / ranks);
        exchange(joint);
        joint->done += round;
        const double passed = seconds_now() - start;
        if (joint->ranks->index == 0 && checkpoint &&
            (seconds_now() - written > checkpoint_s || joint->done == joint->sets)) {
            checkpoint_write(checkpoint, joint->options, joint->done, &joint->best);
            written = seconds_now();
        }
        const double wanted = (double)sets * fmin(4, round_s / fmax(passed, 1e-6));
        sets = (uint64_t)fmin(fmax(wanted, 1), 1e6);
        ranks_share(joint->ranks, &sets, sizeof sets);
    }
}

static void fill_rows(const struct joint *joint, struct search_result *result)
{
    result->rows = rows_new(joint->best.count);
    result->count = joint->best.count;
    for (size_t i = 0; i < result->count; i++) {
        const uint64_t index = joint->best.entries[i].index;
        const struct candidate candidate = set_at(joint, index / joint->each);
        result->rows[i].deviation = joint->best.entries[i].sum / grid_points(joint->options);
        row_set_exponents(joint->options, &candidate, &result->rows[i].family);
        row_set_coefficients(joint->options, index % joint->each, &result->rows[i].family);
    }
}

void search_joint(const struct search_options *options, const struct ranks *ranks, const char *checkpoint,
                  struct search_result *result)
{
    const double each = fourth_power(options->coefficients.count), sets = search_first_size(options);
    struct joint joint = {.options = options,
                          .ranks = ranks,
                          .sets = (uint64_t)sets,
                          .step = scattered_step((uint64_t)sets),
                          .each = (uint64_t)each};
    *result = (struct search_result){0};
    best_init(&joint.best, options->best);
    if (ranks->index == 0 && checkpoint)
        checkpoint_read(checkpoint, options, &joint.done, &joint.best);
    ranks_share(ranks, &joint.done, sizeof joint.done);
    exchange(&joint);
    grid_init(&joint.grid, options, options->exponents);
    bound_grid_init(&joint.bounds, &joint.grid);
    scales_init(&joint.scales, options);
    joint.clock =
        (struct search_clock){.what = "the joint grid",
                              .total = sets * each,
                              .start = seconds_now(),
                              .before = (double)joint.done * each,
                              .stop = options->quiet ? NULL
                                      : checkpoint   ? "the same command goes on from the checkpoint"
                                                     : "nothing is written (--checkpoint FILE keeps what is done)"};
    search_rounds(&joint, checkpoint);
    progress_end();
    fill_rows(&joint, result);
    scales_free(&joint.scales);
    bound_grid_free(&joint.bounds);
    grid_free(&joint.grid);
    best_free(&joint.best);
}
