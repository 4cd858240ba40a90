/* SPDX-License-Identifier: MIT
 * The name that was meant. */
#ifndef GLINT_BASE_CLOSEST_H
#define GLINT_BASE_CLOSEST_H

/* The name in the list, which ends with NULL, that `text` misses by a slip of the fingers; NULL: none. */
const char *closest_name(const char *text, const char *const *names);

#endif
