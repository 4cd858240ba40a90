/* SPDX-License-Identifier: MIT
 * A strip of a picture. Its faces are drawn by number, whether set up for it or kept from the strip before: of two pixels at the same
 * depth the first stays, however the picture is cut. A triangle that goes on is kept, so that it is set up once; where there is no
 * place left its face goes into the next band's list and is set up again. */
#include "glint_mesh_strip.h"
#include "glint_mesh_texture.h"
#include "glint_mesh_triangle.h"
#include "glint_port.h"

/* Depths are cleared two at a time. */
#ifdef __GNUC__
typedef uint32_t __attribute__((may_alias)) depth_word;
#else
typedef uint32_t depth_word;
#endif

/* A list to which entries are added at its end. */
struct tail {
    uint16_t first, *last;
};

/* Faces before `end`, and what paints them. */
struct part {
    const struct glint_paint *paint;
    uint32_t t_end;
    /* NULL, or what its triangles are drawn by at once; of ALBEDO tables by lines, with a texture. */
    const struct glint_tables *tables;
    void (*lines)(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                  const struct glint_mesh_target *target, const struct glint_texture *texture);
    const struct glint_texture *texture;
    uint16_t end, number; /* end: GLINT_MESH_NONE, which is above all faces, of the last one */
};

/* Alone, since the loop over a strip's faces has no register left for what this needs. */
static __attribute__((noinline)) void part_set(struct part *part, const struct glint_mesh_target *strip,
                                               unsigned number)
{
    const struct glint_mesh_drawn *const drawn = strip->drawn;
    part->number = (uint16_t)number;
    part->paint = &drawn->paints[number];
    part->t_end = glint_mesh_t_end(part->paint);
    part->lines = NULL;
    part->tables = glint_mesh_is_colour(part->paint, strip) ? &part->paint->of.tables.filled : NULL;
    if (glint_mesh_is_albedo(part->paint, strip)) {
        part->lines = GLINT_FLASH_POINTER(drawn->mesh->use->lines);
        part->tables = &part->paint->of.tables.filled;
        part->texture = glint_mesh_texture_of(drawn, part->paint);
    }
    part->end = number + 1 < drawn->mesh->part_count ? drawn->mesh->ends[number] : GLINT_MESH_NONE;
}

/* Corner k of a polygon's triangle i: 0, i - 1 and i. */
static inline const struct glint_mesh_clipped *fan_corner(const struct glint_mesh_clipped *at, unsigned i, unsigned k)
{
    return k == 0 ? at : &at[i - 2 + k];
}

static void fan_set(struct glint_mesh_bench *bench, const struct glint_mesh_frame *frame,
                    const struct glint_mesh_drawn *drawn, unsigned i)
{
    bench->fan = (uint8_t)i;
    for (unsigned k = 0; k < 3; k++)
        glint_mesh_clip_vertex(&bench->vertex[k], frame, drawn,
                               fan_corner(bench->polygon.list[bench->polygon.now].corner, i, k));
}

static unsigned fan_clip(struct glint_mesh_bench *bench, const struct glint_mesh_frame *frame,
                         const struct glint_mesh_drawn *drawn, unsigned face)
{
    return glint_mesh_clip(&bench->polygon, frame, drawn, drawn->mesh->faces + 3 * (size_t)face);
}

/* Of the others rounding may turn one over: of a corner at the near plane it makes 8 of each 1/16 pixel. Corners that are in stay side by
 * side: 0 is the polygon's first, 1 its second one, 2 the last. */
