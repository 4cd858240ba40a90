/* SPDX-License-Identifier: MIT
 * The checks of meshes. */
#ifndef CONFORMANCE_MESHES_H
#define CONFORMANCE_MESHES_H

#include "conformance.h"

/* Exact, or by COLOUR tables. */
void conform_meshes(const struct conformance_size *size, bool tables);

#endif
