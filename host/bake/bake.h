/* SPDX-License-Identifier: MIT
 * A scene's normals as the table loops read them, what that costs in quality, and the files that hold them. */
#ifndef GLINT_BAKE_H
#define GLINT_BAKE_H

#include <stdio.h>

#include "bake/palette.h"
#include "compare/compare.h"
#include "glint.h"
#include "scene/scene.h"

enum bake_format { BAKE_INT16, BAKE_INT10, BAKE_INT8, BAKE_PALETTE, BAKE_FORMATS };
extern const char *const bake_format_names[]; /* "int16" ..., by enum bake_format; ends with NULL */

/* Of one allocation a pointer; those of other formats are NULL. */
struct baked {
    enum bake_format format;
    uint32_t width, height;
    struct glint_vec *normals; /* int16: a pixel each; palette: an entry each */
    uint32_t *words;           /* int10, int8 */
    uint16_t *offsets;         /* palette: 2 x entry */
    uint32_t entries;          /* palette */
};
/* `entries`: the most that a palette may have, the first one included. */
struct baked *bake(const struct scene *scene, enum bake_format format, uint32_t entries);
void baked_free(struct baked *baked);
size_t baked_bytes(const struct baked *baked);
/* The normal that the loops see; 0, 0, 0 where there is no surface. */
struct glint_vec baked_normal(const struct baked *baked, size_t pixel);

/* ---- quality (bake_quality.c) ---- */

enum { QUALITY_ROWS = 4 };
struct quality {
    unsigned n;
    struct difference difference; /* over all pixels with a surface, under all lights */
};
/* A highlight by the exact path from what was baked, against the same from the 16-bit normals. */
void bake_quality(const struct scene *scene, const struct baked *baked, struct quality rows[QUALITY_ROWS]);

/* ---- files (bake_write.c) ---- */

enum bake_kind { BAKE_C, BAKE_RAW, BAKE_UF2, BAKE_KINDS };
enum { FLASH_BASE = 0x10000000, FLASH_END = 0x11000000, FLASH_SECTOR = 4096, FLASH_DEFAULT = 0x10100000 };

void bake_write_c(const struct baked *baked, const char *name, FILE *out);
void bake_write_raw(const struct baked *baked, FILE *out);
void bake_write_uf2(const struct baked *baked, uint32_t address, FILE *out);

#endif
