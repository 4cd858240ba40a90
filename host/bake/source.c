/* SPDX-License-Identifier: MIT */
#include "bake/source.h"

#include <inttypes.h>

#include "bake/c_source.h"

/* ---- arrays ---- */

static void write_vectors(FILE *out, const struct glint_vec *vectors, size_t count)
{
    for (size_t i = 0; i < count; i++)
        fprintf(out, "%s{%d, %d, %d}%s", i % 6 ? " " : "\n    ", vectors[i].x, vectors[i].y, vectors[i].z,
                i + 1 < count ? "," : "");
}

static const char *const notes[] = {
    [BAKE_INT16] =
        "For struct glint_maps with GLINT_NORMALS_INT16; 0, 0, 0 where there is no surface: tables leave these "
        "pixels,\n * the exact paint needs coverage for that",
    [BAKE_INT8] = "For struct glint_maps with GLINT_NORMALS_INT8; z = 0 where there is no surface, with how many "
                  "pixels to the right",
    [BAKE_PALETTE] =
        ("A palette of normals, to be drawn once a frame as one line, and for each pixel twice its entry, for\n"
         " * glint_draw_palette. Entry 0 is no surface: after drawing, give it the background's colour")};

static const char albedo_note[] =
    "For struct glint_maps and a paint of ALBEDO tables; a normal is 0 where there is no surface, the "
    "albedo\n * is GLINT_RGB565 in the machine's order";

static size_t pixels_of(const struct baked *baked)
{
    return (size_t)baked->width * baked->height;
}

static void write_note(const struct baked *baked, FILE *out)
{
    fprintf(out,
            "/* Written by glint bake, version " GLINT_VERSION_STRING ": normals as %s, %" PRIu32 "x%" PRIu32
            ", %zu bytes.\n * %s. */\n",
            bake_format_names[baked->format], baked->width, baked->height, baked_bytes(baked),
            baked->albedo ? albedo_note : notes[baked->format]);
}

/* The array NAME has an element a pixel, in each format. */
static const char *element_type(const struct baked *baked)
{
    return baked->format == BAKE_INT16 ? "struct glint_vec" : baked->format == BAKE_PALETTE ? "uint16_t" : "uint32_t";
}

static void write_elements(const struct baked *baked, FILE *out)
{
    const size_t pixels = pixels_of(baked);
    if (baked->format == BAKE_INT16) {
        write_vectors(out, baked->normals, pixels);
        return;
    }
    for (size_t i = 0; i < pixels; i++)
        if (baked->format == BAKE_PALETTE)
            fprintf(out, "%s%u%s", i % 16 ? " " : "\n    ", baked->offsets[i], i + 1 < pixels ? "," : "");
        else
            fprintf(out, "%s0x%08" PRIx32 "u%s", i % 8 ? " " : "\n    ", baked->words[i], i + 1 < pixels ? "," : "");
}

static void write_albedo(const struct baked *baked, FILE *out)
{
    const size_t pixels = pixels_of(baked);
    for (size_t i = 0; i < pixels; i++)
        fprintf(out, "%s0x%04x%s", i % 12 ? " " : "\n    ", baked->albedo[i], i + 1 < pixels ? "," : "");
}

static void write_bytes(const uint8_t *map, size_t pixels, FILE *out)
{
    for (size_t i = 0; i < pixels; i++)
        fprintf(out, "%s%u%s", i % 24 ? " " : "\n    ", map[i], i + 1 < pixels ? "," : "");
}

/* ---- one file ---- */

void bake_write_c(const struct baked *baked, const char *name, FILE *out)
{
    write_note(baked, out);
    fprintf(out, "#include %s\n\n", baked->normals ? "\"glint.h\"" : "<stdint.h>");
    fprintf(out, "enum { %s_width = %" PRIu32 ", %s_height = %" PRIu32, name, baked->width, name, baked->height);
    if (baked->format == BAKE_PALETTE)
        fprintf(out, ", %s_entries = %" PRIu32, name, baked->entries);
    fputs(" };\n\n", out);
    if (baked->format == BAKE_PALETTE) {
        fprintf(out, "static const struct glint_vec %s_normals[%" PRIu32 "] = {", name, baked->entries);
        write_vectors(out, baked->normals, baked->entries);
        fputs("\n};\n\n", out);
    }
    fprintf(out, "static const %s %s[%zu] = {", element_type(baked), name, pixels_of(baked));
    write_elements(baked, out);
    fputs("\n};\n", out);
    if (baked->albedo) {
        fprintf(out, "\nstatic const uint16_t %s_albedo[%zu] = {", name, pixels_of(baked));
        write_albedo(baked, out);
        fputs("\n};\n", out);
    }
    for (unsigned k = 0; k < BAKED_MAPS; k++) {
        if (!baked->maps[k])
            continue;
        fprintf(out, "\n/* %s */\nstatic const uint8_t %s_%s[%zu] = {", baked_map_meanings[k], name, baked_map_names[k],
                pixels_of(baked));
        write_bytes(baked->maps[k], pixels_of(baked), out);
        fputs("\n};\n", out);
    }
}

