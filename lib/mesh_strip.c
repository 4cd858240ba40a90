/* SPDX-License-Identifier: MIT
 * A strip of a picture. Its faces are drawn by number, whether set up for it or kept from the strip before: of two pixels at the same
 * depth the first stays, however the picture is cut. A triangle that goes on is kept, so that it is set up once; where there is no
 * place left its face goes into the next band's list and is set up again. */
#include "glint_mesh_strip.h"
#include "glint_math_assembly.h"
#include "glint_mesh_lists.h"

/* A list to which entries are added at its end. */
struct tail {
    uint16_t first, *last;
};

/* Faces before `end`, and what paints them. */
struct part {
    const struct glint_paint *paint;
    uint32_t t_end;
    uint16_t end, number; /* end: GLINT_MESH_NONE, which is above all faces, of the last one */
};

/* Alone, since the loop over a strip's faces has no register left for what this needs. */
static __attribute__((noinline)) void part_set(struct part *part, const struct glint_mesh_drawn *drawn, unsigned number)
{
    part->number = (uint16_t)number;
    part->paint = &drawn->paints[number];
    part->t_end = GLINT_FLASH_POINTER(part->paint->path->t_end)(part->paint->with);
    part->end = number + 1 < drawn->mesh->part_count ? drawn->mesh->ends[number] : GLINT_MESH_NONE;
}

static void draw(const struct glint_mesh_target *strip, struct glint_mesh_triangle *triangle,
                 const struct glint_paint *paint)
{
    if (triangle->y < strip->y)
        glint_mesh_triangle_skip(triangle, strip->y);
    GLINT_FLASH_POINTER(paint->path->draw)(paint->with, triangle, strip);
}

/* A face, clipped, as a fan. */
static void draw_clipped(const struct glint_mesh_target *strip, uint16_t number, const struct glint_paint *paint)
{
    struct glint_mesh_bench *bench = (struct glint_mesh_bench *)strip->frame->memory;
    struct glint_mesh_triangle *triangle = &bench->face.triangle;
    const unsigned count =
        glint_mesh_clip(&bench->polygon, strip->frame, strip->drawn, strip->drawn->mesh->faces + 3 * (size_t)number);
    const struct glint_mesh_clipped *at = bench->polygon.list[bench->polygon.now].corner;
    const uint32_t t_end = GLINT_FLASH_POINTER(paint->path->t_end)(paint->with);
    struct glint_mesh_vertex *const v = bench->vertex;
    bench->face.face = number;
    for (unsigned i = 2; i < count; i++) {
        const struct glint_mesh_clipped *const of[3] = {&at[0], &at[i - 1], &at[i]};
        struct glint_mesh_corner corner[3];
        for (unsigned k = 0; k < 3; k++) {
            glint_mesh_clip_vertex(&v[k], strip->frame, strip->drawn, of[k]);
            corner[k].v = &v[k];
            corner[k].side = glint_mesh_side(&of[(k + 1) % 3]->normal, &of[(k + 2) % 3]->normal);
        }
        if (glint_mesh_area(&v[0], &v[1], &v[2]) < 0 &&
            glint_mesh_triangle_set(triangle, corner, glint_mesh_shine(corner, t_end), t_end) &&
            triangle->y < strip->end) {
            bench->fan = (uint8_t)i;
            draw(strip, triangle, paint);
        }
    }
}

/* Draws it where its lines begin in the strip; does it go on after that? */
static bool draw_on(const struct glint_mesh_target *strip, struct glint_mesh_triangle *triangle,
                    const struct glint_paint *paint)
{
    if (triangle->y < strip->end)
        draw(strip, triangle, paint);
    return triangle->y_end > strip->end;
}

static void add(struct tail *tail, uint16_t entry, uint16_t *next)
{
    *tail->last = entry;
    tail->last = next;
}

#if !GLINT_CORTEX_M0PLUS_ASM
void glint_mesh_face_set(struct glint_mesh_triangle *triangle, const struct glint_mesh_drawn *drawn,
                         const uint16_t face[3], uint32_t t_end)
{
    struct glint_mesh_corner corner[3];
    for (unsigned k = 0; k < 3; k++)
        corner[k].v = &drawn->vertices[face[k]];
    const enum glint_mesh_shine shine = glint_mesh_shine(corner, t_end);
    if (shine == GLINT_MESH_GLOSSY)
        glint_mesh_sides(corner, drawn->mesh, face);
    (void)glint_mesh_triangle_set(triangle, corner, shine, t_end); /* it has an area and lines */
}
#endif

/* A face that has not been kept. */
static void strip_face(const struct glint_mesh_target *strip, uint16_t i, const struct part *part, struct tail *keep,
                       struct tail *later)
{
    struct glint_mesh_frame *frame = strip->frame;
    const uint16_t place = frame->free;
    struct glint_mesh_kept *const kept = place != GLINT_MESH_NONE ? &((struct glint_mesh_kept *)frame->kept)[place]
                                                                  : &((struct glint_mesh_bench *)frame->memory)->face;
    const uint16_t *const face = strip->drawn->mesh->faces + 3 * (size_t)i;
    const bool is_set = !glint_mesh_face_is_out(strip->drawn, face);
    kept->face = i;
    if (!is_set) {
        draw_clipped(strip, i, part->paint);
    } else {
        glint_mesh_face_set(&kept->triangle, strip->drawn, face, part->t_end);
        if (!draw_on(strip, &kept->triangle, part->paint))
            return;
    }
    if (!is_set || place == GLINT_MESH_NONE) {
        add(later, i, &strip->drawn->links[i]);
        return;
    }
    frame->free = kept->next;
    add(keep, place, &kept->next);
}

