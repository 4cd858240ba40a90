/* SPDX-License-Identifier: MIT
 * Smooth outlines as lib/sequence.md writes them down, written another way than in lib/: every pixel asks every edge. Faces are drawn by
 * the library, one by one. */
#ifndef GLINT_UNIT_OUTLINES_MODEL_H
#define GLINT_UNIT_OUTLINES_MODEL_H

#include "meshes.h"

#include "glint_mesh_strip.h"

/* ---- A mesh as it lies on the screen ---- */

struct model_edge {
    const struct glint_mesh_vertex *p, *q;
    bool is_outline; /* with a line or column at least; else nothing else is known */
    bool is_flat, inside_is_after;
    unsigned zeros;
    int64_t inverse, step, e; /* e: at `first` */
    int first, end;
};

struct model_mesh {
    struct mesh_shown shown;
    struct glint_mesh_drawn drawn;
    uint32_t work[(MESH_VERTICES * 16 + MESH_FACES * 5 + 1024) / 4];
    const struct glint_mesh_frame *frame;
    bool is_clipped[MESH_FACES], is_front[MESH_FACES], is_thin[MESH_FACES];
    struct model_edge edges[MESH_FACES][3];
};

/* Neighbours that are so both ways. */
static inline void mesh_join_both_ways(struct made_mesh *m)
{
    mesh_join(m);
    for (unsigned i = 0; i < 3u * m->mesh.face_count; i++) {
        const unsigned beside = m->neighbours[i / 3][i % 3];
        bool is_back = beside >= m->mesh.face_count;
        for (unsigned k = 0; !is_back && k < 3; k++)
            is_back = m->neighbours[beside][k] == i / 3;
        if (!is_back)
            m->neighbours[i / 3][i % 3] = GLINT_MESH_RIM;
    }
}

static inline const struct glint_mesh_vertex *model_corner(const struct model_mesh *m, unsigned face, unsigned k)
{
    return &m->drawn.vertices[m->shown.made->faces[face][k % 3]];
}

static inline int64_t model_area(const struct model_mesh *m, unsigned face)
{
    const struct glint_mesh_vertex *a = model_corner(m, face, 0), *b = model_corner(m, face, 1),
                                   *c = model_corner(m, face, 2);
    return (int64_t)(b->x - a->x) * (c->y - a->y) - (int64_t)(c->x - a->x) * (b->y - a->y);
}

/* Is there a face beyond the edge, and does it show its back? */
static inline bool model_is_back(const struct model_mesh *m, unsigned beside)
{
    return beside < m->shown.made->mesh.face_count && !m->is_front[beside];
}

/* Must neither end of an edge be clipped? */
static inline bool model_is_in(const struct model_mesh *m, unsigned face, unsigned k)
{
    return !model_corner(m, face, k)->out && !model_corner(m, face, k + 1)->out;
}

/* A clipped face as triangles. */
struct model_fan {
    unsigned count;
    int32_t area; /* of the largest; 0: there is none */
    struct glint_mesh_vertex at[GLINT_MESH_POLYGON][3];
};

static inline void model_fan_set(struct model_fan *fan, const struct model_mesh *m, unsigned face)
{
    static struct glint_mesh_polygon polygon;
    const unsigned count = glint_mesh_clip(&polygon, m->frame, &m->drawn, m->shown.made->faces[face]);
    const struct glint_mesh_clipped *const of = polygon.list[polygon.now].corner;
    fan->count = count < 3 ? 0 : count - 2;
    fan->area = 0;
    for (unsigned i = 0; i < fan->count; i++) {
        struct glint_mesh_vertex *const at = fan->at[i];
        for (unsigned k = 0; k < 3; k++)
            glint_mesh_clip_vertex(&at[k], m->frame, &m->drawn, k ? &of[i + k] : of);
        const int32_t area = glint_mesh_area(&at[0], &at[1], &at[2]);
        if (abs(area) > abs(fan->area))
            fan->area = area;
    }
}

