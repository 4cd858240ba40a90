/* SPDX-License-Identifier: MIT
 * In the place of glint_msh, by the linker's --wrap: off by one at one argument. */
#include "glint.h"

uint32_t __real_glint_msh(uint32_t n, int32_t c_q16);
uint32_t __wrap_glint_msh(uint32_t n, int32_t c_q16);

uint32_t __wrap_glint_msh(uint32_t n, int32_t c_q16)
{
    return __real_glint_msh(n, c_q16) + (n == 317 && c_q16 == 65000);
}
