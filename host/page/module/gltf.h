/* SPDX-License-Identifier: MIT
 * What src/gltf.ts makes of a glTF: doubles, and after them the pictures' pixels. */
#ifndef GLINT_PAGE_GLTF_H
#define GLINT_PAGE_GLTF_H

#include "mesh/soup.h"

bool gltf_is(const uint8_t *bytes, size_t len);
/* Which gltf_is accepts; aligned. */
struct soup *gltf_soup(const char *name, const double *numbers, bool textures);

#endif
