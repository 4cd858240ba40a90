/* SPDX-License-Identifier: MIT
 * Texts of users and devices, made safe for a terminal. */
#ifndef GLINT_BASE_TEXT_H
#define GLINT_BASE_TEXT_H

#include <stdbool.h>
#include <stdio.h>

/* In place: bytes that are not UTF-8 and control characters (C0, DEL, C1) become '?'. JSON escapes C0 itself: there
 * `keeps_c0`. */
char *text_clean(char *text, bool keeps_c0);
/* Prints the text so. */
void text_print(FILE *stream, const char *text);

#endif
