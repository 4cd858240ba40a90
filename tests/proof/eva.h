/* SPDX-License-Identifier: MIT
 * What the drivers of Eva share: values that are not known, and what is said of values from t (eva_values.h, which eva writes for
 * each model), which the proofs from t show (test_msh, test_lobes, test_powers) and where a driver asks for it stands for their code. */
#ifndef PROOF_EVA_H
#define PROOF_EVA_H

#include "eva_values.h"
#include "glint.h"
#include "glint_sample.h"

static volatile uint32_t any;
static volatile int32_t any_signed;

/* Of an array that lies apart from the stack, and so has values. */
#define ANY_BYTES(array)                                                                                               \
    for (unsigned any_i = 0; any_i < sizeof(array); any_i++)                                                           \
    ((uint8_t *)(array))[any_i] = (uint8_t)any

static inline struct glint_vec any_vector(void)
{
    const struct glint_vec v = {(int16_t)any, (int16_t)any, (int16_t)any};
    return v;
}

static inline struct glint_view any_view(void)
{
    const struct glint_view view = {any_vector(), any_vector(), any_vector()};
    return view;
}

/* A light of any colour, which no kind has made yet. */
static inline struct glint_light any_light(const struct glint_light_kind *kind)
{
    const struct glint_light light = {
        kind,       {any, any, any}, {any_signed, any_signed, any_signed}, {any_signed, any_signed, any_signed}, any,
        any_signed, any_signed};
    return light;
}

/* Any of a model that can be drawn. */
static inline struct glint_material any_material(uint8_t model)
{
    const struct glint_material material = {model,
                                            (uint8_t)any,
                                            (uint16_t)(1 + any % 65535),
                                            0,
                                            {any, any, any},
                                            {any, any, any},
                                            {any, any, any},
                                            {(uint8_t)any, (uint8_t)any, (uint8_t)any},
                                            any & 1};
    return material;
}

#endif
