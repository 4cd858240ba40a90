/* SPDX-License-Identifier: MIT
 * Directional lights. */
#include "glint_lights.h"
#include "glint_math_vector.h"

/* Of a direction of length 1 the sizes sum to at most sqrt(3); more, made by hand, would not fit the loops' N.L. */
static enum glint_err light_check(const struct glint_light *light)
{
    uint32_t sum = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t x = light->direction_q30[i];
        const uint32_t size = x < 0 ? 0 - (uint32_t)x : (uint32_t)x;
        if (size > GLINT_T_ONE + 16)
            return GLINT_ERR_ARG;
        sum += size; /* < 2^32 */
    }
    return sum && sum <= UINT32_C(1859775394) + 64 ? GLINT_OK : GLINT_ERR_ARG;
}

static const struct glint_light_kind light_directional GLINT_FLASH = {false, NULL, light_check, NULL, NULL, NULL, NULL};

enum glint_err glint_light_directional(struct glint_light *light, const int32_t to_light[3])
{
    if (!light || !to_light)
        return GLINT_ERR_ARG;
    if (!glint_unit_q30(light->direction_q30, to_light))
        return GLINT_ERR_VECTOR;
    light->kind = &light_directional;
    light->color_q16[0] = light->color_q16[1] = light->color_q16[2] = 65536;
    return GLINT_OK;
}

bool glint_light_half(struct glint_vec *h, const int32_t l_q30[3], const int32_t v_q30[3])
{
    int32_t half[3];
    if (!glint_half_q30(half, l_q30, v_q30) || !glint_unit_q30(half, half))
        return false;
    return glint_vec_of_q30(h, half, 0);
}
