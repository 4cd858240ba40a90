/* SPDX-License-Identifier: MIT
 * A picture of meshes: its memory. */
#include "glint_math_align.h"
#include "glint_mesh_lists.h"
#include "glint_mesh_pose.h"
#include "glint_mesh_strip.h"

typedef char kept_fits[sizeof(struct glint_mesh_kept) <= GLINT_MESH_KEPT_BYTES ? 1 : -1];

/* More than an AVR can address is more than it can have. */
static size_t mesh_size(uint32_t bytes)
{
    return (size_t)bytes == bytes ? (size_t)bytes : SIZE_MAX;
}

size_t glint_mesh_frame_bytes(uint16_t w, uint16_t lines)
{
    return mesh_size((uint32_t)sizeof(struct glint_mesh_bench) + glint_mesh_depth_bytes(w, lines));
}

/* What is left of the memory, as free places. */
static void begin_kept(struct glint_mesh_frame *frame, uint8_t *memory, size_t bytes)
{
    const size_t room = bytes / sizeof(struct glint_mesh_kept);
    const uint16_t count = (uint16_t)(room < GLINT_MESH_FACES_MAX ? room : GLINT_MESH_FACES_MAX);
    struct glint_mesh_kept *const kept = (struct glint_mesh_kept *)(void *)memory;
    frame->kept = kept;
    frame->free = (uint16_t)(count ? 0 : GLINT_MESH_NONE);
    for (uint16_t i = 0; i < count; i++)
        kept[i].next = (uint16_t)(i + 1u < count ? i + 1u : GLINT_MESH_NONE);
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
    const size_t used = glint_mesh_frame_bytes(w, lines);
    begin_kept(frame, (uint8_t *)memory + used, bytes - used);
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
    drawn->kept = GLINT_MESH_NONE;
    drawn->vertices = (struct glint_mesh_vertex *)memory;
    drawn->links = (uint16_t *)(void *)(drawn->vertices + mesh->vertex_count);
    drawn->bands = drawn->links + mesh->face_count;
    drawn->is_cut = glint_mesh_vertices(frame, drawn);
    glint_mesh_sort(frame, drawn, frame->y);
    *frame->last = drawn;
    frame->last = &drawn->next;
    return GLINT_OK;
}
