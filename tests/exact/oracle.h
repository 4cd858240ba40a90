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

/* base^1, base^2, ... in Q0.128, each low by less than `below` units, for base = c (Blinn) or exp(-acos(c)^2 / 2). */
struct oracle_chain {
    u128 base, power;
    uint32_t n, below;
};
void oracle_chain_next(struct oracle_chain *chain);
/* Is f the rounding of the chain's power? Undecided (never yet seen) counts as wrong, but for exact powers of two. */
bool oracle_chain_rounds_to(const struct oracle_chain *chain, uint32_t f);
/* Is f within .501 ulp of it? */
bool oracle_chain_is_near(const struct oracle_chain *chain, uint32_t f);

/* What is known of a model. Argument: c = u / 2^30. */
struct oracle {
    /* Rational in c and n: is f the rounding (nearest, ties up) of 2^16 F? And F itself, as its formula is printed. */
    bool (*rounds_to)(uint32_t n, uint32_t u, uint32_t f);
    void (*printed)(mpq_t f, uint32_t n, const mpq_t c);
    /* Powers of a function of c: n = 1 of a chain, u < 2^30. Is F >= 2^-q? Exactly, or with a margin that is asserted. */
    void (*chain)(struct oracle_chain *chain, uint32_t u);
    bool (*reaches)(uint32_t n, uint32_t u, unsigned q);
};
/* For each model with functions of its own a NAME_oracle, in oracle_NAME.c. By enum glint_model: */
#define ORACLE_DECLARED(number, name, function, use, grain) extern const struct oracle function##_oracle;
GLINT_MODELS(ORACLE_DECLARED)
extern const struct oracle *const oracles[GLINT_MODEL_COUNT];

/* c = u / 2^30; and F of a rational model. */
void oracle_printed(mpq_t f, enum glint_model model, uint32_t n, uint32_t u);
/* Is F(model, n, c = u / 2^30) >= 2^-q? */
bool oracle_reaches(enum glint_model model, uint32_t n, uint32_t u, unsigned q);

/* ---- for oracles ---- */

#define ORACLE_ONE_U ((uint64_t)1 << 30)
/* num / den rounds to f: (2f - 1) den <= 2 num < (2f + 1) den. */
static inline bool oracle_rounds(u128 num, u128 den, uint32_t f)
{
    return 2 * num + den >= 2 * (u128)f * den && 2 * num < (2 * (u128)f + 1) * den;
}
void oracle_fall(mpq_t f, uint32_t n, const mpq_t c); /* n (1 - c) */
void oracle_fourth_power(mpq_t f);                    /* max(0, f)^4, in place */

#endif