static inline bool model_fan_shows(const struct model_mesh *m, unsigned face)
{
    struct model_fan fan;
    bool has_edge = false;
    for (unsigned k = 0; k < 3; k++)
        has_edge |= model_is_in(m, face, k);
    model_fan_set(&fan, m, face);
    return has_edge && fan.area < 0;
}

static inline int model_along(const struct model_edge *edge, const struct glint_mesh_vertex *v)
{
    return edge->is_flat ? v->x : v->y;
}

static inline int model_across(const struct model_edge *edge, const struct glint_mesh_vertex *v)
{
    return edge->is_flat ? v->y : v->x;
}

/* An outline; one without a line or column is none. */
static inline void model_edge_set(struct model_edge *edge, const struct model_mesh *m, unsigned face, unsigned k)
{
    const struct glint_mesh_vertex *a = model_corner(m, face, k), *b = model_corner(m, face, k + 1),
                                   *c = model_corner(m, face, k + 2);
    edge->is_flat = abs(b->y - a->y) < abs(b->x - a->x);
    edge->p = model_along(edge, b) < model_along(edge, a) ? b : a;
    edge->q = edge->p == a ? b : a;
    const int low = model_along(edge, edge->p), length = model_along(edge, edge->q) - low;
    const int64_t change = model_across(edge, edge->q) - model_across(edge, edge->p);
    edge->first = (low + 7) >> 4;
    edge->end = (low + length + 7) >> 4;
    edge->is_outline = edge->first < edge->end;
    if (!edge->is_outline)
        return;
    edge->zeros = (unsigned)__builtin_clz((unsigned)length);
    edge->inverse = glint_mesh_inverse((uint32_t)length << edge->zeros >> 4);
    edge->step = change * edge->inverse >> (31 - edge->zeros);
    edge->e = (int64_t)4096 * model_across(edge, edge->p) + (edge->step >> 4) * (16 * edge->first + 8 - low);
    if (m->is_clipped[face]) /* c lies anywhere; fronts have their corners in one turn */
        edge->inside_is_after = edge->is_flat == (edge->p == b);
    else
        edge->inside_is_after = (int64_t)(model_across(edge, c) - model_across(edge, edge->p)) * length >
                                change * (model_along(edge, c) - low);
}

static inline void model_set(struct model_mesh *m)
{
    const struct made_mesh *const made = m->shown.made;
    const unsigned count = made->mesh.face_count;
    for (unsigned f = 0; f < count; f++) {
        m->is_clipped[f] = false;
        for (unsigned k = 0; k < 3; k++)
            m->is_clipped[f] |= model_corner(m, f, k)->out != 0;
        m->is_front[f] = m->is_clipped[f] ? model_fan_shows(m, f) : model_area(m, f) < 0;
        m->is_thin[f] = false;
        for (unsigned k = 0; k < 3; k++)
            m->edges[f][k].is_outline = false;
    }
    for (unsigned f = 0; made->mesh.neighbours && f < count; f++) {
        int64_t longest = 0;
        bool has_back = false;
        for (unsigned k = 0; k < 3; k++) {
            const struct glint_mesh_vertex *a = model_corner(m, f, k), *b = model_corner(m, f, k + 1);
            longest = llabs(b->x - a->x) > longest ? llabs(b->x - a->x) : longest;
            longest = llabs(b->y - a->y) > longest ? llabs(b->y - a->y) : longest;
            has_back |= model_is_back(m, made->neighbours[f][k]);
        }
        m->is_thin[f] = m->is_front[f] && !m->is_clipped[f] && has_back && -model_area(m, f) < 2 * longest;
    }
    for (unsigned f = 0; made->mesh.neighbours && f < count; f++)
        for (unsigned k = 0; m->is_front[f] && !m->is_thin[f] && k < 3; k++) {
            const unsigned beside = made->neighbours[f][k];
            if (model_is_in(m, f, k) &&
                (beside == GLINT_MESH_RIM || model_is_back(m, beside) || (beside < count && m->is_thin[beside])))
                model_edge_set(&m->edges[f][k], m, f, k);
        }
}

