/* SPDX-License-Identifier: MIT
 * The highlight over arrays, vectorised and exact. */
#ifndef GLINT_BATCH_H
#define GLINT_BATCH_H

#include <stdbool.h>
#include <stddef.h>

#include "glint.h"

/* f_q16[i] = glint_eval(model, n, c_q16[i]), for any argument, count and alignment; f_q16 may be c_q16 itself, but not
 * overlap it otherwise. What a model has no loop for below goes through a table of all its values where count is large.
 * One thread. Floating point must round to nearest, as it does unless told otherwise. */
void batch_eval(enum glint_model model, uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count);

/* The loops this program holds, best first; the last runs everywhere. For tests and benchmarks: batch_eval takes the
 * first that this processor runs. 1 <= n <= 1000, for Cayley 4 < n. NULL: none. */
typedef void batch_loop(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count);
typedef void batch_lookup(const uint32_t *table, const int32_t *c_q16, uint32_t *f_q16,
                          size_t count); /* table[2^16 + 1] */
struct batch_loops {
    const char *name;
    bool (*runs)(void);
    batch_loop *msh, *schlick, *cayley, *lyon, *ggx, *power; /* power: Blinn's and Phong's */
    batch_lookup *lookup;
};
extern const struct batch_loops batch_loops[];
extern const size_t batch_loops_count;

#endif
