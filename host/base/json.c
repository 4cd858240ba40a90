/* SPDX-License-Identifier: MIT */
#include "base/json.h"

#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "base/text.h"

json_t *json_text(const char *text)
{
    char *copy = strdup(text);
    if (!copy)
        fail("out of memory");
    json_t *json = json_string(text_clean(copy, true));
    free(copy);
    return json;
}
