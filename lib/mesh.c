/* SPDX-License-Identifier: MIT
 * A mesh, checked; a picture of meshes: its memory, and what is drawn in it. */
#include "glint_port.h"
#include "glint_mesh_strip.h"
#include "glint_mesh_pose.h"
#include "glint_mesh_texture.h"
#include "glint_tables.h"

typedef char kept_fits[sizeof(struct glint_mesh_kept) <= GLINT_MESH_KEPT_BYTES ? 1 : -1];

/* Arrays of 16 bits, as cores without unaligned loads would stop at. */
static bool mesh_is_misaligned(const struct glint_mesh *mesh)
{
    const uintptr_t bits = (uintptr_t)mesh->places | (uintptr_t)mesh->normals | (uintptr_t)mesh->faces |
                           (uintptr_t)mesh->ends | (uintptr_t)mesh->neighbours;
    return GLINT_MISALIGNED(bits, 16);
}

enum glint_err glint_mesh_check(const struct glint_mesh *mesh)
{
    if (!mesh || !mesh->places || !mesh->faces || !(mesh->normals || mesh->normals8) || mesh->vertex_count == 0 ||
        mesh->face_count > GLINT_MESH_FACES_MAX || (mesh->part_count && !mesh->ends) ||
        (mesh->of_vertices && mesh->of_faces) || mesh_is_misaligned(mesh))
        return GLINT_ERR_ARG;
    for (size_t i = 0; i < (size_t)3 * mesh->face_count; i++)
        if (mesh->faces[i] >= mesh->vertex_count)
            return GLINT_ERR_ARG;
    for (size_t i = 0; mesh->neighbours && i < (size_t)3 * mesh->face_count; i++)
        if (mesh->neighbours[i] >= mesh->face_count && mesh->neighbours[i] < GLINT_MESH_SEAM)
            return GLINT_ERR_ARG;
    for (size_t i = 0; !mesh->normals && i < (size_t)3 * mesh->vertex_count; i++)
        if (mesh->normals8[i] == INT8_MIN)
            return GLINT_ERR_ARG;
    for (unsigned i = 1; i < mesh->part_count; i++)
        if (mesh->ends[i] < mesh->ends[i - 1])
            return GLINT_ERR_ARG;
    if (mesh->part_count && mesh->ends[mesh->part_count - 1] != mesh->face_count)
        return GLINT_ERR_ARG;
    return !mesh->textures || (mesh->use && GLINT_FLASH_POINTER(mesh->use->can)(mesh)) ? GLINT_OK : GLINT_ERR_ARG;
}

/* More than an AVR can address is more than it can have. */
static size_t mesh_size(uint32_t bytes)
{
    return (size_t)bytes == bytes ? (size_t)bytes : SIZE_MAX;
}

/* The frame's memory begins where a pointer may lie, and is given at a multiple of 4. */
enum { FRAME_PADDING = sizeof(void *) > 4 ? sizeof(void *) - 4 : 0 };

size_t glint_mesh_frame_bytes(uint16_t w, uint16_t lines)
{
    return mesh_size((uint32_t)(sizeof(struct glint_mesh_bench) + FRAME_PADDING) + glint_mesh_depth_bytes(w, lines));
}

enum { LIT_PLACES = GLINT_MESH_LIGHTS_BYTES / GLINT_MESH_KEPT_BYTES };

/* Not where there are too few places, or some may be in use. */
static bool mesh_can_light(const struct glint_mesh_frame *frame)
{
    return frame->lit || (frame->places >= LIT_PLACES && !frame->y);
}

/* The last places become the work memory of lights. */
static void mesh_light(struct glint_mesh_frame *frame)
{
    if (frame->lit)
        return;
    frame->places = (uint16_t)(frame->places - LIT_PLACES);
    glint_mesh_places(frame);
    uint8_t *memory = (uint8_t *)frame->kept + (size_t)frame->places * sizeof(struct glint_mesh_kept);
    while (GLINT_MISALIGNED(memory, pointer))
        memory++;
    frame->lit = memory;
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
    if (FRAME_PADDING > 0 && GLINT_MISALIGNED(memory, pointer))
        frame->memory = (uint8_t *)memory + FRAME_PADDING;
    frame->w = w;
    frame->h = h;
    frame->lines = lines;
    frame->distance = distance;
    frame->y = 0;
    frame->lit = NULL;
    frame->outlines = NULL;
    const size_t used = glint_mesh_frame_bytes(w, lines), room = (bytes - used) / sizeof(struct glint_mesh_kept);
    frame->kept = (uint8_t *)memory + used;
    frame->places = (uint16_t)(room < GLINT_MESH_FACES_MAX ? room : GLINT_MESH_FACES_MAX);
    frame->kept_bytes = sizeof(struct glint_mesh_kept);
    glint_mesh_places(frame);
    return GLINT_OK;
}

size_t glint_mesh_bytes(const struct glint_mesh *mesh, uint16_t h)
{
    if (!mesh)
        return 0;
    return mesh_size((uint32_t)mesh->vertex_count * (uint32_t)sizeof(struct glint_mesh_vertex) +
                     2 * ((uint32_t)mesh->face_count + glint_mesh_bands(h)) + glint_mesh_edges_bytes(mesh, h));
}

