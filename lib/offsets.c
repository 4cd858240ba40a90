/* SPDX-License-Identifier: MIT
 * What the assembly takes for granted (glint_offsets.h): arrays of -1 where it is not so. */
#include "glint_offsets.h"
#include "glint_port.h"
#include "glint_tables.h"
#include "glint_mesh_rows.h"
#include "glint_mesh_strip.h"

typedef char glint_tables_geometry[(int64_t)GLINT_COLOUR_ROWS << GLINT_COLOUR_ROW_SHIFT == (int64_t)1 << 31 &&
                                           1 << GLINT_COLOUR_ROW_BYTES_LOG == 2 * GLINT_COLOUR_STEPS &&
                                           1 << GLINT_SPAN_RUN_LOG == GLINT_SPAN_RUN && GLINT_SPAN_RUN <= 32 &&
                                           GLINT_DITHER_PIXELS_PART == GLINT_DITHER_ROWS << GLINT_DITHER_PIXELS_LOG &&
                                           GLINT_DITHER_SUMS_PART == (GLINT_DITHER_ROWS - 1) << GLINT_DITHER_SUMS_LOG &&
                                           GLINT_DITHER_SUMS == 4 * GLINT_DITHER_PIXELS_PART &&
                                           GLINT_DITHER_SHINES == GLINT_DITHER_SUMS + 4 * GLINT_DITHER_SUMS_PART
                                       ? 1
                                       : -1];

#if GLINT_CORTEX_M0PLUS_ASM
#define AT(type, field, offset) (offsetof(struct type, field) == (offset))
typedef char glint_tables_layout
    [AT(glint_tables, columns, GLINT_AT_TABLES_COLUMNS) && AT(glint_tables, colour, GLINT_AT_TABLES_COLOUR) &&
             AT(glint_tables, t_max_q30, GLINT_AT_TABLES_T_MAX) && AT(glint_tables, dark, GLINT_AT_TABLES_DARK) &&
             AT(glint_tables, shift, GLINT_AT_TABLES_SHIFT) && GLINT_AT_TABLES_COLOUR == GLINT_AT_TABLES_COLUMNS + 4
         ? 1
         : -1];
typedef char glint_paint_layout
    [AT(glint_paint, of.tables.filled, 0) && AT(glint_paint, of.tables.x, GLINT_AT_PAINT_X) &&
             AT(glint_paint, of.tables.y, GLINT_AT_PAINT_X + 4) && AT(glint_paint, of.tables.z, GLINT_AT_PAINT_X + 8) &&
             AT(glint_paint, of.tables.cut, GLINT_AT_PAINT_CUT) && AT(glint_paint, of.tables.r, GLINT_AT_PAINT_R) &&
             AT(glint_paint, of.tables.a, GLINT_AT_PAINT_A) && AT(glint_paint, output.format, GLINT_AT_PAINT_FORMAT)
         ? 1
         : -1];
typedef char glint_exact_layout
    [offsetof(struct glint_paint, of.exact.q) - offsetof(struct glint_paint, of.exact.p) == GLINT_AT_EXACT_Q &&
             offsetof(struct glint_paint, of.exact.r) - offsetof(struct glint_paint, of.exact.p) == GLINT_AT_EXACT_R &&
             AT(glint_sample, nl_q16, GLINT_AT_SAMPLE_NL) && AT(glint_sample, f_q16, GLINT_AT_SAMPLE_NL + 4) &&
             sizeof(struct glint_sample) == GLINT_SAMPLE_SIZE
         ? 1
         : -1];
typedef char glint_span_layout[AT(glint_span, t_q30, 0) && AT(glint_span, dt_q30, 4) && AT(glint_span, ddt_q30, 8) &&
                                       AT(glint_span, nl_q30, 12) && AT(glint_span, dnl_q30, 16) &&
                                       AT(glint_span, w, GLINT_AT_SPAN_W) && AT(glint_surface, pixels, 0) &&
                                       GLINT_NEGATIVE_T == UINT32_C(0) - (UINT32_C(1) << GLINT_NEGATIVE_T_LOG)
                                   ? 1
                                   : -1];
#undef AT
#endif

/* What the assembly takes for granted of a mesh and its triangles: arrays of -1 where it is not so. */

typedef char glint_shine_order[GLINT_MESH_DARK == GLINT_SHINE_DARK && GLINT_MESH_MATT == GLINT_SHINE_MATT ? 1 : -1];

