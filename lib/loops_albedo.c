/* SPDX-License-Identifier: MIT
 * ALBEDO tables: their fill, their lights, and the loops over them. RAM: 8,584 bytes of tables, what a light takes, no
 * buffers. */
#include "glint_tables.h"

enum { SHINE = 2048, LEVELS = 392 /* three times 128, and some: whatever normals and lights are */ };
/* Blue, red and green as fields of a word, each with room above it: a product by a level of up to 32 fits, and so does a
 * guard bit. */
#define FIELDS UINT32_C(0x07e0f81f)
#define HALF UINT32_C(0x02008010) /* of 32nds, in each field */

/* Where the channels lie, and what 1.0 is there. */
static const struct glint_field fields[3] = {{11, 16, 31}, {21, 27, 63}, {0, 5, 31}};

static uint32_t shine_word(const struct glint_shader *shader, uint64_t f)
{
    uint32_t word = 0;
    for (int k = 0; k < 3; k++)
        word |= glint_field_level(fields[k], glint_pixel_value(shader, k, 0, 0, 65535 * f)) << fields[k].at;
    return word;
}

static bool shines(const struct glint_shader *shader, uint32_t f)
{
    return shine_word(shader, f) != 0;
}

void glint_albedo_fill(struct glint_tables *tables, const struct glint_shader *shader, uint32_t *memory)
{
    const uint32_t ambient = shader->material.ambient_q16[0], diffuse = shader->material.diffuse_q16[0];
    const uint32_t t_max = glint_last_t(shader, shines);
    tables->t_max_q30 = t_max;
    tables->shift = (uint8_t)glint_columns_shift(t_max, SHINE);
    tables->colour.sums = memory + LEVELS / 4;
    tables->columns = (uint8_t *)tables->colour.sums; /* levels lie before it, the darkest last: one pointer for both */
    for (uint32_t i = 0; i < SHINE; i++)
        tables->colour.sums[i] = shine_word(shader, glint_pixel_lobe(shader, glint_column_t(t_max, tables->shift, i)));
    for (int32_t row = 0; row < LEVELS; row++) {
        const uint32_t lit = row < 128 ? diffuse * (2 * (uint32_t)row + 1) >> 3 : diffuse * 32; /* 32 D nl */
        tables->columns[-1 - row] = (uint8_t)((ambient * 32 + lit + 32768) >> 16);
    }
    tables->dark = (uint16_t)((ambient * 32u + 32768) >> 16);
}

/* As for COLOUR, but in Q25 and with the other sign, so that neither a shift of e nor a second table's address is needed.
 * r has few bits then; cut is such that the peak stays in its column. What r is off by, 1/64 at the most, t is off by. */
void glint_albedo_light(struct glint_tables_light *light, const struct glint_tables *tables)
{
    light->y = -((light->l.y + 16) >> 5);
    light->z = -((light->l.z + 16) >> 5);
    light->x = -8 * (int32_t)light->l.x - light->y;
    const int64_t x = light->l.x, y = 32 * light->y, z = 32 * light->z - 32768;
    const uint32_t peak = glint_root((uint64_t)(x * x + y * y + z * z) << 20);
    const uint64_t r = peak ? (((uint64_t)1 << (51 - tables->shift)) + peak / 2) / peak : 0;
    light->r = r == 0 ? 1 : r > UINT32_MAX ? UINT32_MAX : (uint32_t)r;
    light->cut = (int32_t)(peak - (uint32_t)(((uint64_t)tables->t_max_q30 << 21 >> tables->shift) / light->r));
}

bool glint_albedo_can(const struct glint_material *m)
{
    for (int k = 0; k < 3; k++)
        if (m->ambient_q16[k] != m->ambient_q16[0] || m->diffuse_q16[k] != m->diffuse_q16[0])
            return false;
    return m->ambient_q16[0] <= 65536 && m->diffuse_q16[0] <= 65536 - m->ambient_q16[0];
}

/* ---- A pixel ---- */

static inline uint32_t lit(uint16_t albedo, uint32_t level)
{
    return (((albedo | (uint32_t)albedo << 16) & FIELDS) * level + HALF) >> 5 & FIELDS;
}

static inline uint32_t full(uint32_t sum) /* a field whose guard is set is full */
{
    const uint32_t over = sum & ~FIELDS;
    return over ? (sum | (over - (over >> 5)) | over >> 6) & FIELDS
                : sum; /* green has 6 bits: its lowest by the >> 6 */
}

static inline uint16_t packed(uint32_t word, bool swapped)
{
    const uint32_t rgb = word | word >> 16;
    return (uint16_t)(swapped ? rgb << 8 | (rgb >> 8 & 255) : rgb);
}

/* Does a pixel in the format's order differ from this machine's? */
static inline bool is_swapped(const struct glint_tables *tables)
{
    const uint16_t one = 1;
    const bool low_first = *(const uint8_t *)&one == 1;
    return (tables->format == GLINT_RGB565_SWAPPED) == low_first;
}

/* ---- Lines ---- */

/* By t and nl, as spans and the wider normals have them. Below 0, t may come by rounding. */
static inline uint16_t pixel(const struct glint_tables *tables, uint32_t t, int32_t nl, uint16_t albedo, bool swapped)
{
    uint32_t word = lit(albedo, nl < 0 ? tables->dark : tables->columns[-1 - (nl >> 23)]);
    if (nl >= 0 && t <= tables->t_max_q30)
        word = full(word + tables->colour.sums[(tables->t_max_q30 - t) >> tables->shift]);
    return packed(word, swapped);
}

