/* SPDX-License-Identifier: MIT
 * Texts of devices and users as JSON. */
#ifndef GLINT_BASE_JSON_H
#define GLINT_BASE_JSON_H

#include <jansson.h>

/* JSON is UTF-8: where the text is not, '?' replaces its bytes. */
json_t *json_text(const char *text);

#endif
