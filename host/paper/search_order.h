/* SPDX-License-Identifier: MIT
 * The order in which a search goes through its functions. */
#ifndef GLINT_SEARCH_ORDER_H
#define GLINT_SEARCH_ORDER_H

#include <stddef.h>
#include <stdint.h>

/* The index-th of all ways to pick four from `count`, the last one changing fastest. */
void pick_four(uint64_t index, size_t count, size_t picked[4]);

/* A step through 0..total-1 that visits each once, far from the one before: a good limit comes early, and what is done
 * is a fair sample of what is left, for the clock. */
uint64_t scattered_step(uint64_t total);
/* Where the i-th step leads. */
uint64_t scattered_at(uint64_t i, uint64_t step, uint64_t total);

#endif
