/* SPDX-License-Identifier: MIT
 * Polygons as triangles. */
#ifndef GLINT_MESH_POLYGON_H
#define GLINT_MESH_POLYGON_H

#include <stdbool.h>
#include <stddef.h>

/* count - 2 triangles, each three of the places' numbers, in the polygon's sense; count: at least 3. A polygon may have dents; where it is not flat it
 * is seen from where most of it faces. False: it has so many corners and dents that this would take seconds. */
bool polygon_cut(const double (*places)[3], size_t count, size_t (*triangles)[3]);

#endif
