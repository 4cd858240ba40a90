/* SPDX-License-Identifier: MIT
 * A line of a triangle by ALBEDO tables, over the mesh's colours: run by run these become a map in RGB565, and the run a span. */
#include "glint_mesh_albedo.h"
#include "glint_mesh_path.h"

/* The nearest of 31 or 63 levels. x / 255 to nearest, x < 2^16, without a division. */
static uint32_t albedo_level(uint32_t colour, uint32_t most)
{
    const uint32_t x = colour * most + 128;
    return (x + (x >> 8)) >> 8;
}

static bool albedo_tables_can(const void *with)
{
    const struct glint_mesh_albedo *albedo = (const struct glint_mesh_albedo *)with;
    return glint_mesh_albedo_can(albedo) && ((const struct glint_tables *)albedo->with)->kind == GLINT_TABLES_ALBEDO;
}

static const struct glint_tables *albedo_tables(const void *with)
{
    return (const struct glint_tables *)((const struct glint_mesh_albedo *)with)->with;
}

static uint32_t albedo_tables_t_end(const void *with)
{
    return albedo_tables(with)->t_max_q30 + 1;
}

static void albedo_tables_draw(const void *with, struct glint_mesh_triangle *triangle,
                               const struct glint_mesh_target *target)
{
    const struct glint_mesh_albedo *albedo = (const struct glint_mesh_albedo *)with;
    struct glint_mesh_across across;
    struct glint_mesh_row row;
    uint16_t *const map = (uint16_t *)(void *)target->samples;
    uint8_t *const colours = (uint8_t *)(map + GLINT_RUN);
    glint_mesh_albedo_set(&across, albedo->of_vertices, albedo->of_faces, target, triangle);
    while (glint_mesh_row_next(&row, triangle, target))
        for (unsigned count; (count = glint_mesh_in_front(&row, GLINT_RUN)) != 0; row.x += count) {
            const struct glint_span span = {row.t, row.dt, row.ddt, (int32_t)row.nl, (int32_t)row.dnl, (uint16_t)count};
            const struct glint_surface surface = {row.line + 2 * row.x, 0, (uint16_t)(row.left + row.x),
                                                  (uint16_t)row.y};
            glint_mesh_albedo_get(&across, (int32_t)row.x, glint_mesh_row_line(triangle), colours, count);
            for (unsigned i = 0; i < count; i++) {
                const uint8_t *colour = colours + 3 * i;
                map[i] = (uint16_t)(albedo_level(colour[0], 31) << 11 | albedo_level(colour[1], 63) << 5 |
                                    albedo_level(colour[2], 31));
                glint_mesh_step(&row);
            }
            glint_tables_albedo_span(albedo_tables(with), &span, map, &surface);
        }
}

const struct glint_mesh_path glint_mesh_tables_albedo GLINT_FLASH = {albedo_tables_can, albedo_tables_t_end,
                                                                     albedo_tables_draw, NULL};
