/* SPDX-License-Identifier: MIT
 * The checks of meshes with colours of their own, under several lights, and with smooth outlines. */
#ifndef CONFORMANCE_PAINTS_H
#define CONFORMANCE_PAINTS_H

#include "conformance.h"

/* Exact, or by ALBEDO tables. */
void conform_mesh_albedo(const struct conformance_size *size, bool tables);
void conform_mesh_lights(const struct conformance_size *size);
/* Exact, or by COLOUR and ALBEDO tables. */
void conform_mesh_outlines(const struct conformance_size *size, bool tables);

#endif