/* ---- Edges and their cells ---- */

/* How much of a pixel is inside, of 255; *is_cell: the edge cuts it. */
static inline int model_part(const struct model_edge *edge, int x, int y, bool *is_cell)
{
    const int along = edge->is_flat ? x : y, across = edge->is_flat ? y : x;
    const int64_t e = edge->e + edge->step * (along - edge->first), cell = e >> 16;
    const int before = cell < across ? 0 : cell > across ? 255 : (int)(e >> 8 & 255);
    *is_cell = cell == across && along >= edge->first && along < edge->end;
    return edge->inside_is_after ? 255 - before : before;
}

/* How much of 255 edge k of the face blends of a pixel; 0: it is no outline, or does not cut it. */
static inline int model_blended(const struct model_mesh *m, unsigned face, unsigned k, int x, int y)
{
    const struct model_edge *const edges = m->edges[face];
    bool is_cell;
    if (!edges[k].is_outline)
        return 0;
    int part = model_part(&edges[k], x, y, &is_cell);
    if (!is_cell)
        return 0;
    for (unsigned j = 0; j < 3; j++) {
        const int along = edges[j].is_flat ? x : y;
        if (j == k || !edges[j].is_outline || along < edges[j].first || along >= edges[j].end)
            continue;
        part += model_part(&edges[j], x, y, &is_cell) - 255;
        part = part < 0 ? 0 : part;
        if (is_cell && j < k)
            return 0;
    }
    return part;
}

/* Pixels beyond which an edge has no cell; none where it is no outline. */
struct model_box {
    int left, top, right, bottom;
};
static inline struct model_box model_box(const struct model_edge *edge)
{
    const struct glint_mesh_vertex *p = edge->p, *q = edge->q;
    if (!edge->is_outline)
        return (struct model_box){0, 0, 0, 0};
    const int left = (p->x < q->x ? p->x : q->x) / 16 - 1, right = (p->x < q->x ? q->x : p->x) / 16 + 2,
              top = (p->y < q->y ? p->y : q->y) / 16 - 1, bottom = (p->y < q->y ? q->y : p->y) / 16 + 2;
    return (struct model_box){left < 0 ? 0 : left, top < 0 ? 0 : top, right > MESH_W ? MESH_W : right,
                              bottom > MESH_H ? MESH_H : bottom};
}

/* Does an outline of the face cut the pixel? */
static inline bool model_cuts(const struct model_mesh *m, unsigned face, int x, int y)
{
    bool is_cell = false;
    for (unsigned k = 0; !is_cell && k < 3; k++)
        if (m->edges[face][k].is_outline)
            (void)model_part(&m->edges[face][k], x, y, &is_cell);
    return is_cell;
}

/* Is the pixel a cell of which so much is inside that faces leave it out, and in the columns, or lines, of near? */
static inline bool model_is_left_out(const struct model_edge *edge, int x, int y, struct model_box near)
{
    const int along = edge->is_flat ? x : y, across = edge->is_flat ? y : x;
    bool is_cell = false;
    if (edge->is_outline)
        (void)model_part(edge, x, y, &is_cell);
    if (!is_cell || along < (edge->is_flat ? near.left : near.top) ||
        along >= (edge->is_flat ? near.right : near.bottom))
        return false;
    const int64_t before = edge->e + edge->step * (along - edge->first) - (int64_t)across * 65536;
    return edge->inside_is_after ? before < 33792 : before >= 31744;
}

