/* SPDX-License-Identifier: MIT
 * The pixel's sequence as glint.h writes it, step by step in 64 bits: what every fast path of the library must equal. */
#ifndef GLINT_EXACT_REFERENCE_PIXEL_H
#define GLINT_EXACT_REFERENCE_PIXEL_H

#include "glint.h"

/* As glint_shade_rect, without its checks. */
void reference_rect(const struct glint_shader *shader, const struct glint_source *source, uint16_t w, uint16_t h,
                    const struct glint_surface *surface, struct glint_box *highlight);
/* As glint_shade_span, without its checks. */
void reference_span(const struct glint_shader *shader, const struct glint_span *span,
                    const struct glint_surface *surface, struct glint_box *highlight);

#endif
