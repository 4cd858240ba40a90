/* SPDX-License-Identifier: MIT */
#include "mesh/stl_check.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <strings.h>

enum { HEAD = 84, FACET = 50, BEHIND_MAX = 4096 };
static const char ends[] = "it ends without endsolid: a part is missing; export or fetch it again",
                  empty[] = "it has no facets; export it again";

size_t stl_binary_len(const char *bytes, size_t len)
{
    uint64_t count = 0;
    for (int i = 3; len >= HEAD && i >= 0; i--)
        count = count << 8 | (uint8_t)bytes[HEAD - 4 + i];
    const uint64_t whole = HEAD + FACET * count;
    return len == whole || (len > whole && len - whole <= BEHIND_MAX && count) ? (size_t)whole : 0;
}

struct words {
    char *at, *end, *word;
    size_t len;
};

static bool is_blank(char c)
{
    return c == 0 || isspace((unsigned char)c);
}

static bool next_word(struct words *words)
{
    while (words->at < words->end && is_blank(*words->at))
        words->at++;
    words->word = words->at;
    while (words->at < words->end && !is_blank(*words->at))
        words->at++;
    words->len = (size_t)(words->at - words->word);
    return words->len > 0;
}

static bool is_word(const struct words *words, const char *wanted)
{
    return words->len == strlen(wanted) && strncasecmp(words->word, wanted, words->len) == 0;
}

/* Names stand behind solid and endsolid, to the end of the line. Some crash libassimp. */
static void blank_line(struct words *words)
{
    for (; words->at < words->end && *words->at != '\n' && *words->at != '\r'; words->at++)
        *words->at = ' ';
}

/* libassimp knows small letters only. */
static void make_small(const struct words *words)
{
    for (size_t i = 0; i < words->len; i++)
        words->word[i] = (char)tolower((unsigned char)words->word[i]);
}

/* Behind an end there may be words that say nothing. Some programs write "end solid", and
 * -1.#IND for a normal: normals of an STL are not drawn. */
const char *stl_check(char *bytes, size_t len)
{
    struct words words = {bytes, bytes + len, NULL, 0};
    unsigned of_normal = 0;
    bool is_open = false, was_end = false, has_facets = false;
    if (stl_binary_len(bytes, len) || !next_word(&words) || !is_word(&words, "solid"))
        return NULL; /* libassimp says what it is not */
    do {
        make_small(&words);
        if (of_normal && memchr(words.word, '#', words.len))
            memset(words.word, '0', words.len);
        of_normal = is_word(&words, "normal") ? 3 : of_normal ? of_normal - 1 : 0;
        const bool is_end = is_word(&words, "endsolid") || (was_end && is_word(&words, "solid"));
        const bool is_facet = is_word(&words, "facet");
        was_end = is_word(&words, "end");
        is_open = !is_end && (is_open || is_facet || is_word(&words, "solid"));
        has_facets |= is_facet;
        if (is_end || is_word(&words, "solid"))
            blank_line(&words);
    } while (next_word(&words));
    return is_open ? ends : has_facets ? NULL : empty;
}
