/* SPDX-License-Identifier: MIT
 * glint_shade_lights as sequence.md has it, in 64 bits. */
#ifndef REFERENCE_LIGHTS_H
#define REFERENCE_LIGHTS_H

#include "glint.h"

/* x / |x|; false where it does not exist. |v| < 2^62. */
bool reference_unit(int64_t out[3], const int64_t v[3]);

/* Good arguments only; highlight may be NULL. */
void reference_lights(const struct glint_shader *shader, const struct glint_lamp *lamps, unsigned count,
                      const struct glint_source *source, uint16_t w, uint16_t h, const struct glint_surface *surface,
                      struct glint_box *highlight);

#endif
