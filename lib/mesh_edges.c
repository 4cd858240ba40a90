/* SPDX-License-Identifier: MIT
 * Smooth outlines. An edge between a face that shows its front and one that does not is an outline. It is walked along its longer axis, a
 * line or column a step, and the pixel that it cuts there is a cell: the faces beside it leave the cell out, and after all faces of
 * the strip the edge blends its own colour over it. Both take cells from the same walk, or holes would appear. Faces are not drawn otherwise
 * than without outlines: while one is drawn, its cells' depths are the nearest, so each path leaves them out. */
#include "glint_mesh_strip.h"
#include "glint_port.h"
#include "glint_tables.h"

/* Of a face. */
enum {
    EDGES = 7,   /* bit k: its edge from corner k on is an outline */
    BESIDE = 8,  /* a neighbour may have an outline */
    FRONT = 16,  /* it shows its front */
    THIN = 32,   /* but so narrow that it counts as back, and is not drawn */
    CLIPPED = 64 /* front or back is not known: there is no outline beside it */
};
typedef char edges_ask[(EDGES | BESIDE | THIN) == GLINT_EDGES_ASK ? 1 : -1];

enum { UNLISTED = 0xfffe }; /* in links: no face has this number */

/* ---- Memory: behind the mesh's ---- */

static uint32_t edges_bands(uint16_t h)
{
    return (h + GLINT_MESH_BAND - 1u) / GLINT_MESH_BAND;
}

uint32_t glint_mesh_edges_bytes(const struct glint_mesh *mesh, uint16_t h)
{
    return mesh->neighbours ? (uint32_t)sizeof(void *) - 2 /* to align */ + (uint32_t)sizeof(struct glint_mesh_hidden) +
                                  3u * mesh->face_count + 2 * edges_bands(h)
                            : 0;
}

static void edges_place(const struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn)
{
    uint8_t *memory = (uint8_t *)(drawn->bands + edges_bands(frame->h));
    while (GLINT_MISALIGNED(memory, pointer))
        memory += 2;
    drawn->hidden = (struct glint_mesh_hidden *)(void *)memory;
    drawn->rims = (uint16_t *)(void *)(drawn->hidden + 1);
    drawn->rim_bands = drawn->rims + drawn->mesh->face_count;
    drawn->edges = (uint8_t *)(drawn->rim_bands + edges_bands(frame->h));
}

/* ---- Which edges are outlines ---- */

static inline const struct glint_mesh_vertex *edges_vertex(const struct glint_mesh_drawn *drawn, unsigned face,
                                                           unsigned corner)
{
    return &drawn->vertices[drawn->mesh->faces[3 * (size_t)face + corner]];
}

static int32_t edges_size(int32_t x)
{
    return x < 0 ? -x : x;
}

/* Narrower than 1/8 pixel, across its longest side along an axis? */
static bool edges_is_thin(const struct glint_mesh_drawn *drawn, unsigned face)
{
    const struct glint_mesh_vertex *v[3];
    int32_t longest = 0;
    for (unsigned k = 0; k < 3; k++)
        v[k] = edges_vertex(drawn, face, k);
    for (unsigned k = 0; k < 3; k++) {
        const struct glint_mesh_vertex *a = v[k], *b = v[k == 2 ? 0 : k + 1];
        const int32_t x = edges_size(b->x - a->x), y = edges_size(b->y - a->y);
        longest = x > longest ? x : longest;
        longest = y > longest ? y : longest;
    }
    return -glint_mesh_area(v[0], v[1], v[2]) < 2 * longest;
}

/* Which faces show their fronts. Those in lists do, if they are not clipped. */
static void edges_fronts(const struct glint_mesh_drawn *drawn)
{
    const uint16_t *face = drawn->mesh->faces;
    for (unsigned i = 0; i < drawn->mesh->face_count; i++, face += 3) {
        const struct glint_mesh_vertex *v = drawn->vertices;
        uint8_t is = FRONT;
        if (drawn->is_cut && glint_mesh_face_is_out(drawn, face))
            is = CLIPPED;
        else if (drawn->links[i] == UNLISTED && glint_mesh_area(&v[face[0]], &v[face[1]], &v[face[2]]) >= 0)
            is = 0;
        drawn->edges[i] = is;
    }
}

