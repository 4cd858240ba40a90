/* SPDX-License-Identifier: MIT */
#include "paper/q16.h"

#include <math.h>

double q16_from_t(enum glint_model model, double n, double x)
{
    const double half = sin(x / 2);
    return glint_eval_t(model, (uint32_t)n, (uint32_t)lround(2 * half * half * GLINT_T_ONE)) / (double)GLINT_C_ONE;
}

double q16_from_c(enum glint_model model, double n, double x)
{
    return glint_eval(model, (uint32_t)n, (int32_t)lround(cos(x) * GLINT_C_ONE)) / (double)GLINT_C_ONE;
}

double q16_cutoff_angle_t(enum glint_model model, double n, unsigned q)
{
    return 2 * asin(sqrt(glint_cutoff_t(model, (uint32_t)n, q) / (2.0 * GLINT_T_ONE)));
}

double q16_cutoff_angle_c(enum glint_model model, double n, unsigned q)
{
    return acos(glint_cutoff(model, (uint32_t)n, q) / (double)GLINT_C_ONE);
}
