/* SPDX-License-Identifier: MIT
 * Does a text STL have its end? libassimp takes what there is. */
#ifndef GLINT_MESH_STL_CHECK_H
#define GLINT_MESH_STL_CHECK_H

#include <stddef.h>

/* A binary STL has as many bytes as the count after its comment says, or a few behind them, which say nothing. The comment may begin as a text STL does.
 * 0: it is none. */
size_t stl_binary_len(const char *bytes, size_t len);
/* What is wrong, as the end of a message; NULL: nothing that is seen here, and a text is as libassimp reads it: with normals, in small letters, names
 * blank. */
const char *stl_check(char *bytes, size_t len);

#endif