/* A thin face's neighbours have outlines towards it. */
static void edges_round(const struct glint_mesh_drawn *drawn, unsigned face)
{
    const uint16_t *const all = drawn->mesh->neighbours;
    drawn->edges[face] = FRONT | THIN;
    for (unsigned k = 0; k < 3; k++) {
        const unsigned beside = all[3 * (size_t)face + k];
        if (beside >= drawn->mesh->face_count || (drawn->edges[beside] & (FRONT | THIN)) != FRONT)
            continue;
        for (unsigned j = 0; j < 3; j++)
            if (all[3 * (size_t)beside + j] == face)
                drawn->edges[beside] = (uint8_t)(drawn->edges[beside] | 1u << j);
    }
}

static void edges_mark(const struct glint_mesh_drawn *drawn)
{
    const unsigned count = drawn->mesh->face_count;
    uint8_t *const edges = drawn->edges;
    bool any_thin = false;
    edges_fronts(drawn);
    const uint16_t *beside = drawn->mesh->neighbours;
    for (unsigned i = 0; i < count; i++, beside += 3) {
        if (!(edges[i] & FRONT))
            continue;
        unsigned found = 0;
        bool has_back = false;
        for (unsigned k = 0; k < 3; k++) {
            const unsigned other = beside[k];
            if (other < count ? edges[other] & (FRONT | CLIPPED) : other != GLINT_MESH_RIM)
                continue;
            found |= 1u << k;
            has_back |= other < count;
        }
        if (has_back && edges_is_thin(drawn, i)) {
            found = THIN;
            any_thin = true;
        }
        edges[i] = (uint8_t)(edges[i] | found);
    }
    for (unsigned i = 0; any_thin && i < count; i++)
        if (edges[i] & THIN)
            edges_round(drawn, i);
    beside = drawn->mesh->neighbours;
    for (unsigned i = 0; i < count; i++, beside += 3)
        for (unsigned k = 0; edges[i] & EDGES && k < 3; k++)
            if (beside[k] < count)
                edges[beside[k]] |= BESIDE;
}

/* Sorts faces with outlines as glint_mesh_sort does all. Their cells lie between their first and last corner, but for what the walk
 * rounds. */
static void edges_sort(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y)
{
    for (uint32_t i = 0; i < edges_bands(frame->h); i++)
        drawn->rim_bands[i] = GLINT_MESH_NONE;
    for (unsigned i = drawn->mesh->face_count; i--;) {
        if (!(drawn->edges[i] & EDGES))
            continue;
        const int32_t a = edges_vertex(drawn, i, 0)->y, b = edges_vertex(drawn, i, 1)->y,
                      c = edges_vertex(drawn, i, 2)->y;
        int32_t first = a < b ? a : b, last = a < b ? b : a;
        first = ((c < first ? c : first) - 1) >> 4;
        last = ((c > last ? c : last) + 1) >> 4;
        first = first > y ? first : y;
        if (first > last || first >= frame->h)
            continue;
        uint16_t *band = &drawn->rim_bands[(uint32_t)first / GLINT_MESH_BAND];
        drawn->rims[i] = *band;
        *band = (uint16_t)i;
    }
}

static void edges_add(const struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn)
{
    edges_place(frame, drawn);
    for (unsigned i = 0; i < drawn->mesh->face_count; i++)
        drawn->links[i] = UNLISTED;
    glint_mesh_sort(frame, drawn, frame->y);
    edges_mark(drawn);
    edges_sort(frame, drawn, frame->y);
}

/* ---- The walk ---- */

/* Pixels of the picture. */
struct window {
    int32_t left, top, right, bottom;
};

