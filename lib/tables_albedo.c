/* SPDX-License-Identifier: MIT */
#include "glint_tables_albedo.h"
#include "glint_math_root.h"
#include "glint_pixel.h"
#include "glint_tables_columns.h"
#include "glint_tables_field.h"
#include "glint_tables_geometry.h"

enum { SHINES = 1 << GLINT_ALBEDO_COLUMNS_LOG };
typedef char glint_albedo_bytes[GLINT_TABLES_ALBEDO_BYTES == GLINT_ALBEDO_LEVELS + 4 * SHINES ? 1 : -1];

/* The highlight's nearest levels in RGB565, as fields (GLINT_ALBEDO_FIELDS). */
static uint32_t shine_word(const struct glint_shader *shader, uint64_t f)
{
    static const struct glint_field fields[3] GLINT_FLASH = {{11, 16, 31}, {21, 27, 63}, {0, 5, 31}};
    uint32_t word = 0;
    for (int k = 0; k < 3; k++)
        word |= glint_field_level(GLINT_FLASH_STRUCT(struct glint_field, fields[k]),
                                  glint_pixel_value(shader, k, 0, 0, 65535 * f))
                << GLINT_FLASH_U8(fields[k].at);
    return word;
}

static bool shines(const struct glint_shader *shader, uint32_t f)
{
    return shine_word(shader, f) != 0;
}

/* The albedo varies from pixel to pixel, so the tables hold what it is scaled by and what is added: by nl a level of 32,
 * by t the highlight as a word of fields. */
void glint_albedo_fill(struct glint_tables *tables, const struct glint_shader *shader, void *memory)
{
    const uint32_t ambient = shader->material.ambient_q16[0], diffuse = shader->material.diffuse_q16[0]; /* <= 2^16 */
    const uint32_t t_max = glint_last_t(shader, shines);
    tables->t_max_q30 = t_max;
    tables->shift = (uint8_t)glint_columns_shift(t_max, SHINES);
    uint8_t *const levels = (uint8_t *)memory;
    uint32_t *const sums = (uint32_t *)memory + GLINT_ALBEDO_LEVELS / 4;
    tables->columns = levels + GLINT_ALBEDO_LEVELS;
    tables->colour.sums = sums;
    for (uint32_t i = 0; i < SHINES; i++)
        sums[i] = shine_word(shader, glint_pixel_lobe(shader, glint_column_t(t_max, tables->shift, i)));
    for (int32_t row = 0; row < GLINT_ALBEDO_LEVELS; row++) {
        const uint32_t lit = row < 128 ? diffuse * (2 * (uint32_t)row + 1) >> 3 : diffuse * 32; /* 32 D nl < 2^25 */
        levels[GLINT_ALBEDO_LEVELS - 1 - row] = (uint8_t)((ambient * 32 + lit + 32768) >> 16);
    }
    tables->dark = (uint16_t)((ambient * 32u + 32768) >> 16);
}

/* As for COLOUR, but in Q25 and with the other sign, so that neither a shift of e nor a second table's address is needed.
 * r has few bits then; cut is such that the peak stays in its column. What r is off by, 1/64 at the most, t is off by. */
void glint_albedo_light(struct glint_tables_light *light, const struct glint_tables *tables)
{
    const unsigned reader = 32 - GLINT_ALBEDO_COLUMNS_LOG; /* e r >> this is the column */
    light->y = -((light->l.y + 16) >> 5);
    light->z = -((light->l.z + 16) >> 5);
    light->x = -8 * (int32_t)light->l.x - light->y;
    const int64_t x = light->l.x, y = 32 * light->y, z = 32 * light->z - 32768;
    const uint32_t peak = glint_root((uint64_t)(x * x + y * y + z * z) << 20); /* Q25 */
    const uint64_t r = peak ? (((uint64_t)1 << (30 + reader - tables->shift)) + peak / 2) / peak : 0;
    light->r = r == 0 ? 1 : r > UINT32_MAX ? UINT32_MAX : (uint32_t)r;
    light->cut = (int32_t)(peak - (uint32_t)(((uint64_t)tables->t_max_q30 << reader >> tables->shift) / light->r));
}

bool glint_albedo_can(const struct glint_material *m)
{
    for (int k = 0; k < 3; k++)
        if (m->ambient_q16[k] != m->ambient_q16[0] || m->diffuse_q16[k] != m->diffuse_q16[0])
            return false;
    return m->ambient_q16[0] <= 65536 && m->diffuse_q16[0] <= 65536 - m->ambient_q16[0];
}
