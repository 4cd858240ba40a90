/* SPDX-License-Identifier: MIT
 * glint bake: normals for the table loops, as C source, raw or UF2, and what they cost in quality. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "bake/bake.h"
#include "bake/source.h"
#include "bake/write.h"
#include "base/argp.h"
#include "base/c_names.h"
#include "base/message.h"
#include "base/output.h"
#include "base/parse.h"
#include "commands/commands.h"
#include "compare/quality.h"
#include "compare/compare_json.h"
#include "image/picture.h"
#include "options/scene_options.h"

enum { KEY_TO = 256, KEY_ALBEDO, KEY_AS, KEY_NAME, KEY_ADDRESS, KEY_STRIP, KEY_JSON };

struct request {
    struct scene_options scene;
    enum bake_format format;
    uint32_t entries;
    enum bake_kind kind;
    const char *name, *path;
    struct c_files files;
    uint32_t strip;   /* lines; 0: not given */
    uint32_t address; /* 0: not given */
    bool json;
};

static const struct argp_option options[] = {
    {"albedo", KEY_ALBEDO, "FILE", 0,
     "The surface's colour, for ALBEDO tables: an array of RGB565 beside the normals; alpha is ignored", 2},
    {NULL, 0, NULL, 0, "The output:", 3},
    {"to", KEY_TO, "FORMAT", 0,
     "int16 (6 bytes a pixel), int10 or int8 (4 bytes; default int8), or palette or "
     "palette:ENTRIES (2 bytes, and 6 an entry; 2..32767, default 4096)",
     3},
    {NULL, 'o', "FILE", 0, "The file to write; - is standard output. Without -o only the quality is printed", 3},
    {"as", KEY_AS, "KIND", 0, "c, raw or uf2 (default: by FILE's ending .c, .h, .bin or .uf2; c for -)", 3},
    {"name", KEY_NAME, "NAME", 0, "The array's name in C and C++; default: FILE's name for FILE.c, else baked", 3},
    {"strip", KEY_STRIP, "LINES", 0, "For FILE.c: macros to draw so many lines at once, where RAM holds no whole frame",
     3},
    {"address", KEY_ADDRESS, "ADDRESS", 0,
     "Where a UF2 file goes in the RP2040's flash, a multiple of 4096 from 0x10000000 on; default 0x10100000", 3},
    {"json", KEY_JSON, NULL, 0, "Print the quality as JSON", 3},
    {0}};

static const char doc[] =
    "Turns a height map, a normal map or a built-in scene into the normals that the library's table loops read, and "
    "prints what that costs in quality."
    "\v"
    "Pixels without a surface (mask): int16 has 0, 0, 0; int10 and int8 have z = 0, and the other bits count the "
    "pixels without a surface from this one on in its line; a palette has entry 0, with the normal 0, 0, 0: give it "
    "the background's colour after shading the palette.\n"
    "FILE.c defines the array NAME, lines from the top, and FILE.h beside it declares it, with macros (NAME in "
    "capitals): _WIDTH, _HEIGHT, _STRIDE in bytes, and _FORMAT for glint_tables_rect; for a palette _ENTRIES and the "
    "array NAME_normals, NAME being the offsets; with --strip also _STRIP, _STRIPS, _STRIP_LINES(i) and "
    "_STRIP_START(i). With --albedo there is an array NAME_albedo, too, _ALBEDO_STRIDE and _STRIP_ALBEDO(i). FILE.h "
    "alone and - hold a static array and the enumerators NAME_width and NAME_height.\n"
    "Raw is the same without names, low bytes first, a palette's normals before its offsets, the albedo after the "
    "normals. UF2 is raw in blocks of 256 bytes for the RP2040: flash is erased in sectors of 4096 bytes, so choose an "
    "address beyond the program's "
    "last one.\n"
    "The quality compares the highlight alone, at full strength on white (msh, q = 8, grey8, exact path), with that of "
    "the 16-bit normals, in levels of 255, over nine lights. It is printed to standard output, or to standard error "
    "with -o -.\n"
    "\n"
    "Examples:\n"
    "  glint bake --height wall.png -o wall.c\n"
    "  glint bake --scene watchface --size 240x240 --strip 16 -o dial.c\n"
    "  glint bake --height wall.png --albedo wall-color.png -o wall.c\n"
    "  glint bake --normals brick.png --to palette:1000 -o brick.c\n"
    "  glint bake --scene watchface --size 240x240 --to int8 -o dial.uf2\n"
    "  glint bake --scene coin --to int10 --json\n";

