/* SPDX-License-Identifier: MIT */
#include "glint_math_vector.h"
#include "glint_math_root.h"

bool glint_unit_q30(int32_t out[3], const int32_t v[3])
{
    uint32_t size[3], largest = 0;
    for (int i = 0; i < 3; i++) {
        size[i] = v[i] < 0 ? 0 - (uint32_t)v[i] : (uint32_t)v[i];
        if (size[i] > largest)
            largest = size[i];
    }
    if (largest == 0)
        return false;
    unsigned up = 0, down = 0; /* bring the largest to 2^29 .. 2^30: the squares then sum to less than 2^62 */
    while (largest << up < (uint32_t)1 << 29)
        up++;
    while (largest >> down >= (uint32_t)1 << 30)
        down++;
    uint64_t sum = 0;
    for (int i = 0; i < 3; i++) {
        size[i] = size[i] << up >> down;
        sum += (uint64_t)size[i] * size[i];
    }
    const uint32_t length = glint_root(sum); /* >= every size */
    for (int i = 0; i < 3; i++) {
        const int32_t part = (int32_t)((((uint64_t)size[i] << 30) + length / 2) / length);
        out[i] = v[i] < 0 ? -part : part;
    }
    return true;
}

static int16_t q15_of_q30(int32_t x)
{
    const int32_t rounded = (x + (1 << 14)) >> 15;
    return (int16_t)(rounded > INT16_MAX ? INT16_MAX : rounded);
}

static struct glint_vec vec_of_q30(const int32_t v[3])
{
    const struct glint_vec vec = {q15_of_q30(v[0]), q15_of_q30(v[1]), q15_of_q30(v[2])};
    return vec;
}

enum glint_err glint_vec_normalize(struct glint_vec *out, const int32_t v[3])
{
    if (!out || !v)
        return GLINT_ERR_ARG;
    int32_t unit[3];
    if (!glint_unit_q30(unit, v))
        return GLINT_ERR_VECTOR;
    *out = vec_of_q30(unit);
    return GLINT_OK;
}

bool glint_light_between(struct glint_light *light, const int32_t l_q30[3], const int32_t v_q30[3])
{
    int32_t half[3], h[3];
    bool behind = true;
    for (int i = 0; i < 3; i++) {
        const int64_t sum = (int64_t)l_q30[i] + v_q30[i];
        behind = behind && sum <= 8 && sum >= -8; /* what the rounding of l and v leaves of 0, and more */
        half[i] = (int32_t)(sum >> 1);
    }
    if (behind || !glint_unit_q30(h, half))
        return false;
    light->l = vec_of_q30(l_q30);
    light->v = vec_of_q30(v_q30);
    light->h = vec_of_q30(h);
    return true;
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
