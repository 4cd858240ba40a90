/* SPDX-License-Identifier: MIT */
#include "bake/c_source.h"

#include <ctype.h>
#include <stddef.h>

struct c_capitals c_capitals(const char *name)
{
    struct c_capitals capitals = {""};
    for (size_t i = 0; name[i] && i + 1 < sizeof capitals.text; i++)
        capitals.text[i] = (char)toupper((unsigned char)name[i]);
    return capitals;
}

void c_begin_header(const char *name, const char *header, FILE *out)
{
    const struct c_capitals macro = c_capitals(name);
    fprintf(out, "#ifndef %s_H\n#define %s_H\n\n#include %s\n", macro.text, macro.text, header);
}

void c_end_header(FILE *out)
{
    fputs("\n#endif\n", out);
}

void c_begin_externs(FILE *out)
{
    fputs("\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n", out);
}

void c_end_externs(FILE *out)
{
    fputs("#ifdef __cplusplus\n}\n#endif\n", out);
}

void c_begin_array(const char *storage, const char *type, const char *name, const char *suffix, FILE *out)
{
    fprintf(out, "\n#ifdef __GNUC__\n__attribute__((aligned(4)))\n#endif\n%sconst %s %s%s[] = {", storage, type, name,
            suffix);
}
