/* SPDX-License-Identifier: MIT
 * Baked normals as C source, as bytes and as UF2 blocks. */
#include "bake/write.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "bake/uf2.h"
#include "base/memory.h"

/* ---- C source ---- */

static void write_vectors(FILE *out, const struct glint_vec *vectors, size_t count)
{
    for (size_t i = 0; i < count; i++)
        fprintf(out, "%s{%d, %d, %d}%s", i % 6 ? " " : "\n    ", vectors[i].x, vectors[i].y, vectors[i].z,
                i + 1 < count ? "," : "");
}

static const char *const notes[] = {
    [BAKE_INT16] =
        "For glint_shade_rect, or glint_tables_rect with GLINT_NORMALS_INT16; 0, 0, 0 where there is no surface",
    [BAKE_INT10] =
        "For glint_tables_rect with GLINT_NORMALS_INT10; z = 0 where there is no surface, with how many pixels to the "
        "right",
    [BAKE_INT8] = "For glint_tables_rect with GLINT_NORMALS_INT8; z = 0 where there is no surface, with how many "
                  "pixels to the right",
    [BAKE_PALETTE] =
        ("A palette of normals, to be shaded once a frame as one line, and for each pixel twice its entry, for\n"
         " * glint_palette_rect. Entry 0 is no surface: after shading, give it the background's colour")};

void bake_write_c(const struct baked *baked, const char *name, FILE *out)
{
    const uint32_t width = baked->width, height = baked->height;
    const size_t pixels = (size_t)width * height;
    fprintf(out,
            "/* Written by glint bake, version " GLINT_VERSION_STRING ": normals as %s, %" PRIu32 "x%" PRIu32
            ", %zu bytes.\n * %s. */\n",
            bake_format_names[baked->format], width, height, baked_bytes(baked), notes[baked->format]);
    fprintf(out, "#include %s\n\n", baked->normals ? "\"glint.h\"" : "<stdint.h>");
    fprintf(out, "enum { %s_width = %" PRIu32 ", %s_height = %" PRIu32, name, width, name, height);
    if (baked->format == BAKE_PALETTE)
        fprintf(out, ", %s_entries = %" PRIu32, name, baked->entries);
    fputs(" };\n\n", out);
    if (baked->format == BAKE_INT16) {
        fprintf(out, "static const struct glint_vec %s[%zu] = {", name, pixels);
        write_vectors(out, baked->normals, pixels);
    } else if (baked->format == BAKE_PALETTE) {
        fprintf(out, "static const struct glint_vec %s_normals[%" PRIu32 "] = {", name, baked->entries);
        write_vectors(out, baked->normals, baked->entries);
        fprintf(out, "\n};\n\nstatic const uint16_t %s[%zu] = {", name, pixels);
        for (size_t i = 0; i < pixels; i++)
            fprintf(out, "%s%u%s", i % 16 ? " " : "\n    ", baked->offsets[i], i + 1 < pixels ? "," : "");
    } else {
        fprintf(out, "static const uint32_t %s[%zu] = {", name, pixels);
        for (size_t i = 0; i < pixels; i++)
            fprintf(out, "%s0x%08" PRIx32 "u%s", i % 8 ? " " : "\n    ", baked->words[i], i + 1 < pixels ? "," : "");
    }
    fputs("\n};\n", out);
}

/* ---- bytes, low ones first ---- */

static uint8_t *put(uint8_t *at, uint32_t value, unsigned bytes)
{
    for (unsigned i = 0; i < bytes; i++)
        *at++ = (uint8_t)(value >> 8 * i);
    return at;
}

static uint8_t *to_bytes(const struct baked *baked)
{
    const size_t pixels = (size_t)baked->width * baked->height;
    const size_t normals = baked->format == BAKE_INT16 ? pixels : baked->entries; /* 0 for words */
    uint8_t *bytes = allocate(baked_bytes(baked), 1), *at = bytes;
    for (size_t i = 0; i < normals; i++) {
        at = put(at, (uint16_t)baked->normals[i].x, 2);
        at = put(at, (uint16_t)baked->normals[i].y, 2);
        at = put(at, (uint16_t)baked->normals[i].z, 2);
    }
    for (size_t i = 0; i < pixels && baked->words; i++)
        at = put(at, baked->words[i], 4);
    for (size_t i = 0; i < pixels && baked->offsets; i++)
        at = put(at, baked->offsets[i], 2);
    return bytes;
}

void bake_write_raw(const struct baked *baked, FILE *out)
{
    uint8_t *bytes = to_bytes(baked);
    fwrite(bytes, 1, baked_bytes(baked), out); /* output_close looks whether it could */
    free(bytes);
}

void bake_write_uf2(const struct baked *baked, uint32_t address, FILE *out)
{
    uint8_t *bytes = to_bytes(baked);
    uf2_write(bytes, baked_bytes(baked), address, UF2_RP2040, out);
    free(bytes);
}
