/* SPDX-License-Identifier: MIT */
#include "paper/paper.h"

#include <stdarg.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"

const char *const verdict_names[] = {"confirmed", "confirmed with limits", "not confirmed"};

enum verdict verdict_of(bool in_full, bool in_part)
{
    return in_full ? CONFIRMED : in_part ? WITH_LIMITS : NOT_CONFIRMED;
}

static void append(json_t *array, json_t *object)
{
    if (!object || json_array_append_new(array, object) != 0)
        fail("out of memory");
}

void paper_claim(struct paper *paper, const char *part, const char *where, const char *claim, enum verdict verdict,
                 json_t *computed)
{
    append(paper->claims, json_pack("{s:s,s:s,s:s,s:o,s:s}", "part", part, "where", where, "claim", claim, "computed",
                                    computed, "verdict", verdict_names[verdict]));
}

void paper_choice(struct paper *paper, const char *part, const char *silent, json_t *chosen, json_t *other)
{
    append(paper->choices,
           json_pack("{s:s,s:s,s:o,s:o}", "part", part, "silent", silent, "chosen", chosen, "other", other));
}

void paper_finding(struct paper *paper, const char *part, json_t *text)
{
    append(paper->findings, json_pack("{s:s,s:o}", "part", part, "text", text));
}

void paper_number(struct paper *paper, const char *name, double value)
{
    if (json_object_set_new(paper->numbers, name, json_real(value)) != 0)
        fail("paper: the number %s is %g", name, value);
}

void paper_count(struct paper *paper, const char *name, long value)
{
    if (json_object_set_new(paper->numbers, name, json_integer(value)) != 0)
        fail("out of memory");
}

json_t *paper_table_new(struct paper *paper, const char *part, const char *title, const char *const *head)
{
    json_t *columns = json_array();
    for (; *head; head++)
        append(columns, json_string(*head));
    json_t *table = json_pack("{s:s,s:o,s:[]}", "title", title, "head", columns, "rows");
    if (!table || json_object_set_new(paper->tables, part, table) != 0)
        fail("out of memory");
    return table;
}

void paper_table_row(json_t *table, int count, ...)
{
    json_t *row = json_array();
    va_list cells;
    va_start(cells, count);
    for (int i = 0; i < count; i++)
        append(row, va_arg(cells, json_t *));
    va_end(cells);
    append(json_object_get(table, "rows"), row);
}

struct output *paper_file(const struct paper *paper, const char *name)
{
    char *file = folder_file(paper->folder, name);
    struct output *output = output_open(file);
    free(file);
    free(output->path); /* messages name the file as it is called in the end */
    output->path = formatted("%s/%s", paper->directory, name);
    return output;
}
