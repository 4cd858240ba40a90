/* SPDX-License-Identifier: MIT
 * Single evaluations: functions that give the highlight of one argument. */
#ifndef GLINT_BENCH_EVALUATIONS_H
#define GLINT_BENCH_EVALUATIONS_H

#include "glint.h"

enum evaluation_takes { TAKES_C, TAKES_T, TAKES_LOBE, TAKES_FLOAT };

struct evaluation {
    const char *name, *what;
    uint32_t (*run)(uint32_t n, uint32_t c_or_t); /* TAKES_C, TAKES_T */
    uint32_t (*run_lobe)(const struct glint_lobe *lobe, uint32_t t_q30);
    float (*run_float)(float n, float c);
    uint8_t takes; /* enum evaluation_takes */
    uint8_t model; /* enum glint_model that it stands for */
};
extern const struct evaluation evaluations[]; /* the last one's name is NULL */
extern struct glint_lobe evaluation_lobe;

/* Before the evaluations of one n. */
void evaluation_begin(uint32_t n);

#endif
