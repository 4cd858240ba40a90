/* SPDX-License-Identifier: MIT
 * A line of a triangle under several lights, pixel by pixel. A pixel has a normal, linear between the corners', and a place, from its
 * depth: lamps that have a place are moved such that the surface's pixel, to which glint_shade_lights sees them, is at this place. */
#include "glint_lights.h"
#include "glint_math_align.h"
#include "glint_mesh_albedo.h"
#include "glint_mesh_pose.h"
#include "glint_mesh_strip.h"

struct mesh_lights {
    struct glint_lights lights;
    struct glint_prepared prepared;
    struct glint_lamp lamps[GLINT_LAMPS_MAX]; /* for the pixel at hand */
    int32_t positions[GLINT_LAMPS_MAX][3];
    struct glint_mesh_across normals, colours;
};

size_t glint_mesh_lights_bytes(void)
{
    return sizeof(struct mesh_lights);
}

enum glint_err glint_mesh_lights_init(struct glint_mesh_lights *lights, const struct glint_shader *shader,
                                      const struct glint_lamp *lamps, unsigned count, void *memory, size_t bytes)
{
    if (!lights || !shader || !memory || bytes < sizeof(struct mesh_lights) || GLINT_MISALIGNED(memory, pointer))
        return GLINT_ERR_ARG;
    struct mesh_lights *const work = (struct mesh_lights *)memory;
    const enum glint_err err = glint_lights_init(&work->lights, &work->prepared, shader, lamps, count);
    if (err)
        return err;
    for (unsigned i = 0; i < count; i++) {
        work->lamps[i] = lamps[i];
        for (unsigned k = 0; k < 3; k++)
            work->positions[i][k] = lamps[i].position[k];
    }
    work->lights.lamps = work->lamps;
    lights->of_vertices = lights->of_faces = NULL;
    lights->memory = memory;
    return GLINT_OK;
}

static bool lit_can(const void *with)
{
    const struct glint_mesh_lights *lights = (const struct glint_mesh_lights *)with;
    return lights && lights->memory && !(lights->of_vertices && lights->of_faces);
}

/* The light of glint_mesh_add is not this one: t is not asked for. */
static uint32_t lit_t_end(const void *with)
{
    (void)with;
    return 0;
}

static int16_t lit_hold(int32_t x)
{
    return (int16_t)(x > INT16_MAX ? INT16_MAX : x < -INT16_MAX ? -INT16_MAX : x);
}

/* The corners' normals, turned as the mesh is: |sum| <= 3 2^29. */
static void lit_normals(struct glint_mesh_across *across, const struct glint_mesh_target *target,
                        const struct glint_mesh_triangle *triangle)
{
    const struct glint_mesh_drawn *drawn = target->drawn;
    const uint16_t *face = drawn->mesh->faces + 3 * (size_t)glint_mesh_face_of(triangle);
    struct glint_mesh_corners corners;
    int16_t turned[3][3];
    glint_mesh_corners_of(&corners, target, glint_mesh_face_of(triangle));
    for (unsigned i = 0; i < 3; i++) {
        struct glint_vec n;
        if (corners.clipped[i])
            n = corners.clipped[i]->normal;
        else
            glint_mesh_normal(&n, drawn->mesh, face[i]);
        for (unsigned k = 0; k < 3; k++) {
            const int16_t *row = drawn->turn[k];
            turned[i][k] =
                lit_hold(((int32_t)row[0] * n.x + (int32_t)row[1] * n.y + (int32_t)row[2] * n.z + 8192) >> 14);
        }
    }
    glint_mesh_across_set(across, &corners, turned);
}

/* Places are held to this, 1/16 pixel. */
static int32_t lit_place(int64_t x)
{
    const int32_t far = (int32_t)1 << 20;
    return x > far ? far : x < -far ? -far : (int32_t)x;
}