/* An edge, a line after another, or where it is flatter, a column. */
struct walk {
    const struct glint_mesh_vertex *upper, *lower; /* or left and right */
    uint32_t inverse;
    unsigned up;
    int32_t first, at, end; /* lines or columns: of the edge, and those to walk */
    int32_t e, step;        /* at `at`: where it is across, Q16 */
    bool is_flat;
    bool grows; /* the inside is right of it or below */
};

/* As edges of triangles: |step| <= 2^16, so the part of the first cell is below 2^16. false: no cell in the window. */
static bool walk_set(struct walk *walk, const struct glint_mesh_vertex *a, const struct glint_mesh_vertex *b,
                     const struct window *window)
{
    const int32_t dx = b->x - a->x, dy = b->y - a->y;
    const bool is_flat = edges_size(dy) < edges_size(dx), turned = (is_flat ? dx : dy) < 0;
    const struct glint_mesh_vertex *const p = turned ? b : a, *const q = turned ? a : b;
    const int32_t low = is_flat ? p->x : p->y, high = is_flat ? q->x : q->y;
    const int32_t least = is_flat ? window->left : window->top, most = is_flat ? window->right : window->bottom;
    const int32_t first = glint_mesh_first(low), end = glint_mesh_first(high);
    walk->at = first > least ? first : least;
    walk->end = end < most ? end : most;
    if (walk->at >= walk->end)
        return false;
    const int32_t from = is_flat ? p->y : p->x, to = is_flat ? q->y : q->x;
    const uint32_t length = (uint32_t)(high - low); /* 1..2^15 - 2 */
    walk->upper = p;
    walk->lower = q;
    walk->up = glint_mesh_zeros(length);
    walk->inverse = glint_mesh_inverse(length << walk->up >> 4);
    walk->first = first;
    walk->step = (to - from) * (int32_t)walk->inverse >> (31 - walk->up);
    walk->e = from * 4096 + (walk->step >> 4) * (16 * first + 8 - low) + walk->step * (walk->at - first);
    walk->is_flat = is_flat;
    walk->grows = is_flat ? turned : !turned;
    return true;
}

/* How much of the cell at e is inside, of 256; 0: it is not cut. */
static inline unsigned walk_part(const struct walk *walk, int32_t e)
{
    const unsigned part = (unsigned)(e >> 8) & 255;
    return walk->grows ? (256 - part) & 255 : part;
}

/* ---- Cells that faces leave out ---- */

/* false: there may be no room for all. */
static bool hide_edge(const struct glint_mesh_target *strip, struct glint_mesh_hidden *hidden,
                      const struct glint_mesh_vertex *a, const struct glint_mesh_vertex *b, const struct window *window)
{
    struct walk walk;
    if (!walk_set(&walk, a, b, window))
        return true;
    const uint32_t w = (uint32_t)strip->w, least = (uint32_t)(walk.is_flat ? window->top : window->left),
                   room = (uint32_t)(walk.is_flat ? window->bottom : window->right) - least,
                   along = walk.is_flat ? 1 : w, across = walk.is_flat ? w : 1, count = hidden->count;
    uint32_t *at = hidden->at + count, first;
    uint16_t *depth = hidden->depth + count, *const depths = strip->depth;
    int32_t left = walk.end - walk.at, e = walk.e;
    if (count + (uint32_t)left > GLINT_MESH_HIDDEN)
        return false;
    first = walk.is_flat ? (uint32_t)walk.at + (least - (uint32_t)strip->y) * w
                         : (uint32_t)(walk.at - strip->y) * w + least;
    for (; left; left--, first += along, e += walk.step) {
        const uint32_t cell = (uint32_t)(e >> 16) - least;
        if (cell >= room || (e & 0xff00) == 0)
            continue;
        uint16_t *const place = depths + (first + cell * across);
        *at++ = first + cell * across;
        *depth++ = *place;
        *place = 0;
    }
    hidden->count = (uint16_t)(at - hidden->at);
    return true;
}

