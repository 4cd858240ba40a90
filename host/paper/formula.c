/* SPDX-License-Identifier: MIT */
#include "paper/formula.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>

static void put_char(FILE *stream, char c)
{
    const char *entity = c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : NULL;
    if (entity)
        fputs(entity, stream);
    else
        fputc(c, stream);
}

void formula_put_plain(FILE *stream, const char *text)
{
    for (; *text; text++)
        put_char(stream, *text);
}

static bool is_word(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

static bool begins(const char *at, const char *end, const char *word)
{
    return (size_t)(end - at) >= strlen(word) && strncmp(at, word, strlen(word)) == 0;
}

/* Where what is raised ends: a bracket with its fellow (at its beginning where it has none), or a sign and letters, digits and decimal points. */
static const char *exponent_end(const char *at, const char *end)
{
    int depth = 0;
    if (at < end && *at == '(') {
        const char *const open = at;
        do {
            depth += (*at == '(') - (*at == ')');
            at++;
        } while (at < end && depth);
        return depth ? open : at;
    }
    at += at < end && *at == '-';
    while (at < end && (isalnum((unsigned char)*at) || (*at == '.' && at + 1 < end && isdigit((unsigned char)at[1]))))
        at++;
    return at;
}

static void put_range(FILE *stream, const char *at, const char *end, bool raised);

/* A sign of several characters; returns how many, or 0. */
static size_t put_sign(FILE *stream, const char *at, const char *end, bool raised, bool word_before)
{
    static const struct sign {
        const char *from, *to;
        bool word;
    } signs[] = {{"<=", "&le;", false},       {">=", "&ge;", false},    {" - ", " &minus; ", false},
                 {"sqrt(", "&radic;(", true}, {"pi/2", "&pi;/2", true}, {"alpha^2", "&alpha;<sup>2</sup>", true}};
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
        if (begins(at, end, signs[i].from) && !(signs[i].word && word_before)) {
            fputs(signs[i].to, stream);
            return strlen(signs[i].from);
        }
    if (raised && *at == '-') {
        fputs("&minus;", stream);
        return 1;
    }
    return 0;
}

/* The power of ten of a number, e-07; returns how many characters it has, or 0. */
static size_t put_power_of_ten(FILE *stream, const char *at, const char *end, char before)
{
    if (*at != 'e' || !isdigit((unsigned char)before) || end - at < 3 || !strchr("+-", at[1]) ||
        !isdigit((unsigned char)at[2]))
        return 0;
    const char *digits = at + 2, *to;
    while (*digits == '0' && digits + 1 < end && isdigit((unsigned char)digits[1]))
        digits++;
    for (to = digits; to < end && isdigit((unsigned char)*to); to++)
        continue;
    fprintf(stream, "&nbsp;&times;&nbsp;10<sup>%s%.*s</sup>", at[1] == '-' ? "&minus;" : "", (int)(to - digits),
            digits);
    return (size_t)(to - at);
}

/* A name with an index, a product of vectors, or a variable; returns how many characters it has, or 0. */
static size_t put_name(FILE *stream, const char *at, const char *end, char before)
{
    const char after = (char)(at + 1 < end ? at[1] : ' ');
    if (isalpha((unsigned char)before) || before == '_')
        return 0;
    if (begins(at, end, "F_")) {
        const char *index = at + 2, *to = index;
        while (to < end && isupper((unsigned char)*to))
            to++;
        fprintf(stream, "<i>F</i><sub>%.*s</sub>", (int)(to - index), index);
        return (size_t)(to - at);
    }
    if (strchr("NLHTB", *at) && after == '.' && at + 2 < end && strchr("NLHTB", at[2]) &&
        !(at + 3 < end && is_word(at[3]))) {
        fprintf(stream, "%c&middot;%c", *at, at[2]);
        return 3;
    }
    if (begins(at, end, "n_across")) {
        fputs("<i>n</i><sub>across</sub>", stream);
        return strlen("n_across");
    }
    if (begins(at, end, "nc") && !(at + 2 < end && is_word(at[2]))) {
        fputs("<i>nc</i>", stream);
        return 2;
    }
    if ((*at == 'a' || *at == 'b') && after >= '1' && after <= '5' && !(at + 2 < end && is_word(at[2]))) {
        fprintf(stream, "<i>%c</i><sub>%c</sub>", *at, after);
        return 2;
    }
    if (*at == 'F' && begins(at, end, "F. ") && isupper((unsigned char)at[3])) /* an initial */
        return 0;
    if (strchr("nqcmktF", *at) && !is_word(after) && after != '\'') {
        fprintf(stream, "<i>%c</i>", *at);
        return 1;
    }
    return 0;
}

static void put_range(FILE *stream, const char *at, const char *end, bool raised)
{
    char before = ' ';
    while (at < end) {
        size_t taken = 0;
        if (*at == '`' && memchr(at + 1, '`', (size_t)(end - at - 1))) {
            fputs("<code>", stream);
            while (*++at != '`')
                put_char(stream, *at);
            fputs("</code>", stream);
            taken = 1;
        } else if (*at == '^' && exponent_end(at + 1, end) > at + 1) {
            const char *to = exponent_end(at + 1, end);
            const bool bracket = at[1] == '(';
            fputs("<sup>", stream);
            put_range(stream, at + 1 + bracket, to - bracket, true);
            fputs("</sup>", stream);
            taken = (size_t)(to - at);
        } else if (!(taken = put_sign(stream, at, end, raised, is_word(before))) &&
                   !(taken = put_power_of_ten(stream, at, end, before))) {
            taken = put_name(stream, at, end, before);
        }
        if (!taken) {
            put_char(stream, *at);
            taken = 1;
        }
        before = at[taken - 1];
        at += taken;
    }
}

void formula_put(FILE *stream, const char *text)
{
    put_range(stream, text, text + strlen(text), false);
}
