/* SPDX-License-Identifier: MIT
 * The box of what the loops over tables light. The loops count every cycle, so this is another look at the normals: by the conditions
 * of each loop, line by line from both ends up to the first pixel with a highlight. */
#include "glint_loops_check.h"
#include "glint_loops_small.h"
#include "glint_loops_vector.h"
#include "glint_tables_normals.h"

/* As glint_colour_int8 and dithered_int8 have d and e; ALBEDO's d is negative where lit, as in int8_line. */
static bool box_has_int8(const struct glint_tables_light *light, uint32_t word)
{
    const int32_t z = (int32_t)word >> 16;
    const uint32_t d =
        (uint32_t)((int8_t)word * light->x) + (uint32_t)((int16_t)word * light->y) + (uint32_t)(z * light->z);
    if (z == 0)
        return false;
    if (light->kind == GLINT_TABLES_ALBEDO)
        return (int32_t)d < 0 && (int32_t)(((uint32_t)z << 10) - (uint32_t)light->cut - d) >= 0;
    return (int32_t)d >= 0 && (int32_t)(d + ((uint32_t)z << 14) - (uint32_t)light->cut) >= 0;
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

static bool box_has(const struct glint_tables *tables, const struct glint_tables_light *light,
                    enum glint_normals format, const void *normals, uint32_t i)
{
    if (format == GLINT_NORMALS_INT8 && tables->kind != GLINT_TABLES_SMALL)
        return box_has_int8(light, ((const uint32_t *)normals)[i]);
    if (format == GLINT_NORMALS_INT10 && tables->kind == GLINT_TABLES_COLOUR && light->frontal)
        return box_has_int10(tables, light, ((const uint32_t *)normals)[i]);
    return box_has_vector(tables, light, glint_normal_at(format, normals, i));
}

enum glint_err glint_tables_box(const struct glint_tables *tables, const struct glint_tables_light *light,
                                enum glint_normals format, const void *normals, ptrdiff_t stride, uint16_t w,
                                uint16_t h, struct glint_box *highlight)
{
    const struct glint_surface unused = {highlight, 0, 0, 0};
    const enum glint_err err = glint_tables_check(tables, light, format, normals, stride, &unused);
    if (err)
        return err;
    uint32_t left = w, end = 0, top = 0, bottom = 0; /* end: one past the last column */
    for (uint16_t y = 0; y < h; y++, normals = (const uint8_t *)normals + stride) {
        uint32_t first = 0, last = w;
        while (first < w && !box_has(tables, light, format, normals, first))
            first++;
        if (first == w)
            continue;
        while (last > end && !box_has(tables, light, format, normals, last - 1))
            last--;
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
