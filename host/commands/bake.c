/* SPDX-License-Identifier: MIT
 * glint bake: normals as the library draws them, as C source, raw or UF2, and what they cost in quality. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "bake/bake.h"
#include "bake/mesh_files.h"
#include "bake/source.h"
#include "bake/uf2.h"
#include "bake/write.h"
#include "base/argp.h"
#include "base/c_names.h"
#include "base/message.h"
#include "base/output_pair.h"
#include "base/parse.h"
#include "commands/commands.h"
#include "compare/compare_json.h"
#include "compare/mesh_cost.h"
#include "compare/mesh_quality.h"
#include "compare/quality_report.h"
#include "image/picture.h"
#include "options/map_options.h"
#include "options/mesh_options.h"
#include "options/scene_options.h"
#include "scene/filter.h"

enum { KEY_TO = 256, KEY_UNIT, KEY_ALBEDO, KEY_AS, KEY_NAME, KEY_ADDRESS, KEY_STRIP, KEY_JSON };

struct request {
    struct scene_options scene;
    enum bake_format format;
    uint32_t entries;
    enum bake_kind kind;
    const char *name, *path;
    struct c_files files;
    uint32_t strip;   /* lines; 0: not given */
    double unit;      /* 0: not given */
    unsigned n;       /* 0: not given */
    uint32_t address; /* 0: not given */
    bool json;
};

