/* SPDX-License-Identifier: MIT
 * The loops of batch.h for AVX2. */
#ifndef GLINT_BATCH_AVX2_H
#define GLINT_BATCH_AVX2_H

#include "models/batch.h"

#if defined __x86_64__ && defined __GNUC__
#define GLINT_BATCH_AVX2 1
bool batch_runs_avx2(void);
batch_loop batch_msh_avx2, batch_schlick_avx2, batch_cayley_avx2, batch_lyon_avx2, batch_ggx_avx2, batch_power_avx2;
batch_lookup batch_lookup_avx2;
#else
#define GLINT_BATCH_AVX2 0
#endif

#endif
