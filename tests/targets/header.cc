/* SPDX-License-Identifier: MIT
 * The header in a C++ program, by the compiler's default standard: all that it defines can be used. */
#include "glint.h"

uint32_t use()
{
    const glint_span span = glint_span();
    return glint_eval(GLINT_MSH, GLINT_N_MAX, GLINT_C_ONE) + glint_eval_t(GLINT_CAYLEY, 60, GLINT_T_ONE) + span.w +
           GLINT_SPAN_MAX + GLINT_Q_MAX;
}
