/* SPDX-License-Identifier: MIT
 * The built-in mesh. */
#ifndef GLINT_MESH_TEAPOT_DATA_H
#define GLINT_MESH_TEAPOT_DATA_H

#include <stdint.h>

enum { TEAPOT_PLACES = 792, TEAPOT_FACES = 992 };
extern const double teapot_places[TEAPOT_PLACES][3];
extern const uint16_t teapot_faces[TEAPOT_FACES][3];

#endif
