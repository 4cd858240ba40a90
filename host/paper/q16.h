/* SPDX-License-Identifier: MIT
 * The library's values at an angle x in radians, as doubles. */
#ifndef GLINT_PAPER_Q16_H
#define GLINT_PAPER_Q16_H

#include "glint.h"

double q16_from_t(enum glint_model model, double n, double x); /* glint_eval_t, t = 2 sin^2(x/2) to the nearest 2^-30 */
double q16_from_c(enum glint_model model, double n, double x); /* glint_eval, c to the nearest 2^-16 */
double q16_cutoff_angle_t(enum glint_model model, double n, unsigned q);
double q16_cutoff_angle_c(enum glint_model model, double n, unsigned q);

#endif
