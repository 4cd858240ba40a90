/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "paper/search_best.h"

void best_init(struct best *best, size_t room)
{
    *best = (struct best){.room = room, .limit = INFINITY};
    best->entries = allocate(room, sizeof *best->entries);
}

static bool before(struct entry a, struct entry b)
{
    return a.sum < b.sum || (a.sum == b.sum && a.index < b.index);
}

void best_add(struct best *best, struct entry entry)
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

bool best_has(const struct best *best, uint64_t index)
{
    for (size_t i = 0; i < best->count; i++)
        if (best->entries[i].index == index)
            return true;
    return false;
}

void best_free(struct best *best)
{
    free(best->entries);
    *best = (struct best){0};
}
