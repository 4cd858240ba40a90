/* SPDX-License-Identifier: MIT */
#include "words.h"

#include <string.h>

#include "base/message.h"

void words_split(struct words *words, char *text, size_t bytes)
{
    words->count = 0;
    for (char *at = text; at < text + bytes; at += strlen(at) + 1) {
        if (words->count == WORDS_MAX)
            fail("more than %d words", WORDS_MAX);
        words->list[words->count++] = at;
    }
    words->list[words->count] = NULL;
}
