/* SPDX-License-Identifier: MIT
 * The deviation of one function of the family (4) from Blinn's over the grid. */
#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "models/models.h"
#include "paper/search_grid.h"

#define PI 3.14159265358979323846

void grid_init(struct grid *grid, const struct search_options *options, struct search_list exponents)
{
    const size_t angles = options->angles, count = options->shininess.count;
    *grid = (struct grid){
        .angles = angles, .shininess = count, .exponents = exponents, .shininess_values = options->shininess.values};
    grid->reference = allocate(angles * count, sizeof(double));
    grid->cosine_power = allocate(angles * exponents.count, sizeof(double));
    grid->shininess_power = allocate(count * exponents.count, sizeof(double));
    const double *n = options->shininess.values;
    for (size_t i = 0; i < angles; i++) {
        const double c = cos(PI / 2 * (double)i / (double)(angles - 1));
        for (size_t j = 0; j < count; j++)
            grid->reference[i * count + j] = model_double(GLINT_BLINN, n[j], c);
        for (size_t b = 0; b < exponents.count; b++)
            grid->cosine_power[b * angles + i] = pow(c, exponents.values[b]);
    }
    for (size_t b = 0; b < exponents.count; b++)
        for (size_t j = 0; j < count; j++)
            grid->shininess_power[b * count + j] = pow(n[j], exponents.values[b]);
}

void grid_free(struct grid *grid)
{
    free(grid->reference);
    free(grid->cosine_power);
    free(grid->shininess_power);
}

/* One angle: F = a / (p n^b3 + q)^b2 for all n. */
struct row {
    double a, p, q, b2;
    const double *shininess_power, *reference;
    size_t count;
};

#define INLINE static inline __attribute__((always_inline))

/* d^(quarters / 4) for a number of quarters that is known when compiled: no pow(). Whole powers are vectorised; roots,
 * which may set errno, are not. */
INLINE double quarter_power(double d, unsigned quarters)
{
    double power = quarters & 2 ? sqrt(d) : 1;
    if (quarters & 1)
        power *= sqrt(sqrt(d));
    for (unsigned i = 0; i < quarters / 4; i++)
        power *= d;
    return power;
}

INLINE double value_at(const struct row *row, size_t j, int quarters)
{
    const double power = quarter_power(row->p * row->shininess_power[j] + row->q, (unsigned)abs(quarters));
    return quarters < 0 ? row->a * power : row->a / power;
}

INLINE double sum_row(const struct row *row, int quarters)
{
    double sum = 0;
    if (quarters % 4) {
        for (size_t j = 0; j < row->count; j++)
            sum += fabs(value_at(row, j, quarters) - row->reference[j]);
        return sum;
    }
#pragma omp simd reduction(+ : sum)
    for (size_t j = 0; j < row->count; j++)
        sum += fabs(value_at(row, j, quarters) - row->reference[j]);
    return sum;
}

static double sum_row_any(const struct row *row)
{
    double sum = 0;
    for (size_t j = 0; j < row->count; j++) {
        const double d = row->p * row->shininess_power[j] + row->q;
        sum += fabs(row->a / pow(d, row->b2) - row->reference[j]);
    }
    return sum;
}

enum { QUARTERS_MAX = 16, NO_QUARTER = 99 };

static int quarters_of(double exponent)
{
    const double quarters = 4 * exponent;
    return quarters == floor(quarters) && fabs(quarters) <= QUARTERS_MAX ? (int)quarters : NO_QUARTER;
}

static double row_deviation(const struct row *row)
{
    switch (quarters_of(row->b2)) {
/* Each quarter step a loop of its own. */
#define CASE(q)                                                                                                        \
    case q:                                                                                                            \
        return sum_row(row, q);
#define CASES(q) CASE(-(q)-1) CASE(-(q)) CASE(q) CASE((q) + 1)
        CASE(0)
        CASES(1)
        CASES(3)
        CASES(5)
        CASES(7)
        CASES(9)
        CASES(11)
        CASES(13)
        CASES(15)
    default:
        return sum_row_any(row);
    }
}

static struct row row_of(const struct grid *grid, const struct candidate *candidate, size_t angle)
{
    const double *power = grid->cosine_power + angle;
    return (struct row){
        .a = candidate->scale * power[candidate->b1 * grid->angles],
        .p = 1 - power[candidate->b3 * grid->angles],
        .q = candidate->ratio * power[candidate->b5 * grid->angles],
        .b2 = grid->exponents.values[candidate->b2],
        .shininess_power = grid->shininess_power + candidate->b3 * grid->shininess,
        .reference = grid->reference + angle * grid->shininess,
        .count = grid->shininess,
    };
}

double candidate_sum(const struct grid *grid, const struct candidate *candidate, double limit)
{
    double sum = 0;
    for (size_t i = 0; i < grid->angles; i++) {
        const struct row row = row_of(grid, candidate, i);
        sum += row_deviation(&row);
        if (!(sum <= limit))
            return INFINITY;
    }
    return isfinite(sum) ? sum : INFINITY;
}

void candidate_places(const struct grid *grid, const struct candidate *candidate, size_t angle, const size_t *places,
                      size_t count, double *values, double *denominators)
{
    const struct row row = row_of(grid, candidate, angle);
    const int quarters = quarters_of(row.b2);
    for (size_t k = 0; k < count; k++) {
        denominators[k] = row.p * row.shininess_power[places[k]] + row.q;
        values[k] = quarters == NO_QUARTER ? row.a / pow(denominators[k], row.b2) : value_at(&row, places[k], quarters);
    }
}