#if GLINT_CORTEX_M0PLUS_ASM
#define AT(field, offset) (offsetof(struct glint_mesh_triangle, field) == (offset))
typedef char glint_triangle_layout
    [AT(values.x, GLINT_AT_TRIANGLE_X) && AT(values.z, GLINT_AT_TRIANGLE_Z) && AT(values.zx, GLINT_AT_TRIANGLE_ZX) &&
             AT(values.zy, GLINT_AT_TRIANGLE_ZY) && AT(values.nl, GLINT_AT_TRIANGLE_NL) &&
             AT(values.nlx, GLINT_AT_TRIANGLE_NLX) && AT(values.nly, GLINT_AT_TRIANGLE_NLY) &&
             AT(values.t, GLINT_AT_TRIANGLE_T) && AT(values.tx, GLINT_AT_TRIANGLE_TX) &&
             AT(values.txx, GLINT_AT_TRIANGLE_TXX) && AT(values.txy, GLINT_AT_TRIANGLE_TXY) &&
             AT(values.ty, GLINT_AT_TRIANGLE_TY) && AT(values.tyy, GLINT_AT_TRIANGLE_TYY) &&
             AT(long_edge, GLINT_AT_TRIANGLE_LONG) && AT(upper, GLINT_AT_TRIANGLE_LONG + 8) &&
             AT(lower, GLINT_AT_TRIANGLE_LONG + 16) && AT(y, GLINT_AT_TRIANGLE_Y) &&
             AT(y_middle, GLINT_AT_TRIANGLE_Y_MIDDLE) && AT(y_end, GLINT_AT_TRIANGLE_Y_END) &&
             AT(shine, GLINT_AT_TRIANGLE_SHINE) && AT(long_is_left, GLINT_AT_TRIANGLE_LONG_IS_LEFT) &&
             offsetof(struct glint_mesh_edge, x) == 0 && offsetof(struct glint_mesh_edge, step) == 4 &&
             offsetof(struct glint_mesh_corner, v) == 0 && offsetof(struct glint_mesh_corner, side) == 4 &&
             sizeof(struct glint_mesh_corner) == 8
         ? 1
         : -1];
#undef AT
#define AT(field, offset) (offsetof(struct glint_mesh_target, field) == (offset))
typedef char glint_target_layout[AT(surface, 0) && AT(depth, 4) && AT(w, 8) && AT(y, GLINT_AT_TARGET_Y) &&
                                         AT(end, GLINT_AT_TARGET_Y + 4) && AT(frame, GLINT_AT_TARGET_FRAME) &&
                                         AT(drawn, GLINT_AT_TARGET_FRAME + 4) &&
                                         offsetof(struct glint_surface, pixels) == 0 &&
                                         offsetof(struct glint_surface, stride) == 4
                                     ? 1
                                     : -1];
#undef AT
#define AT(field, offset) (offsetof(struct glint_mesh_drawn, field) == (offset))
typedef char glint_drawn_layout[AT(mesh, GLINT_AT_DRAWN_MESH) && AT(paints, GLINT_AT_DRAWN_MESH + 4) &&
                                        AT(vertices, GLINT_AT_DRAWN_VERTICES) && AT(links, GLINT_AT_DRAWN_LINKS) &&
                                        AT(bands, GLINT_AT_DRAWN_LINKS + 4) &&
                                        1u << GLINT_MESH_BAND_LOG == GLINT_MESH_BAND && AT(l, GLINT_AT_DRAWN_LIGHT) &&
                                        AT(h, GLINT_AT_DRAWN_LIGHT + 6) && AT(turn, GLINT_AT_DRAWN_LIGHT + 12) &&
                                        AT(position, GLINT_AT_DRAWN_LIGHT + 30) && AT(scale, GLINT_AT_DRAWN_SCALE) &&
                                        AT(is_cut, GLINT_AT_DRAWN_IS_CUT) && AT(edges, GLINT_AT_DRAWN_EDGES) &&
                                        AT(kept, GLINT_AT_DRAWN_KEPT)
                                    ? 1
                                    : -1];
#undef AT
#define AT(field, offset) (offsetof(struct glint_mesh_frame, field) == (offset))
typedef char glint_frame_layout[AT(memory, GLINT_AT_FRAME_KEPT - 4) && AT(kept, GLINT_AT_FRAME_KEPT) &&
                                        AT(w, GLINT_AT_FRAME_W) && AT(h, GLINT_AT_FRAME_W + 2) &&
                                        AT(free, GLINT_AT_FRAME_FREE) && AT(kept_bytes, GLINT_AT_FRAME_KEPT_BYTES)
                                    ? 1
                                    : -1];
#undef AT
#define AT(field, offset) (offsetof(struct glint_mesh_kept, field) == (offset))
typedef char glint_kept_layout[AT(triangle, 0) && AT(face, GLINT_AT_KEPT_FACE) && AT(next, GLINT_AT_KEPT_FACE + 2) &&
                                       sizeof(struct glint_mesh_kept) == GLINT_MESH_KEPT_SIZE &&
                                       offsetof(struct glint_mesh_bench, face) == GLINT_AT_BENCH_FACE
                                   ? 1
                                   : -1];
