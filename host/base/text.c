/* SPDX-License-Identifier: MIT */
#include "base/text.h"

#include <stdint.h>
#include <string.h>

/* The bytes of the UTF-8 character at `text`, and its code; 0: it is none. The shortest form only, no surrogates. */
static size_t character(const unsigned char *text, uint32_t *code)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const size_t length = *text < 0x80 ? 1 : *text >> 5 == 6 ? 2 : *text >> 4 == 14 ? 3 : *text >> 3 == 30 ? 4 : 0;
    *code = length < 2 ? *text : *text & (0x7Fu >> length);
    for (size_t i = 1; i < length; i++) {
        if ((text[i] & 0xC0) != 0x80) /* also at the end of the text */
            return 0;
        *code = *code << 6 | (text[i] & 0x3F);
    }
    const bool good = length && *code >= least[length] && *code <= 0x10FFFF && (*code < 0xD800 || *code > 0xDFFF);
    return good ? length : 0;
}

/* The next character, which may be a '?' in the place of one; returns its bytes. */
static size_t next(const char **at, bool keeps_c0, char out[4])
{
    uint32_t code;
    const size_t length = character((const unsigned char *)*at, &code);
    const bool control = code < ' ' ? !keeps_c0 : code >= 0x7F && code < 0xA0;
    const bool good = length && !control;
    memcpy(out, good ? *at : "?", good ? length : 1);
    *at += length ? length : 1;
    return good ? length : 1;
}

char *text_clean(char *text, bool keeps_c0)
{
    char *to = text;
    for (const char *at = text; *at;) {
        char piece[4];
        const size_t length = next(&at, keeps_c0, piece);
        memcpy(to, piece, length); /* never more than was read */
        to += length;
    }
    *to = '\0';
    return text;
}

void text_print(FILE *stream, const char *text)
{
    while (*text) {
        char piece[4];
        const size_t length = next(&text, false, piece);
        fwrite(piece, 1, length, stream);
    }
}