/* Those of the face's outlines. */
static bool hide_outlines(const struct glint_mesh_target *strip, unsigned face, const struct window *window)
{
    const struct glint_mesh_drawn *drawn = strip->drawn;
    unsigned edges = drawn->edges[face] & EDGES;
    for (unsigned k = 0; edges; k++, edges >>= 1)
        if (edges & 1 && !hide_edge(strip, drawn->hidden, edges_vertex(drawn, face, k),
                                    edges_vertex(drawn, face, k == 2 ? 0 : k + 1), window))
            return false;
    return true;
}

void glint_mesh_show(const struct glint_mesh_target *strip)
{
    struct glint_mesh_hidden *const hidden = strip->drawn->hidden;
    const uint32_t *at = hidden->at + hidden->count;
    const uint16_t *depth = hidden->depth + hidden->count;
    uint16_t *const depths = strip->depth;
    while (at != hidden->at) /* a cell of two edges was hidden twice */
        depths[*--at] = *--depth;
}

/* And those of its neighbours, which reach it where it is narrow. false: there was no room, and nothing is hidden. */
static bool hide(const struct glint_mesh_target *strip, unsigned face, const struct window *window)
{
    const struct glint_mesh_drawn *drawn = strip->drawn;
    const uint16_t *const beside = drawn->mesh->neighbours + 3 * (size_t)face;
    drawn->hidden->count = 0;
    if (window->left >= window->right || window->top >= window->bottom)
        return true;
    bool fits = hide_outlines(strip, face, window);
    for (unsigned k = 0; fits && drawn->edges[face] & BESIDE && k < 3; k++)
        if (beside[k] < drawn->mesh->face_count && drawn->edges[beside[k]] & FRONT)
            fits = hide_outlines(strip, beside[k], window);
    if (!fits)
        glint_mesh_show(strip);
    return fits;
}

/* The pixels of the strip that the face may draw. */
static void face_window(struct window *window, const struct glint_mesh_target *strip, unsigned face)
{
    const struct glint_mesh_drawn *drawn = strip->drawn;
    window->left = 0;
    window->top = strip->y;
    window->right = strip->w;
    window->bottom = strip->end;
    if (drawn->edges[face] & CLIPPED)
        return;
    const struct glint_mesh_vertex *v = edges_vertex(drawn, face, 0);
    int32_t left = v->x, top = v->y, right = left, bottom = top;
    for (unsigned k = 1; k < 3; k++) {
        v = edges_vertex(drawn, face, k);
        left = v->x < left ? v->x : left;
        right = v->x > right ? v->x : right;
        top = v->y < top ? v->y : top;
        bottom = v->y > bottom ? v->y : bottom;
    }
    left = (left >> 4) - 1; /* an edge's column is rounded */
    right = (right >> 4) + 2;
    top = top >> 4;
    bottom = (bottom >> 4) + 1;
    window->left = left > window->left ? left : window->left;
    window->top = top > window->top ? top : window->top;
    window->right = right < window->right ? right : window->right;
    window->bottom = bottom < window->bottom ? bottom : window->bottom;
}

/* What paints a face; part: up to its own, to begin with. */
static const struct glint_paint *edges_paint(const struct glint_mesh_drawn *drawn, unsigned face, unsigned part)
{
    while (part + 1u < drawn->mesh->part_count && face >= drawn->mesh->ends[part])
        part++;
    return &drawn->paints[part];
}

