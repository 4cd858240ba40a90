/* SPDX-License-Identifier: MIT
 * A picture of meshes, strip by strip. */
#include "glint_math_align.h"
#include "glint_mesh_clip.h"
#include "glint_mesh_edges.h"
#include "glint_mesh_lists.h"
#include "glint_mesh_path.h"

/* What the work on one face takes; ahead of the depths, so that it is not on the stack. */
struct bench {
    struct glint_mesh_polygon polygon;
    struct glint_mesh_triangle triangle;
    struct glint_mesh_corner corner[3];
    struct glint_mesh_row row;
    struct glint_sample samples[GLINT_RUN];
};

/* More than an AVR can address is more than it can have. */
static size_t mesh_size(uint32_t bytes)
{
    return (size_t)bytes == bytes ? (size_t)bytes : SIZE_MAX;
}

size_t glint_mesh_frame_bytes(uint16_t w, uint16_t lines)
{
    return mesh_size((uint32_t)sizeof(struct bench) + (uint32_t)2 * w * lines);
}

enum glint_err glint_mesh_begin(struct glint_mesh_frame *frame, uint16_t w, uint16_t h, uint16_t lines,
                                uint16_t distance, void *memory, size_t bytes)
{
    if (!frame || !memory || w == 0 || h == 0 || lines == 0 || w > GLINT_MESH_SIZE_MAX || h > GLINT_MESH_SIZE_MAX ||
        bytes < glint_mesh_frame_bytes(w, lines) || GLINT_MISALIGNED(memory, 32))
        return GLINT_ERR_ARG;
    frame->first = NULL;
    frame->last = &frame->first;
    frame->memory = memory;
    frame->w = w;
    frame->h = h;
    frame->lines = lines;
    frame->distance = distance;
    frame->y = 0;
    return GLINT_OK;
}

static uint32_t frame_bands(uint16_t h)
{
    return (h + GLINT_MESH_BAND - 1u) / GLINT_MESH_BAND;
}

size_t glint_mesh_bytes(const struct glint_mesh *mesh, uint16_t h)
{
    if (!mesh)
        return 0;
    return mesh_size((uint32_t)mesh->vertex_count * (uint32_t)sizeof(struct glint_mesh_vertex) +
                     2 * ((uint32_t)mesh->face_count + frame_bands(h)));
}

enum glint_err glint_mesh_add(struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn,
                              const struct glint_mesh *mesh, const struct glint_pose *pose,
                              const struct glint_light *light, const struct glint_paint *paints, void *memory,
                              size_t bytes)
{
    if (!frame || !drawn || !mesh || !pose || !light || !paints || !memory || GLINT_MISALIGNED(memory, 32) ||
        bytes < glint_mesh_bytes(mesh, frame->h))
        return GLINT_ERR_ARG;
    if (!glint_pose_set(drawn, pose, light))
        return GLINT_ERR_VECTOR;
    drawn->next = NULL;
    drawn->mesh = mesh;
    drawn->paints = paints;
    drawn->vertices = (struct glint_mesh_vertex *)memory;
    drawn->links = (uint16_t *)(void *)(drawn->vertices + mesh->vertex_count);
    drawn->bands = drawn->links + mesh->face_count;
    glint_mesh_vertices(frame, drawn);
    glint_mesh_sort(frame, drawn, frame->y);
    *frame->last = drawn;
    frame->last = &drawn->next;
    return GLINT_OK;
}

/* A strip in work. */
struct strip {
    const struct glint_mesh_frame *frame;
    const struct glint_surface *surface;
    uint16_t *depth;
    int32_t y, end;
};

/* The triangle's lines in the strip. */
static void strip_triangle(const struct strip *strip, const struct glint_paint *paint)
{
    const struct glint_surface *surface = strip->surface;
    struct bench *bench = (struct bench *)strip->frame->memory;
    struct glint_mesh_triangle *triangle = &bench->triangle;
    struct glint_mesh_row *row = &bench->row;
    row->left = surface->x;
    row->ddt = triangle->values.txx;
    row->dnl = triangle->values.nlx;
    row->dz = triangle->values.zx;
    row->samples = bench->samples;
    const int32_t end = triangle->y_end < strip->end ? triangle->y_end : strip->end;
    if (triangle->y < strip->y)
        glint_mesh_triangle_skip(triangle, strip->y);
    for (; triangle->y < end; glint_mesh_triangle_next(triangle)) {
        const struct glint_mesh_values *v = &triangle->values;
        int32_t left, right;
        if (!glint_mesh_triangle_line(triangle, strip->frame->w, &left, &right))
            continue;
        const int32_t line = triangle->y - strip->y, k = left - v->x; /* |k| < 2^12 */
        const uint32_t n = (uint32_t)k, pairs = (uint32_t)(k * (k - 1) / 2);
        row->line = (uint8_t *)surface->pixels + surface->stride * line;
        row->depth = strip->depth + (size_t)strip->frame->w * (uint32_t)line;
        row->x = (uint32_t)left;
        row->end = (uint32_t)right;
        row->y = (uint32_t)surface->y + (uint32_t)line;
        row->t = v->t + n * v->tx + pairs * v->txx;
        row->dt = v->tx + n * v->txx;
        row->nl = v->nl + n * v->nlx;
        row->z = v->z + n * v->zx;
        paint->path->row(paint->with, row);
    }
}

