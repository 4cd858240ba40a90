/* SPDX-License-Identifier: MIT
 * The checks of meshes with colours of their own, textures and grain, under several lights, and with smooth outlines. */
#ifndef CONFORMANCE_PAINTS_H
#define CONFORMANCE_PAINTS_H

#include "conformance.h"

void conform_mesh_albedo(const struct conformance_size *size);
void conform_mesh_textures(const struct conformance_size *size);
void conform_mesh_grain(const struct conformance_size *size);
void conform_mesh_lights(const struct conformance_size *size);
/* By ALBEDO tables, with textures or colours. */
void conform_mesh_by_albedo(const struct conformance_size *size, bool textures);
/* Exact, or by COLOUR and ALBEDO tables. */
void conform_mesh_outlines(const struct conformance_size *size, bool tables);

#endif