/* ---- a header and definitions ---- */

/* The last strip may be shorter than the others. */
static void write_strip_macros(const char *name, const char *macro, uint32_t height, uint32_t strip, FILE *out)
{
    const uint32_t strips = (height + strip - 1) / strip;
    fprintf(out,
            "\n/* Drawn in strips: strip i, from 0, has %s_STRIP_LINES(i) lines, which begin at %s_STRIP_START(i). */\n"
            "#define %s_STRIP %" PRIu32 " /* lines; the last strip may have fewer */\n"
            "#define %s_STRIPS %" PRIu32 "\n"
            "#define %s_STRIP_LINES(i) ((i) + 1 < %s_STRIPS ? %s_STRIP : %" PRIu32 ")\n"
            "#define %s_STRIP_START(i) (%s + (size_t)(i) * %s_STRIP * %s_WIDTH)\n",
            macro, macro, macro, strip, macro, strips, macro, macro, macro, height - (strips - 1) * strip, macro, name,
            macro, macro);
}

void bake_write_header(const struct baked *baked, const char *name, uint32_t strip, FILE *out)
{
    static const char *const formats[] = {
        [BAKE_INT16] = "GLINT_NORMALS_INT16", [BAKE_INT8] = "GLINT_NORMALS_INT8", [BAKE_PALETTE] = NULL};
    static const int bytes[] = {[BAKE_INT16] = 6, [BAKE_INT8] = 4, [BAKE_PALETTE] = 2};
    const struct c_capitals capitals = c_capitals(name);
    const char *macro = capitals.text;
    write_note(baked, out);
    c_begin_header(name, "<stddef.h>\n\n#include \"glint.h\"", out);
    fprintf(out, "\n#define %s_WIDTH %" PRIu32 "\n#define %s_HEIGHT %" PRIu32 "\n", macro, baked->width, macro,
            baked->height);
    fprintf(out, "#define %s_STRIDE %" PRIu32 " /* bytes from a line to the next */\n", macro,
            (uint32_t)bytes[baked->format] * baked->width);
    if (formats[baked->format])
        fprintf(out, "#define %s_FORMAT %s\n", macro, formats[baked->format]);
    else
        fprintf(out, "#define %s_ENTRIES %" PRIu32 "\n", macro, baked->entries);
    if (baked->albedo)
        fprintf(out, "#define %s_ALBEDO_STRIDE %" PRIu32 "\n", macro, 2 * baked->width);
    if (strip)
        write_strip_macros(name, macro, baked->height, strip, out);
    if (strip && baked->albedo)
        fprintf(out, "#define %s_STRIP_ALBEDO(i) (%s_albedo + (size_t)(i) * %s_STRIP * %s_WIDTH)\n", macro, name, macro,
                macro);
    for (unsigned k = 0; k < BAKED_MAPS && strip; k++)
        if (baked->maps[k]) {
            fprintf(out, "#define %s_STRIP_MAP(map, i) ((map) + (size_t)(i) * %s_STRIP * %s_WIDTH)\n", macro, macro,
                    macro);
            break;
        }
    c_begin_externs(out);
    if (baked->format == BAKE_PALETTE)
        fprintf(out, "extern const struct glint_vec %s_normals[%s_ENTRIES];\n", name, macro);
    fprintf(out, "extern const %s %s[(size_t)%s_WIDTH * %s_HEIGHT];\n", element_type(baked), name, macro, macro);
    if (baked->albedo)
        fprintf(out, "extern const uint16_t %s_albedo[(size_t)%s_WIDTH * %s_HEIGHT];\n", name, macro, macro);
    for (unsigned k = 0; k < BAKED_MAPS; k++)
        if (baked->maps[k])
            fprintf(out, "extern const uint8_t %s_%s[(size_t)%s_WIDTH * %s_HEIGHT]; /* %s; stride %s_WIDTH */\n", name,
                    baked_map_names[k], macro, macro, baked_map_meanings[k], macro);
    c_end_externs(out);
    c_end_header(out);
}

void bake_write_definitions(const struct baked *baked, const char *name, const char *header, FILE *out)
{
    write_note(baked, out);
    fprintf(out, "#include \"%s\"\n", header);
    if (baked->format == BAKE_PALETTE) {
        c_begin_array("", "struct glint_vec", name, "_normals", out);
        write_vectors(out, baked->normals, baked->entries);
        fputs("\n};\n", out);
    }
    c_begin_array("", element_type(baked), name, "", out);
    write_elements(baked, out);
    fputs("\n};\n", out);
    if (baked->albedo) {
        c_begin_array("", "uint16_t", name, "_albedo", out);
        write_albedo(baked, out);
        fputs("\n};\n", out);
    }
    for (unsigned k = 0; k < BAKED_MAPS; k++) {
        char suffix[24];
        if (!baked->maps[k])
            continue;
        snprintf(suffix, sizeof suffix, "_%s", baked_map_names[k]);
        c_begin_array("", "uint8_t", name, suffix, out);
        write_bytes(baked->maps[k], pixels_of(baked), out);
        fputs("\n};\n", out);
    }
}
