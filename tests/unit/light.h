/* SPDX-License-Identifier: MIT
 * A material as light_protocol.h sends it, for tests of its two sides; and when two are the same. */
#ifndef LIGHT_H
#define LIGHT_H

#include "light_protocol.h"
#include "unit.h"

static const struct light_material material = {
    .material = {GLINT_MSH, 6, 60, 0, {1, 2, 3}, {40000, 50000, 60000}, {65536, 7, 8}, {9, 10, 11}, true},
    .space = GLINT_LINEAR,
    .background = 0xabcd};

/* Member by member: what stands in the padding is nobody's. */
static inline void assert_same(const struct glint_material *a, const struct glint_material *b)
{
    assert_int_equal(a->model, b->model);
    assert_int_equal(a->q, b->q);
    assert_int_equal(a->n, b->n);
    assert_int_equal(a->clamp_peak, b->clamp_peak);
    assert_memory_equal(a->albedo, b->albedo, sizeof a->albedo);
    assert_memory_equal(a->ambient_q16, b->ambient_q16, sizeof a->ambient_q16);
    assert_memory_equal(a->diffuse_q16, b->diffuse_q16, sizeof a->diffuse_q16);
    assert_memory_equal(a->specular_q16, b->specular_q16, sizeof a->specular_q16);
}

#endif
