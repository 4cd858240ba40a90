/* SPDX-License-Identifier: MIT
 * Internal. */
#ifndef GLINT_LOOPS_SPAN_ANY_H
#define GLINT_LOOPS_SPAN_ANY_H

#include "glint.h"

/* glint_tables_span for whatever its fast form leaves: errors, SMALL tables, pixels at an odd address. */
enum glint_err glint_span_any(const struct glint_tables *tables, const struct glint_span *span,
                              const struct glint_surface *surface);

#endif