static void wide_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                      enum glint_normals format, const void *normals, const uint16_t *albedo, uint16_t w, uint16_t *out)
{
    const struct glint_vec l = light->l, h = light->h;
    const bool swapped = is_swapped(tables);
    for (uint16_t i = 0; i < w; i++) {
        struct glint_vec n;
        if (format == GLINT_NORMALS_INT16) {
            n = ((const struct glint_vec *)normals)[i];
        } else {
            const uint32_t word = ((const uint32_t *)normals)[i];
            n = glint_normals_unpack(format, word);
        }
        if (n.x | n.y | n.z)
            out[i] = pixel(tables, glint_fast_t(&n, &h), glint_fast_nl(&n, &l), albedo[i], swapped);
    }
}

#if !GLINT_CORTEX_M0PLUS_ASM
static inline void int8_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                             const uint32_t *words, const uint16_t *albedo, uint16_t w, uint16_t *out, bool swapped)
{
    const uint32_t *const shine = tables->colour.sums;
    const uint8_t *const levels = tables->columns;
    const int32_t lx = light->x, ly = light->y, lz = light->z;
    const uint32_t cut = (uint32_t)light->cut, dark = tables->dark, r = light->r;
    for (uint16_t i = 0; i < w; i++) {
        const uint32_t word = words[i];
        const int32_t z = (int32_t)word >> 16;
        if (z == 0) {
            const uint16_t left = (uint16_t)(w - i), gap = (uint16_t)(word ? word : 1);
            i = (uint16_t)(i + (gap < left ? gap : left) - 1);
            continue;
        }
        const int32_t d = (int8_t)word * lx + (int16_t)word * ly + z * lz;
        if (d >= 0) {
            out[i] = packed(lit(albedo[i], dark), swapped);
            continue;
        }
        uint32_t sum = lit(albedo[i], levels[d >> 18]);
        const uint32_t e = ((uint32_t)z << 10) - cut - (uint32_t)d;
        if ((int32_t)e >= 0)
            sum = full(sum + shine[(e * r) >> 21]);
        out[i] = packed(sum, swapped);
    }
}

void glint_albedo_int8(const struct glint_tables *tables, const struct glint_tables_light *light, const uint32_t *words,
                       const uint16_t *albedo, uint16_t w, uint16_t *out)
{
    int8_line(tables, light, words, albedo, w, out, false);
}

void glint_albedo_int8_swapped(const struct glint_tables *tables, const struct glint_tables_light *light,
                               const uint32_t *words, const uint16_t *albedo, uint16_t w, uint16_t *out)
{
    int8_line(tables, light, words, albedo, w, out, true);
}
#endif

static inline void line(const struct glint_tables *tables, const struct glint_tables_light *light,
                        enum glint_normals format, const void *normals, const uint16_t *albedo, uint16_t w,
                        uint16_t *out)
{
    if (format != GLINT_NORMALS_INT8)
        wide_line(tables, light, format, normals, albedo, w, out);
    else if (is_swapped(tables))
        glint_albedo_int8_swapped(tables, light, (const uint32_t *)normals, albedo, w, out);
    else
        glint_albedo_int8(tables, light, (const uint32_t *)normals, albedo, w, out);
}

void glint_albedo_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                       enum glint_normals format, const void *normals, const uint16_t *albedo, uint16_t w,
                       uint16_t *out)
{
    line(tables, light, format, normals, albedo, w, out);
}

enum glint_err glint_tables_albedo_rect(const struct glint_tables *tables, const struct glint_tables_light *light,
                                        enum glint_normals format, const void *normals, ptrdiff_t stride,
                                        const uint16_t *albedo, ptrdiff_t albedo_stride, uint16_t w, uint16_t h,
                                        const struct glint_surface *surface)
{
    const enum glint_err err = glint_tables_check(tables, light, format, normals, stride, surface);
    if (err)
        return err;
    if (tables->kind != GLINT_TABLES_ALBEDO || !albedo || GLINT_MISALIGNED(albedo, 16) ||
        GLINT_MISALIGNED(albedo_stride, 16))
        return GLINT_ERR_ARG;
    const uint8_t *in = (const uint8_t *)normals, *map = (const uint8_t *)albedo;
    uint8_t *out = (uint8_t *)surface->pixels;
    for (; h; h--) {
        const uint16_t *colours = (const uint16_t *)(const void *)map;
        if (GLINT_MISALIGNED(out, 16))
            glint_albedo_odd(tables, light, format, in, colours, w, out);
        else
            line(tables, light, format, in, colours, w, (uint16_t *)(void *)out);
        in += stride;
        map += albedo_stride;
        out += surface->stride;
    }
    return GLINT_OK;
}

enum glint_err glint_tables_albedo_span(const struct glint_tables *tables, const struct glint_span *span,
                                        const uint16_t *albedo, const struct glint_surface *surface)
{
    if (!tables || !span || !albedo || !surface || !surface->pixels || tables->kind != GLINT_TABLES_ALBEDO ||
        GLINT_MISALIGNED(albedo, 16))
        return GLINT_ERR_ARG;
    const bool swapped = is_swapped(tables);
    uint32_t t = span->t_q30, dt = span->dt_q30, nl = (uint32_t)span->nl_q30;
    uint8_t *out = (uint8_t *)surface->pixels;
    for (uint16_t x = 0; x < span->w; x++, out += 2) {
        const uint16_t value = pixel(tables, t >= GLINT_NEGATIVE_T ? 0 : t, (int32_t)nl, albedo[x], swapped);
        glint_put_pixels(out, &value, 1);
        t += dt;
        dt += span->ddt_q30;
        nl += (uint32_t)span->dnl_q30;
    }
    return GLINT_OK;
}
