/* SPDX-License-Identifier: MIT
 * Internal. */
#ifndef GLINT_LOOPS_CHECK_H
#define GLINT_LOOPS_CHECK_H

#include "glint.h"

/* What every rectangle over tables refuses: GLINT_OK, or its error. */
enum glint_err glint_tables_check(const struct glint_tables *tables, const struct glint_tables_light *light,
                                  enum glint_normals format, const void *normals, ptrdiff_t stride,
                                  const struct glint_surface *surface);

#endif