/* A face of more cells than there is room for: a piece of a line after the other, each with room for all of its cells. Alone, for the stack. */
static __attribute__((noinline)) void rows_in_pieces(const struct glint_paint *paint,
                                                     struct glint_mesh_triangle *triangle,
                                                     const struct glint_mesh_target *strip, const struct window *whole)
{
    enum { PIECE = (GLINT_MESH_HIDDEN - 1) / 12 }; /* a cell a column or line of the face's edges and its neighbours' */
    const unsigned face = glint_mesh_face_of(triangle);
    const int32_t end = triangle->y_end < strip->end ? triangle->y_end : strip->end;
    struct window window;
    if (triangle->y < strip->y)
        glint_mesh_triangle_skip(triangle, strip->y);
    for (; triangle->y < end; glint_mesh_triangle_skip(triangle, triangle->y + 1)) {
        window.top = triangle->y;
        window.bottom = triangle->y + 1;
        for (window.left = whole->left; window.left < whole->right; window.left = window.right) {
            struct glint_mesh_kept piece;
            const int32_t right = window.left + PIECE;
            window.right = right < whole->right ? right : whole->right;
            piece.triangle = *triangle;
            piece.face = (uint16_t)face;
            piece.triangle.y_end = (int16_t)window.bottom;
            const struct glint_mesh_part part = glint_mesh_triangle_part(&piece.triangle, window.bottom);
            int32_t line[2];
            if (!glint_mesh_columns(part.left, part.right, strip->w, &line[0], &line[1]))
                break;
            const int32_t from = line[0] > window.left ? line[0] : window.left,
                          to = line[1] < window.right ? line[1] : window.right;
            if (from >= to)
                continue;
            part.left->x = from * 65536;
            part.right->x = to * 65536;
            (void)hide(strip, face, &window);
            glint_mesh_piece(paint, &piece.triangle, strip, line);
            glint_mesh_show(strip);
        }
    }
}

bool glint_mesh_hide(struct glint_mesh_triangle *triangle, const struct glint_mesh_target *strip)
{
    const struct glint_mesh_drawn *drawn = strip->drawn;
    const unsigned face = glint_mesh_face_of(triangle);
    struct window window;
    if (drawn->edges[face] & THIN)
        return false;
    face_window(&window, strip, face);
    if (hide(strip, face, &window))
        return true;
    rows_in_pieces(edges_paint(drawn, face, 0), triangle, strip, &window);
    return false;
}

static void edges_rows(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                       const struct glint_mesh_target *strip)
{
    const bool asks = (strip->drawn->edges[glint_mesh_face_of(triangle)] & GLINT_EDGES_ASK) != 0;
    if (asks && !glint_mesh_hide(triangle, strip))
        return;
    glint_mesh_rows(paint, triangle, strip);
    if (asks)
        glint_mesh_show(strip);
}

#if GLINT_CORTEX_M0PLUS_ASM
static void edges_lines(const struct glint_mesh_target *strip, struct glint_mesh_lines *lines)
{
    (void)strip;
    *(void (**)(void))(void *)((uint8_t *)lines + GLINT_AT_STRIP_INNER) = lines->draw;
    lines->draw = glint_mesh_outlined;
}
#define EDGES_LINES edges_lines
#else
#define EDGES_LINES NULL
#endif

/* ---- Cells that edges blend ---- */

/* A number that changes by 2^26 d / length a cell, modulo 2^32; d of 16 bits and a sign, so that the product fits. */
static uint32_t cells_step(const struct walk *walk, int32_t d)
{
    const int32_t product = d * (int32_t)walk->inverse;
    return walk->up >= 26 ? (uint32_t)product << (walk->up - 26) : (uint32_t)(product >> (26 - walk->up));
}

/* And up to the first cell, offset / 16 of one. */
static uint32_t cells_first(uint32_t step, uint32_t offset)
{
    return (uint32_t)(((int64_t)(int32_t)step * offset) >> 4);
}

/* |a - b|^2 / 2 of the normals at the edge's ends, Q29. */
static uint32_t cells_side(const struct glint_mesh_drawn *drawn, unsigned face, unsigned k)
{
    const uint16_t *of = drawn->mesh->faces + 3 * (size_t)face;
    struct glint_vec a, b;
    glint_mesh_normal(&a, drawn->mesh, of[k]);
    glint_mesh_normal(&b, drawn->mesh, of[k == 2 ? 0 : k + 1]);
    return glint_mesh_side(&a, &b);
}