/* Does a face leave the pixel out? */
static inline bool model_leaves_out(const struct model_mesh *m, unsigned face, int x, int y)
{
    const struct model_box all = {0, 0, MESH_W, MESH_H};
    bool does = false;
    for (unsigned k = 0; k < 3; k++)
        does = does || model_is_left_out(&m->edges[face][k], x, y, all);
    for (unsigned k = 0; m->shown.made->mesh.neighbours && k < 3; k++) {
        const unsigned beside = m->shown.made->neighbours[face][k];
        const struct glint_mesh_vertex *a = model_corner(m, face, k), *b = model_corner(m, face, k + 1);
        struct model_box near = {((a->x < b->x ? a->x : b->x) >> 4) - 1, ((a->y < b->y ? a->y : b->y) >> 4) - 1,
                                 ((a->x < b->x ? b->x : a->x) >> 4) + 2, ((a->y < b->y ? b->y : a->y) >> 4) + 2};
        for (unsigned j = 0; beside < m->shown.made->mesh.face_count && j < 3; j++)
            does = does || model_is_left_out(&m->edges[beside][j], x, y, m->is_clipped[face] ? all : near);
    }
    return does;
}

/* ---- Values of a cell ---- */

static inline uint32_t model_step(const struct model_edge *edge, int64_t d)
{
    const int64_t product = d * edge->inverse;
    return (uint32_t)(edge->zeros > 26 ? product * (1 << (edge->zeros - 26)) : product >> (26 - edge->zeros));
}

static inline uint32_t model_linear(const struct model_edge *edge, uint32_t start, uint32_t step, uint32_t cells)
{
    const int64_t offset = 16 * edge->first + 8 - model_along(edge, edge->p);
    return start + (uint32_t)(((int32_t)step >> 4) * offset) + cells * step;
}

struct model_values {
    uint32_t z, nl, t;
};

static inline struct model_values model_values(const struct model_mesh *m, const struct glint_paint *paint,
                                               unsigned face, unsigned k, int x, int y)
{
    struct model_values v = {0, UINT32_MAX, (uint32_t)1 << 31};
    const struct model_edge edge = m->edges[face][k];
    const struct glint_mesh_vertex *p = edge.p, *q = edge.q;
    const uint32_t cells = (uint32_t)((edge.is_flat ? x : y) - edge.first), t_end = glint_mesh_t_end(paint);
    v.z = model_linear(&edge, (uint32_t)p->z << 16, model_step(&edge, ((int64_t)q->z - p->z) >> 1), cells);
    if (p->nl_q30 < 0 && q->nl_q30 < 0)
        return v;
    const int64_t rise = ((int64_t)(q->nl_q30 >> 2) - (p->nl_q30 >> 2)) >> 15;
    v.nl = model_linear(&edge, (uint32_t)p->nl_q30, model_step(&edge, rise), cells);
    const uint32_t least = p->t_q30 < q->t_q30 ? p->t_q30 : q->t_q30, beyond = least > t_end ? least - t_end : 0;
    struct glint_vec a, b;
    glint_mesh_normal(&a, &m->shown.made->mesh, m->shown.made->faces[face][k]);
    glint_mesh_normal(&b, &m->shown.made->mesh, m->shown.made->faces[face][(k + 1) % 3]);
    const uint32_t s = glint_mesh_side(&a, &b);
    if (beyond >= (uint32_t)1 << 29 || beyond > s)
        return v;
    const int64_t one = (int64_t)1 << 30, o = 16 * edge.first + 8 - model_along(&edge, p);
    const int64_t whole = edge.zeros < 13 ? edge.inverse >> (13 - edge.zeros) : edge.inverse << (edge.zeros - 13);
    const int64_t u = whole < one ? whole : one, w = (u >> 4) * o, D = 2 * (int64_t)s, bend = u * D >> 30,
                  R = (int64_t)q->t_q30 - p->t_q30;
    uint32_t tx = (uint32_t)(R * u >> 30) - (uint32_t)bend + (uint32_t)((bend >> 1) * (2 * w + u) >> 29);
    v.t = p->t_q30 + (uint32_t)(R * w >> 30) - (uint32_t)(s * (w * (one - w) >> 30) >> 29);
    for (uint32_t i = 0; i < cells; i++) {
        v.t += tx;
        tx += (uint32_t)((bend >> 1) * u >> 28);
    }
    return v;
}

