/* SPDX-License-Identifier: MIT
 * The bounds of the quick forms in lib/lobe_*.c, checked over all or a part of their domains: every `step`-th argument, or
 * `per_n` random t for each n. Each prints what it met beside what is stated, and asserts. */
#ifndef GLINT_TEST_NEAR_H
#define GLINT_TEST_NEAR_H

#include <stdint.h>

void check_products(uint32_t step);       /* glint_mulhi_near, glint_squarehi_near, glint_multiply */
void check_reciprocal(uint32_t step);     /* of every mantissa */
void check_gauss_exponent(uint32_t step); /* of every t */
void check_exp2(uint32_t step);           /* of every x */
void check_power(uint32_t per_n);
void check_cayley(uint32_t per_n);
void check_schlick(uint32_t per_n);
void check_gauss(uint32_t per_n);
void check_ggx(uint32_t per_n);
void check_sg(uint32_t per_n);

/* The same values as the simple forms, which the quick ones stand before; prints how often they fall back. */
void check_values(uint32_t per_n);

#endif
