/* SPDX-License-Identifier: MIT
 * The functions that take the model as an argument; they link every model. */
#include "glint.h"

uint32_t glint_eval(enum glint_model model, uint32_t n, int32_t c_q16)
{
    switch (model) {
    case GLINT_MSH:
        return glint_msh(n, c_q16);
    case GLINT_SCHLICK:
        return glint_schlick(n, c_q16);
    case GLINT_BLINN:
    case GLINT_PHONG:
        return glint_blinn(n, c_q16);
    case GLINT_GAUSS:
        return glint_gauss(n, c_q16);
    case GLINT_CAYLEY:
        return glint_cayley(n, c_q16);
    }
    return 0;
}

uint32_t glint_eval_t(enum glint_model model, uint32_t n, uint32_t t_q30)
{
    switch (model) {
    case GLINT_MSH:
        return glint_msh_t(n, t_q30);
    case GLINT_SCHLICK:
        return glint_schlick_t(n, t_q30);
    case GLINT_BLINN:
    case GLINT_PHONG:
        return glint_blinn_t(n, t_q30);
    case GLINT_GAUSS:
        return glint_gauss_t(n, t_q30);
    case GLINT_CAYLEY:
        return glint_cayley_t(n, t_q30);
    }
    return 0;
}

uint32_t glint_cutoff(enum glint_model model, uint32_t n, unsigned q)
{
    switch (model) {
    case GLINT_MSH:
        return glint_msh_cutoff(n, q);
    case GLINT_SCHLICK:
        return glint_schlick_cutoff(n, q);
    case GLINT_BLINN:
    case GLINT_PHONG:
        return glint_blinn_cutoff(n, q);
    case GLINT_GAUSS:
        return glint_gauss_cutoff(n, q);
    case GLINT_CAYLEY:
        return glint_cayley_cutoff(n, q);
    }
    return 0;
}

uint32_t glint_cutoff_t(enum glint_model model, uint32_t n, unsigned q)
{
    switch (model) {
    case GLINT_MSH:
        return glint_msh_cutoff_t(n, q);
    case GLINT_SCHLICK:
        return glint_schlick_cutoff_t(n, q);
    case GLINT_BLINN:
    case GLINT_PHONG:
        return glint_blinn_cutoff_t(n, q);
    case GLINT_GAUSS:
        return glint_gauss_cutoff_t(n, q);
    case GLINT_CAYLEY:
        return glint_cayley_cutoff_t(n, q);
    }
    return 0;
}