/* The place of a pixel, from the viewport's middle; z: its depth, Q16.16. Under perspective 1 / r = 2^29 / R = q 2^-32. */
static void lit_at(int32_t place[3], const struct glint_mesh_frame *frame, int32_t x, int32_t y, uint32_t z)
{
    place[0] = 16 * x + 8 - 8 * (int32_t)frame->w;
    place[1] = 16 * y + 8 - 8 * (int32_t)frame->h;
    place[2] = 32767 - (int32_t)(z >> 16);
    if (frame->distance == 0)
        return;
    const uint32_t most = (uint32_t)65535 << 16, r = z < most - 65536 ? most - z : 65536;
    const uint64_t q = ((uint64_t)1 << 61) / r; /* <= 2^45 */
    place[0] = lit_place((place[0] * (int64_t)q) >> 32);
    place[1] = lit_place((place[1] * (int64_t)q) >> 32);
    place[2] = lit_place(frame->distance - (int64_t)((frame->distance * q) >> 32));
}

/* The lamps as seen from a place, when the pixel of the run is where lights look from. */
static void lit_move(struct mesh_lights *work, const int32_t place[3])
{
    const struct glint_run *run = &work->lights.run;
    const int32_t here[3] = {16 * (int32_t)(run->left + run->x) + 8, 16 * (int32_t)run->y + 8, 0};
    for (unsigned i = 0; i < work->lights.count; i++)
        for (unsigned k = 0; k < 3; k++)
            work->lamps[i].position[k] = work->positions[i][k] - place[k] + here[k];
}

/* Pixels x.. of a row; z: of the first. */
static void lit_pixels(struct mesh_lights *work, const struct glint_mesh_frame *frame, const struct glint_mesh_row *row,
                       int32_t line, uint32_t z, unsigned count, bool coloured)
{
    struct glint_lights *const lights = &work->lights;
    uint32_t now[3];
    struct glint_vec normal;
    uint8_t colour[3];
    glint_mesh_across_at(&work->normals, (int32_t)row->x, line, now);
    for (unsigned i = 0; i < count; i++, z += row->dz) {
        int32_t place[3];
        normal.x = glint_mesh_across_next(&work->normals.of[0], &now[0]);
        normal.y = glint_mesh_across_next(&work->normals.of[1], &now[1]);
        normal.z = glint_mesh_across_next(&work->normals.of[2], &now[2]);
        lights->run.x = row->x + i;
        if (coloured) {
            glint_mesh_albedo_get(&work->colours, (int32_t)(row->x + i), line, colour, 1);
            lights->run.albedo = colour;
        }
        lit_at(place, frame, (int32_t)(row->x + i), line, z);
        lit_move(work, place);
        glint_lights_pixel(lights, &normal);
    }
}

static void lit_draw(const void *with, struct glint_mesh_triangle *triangle, const struct glint_mesh_target *target)
{
    const struct glint_mesh_lights *of = (const struct glint_mesh_lights *)with;
    struct mesh_lights *const work = (struct mesh_lights *)of->memory;
    struct glint_mesh_row row;
    lit_normals(&work->normals, target, triangle);
    const uint8_t *const colours = of->of_faces ? of->of_faces : of->of_vertices;
    if (colours)
        glint_mesh_albedo_set(&work->colours, of->of_vertices, of->of_faces, target, triangle);
    work->lights.run.albedo = work->lights.run.gloss = work->lights.run.mask = NULL;
    while (glint_mesh_row_next(&row, triangle, target)) {
        work->lights.run.line = row.line;
        work->lights.run.left = row.left;
        work->lights.run.y = row.y;
        for (unsigned count; (count = glint_mesh_in_front(&row, GLINT_RUN)) != 0; row.x += count)
            lit_pixels(work, target->frame, &row, glint_mesh_row_line(triangle), row.z - count * row.dz, count,
                       colours != NULL);
    }
}

const struct glint_mesh_path glint_mesh_lit GLINT_FLASH = {lit_can, lit_t_end, lit_draw, NULL};