/* t(s) = t_a + s (t_b - t_a) - s (1 - s) |N_b - N_a|^2 / 2, s in Q30: at the first cell, and its steps. */
static void cells_t(struct glint_mesh_cell *cell, const struct walk *walk, uint32_t side, uint32_t offset)
{
    const uint32_t one = (uint32_t)1 << 30;
    const uint32_t u = walk->up > 27 ? one : walk->inverse << (walk->up - 13), s = (u >> 4) * offset;
    const int64_t d = 2 * (int64_t)side, rise = (int64_t)walk->lower->t_q30 - walk->upper->t_q30;
    const int64_t bend = (u * d) >> 30; /* u <= 2^30, d < 2^33 */
    cell->t = walk->upper->t_q30 + (uint32_t)((rise * s) >> 30) -
              (uint32_t)(((d >> 1) * (int64_t)(((uint64_t)s * (one - s)) >> 30)) >> 29);
    cell->dt = (uint32_t)((rise * u) >> 30) - (uint32_t)bend + (uint32_t)((bend >> 1) * (2 * (int64_t)s + u) >> 29);
    cell->ddt = (uint32_t)(((bend >> 1) * (int64_t)u) >> 28);
}

/* The values at the walk's cell and their steps. t_end: as for glint_mesh_shine. */
static void cells_set(struct glint_mesh_cell *cell, const struct walk *walk, const struct glint_mesh_drawn *drawn,
                      unsigned face, unsigned k, uint32_t t_end)
{
    const struct glint_mesh_vertex *a = walk->upper, *b = walk->lower;
    const uint32_t offset = (uint32_t)(16 * walk->first + 8 - (walk->is_flat ? a->x : a->y)); /* 0..15 */
    const uint32_t n = (uint32_t)(walk->at - walk->first);
    cell->dz = cells_step(walk, ((int32_t)b->z - a->z) >> 1);
    cell->z = ((uint32_t)a->z << 16) + (cells_first(cell->dz, offset)) + n * cell->dz;
    cell->nl = UINT32_MAX;
    cell->t = GLINT_MESH_FAR_T;
    cell->dnl = cell->dt = cell->ddt = 0;
    if ((a->nl_q30 & b->nl_q30) < 0)
        return;
    const uint32_t dnl = cells_step(walk, ((b->nl_q30 >> 2) - (a->nl_q30 >> 2)) >> 15);
    cell->dnl = dnl;
    cell->nl = (uint32_t)a->nl_q30 + cells_first(dnl, offset) + n * dnl;
    const uint32_t least = a->t_q30 < b->t_q30 ? a->t_q30 : b->t_q30, beyond = least > t_end ? least - t_end : 0;
    if (beyond >> 29)
        return;
    const uint32_t side = cells_side(drawn, face, k);
    if (beyond > side)
        return;
    cells_t(cell, walk, side, offset);
    cell->t += n * cell->dt + (n ? n * (n - 1) / 2 * cell->ddt : 0);
    cell->dt += n * cell->ddt;
}

/* What is left of a cell that other outlines of the face cut, too: of 256, 0 where one before edge k blends it. */
static __attribute__((noinline)) unsigned cells_shared(const struct glint_mesh_drawn *drawn, unsigned face, unsigned k,
                                                       int32_t x, int32_t y, unsigned part)
{
    static const struct window all = {-4096, -4096, 4096, 4096};
    unsigned left = part;
    for (unsigned j = 0; j < 3; j++) {
        struct walk walk;
        if (j == k || !(drawn->edges[face] >> j & 1) ||
            !walk_set(&walk, edges_vertex(drawn, face, j), edges_vertex(drawn, face, j == 2 ? 0 : j + 1), &all))
            continue;
        const int32_t along = walk.is_flat ? x : y, across = walk.is_flat ? y : x;
        const int32_t e = walk.e + walk.step * (along - walk.at), cell = e >> 16;
        const bool is_in = along >= walk.at && along < walk.end;
        unsigned of = cell == across ? walk_part(&walk, e) : (cell < across) == walk.grows ? 256 : 0;
        if (cell == across && of == 0)
            of = walk.grows ? 256 : 0;
        else if (cell == across && is_in && j < k)
            return 0;
        left = left + of > 256 ? left + of - 256 : 0;
    }
    return left;
}