/* ---- Pixels of any format ---- */

/* From a byte on, whatever its place on its line. */
static inline void pixel_get(uint8_t pixel[4], enum glint_format format, const uint8_t *line, unsigned x)
{
    const unsigned bits = pixel_bits(format);
    memset(pixel, 0, 4);
    if (bits >= 8)
        memcpy(pixel, line + bits / 8 * x, bits / 8);
    else
        pixel[0] = (uint8_t)(line[bits * x / 8] << bits * x % 8 & 0xff00 >> bits);
}

static inline void pixel_put(const uint8_t pixel[4], enum glint_format format, uint8_t *line, unsigned x)
{
    const unsigned bits = pixel_bits(format);
    uint8_t *const at = &line[bits * x / 8];
    if (bits >= 8) {
        memcpy(at, pixel, bits / 8);
        return;
    }
    const unsigned mask = (0xff00u >> bits & 0xff) >> bits * x % 8;
    *at = (uint8_t)((*at & ~mask) | ((unsigned)pixel[0] >> bits * x % 8 & mask));
}

/* ---- A picture ---- */

struct model_picture {
    struct model_mesh meshes[2];
    unsigned count;
    struct glint_mesh_frame frame;
    _Alignas(8) uint8_t memory[MESH_W * MESH_H * 2 + 4096 + GLINT_MESH_LIGHTS_BYTES];
    uint16_t depth[MESH_H][MESH_W];
    uint8_t pixels[MESH_H * MESH_W * 4];
    unsigned blended, clipped; /* cells; those of clipped faces */
};

/* Where the meshes lie, and which of their edges are outlines. */
static inline void model_begin(struct model_picture *p, const struct mesh_shown *shown, unsigned count)
{
    assert_int_equal(glint_mesh_begin(&p->frame, MESH_W, MESH_H, MESH_H, shown->made->distance, p->memory,
                                      glint_mesh_frame_bytes(MESH_W, MESH_H) + GLINT_MESH_LIGHTS_BYTES),
                     GLINT_OK);
    p->frame.outlines = &glint_outlines;
    p->count = count;
    for (unsigned i = 0; i < count; i++) {
        struct model_mesh *const m = &p->meshes[i];
        m->shown = shown[i];
        m->frame = &p->frame;
        assert_int_equal(glint_mesh_add(&p->frame, &m->drawn, &m->shown.made->mesh, &m->shown.made->pose,
                                        m->shown.paints, m->work, sizeof m->work),
                         GLINT_OK);
        model_set(m);
    }
}

static inline const struct glint_paint *model_paint(const struct model_mesh *m, unsigned face)
{
    unsigned part = 0;
    while (part + 1u < m->shown.made->mesh.part_count && face >= m->shown.made->mesh.ends[part])
        part++;
    return &m->shown.paints[part];
}

/* Calls `each` with the pixels that the face covers and their depths. */
typedef void model_each(void *context, int x, int y, uint32_t z);
static inline void model_cover_by(const struct glint_mesh_vertex *a, const struct glint_mesh_vertex *b,
                                  const struct glint_mesh_vertex *c, model_each *each, void *context)
{
    struct glint_mesh_triangle triangle;
    const struct glint_mesh_corner corner[3] = {{a, 0}, {b, 0}, {c, 0}};
    if (glint_mesh_area(a, b, c) >= 0 || !glint_mesh_triangle_set(&triangle, corner, GLINT_MESH_GLOSSY, UINT32_MAX))
        return;
    if (triangle.y < 0)
        glint_mesh_triangle_skip(&triangle, triangle.y_end < 0 ? triangle.y_end : 0);
    for (; triangle.y < triangle.y_end && triangle.y < MESH_H; glint_mesh_triangle_skip(&triangle, triangle.y + 1)) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(&triangle, triangle.y_end);
        int32_t left, right;
        if (!glint_mesh_columns(part.left, part.right, MESH_W, &left, &right))
            continue;
        for (int32_t x = left; x < right; x++)
            each(context, x, triangle.y, triangle.values.z + (uint32_t)(x - triangle.values.x) * triangle.values.zx);
    }
}

