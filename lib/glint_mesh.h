/* SPDX-License-Identifier: MIT
 * Part of glint.h: meshes, with a highlight at every pixel.
 *
 * Over a triangle whose normals are interpolated linearly t = |N - H|^2 / 2 is a quadratic in x and y, which takes two additions
 * a pixel. Its normals stay unnormalised: for |N| = 1 - d that costs t only d^2 / 2. A picture is drawn in strips of any
 * height and order, each straight to a panel's or toolkit's buffer; pixels do not depend on how it is cut.
 *
 * Places are on the screen in 1/16 pixel from the viewport's middle: x right, y down, z to the viewer. Directions have y up.
 */
#ifndef GLINT_MESH_H
#define GLINT_MESH_H

#include "glint.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Yours, const: it may lie in flash. */
struct glint_mesh {
    const int16_t *places;  /* x, y, z of each vertex, y up */
    const int16_t *normals; /* x, y, z of each vertex in Q1.15, of about unit length; NULL where normals8 are given */
    const int8_t *normals8; /* the same in Q0.7: 127 counts as 1.0 */
    const uint16_t *faces;  /* three vertices of each triangle, counterclockwise as seen from outside */
    /* Parts of different material: the face that each ends before, ascending, the last face_count; NULL: one part. */
    const uint16_t *ends;
    uint16_t vertex_count;
    uint16_t face_count;
    uint8_t part_count; /* of ends */
};
/* GLINT_ERR_ARG: NULL, no vertex, an index beyond them, more than GLINT_MESH_FACES_MAX faces, -128 as a normal's, parts that do
 * not ascend to the last face. The other functions do not look at indices: check a mesh once. */
enum glint_err glint_mesh_check(const struct glint_mesh *mesh);

/* Where a mesh stands. */
struct glint_pose {
    int16_t turn[4];     /* the quaternion w, x, y, z of the rotation, of any length but 0 */
    int16_t position[3]; /* of the mesh's origin, 1/16 pixel */
    uint16_t scale;      /* 32768 of the mesh's units in 1/16 pixel */
};

/* How pixels of a part are made: glint_mesh_exact with a struct glint_prepared, glint_mesh_tables with a struct glint_tables of kind
 * COLOUR or SMALL. The light is glint_mesh_add's; Phong is refused. */
struct glint_mesh_path;
extern const struct glint_mesh_path glint_mesh_exact, glint_mesh_tables;
struct glint_paint {
    const struct glint_mesh_path *path;
    const void *with;
};

/* The same over colours of the mesh in the place of the material's albedo, with a struct glint_mesh_albedo: glint_mesh_exact_albedo with
 * a struct glint_prepared, glint_mesh_tables_albedo with a struct glint_tables of kind ALBEDO. COLOUR and SMALL tables hold one albedo
 * and are refused: meshes of a few colours take a part and tables for each. */
extern const struct glint_mesh_path glint_mesh_exact_albedo, glint_mesh_tables_albedo;
/* One of the arrays is NULL. Yours, const: they may lie in flash. */
struct glint_mesh_albedo {
    const void *with;
    const uint8_t *of_vertices; /* red, green, blue of each; between vertices linear on the screen, as normals are */
    const uint8_t *of_faces;    /* red, green, blue of each */
};

/* The same under up to four lamps, as glint_shade_lights takes them, in the place of glint_mesh_add's light, with a struct
 * glint_mesh_lights: every model, also Phong, format and space. Places of lamps are as those of meshes: from the viewport's middle, and
 * under perspective before it. A pixel costs what glint_shade_lights takes, and more. */
extern const struct glint_mesh_path glint_mesh_lit;
struct glint_mesh_lights {
    void *memory;
    const uint8_t *of_vertices, *of_faces; /* yours to set: as above; both NULL: the material's albedo */
};
/* Memory: glint_mesh_lights_bytes, aligned as a pointer, yours until the picture is drawn. The lamps are copied. GLINT_ERR_ARG: NULL, too
 * few bytes, misaligned; else errors as glint_shade_lights. */
size_t glint_mesh_lights_bytes(void);
enum glint_err glint_mesh_lights_init(struct glint_mesh_lights *lights, const struct glint_shader *shader,
                                      const struct glint_lamp *lamps, unsigned count, void *memory, size_t bytes);

#define GLINT_MESH_SIZE_MAX 2040u /* pixels, of a viewport's width and height */
#define GLINT_MESH_FACES_MAX 65534u
#define GLINT_MESH_BAND 16u /* lines: strips of whole bands cost least */

/* A mesh in a picture, and a picture. State, ours; the memory stays yours. */
struct glint_mesh_vertex {
    int16_t x, y; /* 1/16 pixel from the viewport's corner */
    uint16_t z, out;
    uint32_t t_q30;
    int32_t nl_q30;
};
struct glint_mesh_drawn {
    struct glint_mesh_drawn *next;
    const struct glint_mesh *mesh;
    const struct glint_paint *paints;
    struct glint_mesh_vertex *vertices;
    uint16_t *links, *bands; /* of each face the next in its list; of each band the first face */
    uint16_t kept;           /* the first triangle that goes on */
    struct glint_vec l, h;   /* in the mesh's directions */
    int16_t turn[3][3];      /* Q14 */
    int16_t position[3];
    uint16_t scale;
    bool is_cut; /* by a plane: a vertex is beyond it */
};
struct glint_mesh_frame {
    struct glint_mesh_drawn *first, **last;
    void *memory, *kept;
    uint16_t w, h, lines, distance, y, free;
};

/* Begins a picture of w x h pixels in strips of at most `lines` lines. distance: of the camera from z = 0, 1/16 pixel; 0: parallel
 * projection. Memory: glint_mesh_frame_bytes, aligned to 4. With GLINT_MESH_KEPT_BYTES more for each triangle that goes on from one strip
 * to the next these are set up once: with room for 18 the teapot takes 8 % more cycles than for 50. GLINT_ERR_ARG: NULL, a size of 0
 * or beyond GLINT_MESH_SIZE_MAX, too few bytes, misaligned. */
#define GLINT_MESH_KEPT_BYTES 88u
size_t glint_mesh_frame_bytes(uint16_t w, uint16_t lines);
enum glint_err glint_mesh_begin(struct glint_mesh_frame *frame, uint16_t w, uint16_t h, uint16_t lines,
                                uint16_t distance, void *memory, size_t bytes);

/* Adds a mesh, lit by a directional light, with a paint for each part. Memory: glint_mesh_bytes, aligned to 4, until the picture is
 * drawn. Under perspective the half vector stays that of the distant viewer. GLINT_ERR_ARG: NULL, too few bytes, misaligned.
 * GLINT_ERR_VECTOR: a quaternion of 0. */
size_t glint_mesh_bytes(const struct glint_mesh *mesh, uint16_t h);
enum glint_err glint_mesh_add(struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn,
                              const struct glint_mesh *mesh, const struct glint_pose *pose,
                              const struct glint_light *light, const struct glint_paint *paints, void *memory,
                              size_t bytes);

/* Draws lines y..y + h - 1, where the nearer hides the farther; pixels without a surface are left as they are. *surface: where the
 * strip's first pixel goes. Where y is not the line after the last strip's, faces are sorted again. GLINT_ERR_ARG: NULL, lines
 * beyond the picture or more than glint_mesh_begin was told, a paint whose path cannot draw there. */
enum glint_err glint_mesh_strip(struct glint_mesh_frame *frame, uint16_t y, uint16_t h,
                                const struct glint_surface *surface);

#ifdef __cplusplus
}
#endif
#endif
