/* SPDX-License-Identifier: MIT
 * glint table: a lobe as a table, or the tables of a paint, as C source for flash or raw. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bake/flash_tables.h"
#include "bake/lobe_table.h"
#include "base/argp.h"
#include "base/c_names.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/output_pair.h"
#include "base/parse.h"
#include "commands/commands.h"
#include "draw/paths.h"
#include "image/format.h"
#include "models/models.h"
#include "options/shading_options.h"
#include "scene/scenes.h"

enum { KEY_KIND = 384, KEY_OF, KEY_ENTRIES, KEY_BITS, KEY_NAME, KEY_RAW, KEY_SHININESS, KEY_CUTOFF };

struct request {
    struct shading_options look;
    int kind; /* enum glint_tables_kind; -1: a table of the highlight alone */
    bool raw, is_lobe_option;
    const char *name, *path;
    struct c_files files;
    struct lobe_table table;
};

/* Beside those of shading_options.c, which --kind needs; of these the highlight's alone. */
static const struct argp_option options[] = {
    {NULL, 0, NULL, 0, "The table:", 5},
    {"kind", KEY_KIND, "KIND", 0,
     "Not the highlight alone but tables for glint_paint_tables_filled, which draw as glint render --path does: "
     "colour (20,480 bytes, with --dither 20,608) or albedo (8,584)",
     5},
    {"of", KEY_OF, "c|t", 0, "The argument: the cosine c, or t = 1 - c (default), which is finer near the peak", 5},
    {"entries", KEY_ENTRIES, "COUNT", 0, "Entries, 2 to 65536; default 256", 5},
    {"bits", KEY_BITS, "BITS", 0, "Bits an entry: 8 (1.0 is 255), 16 (1.0 is 32768; default) or 32 (1.0 is 65536)", 5},
    {"shininess", KEY_SHININESS, "N", 0, "The same as -n", 5},
    {"cutoff", KEY_CUTOFF, "Q", 0,
     "The same as -q: the table ends where the highlight falls below 2^-Q; of the highlight alone 0 is a cutoff at 1",
     5},
    {"name", KEY_NAME, "NAME", 0,
     "The array's name in C and C++ (default: FILE's for FILE.c, else from the material, such as msh_n60_q8)", 6},
    {"raw", KEY_RAW, NULL, 0, "Write only the entries, low byte first", 6},
    {"output", 'o', "FILE", 0, "Write to FILE (default: -, standard output)", 6},
    {0}};

static const char doc[] =
    "Writes a material's highlight as a table: C source for flash, with its look-up functions, or raw; or the tables "
    "of a paint."
    "\v"
    "FILE.c defines the array NAME, and FILE.h beside it declares it, with NAME_ENTRIES and NAME_SHIFT in capitals. "
    "Any other FILE and - hold a static array.\n"
    "The argument is the distance from the peak, x = t_q30 or x = 65536 - c_q16. Entry i is the library's value at "
    "x = i 2^SHIFT; SHIFT is the smallest for which the last entry lies beyond the cutoff and is 0. The C source "
    "states SHIFT and the largest measured errors of the nearest entry and of linear interpolation. Of the options of "
    "glint render only --model, -n, -q and --clamp-peak count.\n"
    "With --kind, NAME is a struct glint_tables in constant memory, as glint_paint_tables would have filled it for the "
    "material, colours and format that the options describe (--format: default rgb565). Lights are not part of it.\n"
    "\n"
    "Examples:\n"
    "  glint table --model msh -n 60 -o msh_n60_q8.h\n"
    "  glint table --model gauss -n 200 --of c --entries 64 --bits 8 -o shine.c\n"
    "  glint table --model blinn -n 20 --bits 32 --raw -o blinn.bin\n"
    "  glint table --kind colour -n 60 --color 200,120,40 -o copper.c";

/* ---- the command ---- */

static bool has_look(const struct shading_options *look)
{
    const struct scene_options *scene = &look->scene;
    const struct shading *shading = &look->shading;
    return look->has_color || look->has_view || shading->n_across || look->has_light || look->has_format ||
           shading->space || shading->dither || scene->scene || !isnan(shading->ambient[0]) ||
           !isnan(shading->diffuse[0]) || !isnan(shading->specular[0]);
}

static void check(const struct argp_state *state, struct request *request)
{
    if (request->raw && request->name)
        refuse(state, "--name is for C source; it cannot be used with --raw");
    if (request->raw && output_is_standard(request->path) && isatty(STDOUT_FILENO))
        refuse(state, "--raw: standard output is a terminal; pipe or redirect it, or name a file by -o");
    if (request->kind < 0 && has_look(&request->look))
        refuse(state,
               "the highlight alone has --model, -n, -q and --clamp-peak; other options of glint render need --kind");
    if (request->kind >= 0 && (request->is_lobe_option || request->raw))
        refuse(state, "--of, --entries, --bits and --raw are for the highlight alone; leave them out with --kind");
    if (!request->raw)
        parse_c_files(state, request->path, &request->name, "_ENTRIES", &request->files);
}

