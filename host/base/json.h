/* SPDX-License-Identifier: MIT
 * Texts of devices and users as JSON. */
#ifndef GLINT_BASE_JSON_H
#define GLINT_BASE_JSON_H

#include <jansson.h>

/* Cleaned by text_clean(): JSON is UTF-8, and may be shown on a terminal. */
json_t *json_text(const char *text);

#endif
