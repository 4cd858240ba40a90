/* SPDX-License-Identifier: MIT
 * Shaders, normals and many cases of them, likely or hostile. A case has its own generator, so that cases are the same for any number
 * of threads. */
#ifndef GLINT_EXACT_CASES_H
#define GLINT_EXACT_CASES_H

#include "glint.h"

/* Here, since a case takes many. */
static inline uint32_t case_below(uint64_t *seed, uint32_t limit)
{
    *seed = *seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)((*seed >> 32) * limit >> 32);
}
#define BELOW(limit) case_below(seed, limit)
#define ONE_IN(count) (case_below(seed, count) == 0)

struct glint_vec case_vector(uint64_t *seed);
struct glint_shader case_shader(uint64_t *seed);
/* In doubles, within a unit of glint_vec_normalize, which takes longer than a pixel; (0, 0, 1) for a zero vector. */
struct glint_vec case_unit(const double v[3]);
/* Of the whole sphere, near the half vector, or anything. */
struct glint_vec case_normal(uint64_t *seed, const struct glint_light *light, int spread);

/* Cases until `share` thousandths of GLINT_PIXELS million pixels are drawn, 1000 where it is not set. `one` draws one case in so many
 * bytes of memory of its own, and returns how many pixels; 0 where one differs: then the case's number is printed. */
bool cases_pass(unsigned (*one)(uint64_t *seed, void *memory), size_t bytes, unsigned share);

#endif
