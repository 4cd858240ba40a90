/* SPDX-License-Identifier: MIT
 * What a lamp adds to the sums of a run of pixels. */
#include "glint_lights.h"
#include "glint_pixel.h"

/* (color att x + 2^31) >> 32; color <= 2^20, att <= 2^16, x <= 67109. Where att x = 2^16 p1 + p0 fits 32 bits, color = 2^16 high + low:
 * s = floor(low att x / 2^16) fits, too, and high p0 < 2^20. */
static inline uint32_t lights_scale(uint32_t color, uint32_t att, uint32_t x)
{
    if (x >> 16)
        return (uint32_t)(((uint64_t)color * att * x + ((uint64_t)1 << 31)) >> 32);
    const uint32_t p = att * x, p1 = p >> 16, p0 = p & 0xffff, high = color >> 16, low = color & 0xffff;
    if (color == 65536)
        return p1 + (p0 >> 15);
    const uint32_t s = low * p1 + (low * p0 >> 16);
    return high * p1 + (s >> 16) + ((high * p0 + (s & 0xffff) + 32768) >> 16);
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
    const struct glint_reach *const reach = &lights->reach[at];
    struct glint_light *const here = &lights->prepared->shader.light;
    struct glint_sight *const sight = &lights->sight;
    const bool phong = lights->prepared->shader.lobe.model == GLINT_PHONG;
    const int32_t *position = lamp->position;
    sight->e[0] = position[0] - 16 * (int32_t)(lights->run.left + lights->run.x + from) - 8;
    sight->e[1] = 16 * (int32_t)lights->run.y + 8 - position[1];
    sight->e[2] = position[2];
    for (const struct glint_sample *end = sample + count; sample != end; sample++, normal++) {
        uint32_t att = glint_reach_near(reach, lamp, sight, here);
        if (att == GLINT_REACH_OPEN)
            att = glint_reach_exact(reach, lamp, sight, here);
        *arriving++ = (uint16_t)(att - 1);
        sight->e[0] -= 16;
        if (!att) {
            sample->t_q30 = UINT32_MAX;
            sample->nl_q16 = 0;
        } else if (phong) {
            lights_geometry(lights, here, normal, sample, 1);
        } else {
            glint_samples_unit(here, normal, sample, 1);
        }
    }
}

/* The last channel first: red's sums may be the samples. */
void glint_lights_add(struct glint_lights *lights, unsigned at, unsigned count, const struct glint_sample *samples)
{
    const uint32_t t_end = lights->prepared->near.t_end;
    for (unsigned k = lights->channels; k-- > 0;) {
        const struct glint_lamp *lamp = &lights->lamps[at];
        const bool folded = lights->prepared->high && lights->channels == 1;
        const uint32_t color = folded ? glint_lights_peak(lamp) : glint_lights_color(lamp, k);
        const uint16_t *arriving = lights->arriving;
        struct glint_sample *sum = lights->slots + k * lights->length;
        const struct glint_sample *sample = samples;
        for (const struct glint_sample *end = sum + count; sum != end; sum++, sample++) {
            const uint32_t att = *arriving++ + UINT32_C(1), nl = sample->nl_q16, f = sample->f_q16;
            struct glint_sample part = {UINT32_MAX, 0, 0};
            if (nl) {
                part.t_q30 = sample->t_q30 < t_end && color ? 0 : UINT32_MAX;
                part.nl_q16 = lights_scale(color, att, nl);
                if (f)
                    part.f_q16 = lights_scale(color, att, f);
            }
            if (at) {
                part.t_q30 &= sum->t_q30;
                part.nl_q16 += sum->nl_q16;
                part.f_q16 += sum->f_q16;
            }
            *sum = part;
        }
    }
}