bool glint_mesh_fan_shows(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, unsigned face)
{
    struct glint_mesh_bench *bench = (struct glint_mesh_bench *)frame->memory;
    const unsigned edge = glint_mesh_edge_in(drawn, face);
    const unsigned count = edge < 3 ? fan_clip(bench, frame, drawn, face) : 0;
    const unsigned beside = edge == 2 ? count - 1 : 2;
    unsigned largest = 2;
    int32_t most = 0;
    bool shows = false, beside_shows = false;
    for (unsigned i = 2; i < count; i++) {
        fan_set(bench, frame, drawn, i);
        const int32_t area = glint_mesh_area(&bench->vertex[0], &bench->vertex[1], &bench->vertex[2]);
        const int32_t size = area < 0 ? -area : area;
        if (size > most) {
            most = size;
            shows = area < 0;
            largest = i;
        }
        if (i == beside)
            beside_shows = area < 0;
    }
    if (shows)
        fan_set(bench, frame, drawn, beside_shows ? beside : largest);
    return shows;
}

/* A face, clipped, as a fan. Alone, for the stack of what draws other faces. */
static __attribute__((noinline)) void draw_clipped(const struct glint_mesh_target *strip, uint16_t number,
                                                   const struct glint_paint *paint)
{
    struct glint_mesh_bench *bench = (struct glint_mesh_bench *)strip->frame->memory;
    struct glint_mesh_triangle *triangle = &bench->face.triangle;
    const unsigned count = fan_clip(bench, strip->frame, strip->drawn, number);
    const struct glint_mesh_clipped *at = bench->polygon.list[bench->polygon.now].corner;
    const uint32_t t_end = glint_mesh_t_end(paint);
    struct glint_mesh_vertex *const v = bench->vertex;
    struct glint_mesh_corner corner[3];
    bench->face.face = number;
    for (unsigned i = 2; i < count; i++) {
        fan_set(bench, strip->frame, strip->drawn, i);
        for (unsigned k = 0; k < 3; k++) {
            corner[k].v = &v[k];
            corner[k].side = glint_mesh_side(&fan_corner(at, i, k == 2 ? 0 : k + 1)->normal,
                                             &fan_corner(at, i, k == 0 ? 2 : k - 1)->normal);
        }
        if (glint_mesh_area(&v[0], &v[1], &v[2]) < 0 &&
            glint_mesh_triangle_set(triangle, corner, glint_mesh_shine(corner, t_end), t_end) &&
            triangle->y < strip->end)
            strip->rows(paint, triangle, strip);
    }
}

/* Has its face no cell to leave out? */
static inline bool is_whole(const struct glint_mesh_target *strip, const struct glint_mesh_triangle *triangle)
{
    const uint8_t *const edges = strip->drawn->edges;
    return !edges || !(edges[glint_mesh_face_of(triangle)] & GLINT_EDGES_ASK);
}

