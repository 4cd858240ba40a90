/* SPDX-License-Identifier: MIT
 * What Frama-C's Eva runs: each function of the library with every argument that its declaration allows, and those it clamps. */
#include "glint.h"

volatile uint32_t any;
volatile int32_t any_signed;

#define MODEL(name)                                                                                                    \
    uint32_t eva_##name(void)                                                                                          \
    {                                                                                                                  \
        return glint_##name(any, any_signed);                                                                          \
    }                                                                                                                  \
    uint32_t eva_##name##_t(void)                                                                                      \
    {                                                                                                                  \
        return glint_##name##_t(any, any);                                                                             \
    }                                                                                                                  \
    uint32_t eva_##name##_cutoff(void)                                                                                 \
    {                                                                                                                  \
        return glint_##name##_cutoff(any, any);                                                                        \
    }                                                                                                                  \
    uint32_t eva_##name##_cutoff_t(void)                                                                               \
    {                                                                                                                  \
        return glint_##name##_cutoff_t(any, any);                                                                      \
    }
MODEL(msh)
MODEL(schlick)
MODEL(blinn)
MODEL(gauss)
MODEL(cayley)
MODEL(lyon)

static struct glint_vec vector(void)
{
    const struct glint_vec v = {(int16_t)any, (int16_t)any, (int16_t)any};
    return v;
}

enum glint_err eva_span_init(void)
{
    const struct glint_light light = {vector(), vector(), vector()};
    const struct glint_vec first = vector(), last = vector();
    struct glint_span span;
    return glint_span_init(&span, &light, &first, &last, (uint16_t)any);
}

uint32_t eva_normals_pack(void)
{
    const struct glint_vec v = vector();
    return glint_normals_pack((enum glint_normals)any, &v);
}

int eva_normals_unpack(void)
{
    const struct glint_vec v = glint_normals_unpack((enum glint_normals)any, any);
    return v.x + v.y + v.z;
}

uint16_t eva_srgb_decode(void)
{
    return glint_srgb_decode((uint8_t)any);
}

uint16_t eva_srgb_encode(void)
{
    return glint_srgb_encode((uint16_t)any);
}

enum glint_err eva_lamp_point(void)
{
    const int32_t at[3] = {any_signed, any_signed, any_signed};
    struct glint_lamp lamp;
    return glint_lamp_point(&lamp, at, any);
}
