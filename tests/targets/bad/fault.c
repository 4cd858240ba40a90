/* SPDX-License-Identifier: MIT
 * In the place of glint_msh, by the linker's --wrap: an undefined instruction. */
#include "glint.h"

uint32_t __wrap_glint_msh(uint32_t n, int32_t c_q16);

uint32_t __wrap_glint_msh(uint32_t n, int32_t c_q16)
{
    (void)n;
    (void)c_q16;
    __builtin_trap();
}
