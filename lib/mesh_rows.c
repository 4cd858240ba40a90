/* SPDX-License-Identifier: MIT
 * Lines of a triangle as pixels of any paint: those side by side that are in front are a run. Mostly t and nl are there, as along a span;
 * under points, spots and several lights, and for Phong, normals are interpolated, and a pixel has a place, from its depth. */
#include "glint_mesh_rows.h"
#include "glint_grain.h"
#include "glint_math.h"
#include "glint_mesh_pose.h"
#include "glint_mesh_strip.h"
#include "glint_mesh_texture.h"
#include "glint_tables.h"

/* So that what two functions hold is not on the stack together. */
#define ROWS_ALONE __attribute__((noinline)) static

/* The triangle's line; false where it has no pixel. */
static bool row_set(struct glint_mesh_row *row, const struct glint_mesh_triangle *triangle,
                    const struct glint_mesh_part *part, const struct glint_mesh_target *target)
{
    const struct glint_mesh_values *v = &triangle->values;
    const struct glint_surface *surface = target->surface;
    const int32_t line = triangle->y - target->y;
    int32_t left, right;
    if (!glint_mesh_columns(part->left, part->right, target->w, &left, &right))
        return false;
    const int32_t k = left - v->x; /* |k| < 2^12 */
    const uint32_t n = (uint32_t)k, pairs = (uint32_t)(k * (k - 1) / 2);
    row->run.line = (uint8_t *)surface->pixels + surface->stride * line;
    row->depth = target->depth + (size_t)target->w * (size_t)line;
    row->run.x = (uint32_t)left;
    row->end = (uint32_t)right;
    row->run.left = surface->x;
    row->run.y = (uint32_t)surface->y + (uint32_t)line;
    row->at.t_q30 = v->t + n * v->tx + pairs * v->txx;
    row->at.dt_q30 = v->tx + n * v->txx;
    row->at.ddt_q30 = v->txx;
    row->at.nl_q30 = (int32_t)(v->nl + n * v->nlx);
    row->at.dnl_q30 = (int32_t)v->nlx;
    row->z = v->z + n * v->zx;
    row->dz = v->zx;
    return true;
}

/* The triangle's next row; the triangle goes on to the line after it. false: there is none before the end of it or of the strip. */
ROWS_ALONE bool row_next(struct glint_mesh_row *row, struct glint_mesh_triangle *triangle,
                         const struct glint_mesh_target *target)
{
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end;
    bool found = false;
    while (!found && triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        found = row_set(row, triangle, &part, target);
        glint_mesh_edge_next(part.left);
        glint_mesh_edge_next(part.right);
        glint_mesh_values_next(&triangle->values);
        triangle->y++;
    }
    return found;
}

/* t and nl to another pixel. */
static inline void row_step(struct glint_mesh_row *row)
{
    row->at.t_q30 += row->at.dt_q30;
    row->at.dt_q30 += row->at.ddt_q30;
    row->at.nl_q30 = (int32_t)((uint32_t)row->at.nl_q30 + (uint32_t)row->at.dnl_q30);
}

/* The next pixels side by side that are in front, at most `most`: enters their depths and returns how many they are; row stands at the
 * first of them. 0: there is none. */
static unsigned row_in_front(struct glint_mesh_row *row, unsigned most)
{
    uint16_t *depth = row->depth + row->run.x;
    uint32_t z = row->z;
    for (; row->run.x < row->end && z >> 16 >= *depth; row->run.x++, depth++, z += row->dz)
        row_step(row);
    const uint32_t left = row->end - row->run.x;
    unsigned count = 0;
    for (most = left < most ? (unsigned)left : most; count < most && z >> 16 < *depth; count++, depth++, z += row->dz)
        *depth = (uint16_t)(z >> 16);
    row->z = z;
    return count;
}

/* ---- Colours of the mesh and textures: run by run they become an albedo map ---- */

static bool colours_are(const struct glint_mesh *mesh)
{
    return mesh->of_vertices || mesh->of_faces;
}

ROWS_ALONE void colours_set(struct glint_mesh_across *across, const struct glint_mesh_target *target,
                            const struct glint_mesh_triangle *triangle)
{
    const struct glint_mesh *mesh = target->drawn->mesh;
    struct glint_mesh_corners corners;
    int16_t colours[3][3];
    const unsigned face = glint_mesh_face_of(triangle);
    glint_mesh_corners_of(&corners, target, face);
    for (unsigned i = 0; i < 3; i++) {
        const uint8_t *colour = mesh->of_faces ? mesh->of_faces + 3 * (size_t)face
                                               : mesh->of_vertices + 3 * (size_t)mesh->faces[3 * (size_t)face + i];
        for (unsigned k = 0; k < 3; k++)
            colours[i][k] = colour[k];
    }
    glint_mesh_corners_weigh(&corners, colours);
    glint_mesh_across_set(across, &corners, colours);
}

