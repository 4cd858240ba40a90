/* SPDX-License-Identifier: MIT */
#include "glint_math_vector.h"
#include "glint_math_root.h"

/* size 2^30 / length to nearest, for size <= length < 2^31: digit by digit, as a call of a division takes more stack. */
static inline uint32_t vector_part(uint32_t size, uint32_t length)
{
    uint32_t part = 0;
    for (int digit = 30; digit >= 0; digit--) {
        part <<= 1;
        if (size >= length) {
            size -= length;
            part++;
        }
        size <<= 1;
    }
    return part + (size >= length); /* twice the remainder */
}

static inline uint32_t vector_size(int32_t v)
{
    return v < 0 ? 0 - (uint32_t)v : (uint32_t)v;
}

bool glint_unit_q30(int32_t out[3], const int32_t v[3])
{
    uint32_t largest = 0;
    for (int i = 0; i < 3; i++)
        largest = vector_size(v[i]) > largest ? vector_size(v[i]) : largest;
    if (largest == 0)
        return false;
    unsigned up = 0, down = 0; /* bring the largest to 2^29 .. 2^30: the squares then sum to less than 2^62 */
    while (largest << up < (uint32_t)1 << 29)
        up++;
    while (largest >> down >= (uint32_t)1 << 30)
        down++;
    uint64_t sum = 0;
    for (int i = 0; i < 3; i++) {
        const uint32_t size = vector_size(v[i]) << up >> down;
        sum += (uint64_t)size * size;
        out[i] = v[i] < 0 ? -(int32_t)size : (int32_t)size;
    }
    const uint32_t length = glint_root(sum); /* >= every size */
    for (int i = 0; i < 3; i++) {
        const int32_t part = (int32_t)vector_part(vector_size(out[i]), length);
        out[i] = out[i] < 0 ? -part : part;
    }
    return true;
}

bool glint_vec_of_q30(struct glint_vec *out, const int32_t v[3], int32_t slack)
{
    return glint_vec_near(out, v, slack);
}

enum glint_err glint_vec_normalize(struct glint_vec *out, const int32_t v[3])
{
    if (!out || !v)
        return GLINT_ERR_ARG;
    int32_t unit[3];
    if (!glint_unit_q30(unit, v))
        return GLINT_ERR_VECTOR;
    (void)glint_vec_of_q30(out, unit, 0);
    return GLINT_OK;
}

bool glint_half_q30(int32_t half[3], const int32_t l_q30[3], const int32_t v_q30[3])
{
    bool behind = true;
    for (int i = 0; i < 3; i++) {
        const int32_t l = l_q30[i], v = v_q30[i];
        const uint32_t sum = (uint32_t)l + (uint32_t)v + 8; /* modulo 2^32: sizes are about 2^30 at most */
        behind = behind && sum <= 16;                       /* what the rounding of l and v leaves of 0, and more */
        half[i] = (l & v) + ((l ^ v) >> 1);                 /* the sum may not fit */
    }
    return !behind;
}

bool glint_light_between(struct glint_light *light, const int32_t l_q30[3], const int32_t v_q30[3])
{
    int32_t h[3];
    if (!glint_half_q30(h, l_q30, v_q30) || !glint_unit_q30(h, h))
        return false;
    (void)glint_vec_of_q30(&light->l, l_q30, 0);
    (void)glint_vec_of_q30(&light->v, v_q30, 0);
    return glint_vec_of_q30(&light->h, h, 0);
}

enum glint_err glint_light_init(struct glint_light *light, const int32_t to_light[3], const int32_t to_viewer[3])
{
    if (!light || !to_light || !to_viewer)
        return GLINT_ERR_ARG;
    int32_t l[3], v[3];
    return glint_unit_q30(l, to_light) && glint_unit_q30(v, to_viewer) && glint_light_between(light, l, v)
               ? GLINT_OK
               : GLINT_ERR_VECTOR;
}
