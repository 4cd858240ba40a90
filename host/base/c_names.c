/* SPDX-License-Identifier: MIT
 * Names that written C source can have. */
#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/argp.h"
#include "base/c_library.h"
#include "base/c_names.h"
#include "base/memory.h"

static bool begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

static bool ends(const char *text, const char *with)
{
    const size_t len = strlen(text), len_with = strlen(with);
    return len >= len_with && strcmp(text + len - len_with, with) == 0;
}

/* Letters, digits and single _ between, a letter first: what C and C++ leave to programs. */
static bool is_c_name(const char *text)
{
    for (const char *at = text; *at; at++)
        if (!isalnum((unsigned char)*at) && *at != '_')
            return false;
    return isalpha((unsigned char)*text) && !ends(text, "_") && !strstr(text, "__");
}

/* Of C23, C++23 and GNU C, and what a hosted program or a compiler for Unix defines. */
static const char words[] =
    " alignas alignof and and_eq asm auto bitand bitor bool break case catch char class co_await co_return "
    "co_yield compl concept const const_cast consteval constexpr constinit continue decltype default delete "
    "do double dynamic_cast else enum explicit export extern false float for friend goto if inline int linux "
    "long main mutable namespace new noexcept not not_eq NULL nullptr operator or or_eq private protected public "
    "register reinterpret_cast requires restrict return short signed sizeof static static_assert static_cast "
    "struct switch template this thread_local throw true try typedef typeid typename typeof typeof_unqual "
    "union unix unsigned using virtual void volatile while xor xor_eq ";

/* A keyword, or a name of <stdint.h>; `text` is_c_name. */
static bool is_taken_c_name(const char *text)
{
    static const char *const of_stdint[] = {"INT", "UINT", "PTRDIFF_", "SIG_ATOMIC_", "SIZE_", "WCHAR_", "WINT_"};
    for (const char *at = strstr(words, text); at; at = strstr(at + 1, text))
        if (at[-1] == ' ' && at[strlen(text)] == ' ')
            return true;
    for (size_t i = 0; i < sizeof of_stdint / sizeof *of_stdint; i++)
        if (begins(text, of_stdint[i]) &&
            (ends(text, "_MAX") || ends(text, "_MIN") || ends(text, "_WIDTH") || ends(text, "_C")))
            return true;
    return ends(text, "_t"); /* POSIX keeps these for types, <stdint.h> has many */
}

const char *parse_c_name(const struct argp_state *state, const char *text)
{
    if (strlen(text) > 63 || !is_c_name(text))
        refuse(state, "--name: '%s' is not a C name: a letter, then letters, digits and single _ between, at most 63",
               text);
    if (is_taken_c_name(text))
        refuse(state, "--name: '%s' has a meaning in C or C++; choose another", text);
    if (is_c_library_name(text))
        refuse(state, "--name: '%s' is a name of the C library, which compilers know; choose another", text);
    if (strncasecmp(text, "glint_", 6) == 0 || strcasecmp(text, "glint") == 0)
        refuse(state, "--name: '%s' may be a name of glint.h; choose another", text);
    return text;
}

void parse_c_macro(const struct argp_state *state, const char *name, const char *suffix)
{
    char macro[128];
    snprintf(macro, sizeof macro, "%s%s", name, suffix);
    for (char *at = macro; *at; at++)
        *at = (char)toupper((unsigned char)*at);
    if (is_taken_c_name(macro))
        refuse(state, "--name: '%s' would define %s, which has a meaning in C; take another", name, macro);
}

/* Between the quotes of #include. */
static bool is_includable(const char *name)
{
    for (; *name; name++)
        if (*name == '"' || *name == '\\' || iscntrl((unsigned char)*name))
            return false;
    return true;
}

void parse_c_files(const struct argp_state *state, const char *path, const char **name, const char *suffix,
                   struct c_files *files)
{
    const size_t length = strlen(path);
    *files = (struct c_files){NULL, NULL, NULL};
    if (length < 3 || strcasecmp(path + length - 2, ".c") != 0)
        return;
    const char *slash = strrchr(path, '/');
    files->header = copied(path);
    files->stem = copied(slash ? slash + 1 : path);
    files->header[length - 1] = path[length - 1] == 'C' ? 'H' : 'h';
    files->within = files->header + (slash ? slash + 1 - path : 0);
    if (!is_includable(files->within))
        refuse(state, "-o: '%s' cannot be included in C; name the file without quotes, backslashes and line ends",
               path);
    files->stem[strlen(files->stem) - 2] = '\0';
    if (!*name)
        *name = parse_c_name(state, files->stem);
    parse_c_macro(state, *name, suffix);
}

void c_files_free(struct c_files *files)
{
    free(files->header);
    free(files->stem);
}