/* Draws it where its lines begin in the strip; does it go on after that? */
static bool draw_on(const struct glint_mesh_target *strip, struct glint_mesh_triangle *triangle,
                    const struct part *part)
{
    const bool is_direct =
        part->tables && triangle->y >= strip->y && triangle->y < strip->end && is_whole(strip, triangle);
    if (is_direct && part->lines)
        part->lines(part->tables, triangle, strip, part->texture);
    else if (is_direct)
        glint_mesh_colour(part->tables, triangle, strip);
    else if (triangle->y < strip->end)
        strip->rows(part->paint, triangle, strip);
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
    struct glint_mesh_kept *const kept =
        place != GLINT_MESH_NONE ? glint_mesh_kept_at(frame, place) : &((struct glint_mesh_bench *)frame->memory)->face;
    const uint16_t *const face = strip->drawn->mesh->faces + 3 * (size_t)i;
    const bool is_set = !glint_mesh_face_is_out(strip->drawn, face);
    kept->face = i;
    if (!is_set) {
        draw_clipped(strip, i, part->paint);
    } else {
        glint_mesh_face_set(&kept->triangle, strip->drawn, face, part->t_end);
        if (!draw_on(strip, &kept->triangle, part))
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
    struct tail keep = {GLINT_MESH_NONE, &keep.first}, later = {GLINT_MESH_NONE, &later.first};
    uint16_t face = glint_mesh_take(drawn, strip->y, strip->end), place = drawn->kept;
    uint16_t kept_face = place == GLINT_MESH_NONE ? GLINT_MESH_NONE : glint_mesh_kept_at(frame, place)->face;
    struct part part;
    part_set(&part, strip, 0);
    for (;;) {
        const bool is_kept = kept_face < face;
        const uint16_t i = is_kept ? kept_face : face;
        if (i == GLINT_MESH_NONE)
            break;
        while (i >= part.end)
            part_set(&part, strip, part.number + 1u);
        if (is_kept) {
            struct glint_mesh_kept *const kept = glint_mesh_kept_at(frame, place);
            const uint16_t at = place;
            place = kept->next;
            kept_face = place == GLINT_MESH_NONE ? GLINT_MESH_NONE : glint_mesh_kept_at(frame, place)->face;
            if (draw_on(strip, &kept->triangle, &part)) {
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
    while (drawn->kept != GLINT_MESH_NONE) {
        struct glint_mesh_kept *const kept = glint_mesh_kept_at(frame, drawn->kept);
        const uint16_t next = kept->next;
        kept->next = frame->free;
        frame->free = drawn->kept;
        drawn->kept = next;
    }
}

#if !GLINT_CORTEX_M0PLUS_ASM
/* Sixteen at a time. By what looks like a change of it compilers do not call memset, which on small machines often goes byte by byte. */
void glint_mesh_clear(uint16_t *depth, uint32_t bytes)
{
    depth_word *at = (depth_word *)(void *)depth;
    uint32_t far = UINT32_MAX;
    const depth_word *const end = at + bytes / 4;
#if GLINT_THUMB2
    while (end - at >= 16)
        __asm__("mov r2, %1\n\t"
                "mov r3, %1\n\t"
                "mov r4, %1\n\t"
                "mov r12, %1\n\t"
                "stmia %0!, {r2, r3, r4, r12}\n\t"
                "stmia %0!, {r2, r3, r4, r12}\n\t"
                "stmia %0!, {r2, r3, r4, r12}\n\t"
                "stmia %0!, {r2, r3, r4, r12}"
                : "+r"(at)
                : "r"(far)
                : "r2", "r3", "r4", "r12", "memory");
#endif
    for (; end - at >= 8; at += 8) {
        at[0] = at[1] = at[2] = at[3] = at[4] = at[5] = at[6] = at[7] = far;
#if defined(__arm__) || defined(__riscv) || defined(__xtensa__)
        __asm__("" : "+r"(far));
#endif
    }
    while (at != end)
        *at++ = far;
}
#endif

#if GLINT_CORTEX_M0PLUS_ASM
/* Can the assembly draw the mesh? */
static bool strip_has_lines(const struct glint_mesh_drawn *drawn, const struct glint_mesh_target *target)
{
    const struct glint_use_mesh *const use = drawn->mesh->use;
    for (unsigned i = 0; i == 0 || i < drawn->mesh->part_count; i++) {
        const struct glint_paint *paint = &drawn->paints[i];
        if (!glint_mesh_is_colour(paint, target) && !(use && GLINT_FLASH_POINTER(use->begin)(target, paint, NULL)))
            return false;
    }
    return !drawn->is_cut;
}

uint32_t glint_mesh_part_lines(const struct glint_mesh_target *strip, unsigned part, struct glint_mesh_lines *lines)
{
    const struct glint_paint *paint = &strip->drawn->paints[part];
    uint32_t lay = 0;
    if (paint->of.tables.filled.kind == GLINT_TABLES_COLOUR)
        glint_mesh_colour_begin(&paint->of.tables.filled, strip, lines);
    else
        lay = GLINT_FLASH_POINTER(strip->drawn->mesh->use->begin)(strip, paint, lines);
    if (strip->drawn->edges)
        GLINT_FLASH_POINTER(strip->frame->outlines->lines)(strip, lines);
    return glint_mesh_t_end(paint) | lay;
}
#endif

/* Has a mesh's list nothing there? */
static bool bands_are_empty(const uint16_t *bands, const struct glint_mesh_target *target)
{
    uint32_t band = (uint32_t)target->y / GLINT_MESH_BAND;
    while (band * GLINT_MESH_BAND < (uint32_t)target->end && bands[band] == GLINT_MESH_NONE)
        band++;
    return band * GLINT_MESH_BAND >= (uint32_t)target->end;
}

/* Has the mesh no face there? */
static bool strip_is_empty(const struct glint_mesh_drawn *drawn, const struct glint_mesh_target *target)
{
    return drawn->kept == GLINT_MESH_NONE && bands_are_empty(drawn->bands, target);
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

/* Does the picture's line fit the stride? */
static bool strip_fits(const struct glint_mesh_frame *frame, const struct glint_surface *target, uint16_t h)
{
    const struct glint_mesh_drawn *const drawn = frame->first; /* others have its format */
    return h == 1 || !drawn ||
           glint_stride_fits(target->stride, glint_line_bytes(drawn->paints->output.format, frame->w));
}

/* The box with what the mesh may draw of the strip. */
static void box_join(struct glint_box *box, const struct glint_mesh_drawn *drawn, const struct glint_mesh_target *strip)
{
    const int32_t top = drawn->top > strip->y ? drawn->top : strip->y,
                  bottom = drawn->bottom < strip->end ? drawn->bottom : strip->end;
    int32_t left = drawn->left, right = drawn->right, y = top, end = bottom;
    if (left >= right || top >= bottom)
        return;
    if (box->w) {
        left = box->x < left ? box->x : left;
        right = box->x + box->w > right ? box->x + box->w : right;
        y = box->y < y ? box->y : y;
        end = box->y + box->h > end ? box->y + box->h : end;
    }
    box->x = (uint16_t)left;
    box->y = (uint16_t)y;
    box->w = (uint16_t)(right - left);
    box->h = (uint16_t)(end - y);
}

enum glint_err glint_mesh_strip(struct glint_mesh_frame *frame, uint16_t y, uint16_t h,
                                const struct glint_surface *target)
{
    if (!frame || !target || !target->pixels || y >= frame->h || h == 0 || h > frame->lines || h > frame->h - y ||
        !strip_fits(frame, target, h))
        return GLINT_ERR_ARG;
    struct glint_mesh_bench *bench = (struct glint_mesh_bench *)frame->memory;
    struct glint_mesh_target strip = {target,         (uint16_t *)(void *)(bench + 1),
                                      frame->w,       y,
                                      y + h,          glint_mesh_polygon_samples(&bench->polygon, frame),
                                      frame,          NULL,
                                      glint_mesh_rows};
    bool is_clear = false, has_outlines = false;
    frame->box.x = frame->box.y = frame->box.w = frame->box.h = 0;
    if (frame->lit)
        glint_mesh_lit_begin(frame->lit);
    for (struct glint_mesh_drawn *drawn = frame->first; drawn; drawn = drawn->next) {
        strip.drawn = drawn;
        if (y != frame->y) {
            glint_mesh_forget(frame, drawn);
            glint_mesh_sort(frame, drawn, y);
            if (drawn->edges)
                GLINT_FLASH_POINTER(frame->outlines->sort)(frame, drawn, y);
        }
        const bool is_edged = drawn->edges && !bands_are_empty(drawn->rim_bands, &strip);
        if (strip_is_empty(drawn, &strip) && !is_edged)
            continue;
        if (!is_clear)
            glint_mesh_clear(strip.depth, glint_mesh_depth_bytes(frame->w, h));
        is_clear = true;
        has_outlines |= is_edged;
        strip.rows = glint_mesh_rows;
        if (drawn->edges)
            GLINT_FLASH_POINTER(frame->outlines->begin)(&strip);
        box_join(&frame->box, drawn, &strip);
        strip_draw(&strip);
    }
    for (strip.drawn = frame->first; has_outlines && strip.drawn; strip.drawn = strip.drawn->next)
        if (strip.drawn->edges)
            GLINT_FLASH_POINTER(frame->outlines->end)(&strip);
    frame->y = (uint16_t)(y + h);
    return GLINT_OK;
}

/* Each band has a list of the faces that begin in it. A strip takes the lists of its bands, and gives those that go on to the
 * band after it. Lists ascend by the face's number, and faces are drawn in that order: of two at the same depth the first stays,
 * however the picture is cut into strips. */

#if !GLINT_CORTEX_M0PLUS_ASM
/* The line from y on where a face begins; -1 where it shows its back, or no line. edge: NULL, or where outlines mark it. */
static int32_t lists_first(const struct glint_mesh_frame *frame, const struct glint_mesh_vertex *vertices,
                           const uint16_t face[3], int32_t y, uint8_t *edge)
{
    const struct glint_mesh_vertex *a = &vertices[face[0]], *b = &vertices[face[1]], *c = &vertices[face[2]];
    if (a->out | b->out | c->out) { /* seen once it is clipped, unless one plane cuts all of it */
        if (edge)
            *edge |= GLINT_EDGES_IS_CLIPPED;
        return (a->out & b->out & c->out) == 0 ? y : -1;
    }
    if (glint_mesh_area(a, b, c) >= 0)
        return -1;
    if (edge)
        *edge |= GLINT_EDGES_IS_FRONT;
    int32_t low = a->y, high = b->y;
    if (low > high) {
        low = b->y;
        high = a->y;
    }
    low = c->y < low ? c->y : low;
    high = c->y > high ? c->y : high;
    low = glint_mesh_first(low);
    high = glint_mesh_first(high);
    low = low > y ? low : y;
    return low < high && low < frame->h ? low : -1;
}

void glint_mesh_sort_faces(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y)
{
    const uint16_t *face = drawn->mesh->faces + 3 * (size_t)drawn->mesh->face_count;
    uint8_t *const edges = drawn->edges;
    for (unsigned i = drawn->mesh->face_count; i--;) {
        face -= 3;
        const int32_t first = lists_first(frame, drawn->vertices, face, y, edges ? edges + i : NULL);
        if (first < 0)
            continue;
        uint16_t *band = &drawn->bands[(uint32_t)first / GLINT_MESH_BAND];
        drawn->links[i] = *band;
        *band = (uint16_t)i;
    }
}
#endif

void glint_mesh_sort(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y)
{
    for (uint32_t i = 0; i < glint_mesh_bands(frame->h); i++)
        drawn->bands[i] = GLINT_MESH_NONE;
    glint_mesh_sort_faces(frame, drawn, y);
}

/* Two lists that ascend as one. */
static uint16_t lists_merged(uint16_t *links, uint16_t a, uint16_t b)
{
    uint16_t first = GLINT_MESH_NONE, *at = &first;
    while (a != GLINT_MESH_NONE && b != GLINT_MESH_NONE) {
        uint16_t *const lower = a < b ? &a : &b;
        *at = *lower;
        at = &links[*lower];
        *lower = *at;
    }
    *at = a != GLINT_MESH_NONE ? a : b;
    return first;
}

uint16_t glint_mesh_take(const struct glint_mesh_drawn *drawn, int32_t y, int32_t end)
{
    uint16_t list = GLINT_MESH_NONE;
    for (uint32_t band = (uint32_t)y / GLINT_MESH_BAND; band * GLINT_MESH_BAND < (uint32_t)end; band++) {
        list = lists_merged(drawn->links, list, drawn->bands[band]);
        drawn->bands[band] = GLINT_MESH_NONE;
    }
    return list;
}

void glint_mesh_give(const struct glint_mesh_drawn *drawn, uint16_t list, int32_t y)
{
    uint16_t *band = &drawn->bands[(uint32_t)y / GLINT_MESH_BAND];
    *band = lists_merged(drawn->links, list, *band);
}