/* ---- options ---- */

static const char *const kind_names[] = {"c", "raw", "uf2", NULL};

static void parse_to(const struct argp_state *state, const char *text, struct request *request)
{
    static const char with_entries[] = "palette:";
    if (strncmp(text, with_entries, strlen(with_entries)) == 0) {
        request->format = BAKE_PALETTE;
        request->entries = (uint32_t)parse_integer(state, "--to palette:ENTRIES", text + strlen(with_entries),
                                                   PALETTE_MIN, PALETTE_MAX);
        return;
    }
    request->format = (enum bake_format)parse_choice(state, "--to", "format", text, bake_format_names);
}

static uint32_t parse_address(const struct argp_state *state, const char *text)
{
    char *end;
    errno = 0;
    const unsigned long long value = strtoull(text, &end, 0);
    if (strspn(text, "0123456789xXabcdefABCDEF") != strlen(text) || !*text || *end || errno || value < FLASH_BASE ||
        value >= FLASH_END || value % FLASH_SECTOR)
        refuse(state, "--address: '%s' is not a multiple of %d from 0x%x to 0x%x", text, FLASH_SECTOR, FLASH_BASE,
               FLASH_END - FLASH_SECTOR);
    return (uint32_t)value;
}

static enum bake_kind kind_by_ending(const struct argp_state *state, const char *path)
{
    static const struct {
        const char *ending;
        enum bake_kind kind;
    } endings[] = {{".c", BAKE_C}, {".h", BAKE_C}, {".bin", BAKE_RAW}, {".uf2", BAKE_UF2}};
    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof endings / sizeof *endings; i++)
        if (strcasecmp(dot, endings[i].ending) == 0)
            return endings[i].kind;
    refuse(state, "-o: '%s' does not end in .c, .h, .bin or .uf2; rename it, or give --as", path);
}

static bool is_stdout(const char *path)
{
    return path && strcmp(path, "-") == 0;
}

