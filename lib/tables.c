/* SPDX-License-Identifier: MIT
 * Tables from exact values, and lights for the loops that read them (glint.h). */
#include "glint_tables.h"

enum { COLUMNS = 4096, SPARE = 16, SEGMENT = GLINT_SEGMENT };
#define GAP ((uint32_t)1 << 16) /* how far below 0 t may come, Q2.30, by rounding */

size_t glint_tables_bytes(enum glint_tables_kind kind)
{
    return kind == GLINT_TABLES_COLOUR   ? GLINT_TABLES_COLOUR_BYTES
           : kind == GLINT_TABLES_SMALL  ? GLINT_TABLES_SMALL_BYTES
           : kind == GLINT_TABLES_ALBEDO ? GLINT_TABLES_ALBEDO_BYTES
                                         : 0;
}

unsigned glint_columns_shift(uint32_t t_max_q30, uint32_t columns)
{
    unsigned s = 0;
    while ((t_max_q30 >> s) + (GAP >> s) >= columns - SPARE)
        s++;
    return s;
}

/* F, and the column nearest to it. F(0) is 1.0 at least for n and q of the domain, so never 0. */
struct peak {
    const struct glint_shader *shader;
    uint32_t f0;
};

static uint8_t column_of(const struct peak *peak, uint32_t f)
{
    return (uint8_t)((63 * f + peak->f0 / 2) / peak->f0);
}

static uint8_t column_at(const struct peak *peak, uint32_t t_q30)
{
    return column_of(peak, glint_pixel_lobe(peak->shader, t_q30));
}

static bool has_column(const struct glint_shader *shader, uint32_t f)
{
    const struct peak peak = {shader, glint_pixel_lobe(shader, 0)};
    return column_of(&peak, f) != 0;
}

static uint32_t f_of(const struct peak *peak, uint32_t column)
{
    return (column * peak->f0 + 31) / 63;
}

static uint32_t nl_of(uint32_t row)
{
    return row < 64 ? 1024 * row + 512 : 65536;
}

static void fill_colour(struct glint_tables *tables, const struct peak *peak)
{
    struct glint_shader shader = *peak->shader;
    const uint32_t t_max = glint_last_t(&shader, has_column);
    tables->t_max_q30 = t_max;
    tables->shift = (uint8_t)glint_columns_shift(t_max, COLUMNS);
    for (uint32_t i = 0; i < COLUMNS; i++)
        tables->columns[i] = (uint8_t)(2 * column_at(peak, glint_column_t(t_max, tables->shift, i))); /* bytes */
    const struct glint_surface colours = {tables->colour.colours, 128, 0, 0}, dark = {&tables->dark, 2, 0, 0};
    for (uint16_t row = 0; row < 128; row++)
        for (uint16_t j = 0; j < 64; j++)
            glint_pixel_store(&shader, &colours, j, row, nl_of(row), f_of(peak, j), shader.material.albedo, 255);
    glint_pixel_store(&shader, &dark, 0, 0, 0, 0, shader.material.albedo, 255);
}

/* Channel by channel, a value (65535 * 2^32 = 1.0) as a field of a sum's word. */
static uint32_t sum_word(const struct glint_shader *shader, uint32_t nl_q16, uint32_t f, bool lit)
{
    uint32_t word = 0;
    for (int k = 0; k < 3; k++) {
        const uint8_t albedo = lit ? shader->material.albedo[k] : 0;
        const uint64_t x = glint_pixel_value(shader, k, albedo, nl_q16, (uint64_t)65535 * f);
        const struct glint_field field = glint_field_of(shader->format, k);
        word |= glint_field_level(field, x) << field.at;
    }
    return word;
}

static void fill_small(struct glint_tables *tables, const struct peak *peak)
{
    const uint32_t t_max = tables->t_max_q30;
    unsigned fine = 0;
    while (t_max >> fine >= 16 * SEGMENT)
        fine++;
    tables->shift = (uint8_t)fine;
    for (uint32_t i = 0; i < 2 * SEGMENT; i++) {
        const unsigned s = i < SEGMENT ? fine : fine + 4;
        const uint32_t t = ((i % SEGMENT) << s) + ((uint32_t)1 << s >> 1);
        tables->columns[i] = column_at(peak, t < t_max ? t : t_max);
    }
    uint32_t *diffuse = tables->colour.sums, *specular = diffuse + GLINT_DIFFUSE;
    for (uint32_t row = 0; row < GLINT_DIFFUSE; row++)
        diffuse[row] = sum_word(peak->shader, row ? nl_of(row - 1) : 0, 0, true);
    for (uint32_t j = 0; j < 64; j++)
        specular[j] = sum_word(peak->shader, 0, f_of(peak, j), false);
}