#undef AT
#define AT(field, offset) (offsetof(struct glint_mesh_lines, field) == (offset))
typedef char
    glint_lines_layout[AT(draw, GLINT_AT_LINES_DRAW) && AT(off_first, GLINT_AT_LINES_DRAW + 4) &&
                               AT(line_first, GLINT_AT_LINES_DRAW + 8) && AT(off, GLINT_AT_LINES_DRAW + 12) &&
                               AT(line, GLINT_AT_LINES_DRAW + 16) && AT(line_step, GLINT_AT_LINES_DRAW + 20) &&
                               AT(off_step, GLINT_AT_LINES_DRAW + 24) && AT(last, GLINT_AT_LINES_DRAW + 28) &&
                               AT(colours, GLINT_AT_LINES_COLOURS) && AT(dark, GLINT_AT_LINES_COLOURS + 4) &&
                               AT(shift, GLINT_AT_LINES_COLOURS + 8) && AT(limit, GLINT_AT_LINES_COLOURS + 12) &&
                               AT(w, GLINT_AT_LINES_COLOURS + 16) && AT(end, GLINT_AT_LINES_COLOURS + 20) &&
                               AT(columns, GLINT_AT_LINES_COLOURS + 24) && AT(t_max, GLINT_AT_LINES_COLOURS + 28) &&
                               sizeof(struct glint_mesh_lines) == GLINT_MESH_LINES_BYTES
                           ? 1
                           : -1];
#undef AT
#define AT(field, offset) (offsetof(struct glint_mesh, field) == (offset))
typedef char glint_mesh_layout
    [AT(places, GLINT_AT_MESH_PLACES) && AT(normals, GLINT_AT_MESH_NORMALS) && AT(normals8, GLINT_AT_MESH_NORMALS8) &&
             AT(faces, GLINT_AT_MESH_FACES) && AT(ends, GLINT_AT_MESH_FACES + 4) &&
             AT(face_count, GLINT_AT_MESH_VERTEX_COUNT + 2) && AT(part_count, GLINT_AT_MESH_VERTEX_COUNT + 4) &&
             AT(vertex_count, GLINT_AT_MESH_VERTEX_COUNT) && AT(of_vertices, GLINT_AT_MESH_OF_VERTICES) &&
             AT(uv, GLINT_AT_MESH_UV) && AT(uv_bits, GLINT_AT_MESH_UV_BITS) &&
             offsetof(struct glint_texture, levels) == GLINT_AT_TEXTURE_LEVELS &&
             offsetof(struct glint_texture, w) == GLINT_AT_TEXTURE_W
         ? 1
         : -1];
#undef AT
#define AT(field, offset) (offsetof(struct glint_mesh_vertex, field) == (offset))
typedef char glint_vertex_layout[AT(x, 0) && AT(y, 2) && AT(z, 4) && AT(out, 6) && AT(t_q30, 8) && AT(nl_q30, 12) &&
                                         sizeof(struct glint_mesh_vertex) == 16
                                     ? 1
                                     : -1];
#undef AT
#define AT(field, offset) (offsetof(struct glint_mesh_pixels, field) == (offset))
typedef char glint_pixels_layout
    [AT(z, 0) && AT(nl, 4) && AT(now, 8) && AT(back, 20) && AT(dt, 24) && AT(dz, GLINT_AT_PIXELS_DZ) &&
             AT(dnl, GLINT_AT_PIXELS_DZ + 4) && AT(step, GLINT_AT_PIXELS_DZ + 8) && AT(ddt, GLINT_AT_PIXELS_DDT) &&
             AT(depth, GLINT_AT_PIXELS_DDT + 4) && AT(end, GLINT_AT_PIXELS_DDT + 8) &&
             AT(off, GLINT_AT_PIXELS_DDT + 12) && AT(levels, GLINT_AT_PIXELS_DDT + 16) &&
             AT(sums, GLINT_AT_PIXELS_DDT + 20) && AT(t_max, GLINT_AT_PIXELS_DDT + 24) &&
             AT(limit, GLINT_AT_PIXELS_DDT + 28) && AT(shift, GLINT_AT_PIXELS_DDT + 32) &&
             AT(dark, GLINT_AT_PIXELS_DDT + 36) && AT(picture, GLINT_AT_PIXELS_DDT + 40) &&
             offsetof(struct glint_mesh_picture, pixels) == 0 && offsetof(struct glint_mesh_picture, palette) == 4 &&
             offsetof(struct glint_mesh_picture, w) == 8 && offsetof(struct glint_mesh_picture, h) == 12 &&
             AT(loop, GLINT_AT_PIXELS_DDT + 56) && 1 << GLINT_MESH_LAID_LOG == GLINT_MESH_LAID &&
             GLINT_MESH_COLOURS == 0 && GLINT_MESH_NEAREST == 1 && GLINT_MESH_SQUARE == 2 && GLINT_MESH_PALETTE == 3 &&
             GLINT_MESH_SMOOTH == 4 && sizeof(struct glint_mesh_laid) == 40 && AT(now, GLINT_AT_PIXELS_NOW) &&
             offsetof(struct glint_mesh_laid, more) == 36 && GLINT_MESH_LAID_DOWN == 2 && GLINT_MESH_LAID_RIGHT == 4 &&
             GLINT_MESH_LAID_BLUE == 6 &&
             offsetof(struct glint_mesh_bench, copied) ==
                 offsetof(struct glint_mesh_bench, copy) + sizeof(struct glint_mesh_kept) &&
             offsetof(struct glint_mesh_bench, laid) ==
                 offsetof(struct glint_mesh_bench, face) + sizeof(struct glint_mesh_kept)
         ? 1
         : -1];
#undef AT
#endif
