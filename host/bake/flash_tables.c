/* SPDX-License-Identifier: MIT */
#include "bake/flash_tables.h"

#include <inttypes.h>
#include <stdbool.h>
#include <stdlib.h>

#include "bake/c_source.h"
#include "base/memory.h"

const char *const tables_kind_names[] = {"colour", "albedo", NULL};

enum glint_err flash_tables_fill(struct flash_tables *flash, enum glint_tables_kind kind,
                                 const struct glint_material *material, const struct glint_output *output)
{
    struct glint_paint paint;
    *flash = (struct flash_tables){.bytes = glint_tables_bytes(kind, output->dither)};
    flash->memory = allocate(flash->bytes / 4, sizeof *flash->memory);
    const enum glint_err error = glint_paint_tables(&paint, kind, material, output, flash->memory, flash->bytes);
    if (error == GLINT_OK)
        flash->tables = paint.of.tables.filled;
    return error;
}

void flash_tables_free(struct flash_tables *flash)
{
    free(flash->memory);
    free(flash->about);
}

static void write_note(const struct flash_tables *flash, FILE *out)
{
    fprintf(out,
            "/* Written by glint table, version " GLINT_VERSION_STRING ": %s tables, %zu bytes%s%s.\n"
            " * For glint_paint_tables_filled; nothing is to be filled. */\n",
            tables_kind_names[flash->tables.kind], flash->bytes, flash->about ? ": " : "",
            flash->about ? flash->about : "");
}

static size_t offset(const struct flash_tables *flash, const void *at)
{
    return (size_t)((const uint8_t *)at - (const uint8_t *)flash->memory);
}

static const char *use_name(const struct glint_tables *tables)
{
    if (tables->kind == GLINT_TABLES_ALBEDO)
        return "glint_use_albedo";
    return tables->dither ? "glint_use_colour_dithered" : "glint_use_colour";
}

/* The memory as words of this machine, which has the low byte first, and the struct that points into it. */
static void write_tables(const struct flash_tables *flash, const char *name, const char *storage, FILE *out)
{
    const struct glint_tables *tables = &flash->tables;
    const size_t words = flash->bytes / 4;
    fputs("\n#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__\n"
          "#error \"these tables are for machines that store the low byte first\"\n#endif\n",
          out);
    c_begin_array("static ", "uint32_t", name, "_memory", out);
    for (size_t i = 0; i < words; i++)
        fprintf(out, "%s0x%08" PRIx32 "u%s", i % 8 ? " " : "\n    ", flash->memory[i], i + 1 < words ? "," : "");
    fputs("\n};\n\n", out);
    fprintf(out,
            "%sconst struct glint_tables %s = {\n"
            "    (const uint8_t *)%s_memory + %zu,    /* columns */\n"
            "    {(const uint16_t *)(const void *)((const uint8_t *)%s_memory + %zu)},\n"
            "    %" PRIu32 "u, /* t_max_q30 */\n    %u, /* dark */\n    %u, /* kind */\n    %u, /* format */\n"
            "    %u, /* shift */\n    %s, /* dither */\n    %u, /* n */\n    &%s /* use */\n};\n",
            storage, name, name, offset(flash, tables->columns), name, offset(flash, tables->colour.colours),
            tables->t_max_q30, tables->dark, tables->kind, tables->format, tables->shift,
            tables->dither ? "true" : "false", tables->n, use_name(tables));
}

void flash_tables_write_c(const struct flash_tables *flash, const char *name, FILE *out)
{
    write_note(flash, out);
    fputs("#include \"glint.h\"\n", out);
    write_tables(flash, name, "static ", out);
}

void flash_tables_write_header(const struct flash_tables *flash, const char *name, FILE *out)
{
    write_note(flash, out);
    c_begin_header(name, "\"glint.h\"", out);
    c_begin_externs(out);
    fprintf(out, "extern const struct glint_tables %s;\n", name);
    c_end_externs(out);
    c_end_header(out);
}

void flash_tables_write_definition(const struct flash_tables *flash, const char *name, const char *header, FILE *out)
{
    write_note(flash, out);
    fprintf(out, "#include \"%s\"\n", header);
    write_tables(flash, name, "", out);
}
