/* SPDX-License-Identifier: MIT
 * OBJ as libassimp reads it: it drops a vertex that it does not understand, and all faces after it get others. */
#ifndef GLINT_MESH_IMPORT_OBJ_H
#define GLINT_MESH_IMPORT_OBJ_H

#include <stddef.h>

/* The same OBJ with one spelling of numbers (0.5 for .5, 1 for +1, 5.0 for 5.), of lines (none continued, or with blanks before) and of places in lists
 * (counted from the first). Other lines stay. NULL: `wrong` says what is wrong, as the end of a message. The caller frees it. */
char *import_obj_spelled(const char *text, size_t len, size_t *spelled_len, char wrong[120]);

#endif
