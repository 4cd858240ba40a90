/* SPDX-License-Identifier: MIT */
#include "models/batch.h"

#include <stdint.h>
#include <stdlib.h>

#include "models/batch_avx2.h"
#include "models/batch_portable.h"

const struct batch_loops batch_loops[] = {
#if GLINT_BATCH_AVX2
    {"avx2", batch_runs_avx2, batch_msh_avx2, batch_schlick_avx2, batch_cayley_avx2, batch_lyon_avx2, batch_ggx_avx2,
     batch_power_avx2, batch_lookup_avx2},
#endif
    {"portable", batch_runs_portable, batch_msh_portable, batch_schlick_portable, batch_cayley_portable,
     batch_lyon_portable, batch_ggx_portable, NULL, batch_lookup_portable},
};
const size_t batch_loops_count = sizeof batch_loops / sizeof *batch_loops;

/* c_q16 may be f_q16. */
static void by_loop(batch_loop *loop, enum glint_model model, uint32_t n, const int32_t *c_q16, uint32_t *f_q16,
                    size_t count)
{
    if (loop)
        loop(n, c_q16, f_q16, count);
    else
        for (size_t i = 0; i < count; i++)
            f_q16[i] = glint_eval(model, n, c_q16[i]);
}

enum { ENTRIES = GLINT_C_ONE + 1 };

/* A table of every cosine's value, or NULL. */
static uint32_t *table_of(batch_loop *loop, enum glint_model model, uint32_t n)
{
    uint32_t *table = malloc(ENTRIES * sizeof *table);
    if (!table)
        return NULL;
    for (uint32_t c = 0; c < ENTRIES; c++)
        table[c] = c;
    by_loop(loop, model, n, (const int32_t *)table, table, ENTRIES);
    return table;
}

static batch_loop *loop_of(const struct batch_loops *loops, enum glint_model model, uint32_t n)
{
    switch ((int)model) {
    case GLINT_MSH:
        return loops->msh;
    case GLINT_SCHLICK:
        return loops->schlick;
    case GLINT_BLINN:
    case GLINT_PHONG:
        return loops->power;
    case GLINT_CAYLEY:
        return n > 4 ? loops->cayley : loops->power;
    case GLINT_LYON:
        return loops->lyon;
    case GLINT_GGX:
        return loops->ggx;
    }
    return NULL;
}

/* From how many elements on a table pays: the loop for powers is nearly as fast. */
static size_t table_pays(const struct batch_loops *loops, batch_loop *loop)
{
    return !loop ? ENTRIES : loop == loops->power ? (size_t)16 * ENTRIES : SIZE_MAX;
}

void batch_eval(enum glint_model model, uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const struct batch_loops *loops = batch_loops;
    while (!loops->runs())
        loops++;
    n = n < 1 ? 1 : n > GLINT_N_MAX ? GLINT_N_MAX : n;
    batch_loop *loop = loop_of(loops, model, n);
    uint32_t *table = count >= table_pays(loops, loop) ? table_of(loop, model, n) : NULL;
    if (table)
        loops->lookup(table, c_q16, f_q16, count);
    else
        by_loop(loop, model, n, c_q16, f_q16, count);
    free(table);
}
