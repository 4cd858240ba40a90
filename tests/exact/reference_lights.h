/* SPDX-License-Identifier: MIT
 * Any source by the exact paint under any lights, as sequence.md has it, in 64 bits. */
#ifndef REFERENCE_LIGHTS_H
#define REFERENCE_LIGHTS_H

#include "reference_pixel.h"

enum reference_kind { REFERENCE_DIRECTIONAL, REFERENCE_POINT, REFERENCE_SPOT };
enum reference_kind reference_kind(const struct glint_light *light);

/* L, V, H of a directional light; false where it is straight behind, or there is no viewer. */
bool reference_directions(const struct reference *look, const struct glint_light *light, struct glint_vec lvh[3]);

/* The library's paint, lit: what that says. */
enum glint_err reference_paint(struct glint_paint *paint, const struct reference *look);

/* As glint_draw_rect and glint_draw_span, of good arguments only; highlight may be NULL. */
void reference_rect(const struct reference *look, const struct glint_maps *maps, uint16_t w, uint16_t h,
                    const struct glint_surface *target, struct glint_box *highlight);
void reference_span(const struct reference *look, const struct glint_span *span, const struct glint_maps *maps,
                    const struct glint_surface *target, struct glint_box *highlight);

#endif