/* Those of count pixels from x on: red, green, blue. */
static void colours_get(const struct glint_mesh_across *across, int32_t x, int32_t y, uint8_t *out, unsigned count)
{
    uint32_t now[3];
    glint_mesh_across_at(across, x, y, now);
    for (const uint8_t *const end = out + 3 * count; out != end; out += 3)
        for (unsigned k = 0; k < 3; k++)
            out[k] = (uint8_t)glint_mesh_across_next(&across->of[k], &now[k]);
}

/* ---- From normals ---- */

/* In the frame's memory, as it would take stack. */
struct mesh_lit {
    struct glint_lights lights;
    struct glint_mesh_across across;
    struct glint_vec normals[GLINT_MESH_RUN];
    int32_t places[GLINT_MESH_RUN][3];
};
typedef char mesh_lit_fits[sizeof(struct mesh_lit) + sizeof(void *) <= GLINT_MESH_LIGHTS_BYTES ? 1 : -1];

void glint_mesh_lit_begin(void *memory)
{
    ((struct mesh_lit *)memory)->lights.paint = NULL;
}

/* The corners' normals, turned as the mesh is. */
ROWS_ALONE void lit_normals(struct glint_mesh_across *across, const struct glint_mesh_target *target,
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
        for (unsigned k = 0; k < 3; k++)
            turned[i][k] = glint_mesh_turned(drawn->turn[k], n.x, n.y, n.z);
    }
    glint_mesh_across_set(across, &corners, turned);
}

/* Places are held to this, 1/16 pixel. */
static int32_t lit_place(int64_t x)
{
    const int32_t far = (int32_t)1 << 20;
    return x > far ? far : x < -far ? -far : (int32_t)x;
}

/* A place in perspective, from the viewport's middle as all here; z: its depth, Q16.16. 1 / r = 2^29 / R = q 2^-32. */
static void lit_far(int32_t place[3], uint16_t distance, uint32_t z)
{
    const uint32_t most = (uint32_t)65535 << 16, r = z < most - 65536 ? most - z : 65536;
    const uint64_t q = ((uint64_t)1 << 61) / r; /* <= 2^45 */
    place[0] = lit_place((place[0] * (int64_t)q) >> 32);
    place[1] = lit_place((place[1] * (int64_t)q) >> 32);
    place[2] = lit_place(distance - (int64_t)((distance * q) >> 32));
}

/* Normals, and places on the screen, of count pixels; z: of the first. A component after the other, as cores have few registers. */
ROWS_ALONE void lit_fill(struct mesh_lit *lit, const struct glint_mesh_frame *frame, const struct glint_mesh_row *row,
                         int32_t line, uint32_t z, unsigned count)
{
    const int32_t middle_x = 8 * (int32_t)frame->w, middle_y = 8 * (int32_t)frame->h;
    const int32_t left = middle_x + 16 * (int32_t)row->run.left, top = middle_y + 16 * ((int32_t)row->run.y - line);
    int32_t x = 16 * (int32_t)row->run.x + 8 - middle_x;
    uint32_t now[3];
    glint_mesh_across_at(&lit->across, (int32_t)row->run.x, line, now);
    for (unsigned k = 0; k < 3; k++) {
        const struct glint_mesh_slope slope = lit->across.of[k];
        int16_t *out = &lit->normals[0].x + k;
        for (unsigned i = 0; i < count; i++, out += 3)
            *out = glint_mesh_across_next(&slope, &now[k]);
    }
    for (unsigned i = 0; i < count; i++, z += row->dz, x += 16) {
        int32_t *const place = lit->places[i];
        place[0] = x;
        place[1] = 16 * line + 8 - middle_y;
        place[2] = 32767 - (int32_t)(z >> 16);
        if (frame->distance)
            lit_far(place, frame->distance, z);
        place[0] += left;
        place[1] += top;
    }
}

/* Before a triangle's lines; returns how many pixels a run may have. */
ROWS_ALONE unsigned lit_begin(struct mesh_lit *lit, const struct glint_paint *paint, struct glint_run *run)
{
    lit->lights.run = run;
    if (!paint->several)
        return GLINT_MESH_RUN;
    if (lit->lights.paint != paint)
        GLINT_FLASH_POINTER(paint->several->begin)(&lit->lights, paint, false);
    run->apart = glint_lights_apart(&lit->lights);
    lit->lights.normals = lit->normals;
    lit->lights.places = (const int32_t(*)[3])lit->places;
    return lit->lights.length;
}

/* ---- Any ---- */

