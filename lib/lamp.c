/* SPDX-License-Identifier: MIT
 * Lamps: set up, and how much of one reaches a pixel. */
#include "glint_lamp.h"
#include "glint_math_vector.h"

static bool is_far(const int32_t place[3])
{
    for (int i = 0; i < 3; i++)
        if (place[i] > GLINT_LAMP_FAR || place[i] < -GLINT_LAMP_FAR)
            return true;
    return false;
}

enum glint_err glint_lamp_check(const struct glint_lamp *lamp)
{
    const int32_t one = (int32_t)GLINT_T_ONE;
    if (lamp->kind == GLINT_DIRECTIONAL)
        return GLINT_OK;
    if (lamp->kind > GLINT_SPOT || is_far(lamp->position) || lamp->range < 1 || lamp->range > (uint32_t)GLINT_LAMP_FAR)
        return GLINT_ERR_ARG;
    if (lamp->kind == GLINT_SPOT &&
        (lamp->cos_outer_q30 < -one || lamp->cos_outer_q30 > lamp->cos_inner_q30 || lamp->cos_inner_q30 > one))
        return GLINT_ERR_ARG;
    return GLINT_OK;
}

static struct glint_lamp white(enum glint_lamp_kind kind)
{
    const struct glint_lamp lamp = {
        (uint8_t)kind, {65536, 65536, 65536}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {0, 0, 0}, 0, {0, 0, 0}, 0, 0};
    return lamp;
}

enum glint_err glint_lamp_directional(struct glint_lamp *lamp, const int32_t to_light[3], const int32_t to_viewer[3])
{
    if (!lamp)
        return GLINT_ERR_ARG;
    struct glint_light light;
    const enum glint_err err = glint_light_init(&light, to_light, to_viewer);
    if (err)
        return err;
    *lamp = white(GLINT_DIRECTIONAL);
    lamp->light = light;
    return GLINT_OK;
}

static void place(struct glint_lamp *lamp, const int32_t position[3], uint32_t range)
{
    for (int i = 0; i < 3; i++)
        lamp->position[i] = position[i];
    lamp->range = range;
}

enum glint_err glint_lamp_point(struct glint_lamp *lamp, const int32_t position[3], uint32_t range)
{
    if (!lamp || !position)
        return GLINT_ERR_ARG;
    struct glint_lamp point = white(GLINT_POINT);
    place(&point, position, range);
    const enum glint_err err = glint_lamp_check(&point);
    if (err == GLINT_OK)
        *lamp = point;
    return err;
}

enum glint_err glint_lamp_spot(struct glint_lamp *lamp, const int32_t position[3], const int32_t target[3],
                               uint32_t range, int32_t cos_inner_q30, int32_t cos_outer_q30)
{
    if (!lamp || !position || !target || is_far(target))
        return GLINT_ERR_ARG;
    struct glint_lamp spot = white(GLINT_SPOT);
    place(&spot, position, range);
    spot.cos_inner_q30 = cos_inner_q30;
    spot.cos_outer_q30 = cos_outer_q30;
    const enum glint_err err = glint_lamp_check(&spot);
    if (err)
        return err;
    const int32_t axis[3] = {target[0] - position[0], position[1] - target[1], target[2] - position[2]};
    if (!glint_unit_q30(spot.axis_q30, axis))
        return GLINT_ERR_VECTOR;
    *lamp = spot;
    return GLINT_OK;
}
