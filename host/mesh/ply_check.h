/* SPDX-License-Identifier: MIT
 * Does a PLY hold what its header promises? libassimp reads beyond the end of one that does not, or fills up what is missing;
 * of a text it reads a line for each vertex and each face. */
#ifndef GLINT_MESH_PLY_CHECK_H
#define GLINT_MESH_PLY_CHECK_H

#include <stdbool.h>
#include <stddef.h>

/* What is wrong, as the end of a message; NULL: nothing that is seen here, and in the text comments are blanks, among which libassimp loses properties,
 * and elements that it does not know are gone; *len is how long it is then. So are places in a picture that each face has for its own corners, of which
 * libassimp takes one a vertex: *has_corner_uv. */
const char *ply_check(char *text, size_t *len, bool *has_corner_uv);

#endif
