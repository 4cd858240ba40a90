/* SPDX-License-Identifier: MIT
 * Internal. ALBEDO tables (sequence.md): their fill, and a light for the loops over them. */
#ifndef GLINT_TABLES_ALBEDO_H
#define GLINT_TABLES_ALBEDO_H

#include "glint.h"

/* Blue, red and green as fields of a word, each with room above it: a product by a level of up to 32 fits, and so does a
 * guard bit. */
#define GLINT_ALBEDO_FIELDS UINT32_C(0x07e0f81f)

/* In 32nds, how much of the albedo shows at nl_q30 >= 0; all below 0 are tables->dark. Levels lie before the highlights,
 * downwards, so that the assembly has one pointer for both. */
static inline const uint8_t *glint_albedo_level(const struct glint_tables *tables, int32_t number)
{
    return tables->columns - 1 - number;
}

/* May they be filled for this material? Ambient and diffuse grey, together at most 1. */
bool glint_albedo_can(const struct glint_material *material);
void glint_albedo_fill(struct glint_tables *tables, const struct glint_shader *shader, void *memory);
/* Sets what the loops over ALBEDO tables read of a light whose l, h and kind are set. */
void glint_albedo_light(struct glint_tables_light *light, const struct glint_tables *tables);

#endif
