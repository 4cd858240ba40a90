/* SPDX-License-Identifier: MIT
 * The best functions a search has met. */
#ifndef GLINT_SEARCH_BEST_H
#define GLINT_SEARCH_BEST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct entry {
    double sum;     /* of the errors over the grid */
    uint64_t index; /* of the function, in the order of the lists; decides between equal sums */
};

struct best {
    struct entry *entries; /* sorted, smallest first */
    size_t count, room;
    double limit; /* the last entry's sum once there is no more room; read by all threads while one writes */
};

void best_init(struct best *best, size_t room);
void best_add(struct best *best, struct entry entry); /* one thread at a time */
bool best_has(const struct best *best, uint64_t index);
void best_free(struct best *best);

#endif
