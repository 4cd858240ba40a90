/* SPDX-License-Identifier: MIT
 * The formulas as one writes them with libfixmath, Q16.16. */
#include "peers.h"

#include <libfixmath/fix16.h>

uint32_t peer_msh_fixmath(uint32_t n, uint32_t c_q16)
{
    const fix16_t c = (fix16_t)c_q16, d = (fix16_t)n * (fix16_one - c) + c + (c >> 2);
    return (uint32_t)fix16_div(fix16_mul(fix16_div(c, d), F16(1.6)), d);
}

uint32_t peer_schlick_fixmath(uint32_t n, uint32_t c_q16)
{
    const fix16_t c = (fix16_t)c_q16;
    return (uint32_t)fix16_div(c, (fix16_t)n * (fix16_one - c) + c);
}

uint32_t peer_blinn_fixmath(uint32_t n, uint32_t c_q16)
{
    const fix16_t c = (fix16_t)c_q16;
    return (uint32_t)(c > 0 ? fix16_exp((fix16_t)n * fix16_log(c)) : 0);
}