static void check(const struct argp_state *state, struct request *request)
{
    const bool to_stdout = is_stdout(request->path);
    if (request->scene.albedo && request->format == BAKE_PALETTE)
        refuse(state, "--albedo cannot be used with --to palette, whose entries have one colour each");
    if (!request->path &&
        (request->kind != BAKE_KINDS || request->name || request->address || request->strip || request->scene.albedo))
        refuse(state, "no output; give -o FILE");
    if (!request->path)
        return;
    if (request->kind == BAKE_KINDS)
        request->kind = to_stdout ? BAKE_C : kind_by_ending(state, request->path);
    if (request->kind == BAKE_C && !to_stdout)
        parse_c_files(state, request->path, &request->name, "_WIDTH", &request->files);
    if (request->strip && !request->files.header)
        refuse(state, "--strip is for C source in a FILE.c; leave it out, or give -o FILE.c");
    if (request->name && request->kind != BAKE_C)
        refuse(state, "--name is for C source; it cannot be used with --as %s", kind_names[request->kind]);
    if (request->address && request->kind != BAKE_UF2)
        refuse(state, "--address is for UF2; it cannot be used with --as %s", kind_names[request->kind]);
    if (request->scene.albedo && request->kind == BAKE_UF2)
        refuse(state, "--albedo cannot be used with --as uf2: the Pico's firmware has one colour");
    if (to_stdout && request->kind != BAKE_C && isatty(STDOUT_FILENO))
        refuse(state, "-o -: standard output is a terminal; pipe or redirect it, or name a file");
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct request *request = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &request->scene;
        return 0;
    case KEY_ALBEDO:
        request->scene.albedo = text;
        return 0;
    case KEY_TO:
        parse_to(state, text, request);
        return 0;
    case KEY_AS:
        request->kind = (enum bake_kind)parse_choice(state, "--as", "file format", text, kind_names);
        return 0;
    case KEY_NAME:
        request->name = parse_c_name(state, text);
        return 0;
    case KEY_ADDRESS:
        request->address = parse_address(state, text);
        return 0;
    case KEY_STRIP:
        request->strip = (uint32_t)parse_integer(state, "--strip", text, 1, SIDE_MAX);
        return 0;
    case KEY_JSON:
        request->json = true;
        return 0;
    case 'o':
        request->path = parse_output(state, "-o", text);
        return 0;
    case ARGP_KEY_ARG:
        refuse(state, "unexpected argument '%s'; name files by --height, --normals, --mask and -o", text);
    case ARGP_KEY_END:
        check(state, request);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* ---- the report ---- */

static void print_text(const struct baked *baked, const struct quality *rows, FILE *stream)
{
    fprintf(stream, "%s, %" PRIu32 "x%" PRIu32 ", %zu bytes", bake_format_names[baked->format], baked->width,
            baked->height, baked_bytes(baked));
    if (baked->format == BAKE_PALETTE)
        fprintf(stream, ", %" PRIu32 " entries (the first is no surface)", baked->entries);
    fputc('\n', stream);
    if (rows[0].difference.samples == 0) {
        fputs("no surface: the mask leaves every pixel out\n", stream);
        return;
    }
    fputs("   n  largest     mean  PSNR dB  in levels of 255, the highlight alone\n", stream);
    for (int i = 0; i < QUALITY_ROWS; i++) {
        const struct difference *d = &rows[i].difference;
        fprintf(stream, "%4u  %7.0f  %7.4f  ", rows[i].n, d->largest, difference_mean(d));
        if (d->differing)
            fprintf(stream, "%7.2f\n", difference_psnr_db(d));
        else
            fputs("no difference\n", stream);
    }
}

static void report(const struct request *request, const struct scene *scene, const struct baked *baked)
{
    const bool to_stdout = is_stdout(request->path);
    FILE *stream = to_stdout ? stderr : stdout;
    struct quality rows[QUALITY_ROWS];
    bake_quality(scene, baked, rows);
    (request->json ? quality_print_json : print_text)(baked, rows, stream);
    if (fflush(stream) != 0 || ferror(stream))
        fail("standard %s: the quality could not be written", to_stdout ? "error" : "output");
}

/* ---- the command ---- */

static void write_baked(const struct request *request, const struct baked *baked, FILE *out)
{
    switch (request->kind) {
    case BAKE_RAW:
        bake_write_raw(baked, out);
        return;
    case BAKE_UF2:
        bake_write_uf2(baked, request->address, out);
        return;
    default:
        if (request->files.header)
            bake_write_definitions(baked, request->name, request->files.within, out);
        else
            bake_write_c(baked, request->name ? request->name : "baked", out);
    }
}

int command_bake(int argc, char **argv)
{
    static const struct argp_child children[] = {{&scene_options_argp, 0, NULL, 0}, {NULL, 0, NULL, 0}};
    static const struct argp argp = {options, parse_option, NULL, doc, children, NULL, NULL};
    struct request request = {.format = BAKE_INT8, .entries = PALETTE_DEFAULT, .kind = BAKE_KINDS};
    parse_command(&argp, 0, argc, argv, &request);
    if (!request.address)
        request.address = FLASH_DEFAULT;
    struct scene *scene = scene_of_options(&request.scene);
    struct baked *baked = bake(scene, request.format, request.entries);
    if (request.scene.albedo)
        bake_albedo(baked, scene);
    if (request.kind == BAKE_UF2 && baked_bytes(baked) > FLASH_END - request.address)
        fail("%s: %zu bytes do not fit from 0x%" PRIx32 " to the flash's end at 0x%x; choose a lower --address, a "
             "smaller --size or another --to",
             request.path, baked_bytes(baked), request.address, FLASH_END);
    struct output *output = request.path ? output_open(request.path) : NULL;
    struct output *header = request.files.header ? output_open(request.files.header) : NULL;
    if (header)
        bake_write_header(baked, request.name, request.strip, header->stream);
    if (output)
        write_baked(&request, baked, output->stream);
    if (output && is_stdout(request.path)) {
        output_close(output); /* an error there is the last word */
        output = NULL;
    }
    report(&request, scene, baked);
    if (header) /* files get their names when all is said */
        output_close(header);
    if (output)
        output_close(output);
    c_files_free(&request.files);
    baked_free(baked);
    scene_free(scene);
    return EXIT_GOOD;
}