enum glint_err glint_tables_fill(struct glint_tables *tables, enum glint_tables_kind kind,
                                 const struct glint_shader *shader, void *memory, size_t bytes)
{
    const size_t needed = glint_tables_bytes(kind);
    if (!tables || !shader || !memory || needed == 0 || bytes < needed || GLINT_MISALIGNED(memory, 32) ||
        shader->lobe.model == GLINT_PHONG || (kind == GLINT_TABLES_ALBEDO && !glint_albedo_can(&shader->material)))
        return GLINT_ERR_ARG;
    const bool is_plain_565 = shader->format <= GLINT_RGB565_SWAPPED && !shader->dither;
    if (glint_pixel_check(shader) || (kind != GLINT_TABLES_SMALL && !is_plain_565) ||
        (kind != GLINT_TABLES_COLOUR && shader->space))
        return GLINT_ERR_FORMAT;
    const struct peak peak = {shader, glint_pixel_lobe(shader, 0)};
    if (peak.f0 == 0) /* no such model */
        return GLINT_ERR_ARG;
    tables->kind = (uint8_t)kind;
    tables->format = shader->format;
    tables->dither = shader->dither;
    tables->t_max_q30 = shader->lobe.t_max_q30;
    tables->dark = 0;
    if (kind == GLINT_TABLES_COLOUR) { /* the 16-bit table first, for its alignment */
        tables->colour.colours = (uint16_t *)memory;
        tables->columns = (uint8_t *)memory + 128 * 64 * 2;
        fill_colour(tables, &peak);
    } else if (kind == GLINT_TABLES_ALBEDO) {
        glint_albedo_fill(tables, shader, (uint32_t *)memory);
    } else {
        tables->colour.sums = (uint32_t *)memory;
        tables->columns = (uint8_t *)memory + 4 * (GLINT_DIFFUSE + 64);
        fill_small(tables, &peak);
    }
    return GLINT_OK;
}

/* N.H |L + V| = N.L + N.z for a viewer at (0, 0, 1): one dot serves both. With m = |L + V| = peak / 2^29, 1 - N.H =
 * (peak - d - z) / m, so a column's number is (d + z - cut) 2 / m >> s = ((e >> a) r) >> 20. */
enum glint_err glint_tables_light_init(struct glint_tables_light *light, const struct glint_tables *tables,
                                       const struct glint_light *from)
{
    if (!light || !tables || !from)
        return GLINT_ERR_ARG;
    light->l = from->l;
    light->h = from->h;
    light->kind = tables->kind;
    light->frontal = from->v.x == 0 && from->v.y == 0 && from->v.z == 32767;
    if (tables->kind == GLINT_TABLES_ALBEDO) {
        glint_albedo_light(light, tables);
        return GLINT_OK;
    }
    light->y = (from->l.y + 1) >> 1; /* Q14, as z */
    light->z = (from->l.z + 1) >> 1;
    light->x = 128 * (int32_t)from->l.x - light->y; /* Q22; v holds x, too */
    const int64_t x = from->l.x, y = 2 * light->y, z = 2 * light->z + 32768;
    const uint32_t peak = glint_root((uint64_t)(x * x + y * y + z * z) << 28);          /* Q29, <= 2^30 + 2^16 */
    const uint32_t reach = (uint32_t)(((uint64_t)tables->t_max_q30 * peak) >> 30) >> 1; /* of e */
    light->peak = (int32_t)peak;
    light->cut = (int32_t)(peak - (uint32_t)(((uint64_t)tables->t_max_q30 * peak) >> 30));
    unsigned a = 0;
    while (reach >> a >= 32768)
        a++;
    const uint64_t r =
        peak && tables->kind == GLINT_TABLES_COLOUR ? ((uint64_t)1 << (50 + a - tables->shift)) / peak : 0;
    light->a = (uint8_t)a;
    light->r = r > UINT32_MAX ? UINT32_MAX : (uint32_t)r;
    return GLINT_OK;
}
