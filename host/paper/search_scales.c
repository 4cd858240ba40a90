/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "paper/search_order.h"
#include "paper/search_scales.h"

/* One way to pick the four. */
struct way {
    double ratio, scale;
    uint64_t coefficients;
};

static int compare_ways(const void *left, const void *right)
{
    const struct way *a = left, *b = right;
    if (a->ratio != b->ratio)
        return a->ratio < b->ratio ? -1 : 1;
    if (a->scale != b->scale)
        return a->scale < b->scale ? -1 : 1;
    return a->coefficients < b->coefficients ? -1 : a->coefficients > b->coefficients;
}

static size_t count_ratios(const struct way *ways, size_t count)
{
    size_t ratios = 1;
    for (size_t i = 1; i < count; i++)
        ratios += ways[i].ratio != ways[i - 1].ratio;
    return ratios;
}

/* The sorted ways, each function once. */
static void fill_lists(struct scale_list *list, const struct way *ways, size_t count)
{
    for (size_t i = 0, end; i < count; i = end, list++) {
        for (end = i; end < count && ways[end].ratio == ways[i].ratio; end++)
            ;
        *list = (struct scale_list){.ratio = ways[i].ratio, .scales = allocate(end - i, sizeof *list->scales)};
        for (size_t k = i; k < end; k++)
            if (k == i || ways[k].scale != ways[k - 1].scale)
                list->scales[list->count++] = (struct scale){ways[k].scale, ways[k].coefficients};
    }
}

void scales_init(struct scales *scales, const struct search_options *options)
{
    const size_t count = options->coefficients.count, all = count * count * count * count;
    const double *a = options->coefficients.values;
    struct way *ways = allocate(all, sizeof *ways);
    *scales = (struct scales){.exponents = options->exponents.count};
    for (size_t b2 = 0; b2 < scales->exponents; b2++) {
        for (size_t way = 0; way < all; way++) {
            size_t i[4];
            pick_four(way, count, i);
            ways[way] =
                (struct way){a[i[3]] / a[i[2]], a[i[0]] / (a[i[1]] * pow(a[i[2]], options->exponents.values[b2])), way};
        }
        qsort(ways, all, sizeof *ways, compare_ways);
        if (b2 == 0) {
            scales->ratios = count_ratios(ways, all);
            scales->lists = allocate(scales->ratios * scales->exponents, sizeof *scales->lists);
        }
        fill_lists(scales->lists + b2 * scales->ratios, ways, all);
    }
    free(ways);
}

const struct scale_list *scales_of(const struct scales *scales, size_t b2)
{
    return scales->lists + b2 * scales->ratios;
}

void scales_free(struct scales *scales)
{
    for (size_t i = 0; i < scales->ratios * scales->exponents; i++)
        free(scales->lists[i].scales);
    free(scales->lists);
}
