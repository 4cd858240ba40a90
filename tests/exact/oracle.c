/* SPDX-License-Identifier: MIT */
#include "oracle.h"

/* ---- for any model ---- */

#define ORACLE(number, name, function, use, grain) &function##_oracle,
const struct oracle *const oracles[GLINT_MODEL_COUNT] = {GLINT_MODELS(ORACLE)};

void oracle_printed(mpq_t f, enum glint_model model, uint32_t n, uint32_t u)
{
    mpq_t c;
    mpq_init(c);
    mpq_set_ui(c, u, ORACLE_ONE_U);
    mpq_canonicalize(c);
    oracles[model]->printed(f, n, c);
    mpq_clear(c);
}

bool oracle_reaches(enum glint_model model, uint32_t n, uint32_t u, unsigned q)
{
    if (oracles[model]->reaches)
        return oracles[model]->reaches(n, u, q);
    mpq_t f;
    mpq_init(f);
    oracle_printed(f, model, n, u);
    const bool reached = mpq_cmp_ui(f, 1, 1UL << q) >= 0;
    mpq_clear(f);
    return reached;
}

/* ---- for oracles ---- */

void oracle_fall(mpq_t f, uint32_t n, const mpq_t c)
{
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    mpq_sub(one, one, c);
    mpq_set_ui(f, n, 1);
    mpq_mul(f, f, one);
    mpq_clear(one);
}

void oracle_fourth_power(mpq_t f)
{
    if (mpq_sgn(f) < 0)
        mpq_set_ui(f, 0, 1);
    mpq_mul(f, f, f);
    mpq_mul(f, f, f);
}

/* ---- chains ---- */

static u128 mulhi(u128 a, u128 b)
{
    const uint64_t a0 = (uint64_t)a, a1 = (uint64_t)(a >> 64), b0 = (uint64_t)b, b1 = (uint64_t)(b >> 64);
    const u128 m1 = (u128)a1 * b0 + ((u128)a0 * b0 >> 64);
    const u128 m2 = (u128)a0 * b1 + (uint64_t)m1;
    return (u128)a1 * b1 + (m1 >> 64) + (m2 >> 64);
}

void oracle_chain_next(struct oracle_chain *chain)
{
    chain->power = mulhi(chain->power, chain->base);
    chain->n++;
    chain->below += 4; /* err(xy) <= err(x) + err(y) + 1 */
}

bool oracle_chain_rounds_to(const struct oracle_chain *chain, uint32_t f)
{
    const u128 half = (u128)1 << 111;
    const uint32_t low = (uint32_t)(((chain->power >> 111) + 1) >> 1);
    const u128 fraction = (chain->power + half) & (2 * half - 1);
    return low == f && fraction < 2 * half - chain->below;
}

bool oracle_chain_is_near(const struct oracle_chain *chain, uint32_t f)
{
    const u128 limit = (((u128)1 << 112) / 1000) * 501;
    if (f == 65536)
        return -chain->power <= limit; /* 1 - power, modulo 1 */
    const u128 value = (u128)f << 112, power = chain->power;
    return (value > power ? value - power : power - value) <= limit - chain->below;
}
