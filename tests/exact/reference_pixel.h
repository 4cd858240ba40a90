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

/* Its parts: a rectangle that is begun with its first three fields; the normal of a pixel, NULL where the mask has 0; steps 2 and 3;
 * steps 4 to 8, of what several lights may sum to. */
struct reference_rect {
    const struct glint_shader *shader;
    const struct glint_source *source;
    const struct glint_surface *surface;
    struct glint_box box; /* what shines so far */
    uint32_t right;
};
const struct glint_vec *reference_at(const struct reference_rect *rect, uint32_t x, uint32_t y);
uint32_t reference_nl(struct glint_vec normal, const struct glint_light *light);
uint32_t reference_f(const struct glint_shader *shader, struct glint_vec normal, const struct glint_light *light);
void reference_put(struct reference_rect *rect, uint32_t x, uint32_t y, const uint64_t lit[3], const uint64_t shine[3]);

#endif