static void strip_mesh(const struct glint_mesh_target *strip)
{
    struct glint_mesh_frame *frame = strip->frame;
    struct glint_mesh_drawn *drawn = strip->drawn;
    struct glint_mesh_kept *const all = (struct glint_mesh_kept *)frame->kept;
    struct tail keep = {GLINT_MESH_NONE, &keep.first}, later = {GLINT_MESH_NONE, &later.first};
    uint16_t face = glint_mesh_take(drawn, strip->y, strip->end), place = drawn->kept;
    uint16_t kept_face = place == GLINT_MESH_NONE ? GLINT_MESH_NONE : all[place].face;
    struct part part;
    part_set(&part, drawn, 0);
    for (;;) {
        const bool is_kept = kept_face < face;
        const uint16_t i = is_kept ? kept_face : face;
        if (i == GLINT_MESH_NONE)
            break;
        while (i >= part.end)
            part_set(&part, drawn, part.number + 1u);
        if (is_kept) {
            struct glint_mesh_kept *const kept = &all[place];
            const uint16_t at = place;
            place = kept->next;
            kept_face = place == GLINT_MESH_NONE ? GLINT_MESH_NONE : all[place].face;
            if (draw_on(strip, &kept->triangle, part.paint)) {
                add(&keep, at, &kept->next);
            } else {
                kept->next = frame->free;
                frame->free = at;
            }
        } else {
            face = drawn->links[i];
            strip_face(strip, i, &part, &keep, &later);
        }
    }
    *keep.last = *later.last = GLINT_MESH_NONE;
    drawn->kept = keep.first;
    if (strip->end < frame->h)
        glint_mesh_give(drawn, later.first, strip->end);
}

void glint_mesh_forget(struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn)
{
    struct glint_mesh_kept *const all = (struct glint_mesh_kept *)frame->kept;
    while (drawn->kept != GLINT_MESH_NONE) {
        struct glint_mesh_kept *const kept = &all[drawn->kept];
        const uint16_t next = kept->next;
        kept->next = frame->free;
        frame->free = drawn->kept;
        drawn->kept = next;
    }
}

static bool strip_can(const struct glint_mesh_frame *frame)
{
    for (const struct glint_mesh_drawn *drawn = frame->first; drawn; drawn = drawn->next)
        for (unsigned i = 0; i == 0 || i < drawn->mesh->part_count; i++)
            if (!drawn->paints[i].path || !GLINT_FLASH_POINTER(drawn->paints[i].path->can)(drawn->paints[i].with))
                return false;
    return true;
}

#if !GLINT_CORTEX_M0PLUS_ASM
/* Two at a time. */
void glint_mesh_clear(uint16_t *depth, uint32_t bytes)
{
    uint32_t *at = (uint32_t *)(void *)depth;
    for (const uint32_t *const end = at + bytes / 4; at != end; at++)
        *at = UINT32_MAX;
}
#endif

#if GLINT_CORTEX_M0PLUS_ASM
/* Can the assembly draw the mesh? */
static bool strip_has_lines(const struct glint_mesh_drawn *drawn, const struct glint_mesh_target *target)
{
    for (unsigned i = 0; i == 0 || i < drawn->mesh->part_count; i++) {
        const struct glint_paint *paint = &drawn->paints[i];
        if (!GLINT_FLASH_POINTER(paint->path->begin) ||
            !GLINT_FLASH_POINTER(paint->path->begin)(paint->with, target, NULL))
            return false;
    }
    return !drawn->is_cut;
}
#endif

/* Has the mesh no face there? */
static bool strip_is_empty(const struct glint_mesh_drawn *drawn, const struct glint_mesh_target *target)
{
    uint32_t band = (uint32_t)target->y / GLINT_MESH_BAND;
    while (band * GLINT_MESH_BAND < (uint32_t)target->end && drawn->bands[band] == GLINT_MESH_NONE)
        band++;
    return drawn->kept == GLINT_MESH_NONE && band * GLINT_MESH_BAND >= (uint32_t)target->end;
}

static void strip_draw(const struct glint_mesh_target *strip)
{
#if GLINT_CORTEX_M0PLUS_ASM
    if (strip_has_lines(strip->drawn, strip)) {
        glint_mesh_strip_lines(strip);
        return;
    }
#endif
    strip_mesh(strip);
}

enum glint_err glint_mesh_strip(struct glint_mesh_frame *frame, uint16_t y, uint16_t h,
                                const struct glint_surface *surface)
{
    if (!frame || !surface || !surface->pixels || y >= frame->h || h == 0 || h > frame->lines || h > frame->h - y ||
        !strip_can(frame))
        return GLINT_ERR_ARG;
    struct glint_mesh_bench *bench = (struct glint_mesh_bench *)frame->memory;
    struct glint_mesh_target target = {surface,  (uint16_t *)(void *)(bench + 1),
                                       frame->w, y,
                                       y + h,    glint_mesh_polygon_samples(&bench->polygon, frame),
                                       frame,    NULL};
    bool is_clear = false;
    for (struct glint_mesh_drawn *drawn = frame->first; drawn; drawn = drawn->next) {
        target.drawn = drawn;
        if (y != frame->y) {
            glint_mesh_forget(frame, drawn);
            glint_mesh_sort(frame, drawn, y);
        }
        if (strip_is_empty(drawn, &target))
            continue;
        if (!is_clear)
            glint_mesh_clear(target.depth, glint_mesh_depth_bytes(frame->w, h));
        is_clear = true;
        strip_draw(&target);
    }
    frame->y = (uint16_t)(y + h);
    return GLINT_OK;
}