static error_t parse_option(int key, char *argument, struct argp_state *state)
{
    static const char *const arguments[] = {"c", "t", NULL};
    struct request *request = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &request->look;
        return 0;
    case KEY_KIND:
        request->kind = (int)parse_choice(state, "--kind", "kind of tables", argument, tables_kind_names);
        return 0;
    case KEY_SHININESS:
        request->look.shading.n = (unsigned)parse_integer(state, "-n", argument, 1, GLINT_N_MAX);
        request->look.roughness = NAN;
        return 0;
    case KEY_CUTOFF:
        request->look.shading.q = (unsigned)parse_integer(state, "-q", argument, 0, GLINT_Q_MAX);
        return 0;
    case KEY_OF:
        request->table.of_t = parse_choice(state, "--of", "argument", argument, arguments) == 1;
        request->is_lobe_option = true;
        return 0;
    case KEY_ENTRIES:
        request->table.count = (uint32_t)parse_integer(state, "--entries", argument, 2, 65536);
        request->is_lobe_option = true;
        return 0;
    case KEY_BITS:
        if (strcmp(argument, "8") != 0 && strcmp(argument, "16") != 0 && strcmp(argument, "32") != 0)
            refuse(state, "--bits: '%s' is not 8, 16 or 32", argument);
        request->table.bits = (unsigned)strtoul(argument, NULL, 10);
        request->is_lobe_option = true;
        return 0;
    case KEY_NAME:
        request->name = parse_c_name(state, argument);
        return 0;
    case KEY_RAW:
        request->raw = true;
        return 0;
    case 'o':
        request->path = parse_output(state, "-o", argument);
        return 0;
    case ARGP_KEY_ARG:
        refuse(state, "unexpected argument '%s'; name the file by -o", argument);
        return 0;
    case ARGP_KEY_END:
        check(state, request);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* A scene's own finish, or the plain one. */
static struct shading shading_of_request(const struct request *request)
{
    const bool is_rgb565 = request->kind >= 0 && !request->look.has_format;
    return shading_of_options(&request->look, is_rgb565 ? GLINT_RGB565 : request->look.shading.format,
                              scene_finish(request->look.scene.scene));
}

/* Of the highlight alone -q 0 is a cutoff at 1, not the usual one. */
static unsigned cutoff_of(const struct request *request, const struct shading *shading)
{
    return request->kind < 0 && request->look.shading.q == 0 ? 0 : shading->q;
}

static void write_lobe(struct request *request, const struct shading *shading, const char *name)
{
    struct lobe_table *table = &request->table;
    glint_lobe_init(&table->lobe, shading->model, shading->n, cutoff_of(request, shading));
    table->clamp_peak = shading->clamp_peak;
    lobe_table_fill(table);
    struct output_pair outputs = output_pair_open(request->path, request->files.header);
    FILE *const stream = outputs.source->stream;
    if (request->raw) {
        lobe_table_write_raw(table, stream);
    } else if (outputs.header) {
        lobe_table_write_header(table, name, outputs.header->stream);
        lobe_table_write_definition(table, name, request->files.within, stream);
    } else {
        lobe_table_write_c(table, name, stream);
    }
    output_pair_close(&outputs);
    free(table->entries);
}

/* The reasons for which the library would refuse are those of the path over such tables. */
static void write_tables(const struct request *request, struct shading shading, const char *name)
{
    const enum glint_tables_kind kind = (enum glint_tables_kind)request->kind;
    char path[32];
    snprintf(path, sizeof path, "%s-int16", tables_kind_names[kind]);
    while (path_names[shading.path] && strcmp(path_names[shading.path], path) != 0)
        shading.path++;
    if (path_refusal(&shading))
        fail("--kind %s: %s", tables_kind_names[kind], path_refusal(&shading));
    struct flash_tables flash;
    const struct glint_material material = shading_material(&shading);
    const struct glint_output output = shading_output(&shading);
    if (flash_tables_fill(&flash, kind, &material, &output) != GLINT_OK)
        fail("--kind %s: needs a grey --ambient and --diffuse of at most 1 together, as --ambient .1 --diffuse .9",
             tables_kind_names[kind]);
    flash.about = formatted("%s, n = %u, q = %u, %s, %s", model_names[shading.model], shading.n, shading.q,
                            format_names[shading.format], space_names[shading.space]);
    struct output_pair outputs = output_pair_open(request->path, request->files.header);
    FILE *const stream = outputs.source->stream;
    if (outputs.header) {
        flash_tables_write_header(&flash, name, outputs.header->stream);
        flash_tables_write_definition(&flash, name, request->files.within, stream);
    } else {
        flash_tables_write_c(&flash, name, stream);
    }
    output_pair_close(&outputs);
    flash_tables_free(&flash);
}

int command_table(int argc, char **argv)
{
    static const struct argp_child children[] = {{&shading_options_argp, 0, NULL, 0}, {NULL, 0, NULL, 0}};
    static const struct argp argp = {options, parse_option, NULL, doc, children, NULL, NULL};
    struct request request = {.kind = -1, .path = "-"};
    request.table = (struct lobe_table){.of_t = true, .bits = 16, .count = 256};
    parse_command(&argp, 0, argc, argv, &request);
    const struct shading shading = shading_of_request(&request);
    char plain_name[64];
    snprintf(plain_name, sizeof plain_name, "%s_n%u_q%u", model_names[shading.model], shading.n,
             cutoff_of(&request, &shading));
    const char *name = request.name ? request.name : plain_name;
    if (request.kind < 0)
        write_lobe(&request, &shading, name);
    else
        write_tables(&request, shading, name);
    c_files_free(&request.files);
    return EXIT_GOOD;
}
