/* SPDX-License-Identifier: MIT */
#include "mesh/ply_check.h"

#include <ctype.h>
#include <errno.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ELEMENTS_MAX = 16, PROPERTIES_MAX = 256, LINE = 256 };

struct property {
    unsigned count_bytes, bytes; /* the first: of a list's length; 0: no list */
    bool is_signed, is_big;      /* that length */
    bool is_float;               /* no list */
    const char *signs;           /* those that its whole numbers may have; NULL: they have points */
};
struct element {
    uint64_t count;
    bool is_known;  /* to libassimp */
    bool has_faces; /* lists of vertices */
    unsigned properties;
    struct property of[PROPERTIES_MAX];
};
struct body {
    char *at;
    const char *end;
    bool is_text;
    bool is_cr;     /* lines of the header end in this alone */
    bool is_broken; /* a number that should be whole is not */
    bool has_corner_uv;
};

static const char ends[] = "it ends before all that its header promises; export or fetch it again",
                  damaged[] = "its header is damaged; export it again",
                  misread[] =
                      "its data begin with the byte 10, which libassimp takes for the header's end; export it as text",
                  odd_list[] = "a list's length is not a number from 0 on; export it again",
                  short_line[] = "a line of its data has too few numbers: libassimp takes one for each vertex and each "
                                 "face; export it again",
                  broken[] = "a number is not whole, as its header promises; export it again",
                  no_faces[] = "it has no faces; make triangles of its points, or export it with its faces",
                  too_many[] = "its header has more than 16 elements, or 256 properties of one; export it without",
                  torn[] = "a comment that names a texture stands among properties; move it above the elements";

static bool is_blank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

static bool ends_line(char c)
{
    return c == '\n' || c == '\r';
}

/* ---- the header ---- */

/* A line, or its beginning, without blanks and its end behind. False: there is none any more. */
static bool next_line(struct body *body, char line[LINE])
{
    while (body->at < body->end && (*body->at == ' ' || *body->at == '\t'))
        body->at++;
    char *end = body->at;
    while (end < body->end && !ends_line(*end))
        end++;
    size_t len = (size_t)(end - body->at);
    if (end == body->end)
        return false;
    len = len < LINE ? len : LINE - 1;
    while (len && is_blank(body->at[len - 1]))
        len--;
    memcpy(line, body->at, len);
    line[len] = 0;
    end += *end == '\r' && end + 1 < body->end && end[1] == '\n' ? 2 : 1;
    body->at = end;
    return true;
}

/* Between some words libassimp knows one blank only, and no vertical tabs. */
static void space_words(char *line, char *end)
{
    char *to = line;
    while (end > line && ends_line(end[-1]))
        end--;
    for (const char *at = line; at < end; at++)
        if (!is_blank(*at))
            *to++ = *at;
        else if (to > line && to[-1] != ' ')
            *to++ = ' ';
    memset(to, ' ', (size_t)(end - to));
}

static bool is_in(const char *word, const char *words)
{
    char name[40];
    snprintf(name, sizeof name, " %.36s ", word);
    return strstr(words, name) != NULL;
}