bool glint_mesh_is_lit(const struct glint_paint *paint)
{
    return paint->several || glint_mesh_has_grain(paint) ||
           (glint_paint_is_exact(paint) && GLINT_FLASH_POINTER(paint->model->geometry));
}

uint32_t glint_mesh_t_end(const struct glint_paint *paint)
{
    return glint_mesh_is_lit(paint)      ? 0 /* t is not asked for */
           : glint_paint_is_exact(paint) ? paint->of.exact.t_end
                                         : paint->of.tables.filled.t_max_q30 + 1;
}

bool glint_mesh_is_colour(const struct glint_paint *paint, const struct glint_mesh_target *target)
{
    return GLINT_FUSED && !glint_paint_is_exact(paint) && paint->of.tables.filled.kind == GLINT_TABLES_COLOUR &&
           !paint->of.tables.filled.dither && !GLINT_MISALIGNED(target->surface->pixels, 16) &&
           !GLINT_MISALIGNED(target->surface->stride, 16);
}

/* An outline's cell as a row of one pixel, of which coverage is a part. */
static bool row_cell(struct glint_mesh_row *row, struct glint_mesh_cells *cells, glint_mesh_next *next,
                     const struct glint_mesh_target *target, struct glint_mesh_cell *cell)
{
    const struct glint_surface *surface = target->surface;
    if (!next(cells, cell))
        return false;
    row->run.line = (uint8_t *)surface->pixels + surface->stride * cell->line;
    row->run.x = (uint32_t)cell->x;
    row->end = row->run.x + 1;
    row->run.left = surface->x;
    row->run.y = (uint32_t)surface->y + (uint32_t)cell->line;
    row->run.coverage = (const uint8_t *)((uintptr_t)&cell->part - (uintptr_t)row->run.x);
    row->at.t_q30 = cell->t;
    row->at.nl_q30 = (int32_t)cell->nl;
    row->at.dt_q30 = row->at.ddt_q30 = 0;
    row->at.dnl_q30 = 0;
    row->z = cell->z;
    row->dz = 0;
    return true;
}

/* ARGB8888 has coverage as alpha, which is right where nothing was; else the pixel lies over what was. x / 255 to nearest, x < 2^16. */
static void cell_over(uint8_t *pixel, const uint8_t was[4], uint32_t part)
{
    for (int k = 0; k < 4 && was[3]; k++) {
        const uint32_t over = k < 3 ? pixel[k] : 255, v = part * over + (255 - part) * was[k] + 128;
        pixel[k] = (uint8_t)((v + (v >> 8)) >> 8);
    }
}

/* By any paint. cells: NULL, or an outline's, of the triangle's face, and what finds the next. whole: NULL, or of a piece of a line the
 * columns from the line's first one on, and the one after its last. */
