/* SPDX-License-Identifier: MIT
 * What the drivers of Eva share: values that are not known, and what is said of values from t, which the proofs from t show
 * (test_msh, test_lobes, test_powers) and where a driver asks for it stands for their code. */
#ifndef PROOF_EVA_H
#define PROOF_EVA_H

#include "glint.h"

/*@ assigns \result \from n, t_q30; ensures \result <= 67109; ensures t_q30 == 0 ==> \result >= 65536; */
uint32_t glint_msh_t(uint32_t n, uint32_t t_q30);
/*@ assigns \result \from n, t_q30; ensures \result <= 65536; ensures t_q30 == 0 ==> \result >= 65536; */
uint32_t glint_schlick_t(uint32_t n, uint32_t t_q30);
/*@ assigns \result \from n, t_q30; ensures \result <= 65536; ensures t_q30 == 0 ==> \result >= 65536; */
uint32_t glint_blinn_t(uint32_t n, uint32_t t_q30);
/*@ assigns \result \from n, t_q30; ensures \result <= 65536; ensures t_q30 == 0 ==> \result >= 65536; */
uint32_t glint_gauss_t(uint32_t n, uint32_t t_q30);
/*@ assigns \result \from n, t_q30; ensures \result <= 65536; ensures t_q30 == 0 ==> \result >= 65536; */
uint32_t glint_cayley_t(uint32_t n, uint32_t t_q30);
/*@ assigns \result \from n, t_q30; ensures \result <= 65536; ensures t_q30 == 0 ==> \result >= 65536; */
uint32_t glint_lyon_t(uint32_t n, uint32_t t_q30);

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

static inline struct glint_light any_light(void)
{
    const struct glint_light light = {any_vector(), any_vector(), any_vector()};
    return light;
}

/* Any but for what Eva follows better one by one. */
static inline struct glint_shader any_shader(uint8_t format, uint8_t space, bool dither)
{
    const struct glint_shader shader = {
        .lobe = {(uint8_t)any, (uint8_t)any, (uint16_t)any, any, any},
        .light = any_light(),
        .material = {{any, any, any}, {any, any, any}, {any, any, any}, {(uint8_t)any, (uint8_t)any, (uint8_t)any}},
        .format = format,
        .space = space,
        .dither = dither,
        .clamp_peak = any & 1};
    return shader;
}

#endif
