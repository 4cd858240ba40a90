/* SPDX-License-Identifier: MIT
 * What a lamp adds to the sums of a run of pixels. */
#include "glint_lights.h"
#include "glint_math_multiply.h"
#include "glint_pixel.h"

/* (color att x + 2^31) >> 32; color <= 2^20, att <= 2^16, x <= 67109 */
static GLINT_LIGHTS_ALONE uint32_t lights_scale(uint32_t color, uint32_t att, uint32_t x)
{
    if (x >> 16)
        return (uint32_t)(((uint64_t)color * att * x + ((uint64_t)1 << 31)) >> 32);
    const uint32_t product = att * x;
    if (color == 65536)
        return (product >> 16) + (product >> 15 & 1);
    return (uint32_t)((glint_multiply(color, product) + ((uint64_t)1 << 31)) >> 32);
}

/* Steps 1 and 2 for count pixels. */
static void lights_geometry(const struct glint_lights *lights, const struct glint_light *light,
                            const struct glint_vec *normal, struct glint_sample *sample, unsigned count)
{
    if (glint_light_is_wide(light))
        glint_samples_wide(light, normal, sample, count);
    else
        glint_samples_unit(light, normal, sample, count);
    if (lights->prepared->shader.lobe.model == GLINT_PHONG)
        for (const struct glint_sample *end = sample + count; sample != end; sample++, normal++)
            if (sample->nl_q16)
                sample->t_q30 = glint_phong_t(normal, light);
}

/* Of a lamp that has a place, at the pixel that is e away, like glint_reach_near. */
static inline uint32_t lights_reach(struct glint_lights *lights, unsigned at)
{
    const struct glint_lamp *lamp = &lights->lamps[at];
    struct glint_light *here = &lights->prepared->shader.light;
    const uint32_t att = glint_reach_near(&lights->reach[at], lamp, &lights->sight, here);
    return att != GLINT_REACH_OPEN ? att : glint_reach_exact(&lights->reach[at], lamp, &lights->sight, here);
}

void glint_lights_sample(struct glint_lights *lights, unsigned at, unsigned from, unsigned count,
                         struct glint_sample *sample)
{
    const struct glint_lamp *lamp = &lights->lamps[at];
    const struct glint_vec *normal = lights->normals + from;
    uint16_t *arriving = lights->arriving;
    if (lamp->kind == GLINT_DIRECTIONAL) {
        lights_geometry(lights, &lamp->light, normal, sample, count);
        while (count--)
            *arriving++ = UINT16_MAX;
        return;
    }
    struct glint_sight *const sight = &lights->sight;
    const int32_t *position = lamp->position;
    sight->e[0] = position[0] - 16 * (int32_t)(lights->run.left + lights->run.x + from) - 8;
    sight->e[1] = 16 * (int32_t)lights->run.y + 8 - position[1];
    sight->e[2] = position[2];
    for (const struct glint_sample *end = sample + count; sample != end; sample++, normal++) {
        const uint32_t att = lights_reach(lights, at);
        *arriving++ = (uint16_t)(att - 1);
        sample->t_q30 = UINT32_MAX;
        sample->nl_q16 = 0;
        if (att)
            lights_geometry(lights, &lights->prepared->shader.light, normal, sample, 1);
        sight->e[0] -= 16;
    }
}

/* The last channel first: red's sums may be the samples. */
void glint_lights_add(struct glint_lights *lights, unsigned at, unsigned count, const struct glint_sample *sample)
{
    const struct glint_lamp *lamp = &lights->lamps[at];
    const uint32_t t_end = lights->prepared->near.t_end;
    const uint16_t *arriving = lights->arriving;
    struct glint_sample *sum = lights->slots;
    for (const struct glint_sample *end = sample + count; sample != end; sample++, sum++) {
        const uint32_t att = *arriving++ + UINT32_C(1), nl = sample->nl_q16, f = sample->f_q16;
        const bool shines = sample->t_q30 < t_end;
        struct glint_sample *to = sum + lights->channels * lights->length;
        for (unsigned k = lights->channels; k-- > 0;) {
            const uint32_t color = glint_lights_color(lamp, k);
            struct glint_sample part = {UINT32_MAX, 0, 0};
            to -= lights->length;
            if (nl)
                part.nl_q16 = lights_scale(color, att, nl);
            if (f)
                part.f_q16 = lights_scale(color, att, f);
            if (shines && color)
                part.t_q30 = 0;
            if (at) {
                part.t_q30 &= to->t_q30;
                part.nl_q16 += to->nl_q16;
                part.f_q16 += to->f_q16;
            }
            *to = part;
        }
    }
}
