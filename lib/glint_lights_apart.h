/* SPDX-License-Identifier: MIT
 * Internal. Levels of pixels whose channels have samples of their own, as coloured lamps leave them. */
#ifndef GLINT_LIGHTS_APART_H
#define GLINT_LIGHTS_APART_H

#include "glint_pixel_prepared.h"

/* As the levels of every format in gamma space; a channel's samples begin prepared->apart after those of the channel before. */
uint32_t glint_apart_levels(const struct glint_prepared *prepared, const struct glint_run *run,
                            const struct glint_sample *samples, unsigned count);

#endif