/* A face that needs no clipping. */
static void strip_face(const struct strip *strip, const struct glint_mesh_drawn *drawn, const uint16_t face[3],
                       const struct glint_paint *paint)
{
    struct bench *bench = (struct bench *)strip->frame->memory;
    for (int i = 0; i < 3; i++) {
        bench->corner[i].v = drawn->vertices[face[i]];
        bench->corner[i].normal = glint_mesh_normal(drawn->mesh, face[i]);
    }
    if (glint_mesh_triangle_set(&bench->triangle, bench->corner))
        strip_triangle(strip, paint);
}

/* The others, as a fan. */
static void strip_clipped(const struct strip *strip, const struct glint_mesh_drawn *drawn, const uint16_t face[3],
                          const struct glint_paint *paint)
{
    struct bench *bench = (struct bench *)strip->frame->memory;
    const unsigned count = glint_mesh_clip(&bench->polygon, strip->frame, drawn, face);
    const struct glint_mesh_clipped *at = bench->polygon.corner[bench->polygon.now];
    for (unsigned i = 2; i < count; i++) {
        bench->corner[0] = glint_mesh_clip_corner(strip->frame, drawn, &at[0]);
        bench->corner[1] = glint_mesh_clip_corner(strip->frame, drawn, &at[i - 1]);
        bench->corner[2] = glint_mesh_clip_corner(strip->frame, drawn, &at[i]);
        if (glint_mesh_area(&bench->corner[0].v, &bench->corner[1].v, &bench->corner[2].v) < 0 &&
            glint_mesh_triangle_set(&bench->triangle, bench->corner))
            strip_triangle(strip, paint);
    }
}

static void strip_mesh(const struct strip *strip, const struct glint_mesh_drawn *drawn)
{
    const struct glint_mesh *mesh = drawn->mesh;
    uint16_t later = GLINT_MESH_NONE, *later_end = &later;
    unsigned part = 0;
    for (uint16_t i = glint_mesh_take(drawn, strip->y, strip->end), next; i != GLINT_MESH_NONE; i = next) {
        const uint16_t *face = mesh->faces + 3 * (size_t)i;
        int32_t first, last;
        next = drawn->links[i];
        glint_mesh_face_lines(strip->frame, drawn, face, &first, &last);
        if (last > strip->end) {
            *later_end = i;
            later_end = &drawn->links[i];
            *later_end = GLINT_MESH_NONE;
        }
        while (part + 1 < mesh->part_count && i >= mesh->ends[part])
            part++;
        if (first >= strip->end)
            continue;
        if (glint_mesh_face_is_out(drawn, face))
            strip_clipped(strip, drawn, face, &drawn->paints[part]);
        else
            strip_face(strip, drawn, face, &drawn->paints[part]);
    }
    if (strip->end < strip->frame->h)
        glint_mesh_give(drawn, later, strip->end);
}

static bool strip_can(const struct glint_mesh_frame *frame, const struct glint_surface *surface)
{
    for (const struct glint_mesh_drawn *drawn = frame->first; drawn; drawn = drawn->next)
        for (unsigned i = 0; i == 0 || i < drawn->mesh->part_count; i++)
            if (!drawn->paints[i].path || !drawn->paints[i].path->can(drawn->paints[i].with, surface))
                return false;
    return true;
}

enum glint_err glint_mesh_strip(struct glint_mesh_frame *frame, uint16_t y, uint16_t h,
                                const struct glint_surface *surface)
{
    if (!frame || !surface || !surface->pixels || y >= frame->h || h == 0 || h > frame->lines || h > frame->h - y ||
        !strip_can(frame, surface))
        return GLINT_ERR_ARG;
    struct bench *bench = (struct bench *)frame->memory;
    const struct strip strip = {frame, surface, (uint16_t *)(void *)(bench + 1), y, y + h};
    for (size_t i = 0, all = (size_t)frame->w * h; i < all; i++)
        strip.depth[i] = UINT16_MAX;
    for (const struct glint_mesh_drawn *drawn = frame->first; drawn; drawn = drawn->next) {
        if (y != frame->y)
            glint_mesh_sort(frame, drawn, y);
        strip_mesh(&strip, drawn);
    }
    frame->y = (uint16_t)(y + h);
    return GLINT_OK;
}
