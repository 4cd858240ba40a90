/* SPDX-License-Identifier: MIT
 * Cells: the pixels that outlines cut. The faces beside an outline leave its cells out, where their middles are inside, and after all faces of
 * the strip it blends its own colour over them; both take cells from the same walk, or holes would appear. Faces are not drawn otherwise
 * than without outlines: while one is drawn, its cells' depths are the nearest, so each path leaves them out. */
#include "glint_mesh_edges.h"
#include "glint_port.h"
#include "glint_tables.h"

/* ---- Cells that faces leave out ---- */

static int32_t cells_max(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

static int32_t cells_min(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

/* Of an outline those of lines or, if it is flat, columns at..end - 1. Returns where the next one is kept. */
static inline __attribute__((always_inline)) struct glint_mesh_hidden *
hide_rim(struct glint_mesh_hidden *hidden, const struct glint_mesh_rim *rim, int32_t w, int32_t at, int32_t end)
{
    const int32_t along = rim->is & GLINT_RIM_FLAT ? 1 : w, across = rim->is & GLINT_RIM_FLAT ? w : 1;
    /* A face draws no cell of which less is inside: its middle is outside. Somewhat less than half, for what edges round. The part is at
     * least GLINT_CELL_LEFT_OUT where what is left of the cell is less than least. */
    const uint16_t least = (256u - GLINT_CELL_LEFT_OUT) << 8, bias = rim->is & GLINT_RIM_GROWS ? 0 : least;
    const int32_t step = rim->step, first = at - rim->at;
    uint16_t *line = rim->depth + along * first;
    int32_t e = rim->e + step * first;
    for (const uint16_t *const last = line + along * (end - at); line < last; line += along, e += step) {
        if ((uint16_t)(e + bias) >= least)
            continue;
        uint16_t *const depth = line + across * (e >> 16);
        hidden->at = depth;
        hidden->depth = *depth;
        hidden++;
        *depth = 0;
    }
    return hidden;
}

static void cells_show(const struct glint_mesh_target *strip)
{
    const struct glint_mesh_outlines *const outlines = strip->drawn->outlines;
    const struct glint_mesh_hidden *const first = outlines->of.depths, *hidden = first + outlines->hidden;
    while (hidden != first) { /* a cell of two edges was hidden twice */
        hidden--;
        *hidden->at = (uint16_t)hidden->depth;
    }
}

/* Those of the face, and those of its neighbours that lie beside the edges between, which reach it where these are narrow. window: NULL, the whole
 * strip. false: there was no room, and nothing is hidden. */
static __attribute__((noinline)) bool hide(const struct glint_mesh_target *strip, unsigned face,
                                           const struct glint_mesh_window *window)
{
    const struct glint_mesh_drawn *const drawn = strip->drawn;
    struct glint_mesh_outlines *const outlines = drawn->outlines;
    struct glint_mesh_hidden *hidden = outlines->of.depths;
    const struct glint_mesh_hidden *const full = hidden + GLINT_MESH_HIDDEN;
    const uint16_t *const beside = drawn->mesh->neighbours + 3 * (size_t)face;
    const unsigned edges = drawn->edges[face], count = drawn->mesh->face_count;
    for (unsigned k = edges & GLINT_EDGES_BESIDE ? 4 : 1; k--;) {
        /* The face itself is the last one. */
        const unsigned i = k ? beside[k - 1] : face;
        const struct glint_mesh_rim *rim = outlines->rims;
        if (i >= count)
            continue;
        if (drawn->edges[i] & GLINT_EDGES_LISTED)
            rim += drawn->rims[i];
        else if (!(drawn->edges[i] & GLINT_EDGES) || outlines->rest == GLINT_MESH_NONE ||
                 (rim = glint_mesh_rims_of(strip, i)) == NULL)
            continue;
        for (;; rim++) {
            int32_t at = rim->at, end = rim->end;
            if (window) {
                at = cells_max(at, rim->is & GLINT_RIM_FLAT ? window->left : window->top);
                end = cells_min(end, rim->is & GLINT_RIM_FLAT ? window->right : window->bottom);
            }
            if (k && !(edges & GLINT_EDGES_CLIPPED)) {
                const struct glint_mesh_vertex *const p = glint_mesh_corner_at(drawn, face, k - 1),
                                                      *const q = glint_mesh_corner_at(drawn, face,
                                                                                      glint_mesh_corner_after(k - 1));
                const bool is_flat = rim->is & GLINT_RIM_FLAT;
                const int32_t a = is_flat ? p->x : p->y, b = is_flat ? q->x : q->y;
                at = cells_max(at, (cells_min(a, b) >> 4) - 1);
                end = cells_min(end, (cells_max(a, b) >> 4) + 2);
            }
            if (end - at > full - hidden) { /* there may be no room for all */
                outlines->hidden = (uint16_t)(hidden - outlines->of.depths);
                cells_show(strip);
                return false;
            }
            if (at < end) /* else its places lie anywhere */
                hidden = hide_rim(hidden, rim, strip->w, at, end);
            if (!(rim->is & GLINT_RIM_MORE))
                break;
        }
    }
    outlines->hidden = (uint16_t)(hidden - outlines->of.depths);
    return true;
}

/* A face of more cells than there is room for: a piece of a line after the other. Alone, for the stack, as hide is. */
static __attribute__((noinline)) void rows_of_many(const struct glint_paint *paint,
                                                   struct glint_mesh_triangle *triangle,
                                                   const struct glint_mesh_target *strip, bool is_colour)
{
    const unsigned face = glint_mesh_face_of(triangle);
    const int32_t end = cells_min(triangle->y_end, strip->end);
    struct glint_mesh_kept *const piece = &strip->drawn->outlines->piece;
    if (triangle->y < strip->y)
        glint_mesh_triangle_skip(triangle, strip->y);
    triangle->shine &= GLINT_MESH_LAID - 1; /* what is laid does not go on with it */
    for (; triangle->y < end; glint_mesh_triangle_skip(triangle, triangle->y + 1)) {
        struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        struct glint_mesh_window window = {0, triangle->y, 0, triangle->y + 1};
        int32_t line[2];
        if (!glint_mesh_columns(part.left, part.right, strip->w, &line[0], &line[1]))
            continue;
        for (window.left = line[0]; window.left < line[1]; window.left = window.right) {
            window.right = line[1];
            while (!hide(strip, face, &window)) /* a column has 12 at most */
                window.right = (window.left + window.right) >> 1;
            piece->triangle = *triangle;
            piece->face = (uint16_t)face;
            piece->triangle.y_end = (int16_t)window.bottom;
            part = glint_mesh_triangle_part(&piece->triangle, window.bottom);
            part.left->x = window.left * 65536;
            part.right->x = window.right * 65536;
            if (GLINT_CORTEX_M0PLUS_ASM && is_colour)
                glint_mesh_colour(&paint->of.tables.filled, &piece->triangle, strip);
            else
                glint_mesh_piece(paint, &piece->triangle, strip, &strip->drawn->outlines->row, line);
            cells_show(strip);
        }
    }
}

static bool hide_all(const struct glint_mesh_triangle *triangle, const struct glint_mesh_target *strip)
{
    return hide(strip, glint_mesh_face_of(triangle), NULL);
}

static void cells_rows(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                       const struct glint_mesh_target *strip)
{
    const unsigned edges = strip->drawn->edges[glint_mesh_face_of(triangle)];
    if (!(edges & GLINT_EDGES_ASK)) {
        glint_mesh_rows(paint, triangle, strip);
    } else if (!(edges & GLINT_EDGES_THIN)) {
        if (hide_all(triangle, strip)) {
            if (triangle->y >= strip->y && glint_mesh_is_colour(paint, strip))
                glint_mesh_colour(&paint->of.tables.filled, triangle, strip);
            else
                glint_mesh_rows(paint, triangle, strip);
            cells_show(strip);
        } else {
            rows_of_many(paint, triangle, strip, false);
        }
    }
}

#if GLINT_CORTEX_M0PLUS_ASM
/* What paints a face. */
static const struct glint_paint *cells_paint(const struct glint_mesh_drawn *drawn, unsigned face)
{
    unsigned part = 0;
    while (part + 1u < drawn->mesh->part_count && face >= drawn->mesh->ends[part])
        part++;
    return &drawn->paints[part];
}

bool glint_mesh_hide(struct glint_mesh_triangle *triangle, const struct glint_mesh_target *strip)
{
    if (hide_all(triangle, strip))
        return true;
    const struct glint_paint *const paint = cells_paint(strip->drawn, glint_mesh_face_of(triangle));
    if (glint_mesh_is_colour(paint, strip)) {
        rows_of_many(paint, triangle, strip, true);
    } else { /* the assembly's struct glint_mesh_pixels stays in the strip's samples; of a mesh that it draws nothing is clipped */
        union glint_mesh_list *const list = ((struct glint_mesh_bench *)strip->frame->memory)->polygon.list;
        struct glint_mesh_target apart = *strip;
        apart.samples = list[strip->samples == list[0].samples].samples;
        rows_of_many(paint, triangle, &apart, false);
    }
    return false;
}
#endif

static void cells_begin(struct glint_mesh_target *strip)
{
    strip->rows = cells_rows;
    glint_mesh_rims_take(strip);
}

#if GLINT_CORTEX_M0PLUS_ASM
static void cells_lines(const struct glint_mesh_target *strip, struct glint_mesh_lines *lines)
{
    (void)strip;
    *(void (**)(void))(void *)((uint8_t *)lines + GLINT_AT_STRIP_INNER) = lines->draw;
    lines->draw = glint_mesh_outlined;
}
#define CELLS_LINES cells_lines
#else
#define CELLS_LINES NULL
#endif

/* ---- What changes along an outline ---- */

static unsigned cells_up(const struct glint_mesh_rim *rim)
{
    return (unsigned)(rim->inverse >> 24);
}

static uint32_t cells_inverse(const struct glint_mesh_rim *rim)
{
    return rim->inverse & 0xffffff;
}

/* A number that changes by 2^26 d / length a cell, modulo 2^32; d of 16 bits and a sign, so that the product fits. */
static uint32_t cells_step(const struct glint_mesh_rim *rim, int32_t d)
{
    const int32_t product = d * (int32_t)cells_inverse(rim);
    const unsigned up = cells_up(rim);
    return up >= 26 ? (uint32_t)product << (up - 26) : (uint32_t)(product >> (26 - up));
}

/* And up to the first cell, offset / 16 of one. */
static uint32_t cells_first(uint32_t step, uint32_t offset)
{
    return (uint32_t)((int32_t)step >> 4) * offset;
}

/* |a - b|^2 / 2 of the normals at its ends, Q29. */
static uint32_t cells_side(const struct glint_mesh_drawn *drawn, const struct glint_mesh_rim *rim)
{
    const uint16_t *of = drawn->mesh->faces + 3 * (size_t)rim->face;
    struct glint_vec a, b;
    glint_mesh_normal(&a, drawn->mesh, of[rim->corner]);
    glint_mesh_normal(&b, drawn->mesh, of[glint_mesh_corner_after(rim->corner)]);
    return glint_mesh_side(&a, &b);
}

/* t(s) = t_a + s (t_b - t_a) - s (1 - s) |N_b - N_a|^2 / 2, s in Q30: at the first cell, and its steps; then at the nth. */
static __attribute__((noinline)) void cells_t(struct glint_mesh_cells *cells, const struct glint_mesh_vertex *a,
                                              const struct glint_mesh_vertex *b, uint32_t offset, uint32_t n,
                                              uint32_t beyond)
{
    struct glint_mesh_cell *const cell = &cells->cell;
    const unsigned up = cells_up(cells->rim);
    const uint32_t one = (uint32_t)1 << 30, side = cells_side(cells->strip->drawn, cells->rim);
    if (beyond > side)
        return;
    const uint32_t u = up > 27 ? one : cells_inverse(cells->rim) << (up - 13), s = (u >> 4) * offset;
    const int64_t d = 2 * (int64_t)side, rise = (int64_t)b->t_q30 - a->t_q30;
    const int64_t bend = (u * d) >> 30; /* u <= 2^30, d < 2^33 */
    cell->t = a->t_q30 + (uint32_t)((rise * s) >> 30) -
              (uint32_t)(((d >> 1) * (int64_t)(((uint64_t)s * (one - s)) >> 30)) >> 29);
    cell->dt = (uint32_t)((rise * u) >> 30) - (uint32_t)bend + (uint32_t)((bend >> 1) * (2 * (int64_t)s + u) >> 29);
    cell->ddt = (uint32_t)(((bend >> 1) * (int64_t)u) >> 28);
    cell->t += n * cell->dt + (n ? n * (n - 1) / 2 * cell->ddt : 0);
    cell->dt += n * cell->ddt;
}

/* The values at the rim's first cell in the strip and their steps. */
static void cells_set(struct glint_mesh_cells *cells)
{
    const struct glint_mesh_rim *const rim = cells->rim;
    struct glint_mesh_cell *const cell = &cells->cell;
    const struct glint_mesh_vertex *a = glint_mesh_corner_at(cells->strip->drawn, rim->face, rim->corner),
                                   *b = glint_mesh_corner_at(cells->strip->drawn, rim->face,
                                                             glint_mesh_corner_after(rim->corner));
    if (rim->is & GLINT_RIM_TURNED) {
        const struct glint_mesh_vertex *const other = a;
        a = b;
        b = other;
    }
    const int32_t low = rim->is & GLINT_RIM_FLAT ? a->x : a->y, first = glint_mesh_first(low);
    const uint32_t offset = (uint32_t)(16 * first + 8 - low); /* 0..15 */
    const uint32_t n = (uint32_t)(rim->at - first);
    cell->dz = cells_step(rim, ((int32_t)b->z - a->z) >> 1);
    cell->z = ((uint32_t)a->z << 16) + cells_first(cell->dz, offset) + n * cell->dz;
    cell->nl = UINT32_MAX;
    cell->t = GLINT_MESH_FAR_T;
    cell->dnl = cell->dt = cell->ddt = 0;
    if ((a->nl_q30 & b->nl_q30) < 0)
        return;
    cell->dnl = cells_step(rim, ((b->nl_q30 >> 2) - (a->nl_q30 >> 2)) >> 15);
    cell->nl = (uint32_t)a->nl_q30 + cells_first(cell->dnl, offset) + n * cell->dnl;
    const uint32_t least = a->t_q30 < b->t_q30 ? a->t_q30 : b->t_q30, t_end = cells->t_end,
                   beyond = least > t_end ? least - t_end : 0;
    if (!(beyond >> 29))
        cells_t(cells, a, b, offset, n, beyond);
}

/* ---- Cells that outlines blend ---- */

/* Its face's other outlines that have lines, or columns, where this one has cells in the strip. */
static void others_set(struct glint_mesh_cells *cells)
{
    static const struct glint_mesh_window all = {INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX};
    const struct glint_mesh_drawn *const drawn = cells->strip->drawn;
    const struct glint_mesh_rim *const rim = cells->rim;
    const unsigned face = rim->face, edges = drawn->edges[face] & GLINT_EDGES & ~(1u << rim->corner);
    cells->others = 0;
    for (unsigned k = 0; edges >> k; k++) {
        struct glint_mesh_rim *const other = &cells->other[cells->others];
        if (!(edges >> k & 1) || !glint_mesh_rim_set(other, drawn, face, k, &all))
            continue;
        int32_t low = rim->at, high = rim->end - 1;
        if ((other->is ^ rim->is) & GLINT_RIM_FLAT) {
            const int32_t top = rim->is & GLINT_RIM_FLAT ? cells->strip->y : 0, first = rim->e >> 16,
                          last = (rim->e + rim->step * (high - low)) >> 16;
            low = top + cells_min(first, last);
            high = top + cells_max(first, last);
        }
        if (other->at <= high && other->end > low)
            cells->others++;
    }
}

/* What these leave of a cell's part; 0 where one before this outline blends the cell. */
static unsigned others_share(const struct glint_mesh_cells *cells, int32_t x, int32_t y, unsigned part)
{
    for (unsigned i = 0; i < cells->others; i++) {
        const struct glint_mesh_rim *const other = &cells->other[i];
        const bool is_flat = other->is & GLINT_RIM_FLAT, grows = other->is & GLINT_RIM_GROWS;
        const int32_t along = is_flat ? x : y, across = is_flat ? y : x;
        if (along < other->at || along >= other->end)
            continue;
        const int32_t e = other->e + other->step * (along - other->at), cell = e >> 16;
        const unsigned of = cell == across ? glint_mesh_rim_part(other, e) : (cell < across) == grows ? 255 : 0;
        if (cell == across && other->corner < cells->rim->corner)
            return 0;
        part = part + of > 255 ? part + of - 255 : 0;
    }
    return part;
}

static inline void cells_next(struct glint_mesh_cells *cells)
{
    struct glint_mesh_cell *const cell = &cells->cell;
    cells->rim->at++;
    cells->rim->e += cells->rim->step;
    cell->z += cell->dz;
    cell->nl += cell->dnl;
    cell->t += cell->dt;
    cell->dt += cell->ddt;
}

/* Sets the place and the part of the next cell that is in front, and goes on; false: there is none. */
static bool cells_found(struct glint_mesh_cells *cells, struct glint_mesh_cell *found)
{
    const struct glint_mesh_target *const strip = cells->strip;
    const struct glint_mesh_rim *const rim = cells->rim;
    for (; rim->at < rim->end; cells_next(cells)) {
        const bool is_flat = rim->is & GLINT_RIM_FLAT;
        const int32_t across = rim->e >> 16, x = is_flat ? rim->at : across,
                      line = is_flat ? across : rim->at - strip->y;
        if (cells->cell.z >> 16 >= strip->depth[line * strip->w + x])
            continue;
        const unsigned part = others_share(cells, x, strip->y + line, glint_mesh_rim_part(rim, rim->e));
        if (part == 0)
            continue;
        *found = cells->cell;
        found->x = x;
        found->line = line;
        found->part = (uint8_t)part;
        cells_next(cells);
        return true;
    }
    return false;
}

static uint32_t colour_swap(uint32_t x)
{
    return (x << 8 | x >> 8) & 0xffff;
}

static inline void colour_blend(uint16_t *out, uint32_t p, uint32_t part, bool swapped)
{
    const uint32_t q = *out;
    *out = swapped ? (uint16_t)colour_swap(glint_over(colour_swap(p), colour_swap(q), part)) : glint_over(p, q, part);
}

#if !GLINT_CORTEX_M0PLUS_ASM
void glint_mesh_blend_matt(const struct glint_mesh_blend *blend)
{
    const uint8_t *const colours = blend->colours, *depth = (const uint8_t *)blend->depth;
    const uint8_t *const end = (const uint8_t *)blend->end;
    const uint32_t step = blend->step, dz = blend->dz, dnl = blend->dnl, dark = blend->dark, grows = blend->grows;
    const int32_t across = (int32_t)blend->across, along = (int32_t)blend->along;
    const uintptr_t off = blend->off;
    const bool is_swapped = blend->is_swapped;
    uint32_t e = blend->e, z = blend->z, nl = blend->nl;
    for (; depth != end; depth += along, e += step, z += dz, nl += dnl) {
        const uint8_t *const at = depth + ((int32_t)e >> 16) * across;
        if (z >> 16 >= *(const uint16_t *)(const void *)at)
            continue;
        const uint32_t part = (e >> 8 & 255) ^ grows;
        const uint32_t p = (int32_t)nl < 0 ? dark : *(const uint16_t *)(const void *)(colours + glint_look_row(nl));
        colour_blend((uint16_t *)(void *)((uintptr_t)at + off), p, part, is_swapped);
    }
}
#endif

/* By COLOUR tables, where nothing shines, no other outline of the face is near, and the lines lie side by side. */
static __attribute__((noinline)) bool cells_matt(const struct glint_mesh_cells *cells)
{
    const struct glint_mesh_target *const strip = cells->strip;
    const struct glint_mesh_rim *const rim = cells->rim;
    const uint32_t w = 2 * (uint32_t)strip->w;
    const bool is_flat = rim->is & GLINT_RIM_FLAT;
    if (cells->others || cells->cell.t != GLINT_MESH_FAR_T || strip->surface->stride != (ptrdiff_t)w)
        return false;
    const struct glint_look look = glint_look_up(&cells->paint->of.tables.filled);
    const struct glint_mesh_blend blend = {glint_is_swapped(&cells->paint->of.tables.filled),
                                           cells->cell.nl,
                                           is_flat ? w : 2,
                                           (uint32_t)rim->step,
                                           cells->cell.dz,
                                           cells->cell.dnl,
                                           is_flat ? 2 : w,
                                           rim->depth + (rim->end - rim->at) * (is_flat ? 1 : strip->w),
                                           (uintptr_t)strip->surface->pixels - (uintptr_t)strip->depth,
                                           look.colours,
                                           look.dark,
                                           rim->is & GLINT_RIM_GROWS ? 255u : 0u,
                                           cells->cell.z,
                                           rim->depth,
                                           (uint32_t)rim->e};
    glint_mesh_blend_matt(&blend);
    return true;
}

/* The same where they are not, or it shines: what cells_found finds, in one loop. */
static __attribute__((noinline)) void colour_cells(const struct glint_mesh_cells *cells)
{
    const struct glint_look look = glint_look_up(&cells->paint->of.tables.filled);
    const struct glint_mesh_target *const strip = cells->strip;
    const struct glint_mesh_rim *const rim = cells->rim;
    const bool swapped = glint_is_swapped(&cells->paint->of.tables.filled), is_flat = rim->is & GLINT_RIM_FLAT;
    uint32_t z = cells->cell.z, nl = cells->cell.nl, back = look.t_max - cells->cell.t, dt = cells->cell.dt;
    const ptrdiff_t stride = strip->surface->stride;
    const int32_t along = is_flat ? 1 : strip->w, across = is_flat ? 2 * strip->w : 2;
    const ptrdiff_t out_along = is_flat ? 2 : stride, out_across = is_flat ? stride : 2;
    const uint16_t *depth = rim->depth;
    uint8_t *out = (uint8_t *)strip->surface->pixels + out_along * (is_flat ? rim->at : rim->at - strip->y);
    int32_t e = rim->e;
    for (int32_t at = rim->at; at != rim->end; at++) {
        const int32_t cell = e >> 16;
        if (z >> 16 < *(const uint16_t *)(const void *)((const uint8_t *)depth + across * cell)) {
            unsigned part = glint_mesh_rim_part(rim, e);
            uint16_t pixel;
            if (cells->others)
                part = others_share(cells, is_flat ? at : cell, is_flat ? strip->y + cell : at, part);
            if (part) {
                glint_look_store(&look, back, nl, &pixel);
                colour_blend((uint16_t *)(void *)(out + out_across * cell), pixel, part, swapped);
            }
        }
        depth += along;
        out += out_along;
        e += rim->step;
        z += cells->cell.dz;
        nl += cells->cell.dnl;
        back -= dt;
        dt += cells->cell.ddt;
    }
}

static void cells_part(struct glint_mesh_cells *cells, unsigned part)
{
    const struct glint_mesh_drawn *const drawn = cells->strip->drawn;
    cells->part = (uint16_t)part;
    cells->paint = &drawn->paints[part];
    cells->t_end = glint_mesh_t_end(cells->paint);
    cells->is_colour = glint_mesh_is_colour(cells->paint, cells->strip);
    cells->end = part + 1 < drawn->mesh->part_count ? drawn->mesh->ends[part] : GLINT_MESH_NONE;
}

static __attribute__((noinline)) void cells_draw(struct glint_mesh_cells *cells, struct glint_mesh_rim *rim)
{
    const struct glint_mesh_target *const strip = cells->strip;
    while (rim->face >= cells->end)
        cells_part(cells, cells->part + 1u);
    cells->rim = rim;
    others_set(cells);
    cells_set(cells);
    if (cells->is_colour) {
        if (!cells_matt(cells))
            colour_cells(cells);
        return;
    }
    struct glint_mesh_bench *bench = (struct glint_mesh_bench *)strip->frame->memory;
    bench->face.face = rim->face;
    if (strip->drawn->edges[rim->face] & GLINT_EDGES_CLIPPED)
        (void)glint_mesh_fan_shows(strip->frame, strip->drawn, rim->face);
    glint_mesh_blend_cells(cells->paint, cells, cells_found, &cells->blending, &bench->face.triangle, strip);
}

static void cells_end(const struct glint_mesh_target *strip)
{
    struct glint_mesh_outlines *const outlines = strip->drawn->outlines;
    struct glint_mesh_cells *const cells = &outlines->of.cells;
    cells->strip = strip;
    cells_part(cells, 0);
    for (unsigned i = 0; i < outlines->count; i++)
        cells_draw(cells, &outlines->rims[i]);
    for (uint16_t face = outlines->rest; face != GLINT_MESH_NONE; face = strip->drawn->rims[face])
        for (struct glint_mesh_rim *rim = glint_mesh_rims_of(strip, face); rim; rim = glint_mesh_rim_after(rim))
            cells_draw(cells, rim);
    glint_mesh_rims_give(strip);
}

const struct glint_use_outlines glint_outlines GLINT_FLASH = {glint_mesh_edges_add, glint_mesh_edges_sort, cells_begin,
                                                              cells_end, CELLS_LINES};
