/* SPDX-License-Identifier: MIT
 * Checks of the functions of the cosine, and of sRGB's. */
#ifndef CONFORMANCE_LOBES_H
#define CONFORMANCE_LOBES_H

#include "conformance.h"

void conform_model(unsigned check, const struct conformance_size *size);
void conform_lobes(const struct conformance_size *size);
void conform_every_c(unsigned check);
void conform_srgb(const struct conformance_size *size);

#endif