static inline void model_cover(const struct model_mesh *m, unsigned face, model_each *each, void *context)
{
    struct model_fan fan;
    if (!m->is_clipped[face]) {
        model_cover_by(model_corner(m, face, 0), model_corner(m, face, 1), model_corner(m, face, 2), each, context);
        return;
    }
    model_fan_set(&fan, m, face);
    for (unsigned i = 0; i < fan.count; i++)
        model_cover_by(&fan.at[i][0], &fan.at[i][1], &fan.at[i][2], each, context);
}

/* A face alone, which is drawn without outlines, and the picture. */
struct model_face {
    struct model_picture *picture;
    const struct model_mesh *mesh;
    unsigned face;
    enum glint_format format;
    uint8_t alone[MESH_H * MESH_W * 4];
};

static inline void model_pixel(void *context, int x, int y, uint32_t z)
{
    struct model_face *const of = context;
    const size_t line = bytes_of(of->format, MESH_W) * (size_t)y;
    uint16_t *const depth = &of->picture->depth[y][x];
    uint8_t pixel[4];
    if (z >> 16 >= *depth || model_leaves_out(of->mesh, of->face, x, y))
        return;
    *depth = (uint16_t)(z >> 16);
    pixel_get(pixel, of->format, of->alone + line, (unsigned)x);
    pixel_put(pixel, of->format, of->picture->pixels + line, (unsigned)x);
}

static inline void model_face_draw(struct model_face *of)
{
    static const unsigned whole[] = {MESH_H};
    static struct made_mesh one;
    const struct made_mesh *const made = of->mesh->shown.made;
    const struct mesh_shown shown = {&one, model_paint(of->mesh, of->face)};
    one.mesh = made->mesh;
    one.pose = made->pose;
    one.distance = made->distance;
    one.mesh.faces += 3 * of->face;
    one.mesh.face_count = 1;
    one.mesh.ends = NULL;
    one.mesh.part_count = 0;
    one.mesh.neighbours = NULL;
    if (one.mesh.of_faces)
        one.mesh.of_faces += 3 * of->face;
    memset(of->alone, 0, sizeof of->alone);
    meshes_picture(&shown, 1, &(struct mesh_cut){whole, 1, MESH_DOWN}, of->alone, bytes_of(of->format, MESH_W));
    model_cover(of->mesh, of->face, model_pixel, of);
}

/* A pixel by a paint over what it was, `part` of 255 of it. The albedo of a face that has one: red, green, blue. */
static inline void model_span(uint8_t pixel[4], const struct glint_paint *paint, const struct model_values *v,
                              const uint8_t *albedo, uint8_t part, int x, int y)
{
    const struct glint_span span = {.t_q30 = v->t, .nl_q30 = (int32_t)v->nl, .w = 1};
    const struct glint_surface surface = {pixel, 4, (uint16_t)x, (uint16_t)y};
    struct glint_maps maps = {.coverage = &part};
    uint16_t rgb565;
    if (albedo && glint_paint_is_exact(paint)) {
        maps.albedo = albedo;
        maps.albedo_format = GLINT_RGB888;
    } else if (albedo) {
        static const uint32_t one[3] = {254952, 518127, 254952};
        uint32_t level[3];
        for (int k = 0; k < 3; k++)
            level[k] = (albedo[k] * one[k] + ((uint32_t)1 << 20)) >> 21;
        rgb565 = (uint16_t)(level[0] << 11 | level[1] << 5 | level[2]);
        maps.albedo = (const uint8_t *)&rgb565;
        maps.albedo_format = GLINT_RGB565;
    }
    assert_int_equal(glint_draw_span(paint, &span, &maps, &surface, NULL), GLINT_OK);
}

