/* SPDX-License-Identifier: MIT */
#include <errno.h>
#include <inttypes.h>
#include <jansson.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>

#include "base/message.h"
#include "base/output.h"
#include "paper/search_checkpoint.h"
#include "paper/search_rows.h"

static json_t *numbers(const struct search_list *list)
{
    json_t *array = json_array();
    for (size_t i = 0; i < list->count; i++)
        json_array_append_new(array, json_real(list->values[i]));
    return array;
}

/* What the search is; equal texts are the same search. */
static json_t *search_of(const struct search_options *options)
{
    return json_pack("{s:o, s:o, s:o, s:I, s:I}", "exponents", numbers(&options->exponents), "coefficients",
                     numbers(&options->coefficients), "shininess", numbers(&options->shininess), "angles",
                     (json_int_t)options->angles, "best", (json_int_t)options->best);
}

void checkpoint_write(const char *path, const struct search_options *options, uint64_t sets_done,
                      const struct best *best)
{
    json_t *rows = json_array();
    for (size_t i = 0; i < best->count; i++)
        json_array_append_new(
            rows, json_pack("{s:I, s:f}", "function", (json_int_t)best->entries[i].index, "sum", best->entries[i].sum));
    json_t *root = json_pack("{s:s, s:o, s:I, s:o}", "glint", "joint search", "search", search_of(options), "sets_done",
                             (json_int_t)sets_done, "best", rows);
    struct output *output = output_open(path);
    json_dumpf(root, output->stream, JSON_COMPACT); /* doubles with 17 digits: the same numbers when read */
    fputc('\n', output->stream);
    output_close(output);
    json_decref(root);
}

static bool read_best(const json_t *rows, uint64_t functions, struct best *best)
{
    size_t i;
    json_t *row;
    json_array_foreach(rows, i, row)
    {
        json_int_t function;
        double sum;
        if (json_unpack(row, "{s:I, s:F}", "function", &function, "sum", &sum) != 0 || function < 0 ||
            (uint64_t)function >= functions || !isfinite(sum) || sum < 0 || best_has(best, (uint64_t)function))
            return false;
        best_add(best, (struct entry){sum, (uint64_t)function});
    }
    return json_is_array(rows) && json_array_size(rows) <= best->room;
}

void checkpoint_read(const char *path, const struct search_options *options, uint64_t *sets_done, struct best *best)
{
    struct stat status;
    const bool there = stat(path, &status) == 0;
    if (!there && errno == ENOENT)
        return;
    json_error_t error;
    const bool is_file = there && S_ISREG(status.st_mode); /* a pipe would be waited for */
    json_t *root = is_file ? json_load_file(path, 0, &error) : NULL, *search = json_object_get(root, "search");
    json_t *wanted = search_of(options);
    const char *kind = json_string_value(json_object_get(root, "glint"));
    if (!kind || strcmp(kind, "joint search") != 0)
        fail("--checkpoint: %s is not a checkpoint of glint search; name another file, or remove it", path);
    if (!json_equal(search, wanted))
        fail("--checkpoint: %s is of a search with other options; name another file, or remove it", path);
    const double sets = search_first_size(options);
    json_int_t done;
    if (json_unpack(root, "{s:I}", "sets_done", &done) != 0 || done < 0 || (double)done > sets ||
        !read_best(json_object_get(root, "best"), (uint64_t)(sets * fourth_power(options->coefficients.count)), best))
        fail("--checkpoint: %s is damaged; remove it to search from the beginning", path);
    *sets_done = (uint64_t)done;
    json_decref(wanted);
    json_decref(root);
}
