/* SPDX-License-Identifier: MIT */
#include "base/json.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"

json_t *json_text(const char *text)
{
    char *copy = copied(text);
    json_t *json = json_string(text_clean(copy, true));
    free(copy);
    return json;
}
