/* SPDX-License-Identifier: MIT
 * The deviation of one function of the family (4) from Blinn's over the grid. */
#include <math.h>
#include <stdlib.h>

#include "base/message.h"
#include "models/models.h"
#include "paper/search_grid.h"

#define PI 3.14159265358979323846

static double *numbers(size_t count)
{
    double *values = malloc(count * sizeof *values);
    if (!values)
        fail("out of memory");
    return values;
}

void grid_init(struct grid *grid, const struct search_options *options, struct search_list exponents)
{
    const size_t angles = options->angles, count = options->shininess.count;
    *grid = (struct grid){.angles = angles, .shininess = count, .exponents = exponents};
    grid->reference = numbers(angles * count);
    grid->cosine_power = numbers(angles * exponents.count);
    grid->shininess_power = numbers(count * exponents.count);
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

enum { NO_HALF_STEP = 99 };

#define INLINE static inline __attribute__((always_inline))

/* b2 = half_steps / 2 is known when compiled: no pow(), and whole powers are vectorised (sqrt, which may set errno, is
 * not). */
INLINE double error_at(const struct row *row, size_t j, int half_steps)
{
    const double d = row->p * row->shininess_power[j] + row->q;
    double power = half_steps % 2 ? sqrt(d) : 1;
    for (int i = 0; i < abs(half_steps) / 2; i++)
        power *= d;
    return fabs((half_steps < 0 ? row->a * power : row->a / power) - row->reference[j]);
}

INLINE double sum_row(const struct row *row, int half_steps)
{
    double sum = 0;
    if (half_steps % 2) {
        for (size_t j = 0; j < row->count; j++)
            sum += error_at(row, j, half_steps);
        return sum;
    }
#pragma omp simd reduction(+ : sum)
    for (size_t j = 0; j < row->count; j++)
        sum += error_at(row, j, half_steps);
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

static double row_deviation(const struct row *row)
{
    const double half_steps = 2 * row->b2;
    switch (half_steps == floor(half_steps) && fabs(half_steps) <= 6 ? (int)half_steps : NO_HALF_STEP) {
    case -6:
        return sum_row(row, -6);
    case -5:
        return sum_row(row, -5);
    case -4:
        return sum_row(row, -4);
    case -3:
        return sum_row(row, -3);
    case -2:
        return sum_row(row, -2);
    case -1:
        return sum_row(row, -1);
    case 0:
        return sum_row(row, 0);
    case 1:
        return sum_row(row, 1);
    case 2:
        return sum_row(row, 2);
    case 3:
        return sum_row(row, 3);
    case 4:
        return sum_row(row, 4);
    case 5:
        return sum_row(row, 5);
    case 6:
        return sum_row(row, 6);
    default:
        return sum_row_any(row);
    }
}

double candidate_sum(const struct grid *grid, const struct candidate *candidate, double limit)
{
    double sum = 0;
    for (size_t i = 0; i < grid->angles; i++) {
        const double *power = grid->cosine_power + i;
        const struct row row = {
            .a = candidate->scale * power[candidate->b1 * grid->angles],
            .p = 1 - power[candidate->b3 * grid->angles],
            .q = candidate->ratio * power[candidate->b5 * grid->angles],
            .b2 = grid->exponents.values[candidate->b2],
            .shininess_power = grid->shininess_power + candidate->b3 * grid->shininess,
            .reference = grid->reference + i * grid->shininess,
            .count = grid->shininess,
        };
        sum += row_deviation(&row);
        if (!(sum <= limit))
            return INFINITY;
    }
    return isfinite(sum) ? sum : INFINITY;
}
