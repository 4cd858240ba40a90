/* SPDX-License-Identifier: MIT */
#include "mesh/stl_check.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <strings.h>

enum { HEAD = 84, FACET = 50, BEHIND_MAX = 4096, WORD = 4, NEVER = 5 };
static const char ends[] = "it ends without endsolid: a part is missing; export or fetch it again",
                  empty[] = "it has no facets; export it again",
                  hollow[] = "its head says that it has no facets, but more follows; export it again",
                  odd_len[] = "it is neither a text that begins with solid nor as long as its head says; export or "
                              "fetch it again",
                  bare[] = "a facet has no normal, and no outer loop in whose place one could be; export it again";

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
    for (; words->at < words->end && is_blank(*words->at); words->at++)
        if (!*words->at)
            *words->at = ' '; /* libassimp ends there */
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

static bool next_on_line(struct words *words)
{
    while (words->at < words->end && is_blank(*words->at) && *words->at != '\n' && *words->at != '\r')
        words->at++;
    return words->at < words->end && !is_blank(*words->at) && next_word(words);
}

/* Where a name ends that stands behind solid or endsolid: with its line, but before what follows on it: a facet with a normal or a
 * loop, or the solid that it or the next line's facet is of. */
static char *name_end(struct words words, bool is_end)
{
    enum { NAME, IS_FACET, IS_NORMAL, IS_OUTER } step = NAME;
    char *facet = NULL, *solid = NULL;
    while (next_on_line(&words)) {
        if ((step == IS_NORMAL && strchr("+-.0123456789", *words.word)) ||
            (step == IS_OUTER && is_word(&words, "loop")))
            return is_end && solid ? solid : facet;
        step = is_word(&words, "facet")                               ? IS_FACET
               : step == IS_FACET && is_word(&words, "normal")        ? IS_NORMAL
               : step && step != IS_OUTER && is_word(&words, "outer") ? IS_OUTER
                                                                      : NAME;
        facet = step == IS_FACET ? words.word : facet;
        solid = step == NAME && is_word(&words, "solid") ? words.word : solid;
    }
    char *const line_end = words.at;
    return is_end && solid && next_word(&words) && is_word(&words, "facet") ? solid : line_end;
}

/* Some names crash libassimp. */
static void blank_name(struct words *words, bool is_end)
{
    char *const end = name_end(*words, is_end);
    const bool is_within = end < words->end && !is_blank(*end) && end > words->at;
    memset(words->at, ' ', (size_t)(end - words->at));
    words->at = end;
    if (is_within) /* libassimp takes what stands on solid's line for its name */
        end[-1] = '\n';
}

/* libassimp knows small letters only. */
static void make_small(const struct words *words)
{
    for (size_t i = 0; i < words->len; i++)
        words->word[i] = (char)tolower((unsigned char)words->word[i]);
}

/* What libassimp takes for a number. Some programs write -1.#IND for a normal: normals of an STL are not drawn. */
static void make_number(const struct words *words)
{
    for (size_t i = 0; i < words->len; i++)
        if (!strchr("+-.0123456789e", words->word[i])) {
            memset(words->word, '0', words->len);
            return;
        }
}

struct facet {
    char *at, *loop, *loop_end; /* NULL: not met */
    unsigned normal; /* how many of its numbers are still to come; WORD: its word, too; NEVER: they do not come */
};

/* libassimp wants a normal: there is room for it where the words outer loop, endloop and endfacet stand, which it passes over. False: they do not. */
static bool give_normal(const struct facet *facet, const char *end)
{
    static const char begin[] = "facet normal 0 0 0";
    enum { LEN = sizeof begin - 1 };
    if (!facet->loop || facet->loop_end < facet->loop)
        return false;
    const size_t len = (size_t)(facet->loop_end - facet->loop), room = (size_t)(end - facet->at);
    memmove(facet->at + LEN, facet->loop, len); /* less than facet, loop, what is between, endloop, endfacet */
    memcpy(facet->at, begin, LEN);
    memset(facet->at + LEN + len, ' ', room - LEN - len);
    return true;
}

/* False: one has no normal, and none can be given. */
static bool take_word(struct facet *facet, const struct words *words)
{
    if (is_word(words, "facet")) {
        const bool is_bare = facet->normal;
        *facet = (struct facet){.at = words->word, .normal = WORD};
        return !is_bare;
    }
    if (facet->normal == WORD) {
        facet->normal = is_word(words, "normal") ? 3 : NEVER;
    } else if (facet->normal && facet->normal != NEVER && isalpha((unsigned char)*words->word) &&
               !strchr("ni", *words->word)) {
        facet->normal = NEVER; /* as outer does */
    } else if (facet->normal && facet->normal != NEVER) {
        make_number(words);
        facet->normal--;
    }
    if (is_word(words, "loop"))
        facet->loop = words->at;
    if (is_word(words, "endloop"))
        facet->loop_end = words->word;
    if (!is_word(words, "endfacet") || !facet->normal)
        return true;
    const struct facet of = *facet;
    *facet = (struct facet){0};
    return of.at && give_normal(&of, words->at);
}

/* Behind an end there may be words that say nothing. Some programs write "end solid". */
static const char *check_text(struct words *words)
{
    struct facet facet = {0};
    bool is_open = false, was_end = false, has_facets = false;
    do {
        make_small(words);
        const bool is_end = is_word(words, "endsolid") || (was_end && is_word(words, "solid"));
        const bool is_solid = is_word(words, "solid"), is_facet = is_word(words, "facet");
        was_end = is_word(words, "end");
        is_open = !is_end && (is_open || is_facet || is_solid);
        has_facets |= is_facet;
        if (!take_word(&facet, words) || ((is_end || is_solid) && facet.normal))
            return bare;
        if (is_end || is_solid)
            blank_name(words, is_end);
    } while (next_word(words));
    return is_open ? ends : has_facets ? NULL : empty;
}

const char *stl_check(char *bytes, size_t len)
{
    struct words words = {bytes, bytes + len, NULL, 0};
    const bool is_hollow = len > HEAD && memcmp(bytes + HEAD - 4, "\0\0\0\0", 4) == 0;
    if (len >= 3 && memcmp(bytes, "\xEF\xBB\xBF", 3) == 0) /* of UTF-8 */
        memset(bytes, ' ', 3);
    if (stl_binary_len(bytes, len))
        return len == HEAD ? empty : NULL;
    if (!next_word(&words) || !is_word(&words, "solid"))
        return is_hollow ? hollow : odd_len;
    memset(bytes, ' ', (size_t)(words.word - bytes)); /* libassimp knows no empty lines there */
    return check_text(&words);
}
