/* SPDX-License-Identifier: MIT */
#include "glint_loops_check.h"
#include "glint_math_align.h"
#include "glint_tables_normals.h"

enum glint_err glint_tables_check(const struct glint_tables *tables, const struct glint_tables_light *light,
                                  enum glint_normals format, const void *normals, ptrdiff_t stride,
                                  const struct glint_surface *surface)
{
    if (!tables || !light || !normals || !surface || !surface->pixels || tables->kind != light->kind ||
        (glint_normals_size(format) == 4 ? GLINT_MISALIGNED(normals, 32) || GLINT_MISALIGNED(stride, 32)
                                         : GLINT_MISALIGNED(normals, 16) || GLINT_MISALIGNED(stride, 16)))
        return GLINT_ERR_ARG;
    if ((unsigned)format > GLINT_NORMALS_INT8)
        return GLINT_ERR_FORMAT;
    return tables->kind != GLINT_TABLES_SMALL && format == GLINT_NORMALS_INT8 && !light->frontal ? GLINT_ERR_VECTOR
                                                                                                 : GLINT_OK;
}
