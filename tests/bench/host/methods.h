/* SPDX-License-Identifier: MIT
 * What is measured on the host: ways to shade an array of cosines. */
#ifndef GLINT_BENCH_METHODS_H
#define GLINT_BENCH_METHODS_H

#include <stddef.h>
#include <stdint.h>

/* Arguments and results are int32_t Q16.16, or float for the methods in float. */
typedef void method(uint32_t n, const void *restrict in, void *restrict out, size_t count);

method float_msh, float_schlick;                    /* floats.c */
method float_blinn;                                 /* powf.c */
method fixmath_msh, fixmath_schlick, fixmath_blinn; /* fixmath.c */

#endif
