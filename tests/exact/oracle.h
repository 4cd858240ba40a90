/* SPDX-License-Identifier: MIT
 * The real functions, computed another way than in lib/: 128-bit and GMP integers for the rational models, repeated
 * multiplication by the base for powers and Gauss, whose base comes from MPFR. */
#ifndef GLINT_TEST_ORACLE_H
#define GLINT_TEST_ORACLE_H

#include <stdbool.h>
#include <stdint.h>

#include <gmp.h>
#include <mpfr.h>

#include "glint.h"

typedef unsigned __int128 u128;

/* Is f the rounding (nearest, ties up) of 2^16 F? Argument: c = u / 2^30. */
bool oracle_msh_rounds_to(uint32_t n, uint32_t u, uint32_t f);
bool oracle_schlick_rounds_to(uint32_t n, uint32_t u, uint32_t f);
bool oracle_cayley_rounds_to(uint32_t n, uint32_t u, uint32_t f);

/* base^1, base^2, ... in Q0.128, each low by less than `below` units, for base = c (Blinn) or exp(-acos(c)^2 / 2). */
struct oracle_chain {
    u128 base, power;
    uint32_t n, below;
};
void oracle_chain_blinn(struct oracle_chain *chain, uint32_t u); /* 0 < u < 2^30 */
void oracle_chain_gauss(struct oracle_chain *chain, uint32_t u);
void oracle_chain_next(struct oracle_chain *chain);
/* Is f the rounding of the chain's power? Undecided (never yet seen) counts as wrong, but for exact powers of two. */
bool oracle_chain_rounds_to(const struct oracle_chain *chain, uint32_t f);
/* Is f within .501 ulp of it? */
bool oracle_chain_is_near(const struct oracle_chain *chain, uint32_t f);

/* Is F(model, n, c = u / 2^30) >= 2^-q? Decided exactly, or for Gauss by MPFR with a margin that is asserted. */
bool oracle_reaches(enum glint_model model, uint32_t n, uint32_t u, unsigned q);

#endif