struct glint_mesh_cells {
    const struct glint_mesh_target *strip;
    struct walk walk;
    struct glint_mesh_cell cell;
    unsigned face, k;
    bool is_alone; /* no other edge of the face is an outline */
};

static inline void cells_next(struct glint_mesh_cells *cells)
{
    struct glint_mesh_cell *const cell = &cells->cell;
    cells->walk.at++;
    cells->walk.e += cells->walk.step;
    cell->z += cell->dz;
    cell->nl += cell->dnl;
    cell->t += cell->dt;
    cell->dt += cell->ddt;
}

/* Sets the place and the part of the next cell that is in front, and goes on; false: there is none. */
static bool cells_found(struct glint_mesh_cells *cells, struct glint_mesh_cell *found)
{
    const struct glint_mesh_target *const strip = cells->strip;
    struct walk *const walk = &cells->walk;
    for (; walk->at < walk->end; cells_next(cells)) {
        const int32_t across = walk->e >> 16, x = walk->is_flat ? walk->at : across,
                      line = (walk->is_flat ? across : walk->at) - strip->y;
        unsigned part = walk_part(walk, walk->e);
        if (part == 0 || (uint32_t)x >= (uint32_t)strip->w || (uint32_t)line >= (uint32_t)(strip->end - strip->y) ||
            cells->cell.z >> 16 >= strip->depth[(size_t)line * (size_t)strip->w + (size_t)x])
            continue;
        if (!cells->is_alone)
            part = cells_shared(strip->drawn, cells->face, cells->k, x, line + strip->y, part);
        if (part == 0)
            continue;
        *found = cells->cell;
        found->x = x;
        found->line = line;
        found->part = (uint8_t)(part > 255 ? 255 : part);
        cells_next(cells);
        return true;
    }
    return false;
}

/* p over q in `part` of 255, of levels: as tables' pixels under a coverage map. */
static uint32_t colour_channel(uint32_t p, uint32_t q, uint32_t part)
{
    const uint32_t v = part * p + (255 - part) * q + 128;
    return (v + (v >> 8)) >> 8;
}

static uint32_t colour_swap(uint32_t x)
{
    return (x << 8 | x >> 8) & 0xffff;
}

static void colour_blend(uint16_t *out, uint32_t pixel, uint32_t part, bool swapped)
{
    const uint32_t p = swapped ? colour_swap(pixel) : pixel, q = swapped ? colour_swap(*out) : *out;
    const uint32_t rgb = colour_channel(p >> 11, q >> 11, part) << 11 |
                         colour_channel(p >> 5 & 63, q >> 5 & 63, part) << 5 | colour_channel(p & 31, q & 31, part);
    *out = (uint16_t)(swapped ? colour_swap(rgb) : rgb);
}

/* By COLOUR tables: what cells_found finds, in one loop. */
static __attribute__((noinline)) void colour_cells(struct glint_mesh_cells *cells, const struct glint_paint *paint)
{
    const struct glint_look look = glint_look_up(&paint->of.tables.filled);
    const struct glint_mesh_target *const strip = cells->strip;
    const struct walk *const walk = &cells->walk;
    const bool swapped = paint->output.format == GLINT_RGB565_SWAPPED;
    const uint32_t w = (uint32_t)strip->w, lines = (uint32_t)(strip->end - strip->y),
                   least = walk->is_flat ? (uint32_t)strip->y : 0, room = walk->is_flat ? lines : w;
    uint32_t z = cells->cell.z, nl = cells->cell.nl, back = look.t_max - cells->cell.t, dt = cells->cell.dt;
    int32_t e = walk->e;
    for (int32_t at = walk->at; at != walk->end; at++) {
        const uint32_t cell = (uint32_t)(e >> 16) - least, x = walk->is_flat ? (uint32_t)at : cell,
                       line = walk->is_flat ? cell : (uint32_t)(at - strip->y);
        if (cell < room && (e & 0xff00) && z >> 16 < strip->depth[line * w + x]) {
            unsigned part = walk_part(walk, e);
            uint16_t pixel;
            if (!cells->is_alone)
                part = cells_shared(strip->drawn, cells->face, cells->k, (int32_t)x, (int32_t)line + strip->y, part);
            if (part) {
                uint16_t *out =
                    (uint16_t *)(void *)((uint8_t *)strip->surface->pixels + strip->surface->stride * (ptrdiff_t)line) +
                    x;
                glint_look_store(&look, back, nl, &pixel);
                colour_blend(out, pixel, part > 255 ? 255 : part, swapped);
            }
        }
        e += walk->step;
        z += cells->cell.dz;
        nl += cells->cell.dnl;
        back -= dt;
        dt += cells->cell.ddt;
    }
}

