/* SPDX-License-Identifier: MIT
 * The box of what the loops over tables light. The loops count every cycle, so this is another look at the normals: by the conditions
 * of each loop, line by line from both ends up to the first pixel with a highlight. */
#include "glint_loops_check.h"
#include "glint_loops_small.h"
#include "glint_loops_vector.h"
#include "glint_tables_normals.h"

/* A line of normals, and what it is looked at by. */
struct box_line {
    const struct glint_tables *tables;
    const struct glint_tables_light *light;
    enum glint_normals format;
    const void *normals;
};

/* As glint_colour_int8 and dithered_int8 have d and e; ALBEDO's d is negative where lit, as in int8_line. */
static inline bool box_has_int8(int32_t x, int32_t y, int32_t z, int32_t cut, uint32_t word, bool albedo)
{
    const int32_t n_z = (int32_t)word >> 16;
    if (n_z == 0)
        return false;
    const uint32_t d = (uint32_t)((int8_t)word * x) + (uint32_t)((int16_t)word * y) + (uint32_t)(n_z * z);
    if (albedo)
        return (int32_t)d < 0 && (int32_t)(((uint32_t)n_z << 10) - (uint32_t)cut - d) >= 0;
    return (int32_t)d >= 0 && (int32_t)(d + ((uint32_t)n_z << 14) - (uint32_t)cut) >= 0;
}

/* How many of count normals, from number i on, each a step further, come before one with a highlight. */
typedef uint32_t box_dark(const struct box_line *line, uint32_t i, int32_t step, uint32_t count);

static uint32_t dark_int8(const struct box_line *line, uint32_t i, int32_t step, uint32_t count)
{
    const struct glint_tables_light *light = line->light;
    const int32_t x = light->x, y = light->y, z = light->z, cut = light->cut;
    const bool albedo = light->kind == GLINT_TABLES_ALBEDO;
    const uint32_t *word = (const uint32_t *)line->normals + i;
    uint32_t left = count;
    while (left && !box_has_int8(x, y, z, cut, *word, albedo))
        if (--left)
            word += step;
    return count - left;
}

/* As glint_colour_int10. */
static bool box_has_int10(const struct glint_tables *tables, const struct glint_tables_light *light, uint32_t word)
{
    const int32_t top_z = (int32_t)(word << 20);
    const uint32_t x = (uint32_t)(((int32_t)word >> 22) * 32 - ((light->h.x + 1) >> 1));
    const uint32_t y = (uint32_t)(((int32_t)(word << 10) >> 22) * 32 - ((light->h.y + 1) >> 1));
    const uint32_t z = (uint32_t)((top_z >> 17) - ((light->h.z + 1) >> 1)), peak = (uint32_t)light->peak;
    const uint32_t s = x * x + y * y + z * z;
    return top_z && s <= tables->t_max_q30 >> 1 &&
           (int32_t)(peak - (peak >> 15) * (s >> 14) - (uint32_t)(top_z >> 2)) >= 0;
}

/* Any other: t and nl by a product of vectors each. */
static bool box_has_vector(const struct glint_tables *tables, const struct glint_tables_light *light,
                           struct glint_vec n)
{
    const uint32_t t = glint_fast_t(&n, &light->h);
    const int32_t nl = glint_fast_nl(&n, &light->l);
    if (!(n.x | n.y | n.z) || nl < 0 || t > tables->t_max_q30)
        return false;
    return tables->kind != GLINT_TABLES_SMALL || (nl > 0 && glint_small_column(tables, t) > 0);
}

static uint32_t dark_other(const struct box_line *line, uint32_t i, int32_t step, uint32_t count)
{
    const bool is_int10 =
        line->format == GLINT_NORMALS_INT10 && line->tables->kind == GLINT_TABLES_COLOUR && line->light->frontal;
    uint32_t at = 0;
    for (; at < count; at++, i += (uint32_t)step)
        if (is_int10 ? box_has_int10(line->tables, line->light, ((const uint32_t *)line->normals)[i])
                     : box_has_vector(line->tables, line->light, glint_normal_at(line->format, line->normals, i)))
            break;
    return at;
}

enum glint_err glint_tables_box(const struct glint_tables *tables, const struct glint_tables_light *light,
                                enum glint_normals format, const void *normals, ptrdiff_t stride, uint16_t w,
                                uint16_t h, struct glint_box *highlight)
{
    const struct glint_surface unused = {highlight, 0, 0, 0};
    const enum glint_err err = glint_tables_check(tables, light, format, normals, stride, &unused);
    if (err)
        return err;
    struct box_line line = {tables, light, format, normals};
    const bool is_int8 = format == GLINT_NORMALS_INT8 && tables->kind != GLINT_TABLES_SMALL;
    box_dark *const dark = is_int8 ? dark_int8 : dark_other;
    uint32_t left = w, end = 0, top = 0, bottom = 0; /* end: one past the last column */
    for (uint16_t y = 0; y < h; y++, line.normals = (const uint8_t *)line.normals + stride) {
        const uint32_t first = dark(&line, 0, 1, w);
        if (first == w)
            continue;
        const uint32_t last =
            end < w ? w - dark(&line, w - 1u, -1, w - end) : w; /* end, where nothing beyond it shines */
        top = end ? top : y;
        left = first < left ? first : left;
        end = last;
        bottom = y;
    }
    highlight->x = (uint16_t)(end ? left : 0);
    highlight->y = (uint16_t)top;
    highlight->w = (uint16_t)(end ? end - left : 0);
    highlight->h = (uint16_t)(end ? bottom - top + 1 : 0);
    return GLINT_OK;
}
