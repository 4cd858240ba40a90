/* SPDX-License-Identifier: MIT */
#include "mesh/import_obj.h"

#if GLINT_WITH_MESH
#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/memory.h"

struct obj {
    const char *at, *end;
    unsigned long number;         /* of the line, from 1 */
    unsigned long long counts[3]; /* of v, vt and vn so far: a face names them in this order */
    char *line;                   /* a whole one, of those that are continued; ends with 0 */
    size_t room;
    FILE *out;
    char *wrong;
};

/* ---- lines ---- */

static bool ends_line(const struct obj *obj)
{
    return obj->at == obj->end || *obj->at == '\n' || *obj->at == '\r';
}

static void skip_end(struct obj *obj)
{
    if (obj->at < obj->end && *obj->at == '\r' && obj->at + 1 < obj->end && obj->at[1] == '\n')
        obj->at++;
    if (obj->at < obj->end)
        obj->at++;
    obj->number++;
}

static void keep(struct obj *obj, size_t *len, char byte)
{
    if (*len + 1 >= obj->room) {
        char *more = realloc(obj->line, obj->room *= 2);
        if (!more)
            abort(); /* the parent says that libassimp crashed */
        obj->line = more;
    }
    obj->line[(*len)++] = byte;
}

/* A backslash before the end continues it, but for a comment. */
static bool next_line(struct obj *obj)
{
    size_t len = 0;
    if (obj->at == obj->end)
        return false;
    for (;; obj->at++) {
        if (ends_line(obj)) {
            skip_end(obj);
            if (len == 0 || obj->line[len - 1] != '\\' || obj->line[0] == '#' || obj->at == obj->end)
                break;
            obj->line[--len] = 0;
            if (len > 0)
                obj->line[len++] = ' ';
            obj->at--;
        } else if (len > 0 || !isspace((unsigned char)*obj->at)) {
            keep(obj, &len, *obj->at);
        }
    }
    while (len > 0 && isspace((unsigned char)obj->line[len - 1]))
        len--;
    obj->line[len] = 0;
    return true;
}

/* ---- words ---- */

/* Ends it with 0; NULL: none is left, but a comment may be. */
static char *next_word(char **at)
{
    char *word = *at + strspn(*at, " \t\v\f");
    if (!*word || *word == '#')
        return NULL;
    *at = word + strcspn(word, " \t\v\f");
    if (**at)
        *(*at)++ = 0;
    return word;
}

/* Decimal digits with a point, if there is one, before, between or behind them, then an exponent; or what is not a number, which the reader
 * of all formats refuses. */
static bool put_number(struct obj *obj, const char *word)
{
    const bool minus = *word == '-';
    const char *at = word + (minus || *word == '+');
    const size_t before = strspn(at, "0123456789"), point = at[before] == '.';
    const size_t behind = point ? strspn(at + before + 1, "0123456789") : 0;
    const char *exponent = at + before + point + behind, *end = exponent;
    fputs(minus ? " -" : " ", obj->out);
    if (strncasecmp(at, "nan", 3) == 0 || strncasecmp(at, "inf", 3) == 0)
        return fputs("nan", obj->out) >= 0;
    if (*end == 'e' || *end == 'E') {
        end += 1 + (end[1] == '-' || end[1] == '+');
        const size_t digits = strspn(end, "0123456789");
        end += digits;
        if (digits == 0)
            return false;
    }
    if (*end || before + behind == 0)
        return false;
    fprintf(obj->out, "%.*s", before ? (int)before : 1, before ? at : "0");
    if (point)
        fprintf(obj->out, ".%.*s", behind ? (int)behind : 1, behind ? at + before + 1 : "0");
    fputs(exponent, obj->out);
    return true;
}

/* V, V/VT, V//VN or V/VT/VN. */
static bool put_corner(struct obj *obj, char *word)
{
    static const char *const before[3] = {" ", "/", "/"};
    int empty = 0;
    for (int i = 0; i < 3 && word; i++) {
        char *slash = strchr(word, '/'), *end;
        if (slash)
            *slash = 0;
        const long long index = strtoll(word, &end, 10);
        if (*end || (i == 0 && !*word))
            return false;
        if (*word) {
            const long long place = index < 0 ? (long long)obj->counts[i] + 1 + index : index;
            if (place < 1)
                return false;
            fprintf(obj->out, "%s%s%lld", empty ? "/" : "", before[i], place);
        }
        empty = !*word;
        word = slash ? slash + 1 : NULL;
    }
    return !word; /* not a fourth one */
}

/* ---- statements ---- */

/* A kind of line that has numbers, and how many. */
struct kind {
    const char *name, *what;
    unsigned min, max;
};
static const struct kind kinds[] = {
    {"v", "a vertex has three numbers, or six with its colour", 3, 7},
    {"vt", "a place in a texture has two numbers", 1, 3},
    {"vn", "a normal has three numbers", 3, 3},
};

static bool put_numbers(struct obj *obj, const struct kind *kind, char *at)
{
    unsigned count = 0;
    char *words[8];
    for (char *word; count < 8 && (word = next_word(&at));)
        words[count++] = word;
    if (count < kind->min || count > kind->max || (kind->max == 7 && count == 5))
        return false;
    fputs(kind->name, obj->out);
    for (unsigned i = 0; i < count && i < 6; i++) /* the seventh is an alpha */
        if (!put_number(obj, words[i]))
            return false;
    fputs(count == 1 ? " 0\n" : "\n", obj->out);
    obj->counts[kind - kinds]++;
    return true;
}

static bool put_corners(struct obj *obj, const char *name, char *at)
{
    fputs(name, obj->out);
    for (char *word; (word = next_word(&at));)
        if (!put_corner(obj, word))
            return false;
    fputs("\n", obj->out);
    return true;
}

static bool put_line(struct obj *obj)
{
    const char *wrong = NULL;
    const size_t name_len = strcspn(obj->line, " \t\v\f");
    char *rest = obj->line + name_len;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strlen(kinds[i].name) == name_len && strncmp(obj->line, kinds[i].name, name_len) == 0) {
            if (put_numbers(obj, &kinds[i], rest))
                return true;
            wrong = kinds[i].what;
        }
    if (!wrong && name_len == 1 && obj->line[0] == 'f') {
        if (put_corners(obj, "f", rest))
            return true;
        wrong = "a face has numbers of vertices, which count from 1, or from -1 back";
    }
    if (wrong)
        snprintf(obj->wrong, 120, "line %lu: %s", obj->number - 1, wrong);
    else if (obj->line[0] != '#')
        fprintf(obj->out, "%s\n", obj->line);
    return !wrong;
}

char *import_obj_spelled(const char *text, size_t len, size_t *spelled_len, char wrong[120])
{
    char *spelled = NULL;
    const size_t mark = len >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0; /* of UTF-8 */
    struct obj obj = {.at = text + mark, .end = text + len, .number = 1, .room = 256, .wrong = wrong};
    obj.line = allocate(obj.room, 1);
    obj.out = open_memstream(&spelled, spelled_len);
    if (!obj.out)
        abort();
    bool good = true;
    while (good && next_line(&obj))
        good = put_line(&obj);
    free(obj.line);
    if (fclose(obj.out) != 0)
        abort();
    if (good)
        return spelled;
    free(spelled);
    return NULL;
}

#endif
