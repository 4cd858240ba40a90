/* SPDX-License-Identifier: MIT
 * The check of meshes. */
#ifndef CONFORMANCE_MESHES_H
#define CONFORMANCE_MESHES_H

#include "conformance.h"

void conform_meshes(const struct conformance_size *size);

#endif
