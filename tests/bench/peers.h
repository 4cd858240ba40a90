/* SPDX-License-Identifier: MIT
 * What people use today: float formulas as a shader would have them, a table of powers, libfixmath. */
#ifndef GLINT_BENCH_PEERS_H
#define GLINT_BENCH_PEERS_H

#include <stdint.h>

float peer_blinn_powf(float n, float c);
float peer_schlick_float(float n, float c);
float peer_msh_float(float n, float c);

void peer_table_fill(uint32_t n);
uint32_t peer_table(uint32_t n, uint32_t c_q16);

uint32_t peer_blinn_fixmath(uint32_t n, uint32_t c_q16); /* fixmath.c */
uint32_t peer_schlick_fixmath(uint32_t n, uint32_t c_q16);
uint32_t peer_msh_fixmath(uint32_t n, uint32_t c_q16);

#endif
