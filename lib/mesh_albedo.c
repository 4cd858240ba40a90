/* SPDX-License-Identifier: MIT
 * A line of a triangle by the prepared shader, over the mesh's colours: run by run these become an albedo map. */
#include "glint_mesh_albedo.h"
#include "glint_mesh_samples.h"
#include "glint_mesh_strip.h"

void glint_mesh_albedo_set(struct glint_mesh_across *across, const uint8_t *of_vertices, const uint8_t *of_faces,
                           const struct glint_mesh_target *target, const struct glint_mesh_triangle *triangle)
{
    struct glint_mesh_corners corners;
    int16_t colours[3][3];
    const unsigned face = glint_mesh_face_of(triangle);
    glint_mesh_corners_of(&corners, target, face);
    for (unsigned i = 0; i < 3; i++) {
        const uint8_t *colour = of_faces ? of_faces + 3 * (size_t)face
                                         : of_vertices + 3 * (size_t)target->drawn->mesh->faces[3 * (size_t)face + i];
        for (unsigned k = 0; k < 3; k++)
            colours[i][k] = colour[k];
    }
    glint_mesh_corners_weigh(&corners, colours);
    glint_mesh_across_set(across, &corners, colours);
}

void glint_mesh_albedo_get(const struct glint_mesh_across *across, int32_t x, int32_t y, uint8_t *out, unsigned count)
{
    uint32_t now[3];
    glint_mesh_across_at(across, x, y, now);
    for (const uint8_t *const end = out + 3 * count; out != end; out += 3)
        for (unsigned k = 0; k < 3; k++)
            out[k] = (uint8_t)glint_mesh_across_next(&across->of[k], &now[k]);
}

static bool albedo_can(const void *with)
{
    const struct glint_mesh_albedo *albedo = (const struct glint_mesh_albedo *)with;
    return glint_mesh_albedo_can(albedo) && glint_mesh_prepared_can((const struct glint_prepared *)albedo->with);
}

static uint32_t albedo_t_end(const void *with)
{
    return ((const struct glint_prepared *)((const struct glint_mesh_albedo *)with)->with)->near.t_end;
}

static void albedo_draw(const void *with, struct glint_mesh_triangle *triangle, const struct glint_mesh_target *target)
{
    const struct glint_mesh_albedo *albedo = (const struct glint_mesh_albedo *)with;
    struct glint_mesh_across across;
    struct glint_mesh_row row;
    uint8_t colours[3 * GLINT_RUN];
    glint_mesh_albedo_set(&across, albedo->of_vertices, albedo->of_faces, target, triangle);
    while (glint_mesh_row_next(&row, triangle, target)) {
        struct glint_run run = {row.line, 0, row.left, row.y, colours, NULL, NULL};
        for (unsigned count; (count = glint_mesh_in_front(&row, GLINT_RUN)) != 0; row.x += count) {
            glint_mesh_albedo_get(&across, (int32_t)row.x, glint_mesh_row_line(triangle), colours, count);
            glint_mesh_samples(&row, target->samples, count);
            run.x = row.x;
            glint_prepared_run((const struct glint_prepared *)albedo->with, &run, target->samples, count);
        }
    }
}

const struct glint_mesh_path glint_mesh_exact_albedo GLINT_FLASH = {albedo_can, albedo_t_end, albedo_draw, NULL};