/* Of the edge at hand: where no cells are hidden now, as it would take stack. */
typedef char edges_cells_fit[sizeof(struct glint_mesh_cells) <= sizeof(struct glint_mesh_hidden) ? 1 : -1];

static __attribute__((noinline)) void edges_draw_face(const struct glint_mesh_target *strip, unsigned face,
                                                      const struct glint_paint *paint)
{
    const struct window window = {0, strip->y, strip->w, strip->end};
    const struct glint_mesh_drawn *drawn = strip->drawn;
    const unsigned edges = drawn->edges[face] & EDGES;
    struct glint_mesh_cells *const cells = (struct glint_mesh_cells *)(void *)drawn->hidden;
    cells->strip = strip;
    cells->face = face;
    cells->is_alone = (edges & (edges - 1)) == 0;
    for (unsigned k = 0; k < 3; k++) {
        if (!(edges >> k & 1) || !walk_set(&cells->walk, edges_vertex(drawn, face, k),
                                           edges_vertex(drawn, face, k == 2 ? 0 : k + 1), &window))
            continue;
        cells->k = k;
        cells_set(&cells->cell, &cells->walk, drawn, face, k, glint_mesh_t_end(paint));
        if (glint_mesh_is_colour(paint, strip))
            colour_cells(cells, paint);
        else {
            struct glint_mesh_bench *bench = (struct glint_mesh_bench *)strip->frame->memory;
            bench->face.face = (uint16_t)face;
            glint_mesh_blend_cells(paint, cells, cells_found, &bench->face.triangle, strip);
        }
    }
}

/* The last line that a face's cells may be in. */
static int32_t edges_last(const struct glint_mesh_drawn *drawn, unsigned face)
{
    int32_t last = edges_vertex(drawn, face, 0)->y;
    for (unsigned k = 1; k < 3; k++) {
        const int32_t y = edges_vertex(drawn, face, k)->y;
        last = y > last ? y : last;
    }
    return (last + 1) >> 4;
}

/* The lists of faces with outlines for those of all faces, and back. */
static void edges_swap(struct glint_mesh_drawn *drawn)
{
    uint16_t *const links = drawn->links, *const bands = drawn->bands;
    drawn->links = drawn->rims;
    drawn->bands = drawn->rim_bands;
    drawn->rims = links;
    drawn->rim_bands = bands;
}

static void edges_draw(const struct glint_mesh_target *strip)
{
    struct glint_mesh_drawn *const drawn = strip->drawn;
    const struct glint_paint *paint = drawn->paints;
    uint16_t later = GLINT_MESH_NONE, *last = &later;
    edges_swap(drawn);
    uint16_t i = glint_mesh_take(drawn, strip->y, strip->end);
    while (i != GLINT_MESH_NONE) {
        paint = edges_paint(drawn, i, (unsigned)(paint - drawn->paints));
        edges_draw_face(strip, i, paint);
        const uint16_t next = drawn->links[i];
        if (edges_last(drawn, i) >= strip->end) {
            *last = i;
            last = &drawn->links[i];
        }
        i = next;
    }
    *last = GLINT_MESH_NONE;
    if (strip->end < strip->frame->h)
        glint_mesh_give(drawn, later, strip->end);
    edges_swap(drawn);
}

const struct glint_use_outlines glint_outlines GLINT_FLASH = {edges_add, edges_sort, edges_rows, edges_draw,
                                                              EDGES_LINES};
