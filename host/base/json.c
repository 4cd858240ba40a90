/* SPDX-License-Identifier: MIT */
#include "base/json.h"

#include <stdlib.h>
#include <string.h>

#include "base/message.h"

json_t *json_text(const char *text)
{
    json_t *json = json_string(text);
    if (json)
        return json;
    char *copy = strdup(text);
    if (!copy)
        fail("out of memory");
    for (char *at = copy; *at; at++)
        if (*at & 0x80)
            *at = '?';
    json = json_string(copy);
    free(copy);
    return json;
}
