/* SPDX-License-Identifier: MIT
 * Where in a frame the bytes of its LZ4 form lie: what a part of it would take, before compressing it. */
#ifndef GLINT_PLAN_DENSITY_H
#define GLINT_PLAN_DENSITY_H

#include "sinks/sink.h"

struct density;
struct density *density_new(unsigned width, unsigned height);
void density_free(struct density *density);
void density_measure(struct density *density, const struct piece *pieces, size_t count); /* of a whole frame */
double density_bytes(const struct density *density, const struct glint_box *box);

#endif