/* 0: unknown. */
static unsigned bytes_of(const char *type)
{
    static const struct {
        const char *names;
        unsigned bytes;
    } types[] = {{" char uchar int8 uint8 ", 1},
                 {" short ushort int16 uint16 ", 2},
                 {" int uint int32 uint32 float float32 ", 4},
                 {" double float64 ", 8}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (is_in(type, types[i].names))
            return types[i].bytes;
    return 0;
}

static const char *signs_of(const char *type)
{
    return *type == 'f' || *type == 'd' ? NULL : *type == 'u' ? "" : "+-";
}

static bool take_property(struct element *element, const char *line)
{
    char type[32], count[32], name[32] = "";
    struct property *property = &element->of[element->properties++];
    *property = (struct property){0};
    if (sscanf(line, "property list %31s %31s %31s", count, type, name) >= 2) {
        element->has_faces |= is_in(name, " vertex_indices vertex_index ");
        const bool is_whole = !strstr(count, "float") && !strstr(count, "double");
        property->count_bytes = is_whole ? bytes_of(count) : 0;
        property->is_signed = count[0] != 'u';
        property->bytes = property->count_bytes ? bytes_of(type) : 0;
        property->signs = signs_of(type);
    } else if (sscanf(line, "property %31s", type) == 1) {
        property->bytes = bytes_of(type);
        property->signs = signs_of(type);
        property->is_float = is_in(type, " float float32 double float64 ");
    }
    return property->bytes > 0;
}

/* A number from 0 on, and nothing behind it. */
static bool take_number(const char *word, uint64_t *number)
{
    char *end;
    errno = 0;
    const long long value = strtoll(word, &end, 10);
    *number = (uint64_t)value;
    return isdigit((unsigned char)*word) && !*end && !errno;
}

static bool take_element(struct element *element, const char *line)
{
    char name[32], count[32], left;
    *element = (struct element){0};
    if (sscanf(line, "element %31s %31s %c", name, count, &left) != 2)
        return false;
    element->is_known = is_in(name, " vertex face tristrips edge material TextureFile ");
    return take_number(count, &element->count);
}

/* The property of a line becomes one that libassimp does not know, if it has this name. */
static bool leave_out(char *from, const char *end, const char *name)
{
    const size_t len = strlen(name);
    while (end > from && is_blank(end[-1]))
        end--;
    if ((size_t)(end - from) <= len || memcmp(end - len, name, len) != 0 || !is_blank(end[-1 - (ptrdiff_t)len]))
        return false;
    memset(from + (end - from) - len, 'x', len);
    return true;
}

static bool begins(const char *line, const char *word)
{
    const size_t len = strlen(word);
    return strncmp(line, word, len) == 0 && (line[len] == 0 || is_blank(line[len]));
}

/* The comment that libassimp reads; without a name it would take the next line's first word for one. */
static bool is_texture(const char *line)
{
    char word[16] = "", name;
    return sscanf(line, "comment %15s %c", word, &name) == 2 && strcmp(word, "TextureFile") == 0;
}

/* Returns what is wrong, or NULL. Lines that say nothing become blanks before the next one: among properties libassimp takes them for an element's end.
 * So do those of elements that it does not know, and does not skip. */
static const char *read_header(struct body *body, struct element elements[ELEMENTS_MAX], unsigned *count)
{
    char line[LINE] = "", format[32] = "";
    bool is_torn = false;
    *count = 0;
    if (next_line(body, line) && !begins(line, "ply"))
        return damaged;
    for (;;) {
        char *const from = body->at;
        if (!next_line(body, line))
            return ends;
        if (!begins(line, "comment"))
            space_words(from, body->at);
        if (strcmp(line, "end_header") == 0)
            break;
        if (memchr(from, 0, (size_t)(body->at - from)))
            return damaged;
        const bool is_element = begins(line, "element"), is_property = begins(line, "property");
        if (is_texture(line)) {
            is_torn = true;
            continue;
        }
        if (!*line || begins(line, "comment") || begins(line, "obj_info")) {
            memset(from, ' ', (size_t)(body->at - from));
            continue;
        }
        if (is_property && !*count)
            return damaged;
        if (is_element ? *count == ELEMENTS_MAX : is_property && elements[*count - 1].properties == PROPERTIES_MAX)
            return too_many;
        if (is_property && is_torn)
            return torn;
        if (is_property) {
            leave_out(from, body->at, "alpha"); /* libassimp makes black of one without colours; alpha is not drawn */
            body->has_corner_uv |= leave_out(from, body->at, "texcoord");
        }
        is_torn = is_torn && !is_element;
        if (is_element    ? !take_element(&elements[(*count)++], line)
            : is_property ? !take_property(&elements[*count - 1], line)
                          : sscanf(line, "format %31s", format) != 1)
            return damaged;
        if ((is_element || is_property) && !elements[*count - 1].is_known)
            memset(from, ' ', (size_t)(body->at - from));
    }
    body->is_text = strcmp(format, "ascii") == 0;
    const bool is_big = strcmp(format, "binary_big_endian") == 0;
    if (!body->is_text && !is_big && strcmp(format, "binary_little_endian") != 0)
        return damaged;
    for (unsigned i = 0; i < *count; i++)
        for (unsigned k = 0; k < elements[i].properties; k++)
            elements[i].of[k].is_big = is_big;
    if (body->is_cr && !body->is_text && body->at[-1] == '\n')
        body->at--; /* the first of the data */
    return NULL;
}

/* ---- the body ---- */

/* Empty lines become blanks before the next one, too. */
static void skip_blanks(struct body *body)
{
    while (body->at < body->end && is_blank(*body->at))
        *body->at++ = ' ';
}

static void skip_line(struct body *body)
{
    while (body->at < body->end && !ends_line(*body->at))
        body->at++;
    body->at += body->at < body->end;
    body->at += body->at < body->end && body->at[-1] == '\r' && *body->at == '\n';
    skip_blanks(body);
}

/* libassimp takes what stands behind the digits of a whole number for the next one. */
static bool is_number(const char *word, const char *end, const char *signs)
{
    if (signs && *word && strchr(signs, *word))
        word++;
    const char *const digits = word;
    while (word < end && isdigit((unsigned char)*word))
        word++;
    return !signs || (word > digits && word == end);
}

/* Within a line. Before a word only these are blanks to libassimp. */
static bool skip_word(struct body *body, const char *signs)
{
    while (body->at < body->end && (*body->at == ' ' || *body->at == '\t'))
        body->at++;
    const char *const word = body->at;
    while (body->at < body->end && !is_blank(*body->at))
        body->at++;
    if (body->at == word)
        return false;
    body->is_broken = !is_number(word, body->at, signs);
    return !body->is_broken;
}

static bool skip(struct body *body, uint64_t count, unsigned bytes, const char *signs)
{
    if (!body->is_text && count > (uint64_t)(body->end - body->at) / bytes)
        return false;
    if (!body->is_text) {
        body->at += count * bytes;
        return true;
    }
    while (count && skip_word(body, signs))
        count--;
    return count == 0;
}

static const char *too_short(const struct body *body)
{
    return body->is_broken ? broken : body->is_text && body->at < body->end ? short_line : ends;
}

/* Returns what is wrong, or NULL. */
static const char *take_length(struct body *body, const struct property *list, uint64_t *length)
{
    char word[24] = "";
    const char *const at = body->at;
    if (!skip(body, 1, list->count_bytes, NULL))
        return too_short(body);
    if (body->is_text) {
        const char *from = at;
        while (is_blank(*from))
            from++;
        snprintf(word, sizeof word, "%.*s", (int)(body->at - from < 23 ? body->at - from : 23), from);
        return take_number(word, length) ? NULL : odd_list;
    }
    *length = 0;
    for (unsigned i = 0; i < list->count_bytes; i++)
        *length |= (uint64_t)(uint8_t)at[i] << 8 * (list->is_big ? list->count_bytes - 1 - i : i);
    return list->is_signed && *length >> (8 * list->count_bytes - 1) ? odd_list : NULL;
}

/* Elements without lists are of one size. */
static const char *check_element(struct body *body, const struct element *element)
{
    unsigned bytes = 0, lists = 0;
    for (unsigned k = 0; k < element->properties; k++) {
        bytes += element->of[k].bytes;
        lists += element->of[k].count_bytes > 0;
    }
    if (!element->properties)
        return NULL;
    if (!lists && !body->is_text)
        return skip(body, element->count, bytes, NULL) ? NULL : ends;
    for (uint64_t i = 0; i < element->count; i++) {
        for (unsigned k = 0; k < element->properties; k++) {
            const struct property *property = &element->of[k];
            uint64_t length = 1;
            const char *wrong = property->count_bytes ? take_length(body, property, &length) : NULL;
            if (wrong)
                return wrong;
            if (!skip(body, length, property->bytes, element->is_known ? property->signs : NULL))
                return too_short(body);
        }
        if (body->is_text) /* behind what may be there, too */
            skip_line(body);
    }
    return NULL;
}

/* What is in an element that libassimp does not know leaves the file. */
static const char *check_or_cut(struct body *body, const struct element *element)
{
    char *const from = body->at;
    const char *wrong = check_element(body, element);
    if (!wrong && !element->is_known) {
        memmove(from, body->at, (size_t)(body->end - body->at));
        body->end -= body->at - from;
        body->at = from;
    }
    return wrong;
}

/* libassimp crashes on a file without. */
static bool has_faces(const struct element *elements, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        if (elements[i].is_known && elements[i].has_faces && elements[i].count)
            return true;
    return false;
}

/* The last bit of a number with a point tells nothing. */
static bool may_change_first(const struct element *elements, unsigned count)
{
    unsigned i = 0;
    while (i < count && !(elements[i].is_known && elements[i].count && elements[i].properties))
        i++;
    return i < count && elements[i].of[0].is_float && !elements[i].of[0].is_big;
}

/* The mark of UTF-8 stands before what some programs write as text. */
static void leave_mark_out(char *text, size_t *len)
{
    static const char mark[] = "\xEF\xBB\xBF";
    enum { LEN = sizeof mark - 1 };
    if (*len < LEN || memcmp(text, mark, LEN) != 0)
        return;
    *len -= LEN;
    memmove(text, text + LEN, *len);
}

const char *ply_check(char *text, size_t *len, bool *has_corner_uv)
{
    leave_mark_out(text, len);
    struct body body = {.at = text, .end = text + *len, .is_cr = *len > 4 && text[3] == '\r' && text[4] != '\n'};
    struct element elements[ELEMENTS_MAX];
    unsigned count;
    const char *wrong = read_header(&body, elements, &count);
    *has_corner_uv = body.has_corner_uv;
    if (!wrong && body.is_text)
        skip_blanks(&body);
    char *const data = body.at;
    for (unsigned i = 0; i < count && !wrong; i++)
        wrong = check_or_cut(&body, &elements[i]);
    *len = (size_t)(body.end - text);
    if (!wrong && !has_faces(elements, count))
        return no_faces;
    if (!wrong && !body.is_text && data < body.end && *data == '\n' && (data[-1] == '\r' || data[-2] != '\r')) {
        if (!may_change_first(elements, count))
            return misread;
        *data = 11;
    }
    return wrong;
}
