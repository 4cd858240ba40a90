/* SPDX-License-Identifier: MIT
 * For Eva: directions. Of every vector but 0 one component is the largest, and lies in 2^k .. 2^(k + 1) for one k: shifts follow from k.
 * eva: -eva-precision 3 -eva-slevel 40 */
#include "eva.h"
#include "glint_math_vector.h"

static int32_t within(int64_t most)
{
    const int64_t v = any_signed;
    return v > most || v < -most ? 0 : (int32_t)v;
}

/* Every vector whose component i is the largest, with 2^k <= |v[i]| < 2^(k + 1). */
static void largest(int32_t v[3], unsigned i, unsigned k, bool negative)
{
    const int64_t least = (int64_t)1 << k, most = 2 * least - 1, size = any_signed;
    for (unsigned j = 0; j < 3; j++)
        v[j] = within(most);
    const int64_t held = size < least ? least : size > most ? most : size;
    v[i] = negative ? (int32_t)-held : (int32_t)held;
}

#define EACH_VECTOR(v, bits)                                                                                           \
    int32_t v[3];                                                                                                      \
    for (unsigned k = 0; k < (bits); k++)                                                                              \
        for (unsigned i = 0; i < 3; i++)                                                                               \
            for (unsigned negative = 0; negative < 2; negative++)

void eva_unit_q30(void)
{
    EACH_VECTOR(v, 31)
    {
        int32_t out[3];
        largest(v, i, k, negative);
        (void)glint_unit_q30(out, v);
    }
}

/* The one size of 2^31. */
void eva_unit_q30_far(void)
{
    int32_t out[3];
    for (unsigned i = 0; i < 3; i++) {
        int32_t v[3] = {any_signed, any_signed, any_signed};
        v[i] = INT32_MIN;
        (void)glint_unit_q30(out, v);
    }
}

void eva_unit_near(void)
{
    EACH_VECTOR(v, 30)
    {
        struct glint_unit unit;
        largest(v, i, k, negative);
        (void)glint_unit_near(&unit, v);
    }
}

void eva_unit_front(void)
{
    const int32_t l[3] = {within(GLINT_T_ONE + 8), within(GLINT_T_ONE + 8), within(GLINT_T_ONE + 8)};
    int32_t h[3];
    if (l[2] >= 0)
        glint_unit_front(h, l);
}
