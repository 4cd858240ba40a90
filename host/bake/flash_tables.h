/* SPDX-License-Identifier: MIT
 * COLOUR and ALBEDO tables, filled here for a program that has them in flash. */
#ifndef GLINT_BAKE_FLASH_TABLES_H
#define GLINT_BAKE_FLASH_TABLES_H

#include <stdio.h>

#include "glint.h"

extern const char *const tables_kind_names[]; /* "colour" ..., by enum glint_tables_kind; ends with NULL */

struct flash_tables {
    struct glint_tables tables; /* points into the memory */
    uint32_t *memory;
    size_t bytes;
    char *about; /* the material, for a comment; may be NULL */
};
/* As glint_paint_tables, whose errors it returns. */
enum glint_err flash_tables_fill(struct flash_tables *flash, enum glint_tables_kind kind,
                                 const struct glint_material *material, const struct glint_output *output);
void flash_tables_free(struct flash_tables *flash);

/* All in one file to include, or a header and a source to link, whose file name `header` is. */
void flash_tables_write_c(const struct flash_tables *flash, const char *name, FILE *out);
void flash_tables_write_header(const struct flash_tables *flash, const char *name, FILE *out);
void flash_tables_write_definition(const struct flash_tables *flash, const char *name, const char *header, FILE *out);

#endif