static const struct argp_option options[] = {
    {"albedo", KEY_ALBEDO, "FILE", 0,
     "The surface's colour, for ALBEDO tables: an array of RGB565 beside the normals; alpha is ignored", 2},
    {"unit", KEY_UNIT, "N", 0,
     "Scale a mesh so that a length of 1 in its file becomes N (at most 32767), about its own origin; several meshes "
     "then keep their sizes (default: as large as fits, about its middle)",
     7},
    {NULL, 'n', "N", 0, "For --filter: the material's shininess, 1..1000 (default 60, or the scene's own)", 2},
    {NULL, 0, NULL, 0, "The output:", 3},
    {"to", KEY_TO, "FORMAT", 0,
     "int16 (6 bytes a pixel) or int8 (4 bytes; default), or palette or "
     "palette:ENTRIES (2 bytes, and 6 an entry; 2..32767, default 4096). A mesh's normals: int16 (6 bytes a vertex) or "
     "int8 (3 bytes; default)",
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
    "Turns a height map, a normal map or a built-in scene into the normals that glint_draw_rect takes, or a "
    "mesh into what glint_mesh_add takes, and prints what that costs in quality."
    "\v"
    "Pixels without a surface (mask): int16 has 0, 0, 0, which tables leave undrawn (the exact paint needs coverage "
    "for "
    "that); int8 has z = 0, and the other bits count the pixels without a surface from this one on in its line; a "
    "palette has entry 0, with the normal 0, 0, 0: give it the background's colour after drawing the palette.\n"
    "FILE.c defines the array NAME, lines from the top, and FILE.h beside it declares it, with macros (NAME in "
    "capitals): _WIDTH, _HEIGHT, _STRIDE in bytes, and _FORMAT for struct glint_maps; for a palette _ENTRIES and the "
    "array NAME_normals, NAME being the offsets; with --strip also _STRIP, _STRIPS, _STRIP_LINES(i) and "
    "_STRIP_START(i). With --albedo there is an array NAME_albedo, too, _ALBEDO_STRIDE and _STRIP_ALBEDO(i). Of soft "
    "edges there is NAME_coverage, of --grain FILE "
    "NAME_grain, of --filter NAME_shininess and NAME_gloss (how details shade each other is in NAME_albedo): a byte a "
    "pixel each, for struct glint_maps, with "
    "_STRIP_MAP(map, i). FILE.h "
    "alone and - hold a static array and the enumerators NAME_width and NAME_height.\n"
    "Raw is the same without names, low bytes first, a palette's normals before its offsets, the albedo after the "
    "normals, then coverage, grain, shininess and gloss, those that there are. UF2 is raw in blocks of 256 bytes for "
    "the RP2040: flash is erased in sectors of 4096 bytes, so choose an "
    "address beyond the program's "
    "last one.\n"
    "Of a mesh, FILE.c defines the struct glint_mesh NAME and NAME_materials, a struct glint_material for each of its "
    "parts (q = 0: what the output needs), where its vertices have colours of_vertices, neighbours for smooth outlines "
    "(but for --no-outlines), and where it has textures "
    "these, with each vertex's u and v; FILE.h has "
    "the macros NAME_VERTICES, NAME_FACES and NAME_PARTS. Raw has, 16 bits a number unless bytes are named, and a 0 "
    "after an odd number of bytes:\n"
    "  vertices, triangles, parts, layout\n"
    "  x, y, z of each vertex; its normal (1 or 2 bytes a number)\n"
    "  three vertices of each triangle; the three triangles beside each\n"
    "  the triangle before which each part ends\n"
    "  bytes: red, green, blue, 1 if unlit of each part; colours of vertices\n"
    "  uv_bits, the number of pictures; u and v of each vertex\n"
    "  of each part its picture's number from 1 on, or 0; 1 if smooth\n"
    "  of each picture width, height, levels, colours of its palette; these\n"
    "  and its pixels of all levels, bytes if there is a palette\n"
    "\n"
    "The layout is 1 or 2, the bytes of a normal's number, and 256 more with colours of vertices, 512 with neighbours, "
    "1024 with textures; what it does not name is left out.\n"
    "A mesh's quality is that of whole pictures of 240x240 "
    "from three sides, exact and without textures, against double precision with normals normalised at each pixel.\n"
    "The quality of the others compares the highlight alone, at full strength on white (msh, q = 8, grey8, exact "
    "path), with that of "
    "the 16-bit normals, in levels of 255, over nine lights. It is printed to standard output, or to standard error "
    "with -o -.\n"
    "\n"
    "Examples:\n"
    "  glint bake --height wall.png -o wall.c\n"
    "  glint bake --scene watchface --size 240x240 --strip 16 -o dial.c\n"
    "  glint bake --height wall.png --albedo wall-color.png -o wall.c\n"
    "  glint bake --normals brick.png --to palette:1000 -o brick.c\n"
    "  glint bake --scene watchface --size 240x240 --to int8 -o dial.uf2\n"
    "  glint bake --scene coin --to int16 --json\n"
    "  glint bake --mesh part.stl --split 20 -o part.c\n"
    "  glint bake --mesh crate.gltf --texture-bytes 65536 -o crate.c\n";

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

static void check_mesh(const struct argp_state *state, const struct request *request)
{
    if (!request->scene.mesh.name && request->unit > 0)
        refuse(state, "--unit needs --mesh");
    if (!request->scene.mesh.name)
        return;
    if (request->format != BAKE_INT16 && request->format != BAKE_INT8)
        refuse(state, "--to %s is for maps; a mesh's normals are int16 or int8", bake_format_names[request->format]);
    if (request->strip || request->scene.width)
        refuse(state, "%s is for maps; it cannot be used with a mesh", request->strip ? "--strip" : "--size");
}

static void check(const struct argp_state *state, struct request *request)
{
    const bool to_stdout = request->path && strcmp(request->path, "-") == 0;
    check_mesh(state, request);
    if (request->scene.has_grain && !request->scene.grain_map)
        refuse(state, "--grain: of grain a FILE alone is baked; give another kind to %s",
               request->scene.mesh.name ? "struct glint_mesh, by grain and use_grain"
                                        : "struct glint_maps, by grain_kind and grain_at");
    if (request->n && !request->scene.filter)
        refuse(state, "-n is for --filter N; leave it out");
    if (request->format == BAKE_PALETTE && (request->scene.filter || request->scene.grain_map))
        refuse(state, "%s cannot be used with --to palette, which has no maps beside it",
               request->scene.filter ? "--filter" : "--grain");
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
    if (output_is_standard(request->path) && request->kind != BAKE_C && isatty(STDOUT_FILENO))
        refuse(state, "-o -: standard output is a terminal; pipe or redirect it, or name a file");
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct request *request = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = state->child_inputs[1] = state->child_inputs[2] = &request->scene;
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
    case 'n':
        request->n = (unsigned)parse_integer(state, "-n", text, 1, GLINT_N_MAX);
        return 0;
    case KEY_UNIT:
        request->unit = parse_real(state, "--unit", text, 1e-6, 1e6);
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
        scene_options_argument(state, text, &request->scene);
        return 0;
    case ARGP_KEY_END:
        check(state, request);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
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

static FILE *report_stream(const struct request *request)
{
    return request->path && output_is_standard(request->path) ? stderr : stdout;
}

static void check_flash(const struct request *request, size_t bytes)
{
    if (request->kind == BAKE_UF2 && bytes > FLASH_END - request->address)
        fail("%s: %zu bytes do not fit from 0x%" PRIx32 " to the flash's end at 0x%x; choose a lower --address, a "
             "smaller --size or another --to",
             request->path, bytes, request->address, FLASH_END);
}

static void write_mesh(const struct request *request, const struct baked_mesh *baked, FILE *out)
{
    size_t len;
    uint8_t *raw = bake_mesh_raw(baked, &len);
    check_flash(request, len);
    if (request->kind == BAKE_RAW)
        fwrite(raw, 1, len, out); /* output_close looks whether it could */
    else if (request->kind == BAKE_UF2)
        uf2_write(raw, len, request->address, UF2_RP2040, out);
    else if (request->files.header)
        bake_mesh_write_definitions(baked, request->name, request->files.within, out);
    else
        bake_mesh_write_c(baked, request->name ? request->name : "baked", out);
    free(raw);
}

static void bake_mesh(const struct request *request)
{
    struct mesh *mesh = mesh_load(&request->scene.mesh);
    struct fitted *fitted = mesh_fit(mesh, request->unit);
    if (request->scene.mesh.stepped)
        fitted_forget_neighbours(fitted);
    struct glint_material *materials = mesh_materials(mesh);
    const struct baked_mesh baked = {mesh, fitted, materials, request->format == BAKE_INT8};
    struct mesh_cycles cycles = {0, 0};
    struct quality rows[QUALITY_ROWS];
    struct output_pair outputs = output_pair_open(request->path, request->files.header);
    if (outputs.header)
        bake_mesh_write_header(&baked, request->name, outputs.header->stream);
    if (outputs.source)
        write_mesh(request, &baked, outputs.source->stream);
    output_pair_end_standard(&outputs);
    mesh_quality(mesh, fitted, baked.normals8, rows);
    for (int i = 0; i < MESH_VIEWS; i++) {
        const struct mesh_cycles of_one = mesh_cycles(mesh, fitted, &mesh_views[i]);
        cycles.c += of_one.c / MESH_VIEWS;
        cycles.assembly += of_one.assembly / MESH_VIEWS;
    }
    (request->json ? quality_print_mesh_json : quality_print_mesh)(&baked, rows, cycles, report_stream(request));
    quality_printed(report_stream(request));
    output_pair_close(&outputs);
    free(materials);
    fitted_free(fitted);
    mesh_free(mesh);
}

static void bake_map(const struct request *request)
{
    static const uint8_t white[3] = {255, 255, 255};
    struct scene *scene = scene_of_options(&request->scene);
    scene_soften(scene, request->n ? request->n : scene->finish.n, white);
    struct baked *baked = bake(scene, request->format, request->entries);
    struct quality rows[QUALITY_ROWS];
    if (request->scene.albedo)
        bake_albedo(baked, scene);
    check_flash(request, baked_bytes(baked));
    struct output_pair outputs = output_pair_open(request->path, request->files.header);
    if (outputs.header)
        bake_write_header(baked, request->name, request->strip, outputs.header->stream);
    if (outputs.source)
        write_baked(request, baked, outputs.source->stream);
    output_pair_end_standard(&outputs);
    bake_quality(scene, baked, rows);
    (request->json ? quality_print_json : quality_print)(baked, rows, report_stream(request));
    quality_printed(report_stream(request));
    output_pair_close(&outputs);
    baked_free(baked);
    scene_free(scene);
}

int command_bake(int argc, char **argv)
{
    static const struct argp_child children[] = {{&scene_options_argp, 0, NULL, 0},
                                                 {&map_options_argp, 0, NULL, 0},
                                                 {&mesh_options_argp, 0, NULL, 0},
                                                 {NULL, 0, NULL, 0}};
    static const struct argp argp = {options, parse_option, SCENE_ARGUMENT, doc, children, NULL, NULL};
    struct request request = {.format = BAKE_INT8, .entries = PALETTE_DEFAULT, .kind = BAKE_KINDS};
    parse_command(&argp, 0, argc, argv, &request);
    if (!request.address)
        request.address = FLASH_DEFAULT;
    (request.scene.mesh.name ? bake_mesh : bake_map)(&request);
    c_files_free(&request.files);
    return EXIT_GOOD;
}