static __attribute__((noinline)) bool mesh_is_same(const struct glint_vec *a, const struct glint_vec *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

/* Are paints lit by the same lights? */
static bool mesh_are_alike(const struct glint_paint *a, const struct glint_paint *b)
{
    if (a->light_count != b->light_count || a->several != b->several || !mesh_is_same(&a->v, &b->v))
        return false;
    if (a->several)
        return a->lights == b->lights;
    return mesh_is_same(&a->l, &b->l) && mesh_is_same(&a->h, &b->h) && a->color_q16[0] == b->color_q16[0] &&
           a->color_q16[1] == b->color_q16[1] && a->color_q16[2] == b->color_q16[2];
}

/* Can the parts be drawn with these paints? *is_lit: they take the work memory of lights. */
static bool mesh_can(const struct glint_mesh_frame *frame, const struct glint_mesh *mesh,
                     const struct glint_paint *paints, bool *is_lit)
{
    const bool coloured = mesh->of_vertices || mesh->of_faces;
    const uint8_t format = (frame->first ? frame->first->paints : paints)->output.format;
    for (unsigned i = 0; i == 0 || i < mesh->part_count; i++) {
        const struct glint_paint *paint = &paints[i];
        if (!glint_paint_is_lit(paint) || !mesh_are_alike(paint, paints) || paint->output.format != format)
            return false;
        if (glint_paint_is_exact(paint) && glint_material_across(&paint->material) &&
            (paint->several || !mesh->use_grain))
            return false;
        const bool has_albedo = coloured || (mesh->textures && mesh->textures[i].pixels);
        if (!glint_paint_is_exact(paint) &&
            has_albedo != (bool)GLINT_FLASH_U8(paint->of.tables.filled.use->takes_albedo))
            return false;
        if (has_albedo && !mesh->use && !(coloured && glint_paint_is_exact(paint)))
            return false;
        *is_lit |= glint_mesh_is_lit(paint);
    }
    return !*is_lit || mesh_can_light(frame);
}

/* Pixels beyond which a mesh draws none: those that its vertices lie in, and with outlines one before, as their walk rounds down by 1/16. */
static void mesh_bounds(const struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn)
{
    const struct glint_mesh_vertex *v = drawn->vertices, *const end = v + drawn->mesh->vertex_count;
    const int32_t before = drawn->edges ? 1 : 0;
    drawn->left = drawn->top = 0;
    drawn->right = (int16_t)frame->w;
    drawn->bottom = (int16_t)frame->h;
    if (drawn->is_cut) /* of what is out x and y may be anything */
        return;
    int32_t left = v->x, right = left, top = v->y, bottom = top;
    for (; v != end; v++) {
        left = v->x < left ? v->x : left;
        right = v->x > right ? v->x : right;
        top = v->y < top ? v->y : top;
        bottom = v->y > bottom ? v->y : bottom;
    }
    left = (left - before) >> 4;
    top = (top - before) >> 4;
    right = (right >> 4) + 1;
    bottom = (bottom >> 4) + 1;
    drawn->left = (int16_t)(left < 0 ? 0 : left);
    drawn->top = (int16_t)(top < 0 ? 0 : top);
    drawn->right = (int16_t)(right > frame->w ? frame->w : right);
    drawn->bottom = (int16_t)(bottom > frame->h ? frame->h : bottom);
}

/* Was the picture begun, and what is added not in it yet? */
static bool mesh_has_room(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn)
{
    const struct glint_mesh_drawn *at = frame->first;
    while (at && at != drawn)
        at = at->next;
    return frame->memory && !at;
}

enum glint_err glint_mesh_add(struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn,
                              const struct glint_mesh *mesh, const struct glint_pose *pose,
                              const struct glint_paint *paints, void *memory, size_t bytes)
{
    bool is_lit = false;
    if (!frame || !drawn || !mesh || !pose || !paints || !memory || GLINT_MISALIGNED(memory, 32) ||
        !mesh->vertex_count || !mesh_has_room(frame, drawn) || bytes < glint_mesh_bytes(mesh, frame->h) ||
        !mesh_can(frame, mesh, paints, &is_lit))
        return GLINT_ERR_ARG;
    if (!glint_pose_set(drawn, pose, paints))
        return GLINT_ERR_VECTOR;
    if (is_lit) /* once nothing is refused: it is taken for all of the picture */
        mesh_light(frame);
    if (GLINT_FUSED && mesh->use)
        GLINT_FLASH_POINTER(mesh->use->room)(frame, mesh, paints);
    drawn->next = NULL;
    drawn->mesh = mesh;
    drawn->paints = paints;
    drawn->kept = GLINT_MESH_NONE;
    drawn->vertices = (struct glint_mesh_vertex *)memory;
    drawn->links = (uint16_t *)(void *)(drawn->vertices + mesh->vertex_count);
    drawn->bands = drawn->links + mesh->face_count;
    drawn->is_cut = glint_mesh_vertices(frame, drawn);
    for (unsigned i = 0; paints->light_count == 0 && i < mesh->vertex_count; i++)
        drawn->vertices[i].nl_q30 = -1; /* dark */
    drawn->edges = NULL;
    if (frame->outlines && mesh->neighbours)
        GLINT_FLASH_POINTER(frame->outlines->add)(frame, drawn);
    else
        glint_mesh_sort(frame, drawn, frame->y);
    mesh_bounds(frame, drawn);
    *frame->last = drawn;
    frame->last = &drawn->next;
    return GLINT_OK;
}