static inline void model_blend(struct model_picture *p, const struct model_mesh *m, unsigned face, unsigned k, int x,
                               int y, enum glint_format format)
{
    uint8_t *const line = p->pixels + bytes_of(format, MESH_W) * (size_t)y, was[4], pixel[4];
    const int blended = model_blended(m, face, k, x, y);
    const struct glint_paint *const paint = model_paint(m, face);
    if (blended == 0)
        return;
    const struct model_values v = model_values(m, paint, face, k, x, y);
    if (v.z >> 16 >= p->depth[y][x])
        return;
    const unsigned part = (unsigned)blended;
    const uint8_t *const albedo = m->shown.made->mesh.of_faces ? m->shown.made->mesh.of_faces + 3 * face : NULL;
    p->blended++;
    p->clipped += m->is_clipped[face];
    pixel_get(was, format, line, (unsigned)x);
    memcpy(pixel, was, sizeof pixel);
    model_span(pixel, paint, &v, albedo, (uint8_t)part, x, y);
    for (unsigned i = 0; format == GLINT_ARGB8888 && was[3] && i < 4; i++)
        pixel[i] = (uint8_t)lrint((part * (i < 3 ? pixel[i] : 255) + (255. - part) * was[i]) / 255);
    pixel_put(pixel, format, line, (unsigned)x);
}

/* Under one directional light or none; in colours of faces, or of the material. */
static inline void model_draw(struct model_picture *p, enum glint_format format, uint8_t ground)
{
    static struct model_face of;
    memset(p->pixels, ground, sizeof p->pixels);
    memset(p->depth, 0xff, sizeof p->depth);
    p->blended = p->clipped = 0;
    for (unsigned i = 0; i < p->count; i++)
        for (unsigned f = 0; f < p->meshes[i].shown.made->mesh.face_count; f++) {
            of.picture = p;
            of.mesh = &p->meshes[i];
            of.face = f;
            of.format = format;
            if (of.mesh->is_clipped[f] || (of.mesh->is_front[f] && !of.mesh->is_thin[f]))
                model_face_draw(&of);
        }
    for (unsigned i = 0; i < p->count; i++)
        for (unsigned f = 0; f < p->meshes[i].shown.made->mesh.face_count; f++)
            for (unsigned k = 0; k < 3; k++) {
                const struct model_mesh *const m = &p->meshes[i];
                const struct model_box box = model_box(&m->edges[f][k]);
                for (int y = box.top; y < box.bottom; y++)
                    for (int x = box.left; x < box.right; x++)
                        model_blend(p, m, f, k, x, y, format);
            }
}

/* Pixels that an outline may change: its cells, and those of thin faces. */
static inline void model_mark(void *context, int x, int y, uint32_t z)
{
    (void)z;
    ((bool(*)[MESH_W])context)[y][x] = true;
}

static inline void model_changed(const struct model_picture *p, bool changed[MESH_H][MESH_W])
{
    memset(changed, 0, sizeof(bool[MESH_H][MESH_W]));
    for (unsigned i = 0; i < p->count; i++)
        for (unsigned f = 0; f < p->meshes[i].shown.made->mesh.face_count; f++) {
            const struct model_mesh *const m = &p->meshes[i];
            if (m->is_thin[f])
                model_cover(m, f, model_mark, changed);
            for (unsigned k = 0; k < 3; k++) {
                const struct model_box box = model_box(&m->edges[f][k]);
                for (int y = box.top; y < box.bottom; y++)
                    for (int x = box.left; x < box.right; x++)
                        changed[y][x] |= model_cuts(m, f, x, y);
            }
        }
}

#endif