static inline __attribute__((always_inline)) void
rows_of(const struct glint_paint *paint, struct glint_mesh_triangle *triangle, const struct glint_mesh_target *target,
        struct glint_mesh_row *row, struct glint_mesh_cells *cells, glint_mesh_next *next, struct glint_mesh_cell *cell,
        const int32_t *whole)
{
    const bool is_alpha = paint->output.format == GLINT_ARGB8888;
    uint8_t was[4] = {0, 0, 0, 0};
    struct glint_mesh_bench *const bench = (struct glint_mesh_bench *)target->frame->memory;
    struct mesh_lit *const lit = glint_mesh_is_lit(paint) ? (struct mesh_lit *)target->frame->lit : NULL;
    struct glint_sample *const samples = target->samples;
    struct glint_raw *const raws = (struct glint_raw *)(void *)samples;
    const struct glint_texture *const texture = glint_mesh_texture_of(target->drawn, paint);
    const bool exact = glint_paint_is_exact(paint), has_colours = colours_are(target->drawn->mesh);
    const struct glint_use_mesh *const use = texture || (has_colours && !exact) ? target->drawn->mesh->use : NULL;
    const bool has_grain = glint_mesh_has_grain(paint);
    struct glint_run *const run = &row->run;
    unsigned most = GLINT_MESH_RUN;
    run->albedo = texture || has_colours ? (uint8_t *)bench->colours : NULL;
    run->gloss = run->coverage = NULL;
    run->apart = 0;
    glint_run_soften(run, paint, cells ? &glint_use_coverage : NULL);
    if (lit) {
        most = lit_begin(lit, paint, run);
        lit_normals(&lit->across, target, triangle);
    }
    if (use)
        GLINT_FLASH_POINTER(use->set)(&bench->of.over, target, glint_mesh_face_of(triangle), texture);
    else if (run->albedo)
        colours_set(&bench->of.across, target, triangle);
    while (cells ? row_cell(row, cells, next, target, cell) : row_next(row, triangle, target)) {
        const int32_t line = cells ? target->y + cell->line : triangle->y - 1; /* the picture's */
        if (use) {
            const int32_t x = (int32_t)run->x, left = whole ? whole[0] : x,
                          right = whole ? whole[1] : (int32_t)row->end;
            GLINT_FLASH_POINTER(use->line)
            (&bench->of.over, line, left, right, row->z - (uint32_t)(x - left) * row->dz, row->dz);
        }
        for (unsigned count; (count = cells ? (unsigned)(row->end - run->x) : row_in_front(row, most)) != 0;
             run->x += count) {
            if (cells && is_alpha)
                for (int k = 0; k < 4; k++)
                    was[k] = run->line[4 * run->x + (unsigned)k];
            if (use)
                (exact ? GLINT_FLASH_POINTER(use->rgb888) : GLINT_FLASH_POINTER(use->rgb565))(
                    &bench->of.over, (int32_t)run->x, (uint8_t *)bench->colours, count);
            else if (run->albedo)
                colours_get(&bench->of.across, (int32_t)run->x, line, (uint8_t *)bench->colours, count);
            if (lit) {
                lit_fill(lit, target->frame, row, line, row->z - count * row->dz, count);
                if (paint->several)
                    GLINT_FLASH_POINTER(paint->several->run)(&lit->lights, count);
                else if (has_grain)
                    GLINT_FLASH_POINTER(target->drawn->mesh->use_grain->row)
                (paint, run, target->drawn->mesh->grain, target->drawn->turn, lit->normals, samples, count);
                else GLINT_FLASH_POINTER(paint->model->geometry)(&paint->l, &paint->v, &paint->h, lit->normals, samples,
                                                                 count);
            } else if (exact) {
                glint_samples_walk(&row->at, samples, count);
            } else {
                glint_raws_walk(&row->at, paint->of.tables.filled.t_max_q30, raws, count);
                glint_tables_pixels(paint, run, raws, count);
            }
            if (exact && !paint->several && !has_grain)
                glint_paint_run(paint, run, samples, count);
            if (cells && is_alpha)
                cell_over(run->line + 4 * run->x, was, cell->part);
        }
    }
}

ROWS_ALONE void rows_draw(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                          const struct glint_mesh_target *target)
{
    struct glint_mesh_row row;
    rows_of(paint, triangle, target, &row, NULL, NULL, NULL, NULL);
}

/* What outlines take of it. */
ROWS_ALONE void rows_outlined(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                              const struct glint_mesh_target *target, struct glint_mesh_row *row,
                              struct glint_mesh_cells *cells, glint_mesh_next *next, struct glint_mesh_cell *cell,
                              const int32_t *whole)
{
    rows_of(paint, triangle, target, row, cells, next, cell, whole);
}

void glint_mesh_blend_cells(const struct glint_paint *paint, struct glint_mesh_cells *cells, glint_mesh_next *next,
                            struct glint_mesh_blending *blending, struct glint_mesh_triangle *triangle,
                            const struct glint_mesh_target *target)
{
    rows_outlined(paint, triangle, target, &blending->row, cells, next, &blending->cell, NULL);
}

bool glint_mesh_is_albedo(const struct glint_paint *paint, const struct glint_mesh_target *target)
{
    return GLINT_FUSED && target->drawn->mesh->use && !glint_paint_is_exact(paint) &&
           paint->of.tables.filled.kind == GLINT_TABLES_ALBEDO && !GLINT_MISALIGNED(target->surface->pixels, 16) &&
           !GLINT_MISALIGNED(target->surface->stride, 16);
}

/* What is linear over a triangle is held, and in perspective found, by the ends of its lines. */
void glint_mesh_piece(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                      const struct glint_mesh_target *target, struct glint_mesh_row *row, const int32_t whole[2])
{
    if (glint_mesh_is_colour(paint, target))
        glint_mesh_colour(&paint->of.tables.filled, triangle, target);
    else
        rows_outlined(paint, triangle, target, row, NULL, NULL, NULL, whole);
}

void glint_mesh_rows(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                     const struct glint_mesh_target *target)
{
    if (triangle->y < target->y)
        glint_mesh_triangle_skip(triangle, target->y);
    if (glint_mesh_is_colour(paint, target)) {
        glint_mesh_colour(&paint->of.tables.filled, triangle, target);
    } else if (glint_mesh_is_albedo(paint, target)) {
        GLINT_FLASH_POINTER(target->drawn->mesh->use->lines)
        (&paint->of.tables.filled, triangle, target, glint_mesh_texture_of(target->drawn, paint));
    } else { /* an odd surface, after one that was not */
        triangle->shine &= GLINT_MESH_LAID - 1;
        rows_draw(paint, triangle, target);
    }
}
