/* SPDX-License-Identifier: MIT
 * Meshes, with a highlight at every pixel. Includes glint.h.
 *
 * Over a triangle whose normals are interpolated linearly t = |N - H|^2 / 2 is a quadratic in x and y, which takes two additions
 * a pixel. Its normals stay unnormalised: for |N| = 1 - d that costs t only d^2 / 2. A picture is drawn in strips of any
 * height and order, each straight to a panel's or toolkit's buffer; pixels do not depend on how it is cut.
 *
 * A mesh's place is in 1/16 pixel from the picture's middle: x right, y down, z to the viewer. Places of lights count from the screen's upper
 * left corner, as for rectangles. Directions have y up.
 */
#ifndef GLINT_MESH_H
#define GLINT_MESH_H

#include "glint.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A picture that faces wear. Yours, const: it may lie in flash. It repeats in both directions. */
struct glint_texture {
    const void
        *pixels; /* line after line, v = 0 first: RGB565, machine's order, aligned to 2; or bytes, indices of palette */
    const uint16_t *palette; /* RGB565 of each index; NULL: pixels are RGB565 */
    uint16_t w, h;           /* 1..2048, any */
    /* Pictures that follow one another in memory, each of half the width and height before (rounded down, at least 1): 1..12. A triangle
     * takes the first of less than two texels a pixel. */
    uint8_t levels;
    bool is_smooth; /* bilinear; else the nearest pixel */
};

struct glint_use_mesh; /* const */
extern const struct glint_use_mesh glint_use_mesh_albedo;
struct glint_use_axis; /* const */
extern const struct glint_use_axis glint_use_mesh_grain;

/* Yours, const: it may lie in flash. */
struct glint_mesh {
    const int16_t *places;  /* x, y, z of each vertex, y up */
    const int16_t *normals; /* x, y, z of each vertex in Q1.15, of about unit length; NULL where normals8 are given */
    const int8_t *normals8; /* the same in Q0.7: 127 counts as 1.0 */
    const uint16_t *faces;  /* three vertices of each triangle, counterclockwise as seen from outside */
    /* Parts of different materials: for each the number of the face after its last one, ascending to face_count. NULL: one part. */
    const uint16_t *ends;
    uint16_t vertex_count;
    uint16_t face_count;
    uint8_t part_count; /* of ends */
    /* Colours in place of the material's albedo: one of these arrays, or both NULL. Exact paints and ALBEDO tables take them. COLOUR tables
     * hold one albedo: give a mesh of a few colours a part, and tables, for each. */
    const uint8_t *of_vertices; /* red, green, blue of each; linear on the screen between them, as normals are */
    const uint8_t *of_faces;    /* red, green, blue of each */
    /* Textures in place of the material's albedo: one for each part (a part without has pixels NULL), and u, v of each vertex. NULL: none. Exact
     * paints and ALBEDO tables take them; a mesh has textures or colours, not both. In perspective u and v are right at every eighth pixel of
     * a line and linear between: off by at most d (sqrt(q) - 1) / (sqrt(q) + 1), where they change by d and nearness by q between two of these. */
    const struct glint_texture *textures;
    const uint16_t *uv; /* 1.0, a texture's width or height, is 2^uv_bits; v down */
    uint8_t uv_bits;    /* 8..15 */
    /* &glint_use_mesh_albedo where there are textures, and for colours by ALBEDO tables, so that other programs do not link it; else NULL. */
    const struct glint_use_mesh *use;
    /* Of each face the three beyond its edges (corners 0 to 1, 1 to 2, 2 to 0), for smooth outlines; GLINT_MESH_RIM: none there,
     * GLINT_MESH_SEAM: none, but no outline either. NULL: outlines are stepped. */
    const uint16_t *neighbours;
    /* For paints with n_across: the grain runs along this axis, x, y, z in Q1.15 of about unit length, as it lies in the surface. */
    int16_t grain[3];
    const struct glint_use_axis
        *use_grain; /* &glint_use_mesh_grain, so that other programs do not link it; NULL: no grain */
};
#define GLINT_MESH_RIM 65535u
#define GLINT_MESH_SEAM 65534u
/* GLINT_ERR_ARG: NULL, misaligned, no vertex, an index beyond them, more than GLINT_MESH_FACES_MAX faces, a normal of -128 in normals8,
 * parts that do not ascend to the last face, colours of both vertices and faces, neighbours beyond the faces; textures beside colours,
 * without uv or use, of other sizes, levels or uv_bits than above. The other functions do not look at indices or textures: check a mesh
 * once. */
enum glint_err glint_mesh_check(const struct glint_mesh *mesh);

/* Where a mesh stands. */
struct glint_pose {
    int16_t turn[4];     /* the quaternion w, x, y, z of the rotation, of any length but 0 */
    int16_t position[3]; /* of the mesh's origin, 1/16 pixel */
    uint16_t scale;      /* how many 1/16 pixels 32768 of the mesh's units are */
};

#define GLINT_MESH_SIZE_MAX 2040u /* pixels, of a picture's width and height */
#define GLINT_MESH_FACES_MAX 65534u
#define GLINT_MESH_BAND 16u /* lines: strips of whole bands cost least */

/* A mesh in a picture, and a picture. State, ours; the memory stays yours. */
struct glint_mesh_vertex {
    int16_t x, y; /* 1/16 pixel from the picture's corner */
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
    bool is_cut;                          /* by a plane: a vertex is beyond it */
    struct glint_mesh_outlines *outlines; /* of the strip at hand */
    uint16_t *rims, *rim_bands;           /* as links and bands, of faces with outlines */
    uint8_t *edges;                       /* of each face what outlines ask; NULL: there are none */
    int16_t left, top, right, bottom;     /* pixels beyond which it draws none */
};
struct glint_mesh_frame {
    struct glint_mesh_drawn *first, **last;
    void *memory, *kept;
    uint16_t w, h, lines, distance, y, free;
    uint16_t places, kept_bytes;               /* in kept, of GLINT_MESH_KEPT_BYTES; what a triangle takes of them */
    void *lit;                                 /* the work memory of lights; NULL: none yet */
    const struct glint_use_outlines *outlines; /* yours to set after glint_mesh_begin: &glint_outlines, or NULL */
    struct glint_box
        box; /* after glint_mesh_strip: all it drew lies in it, in pixels of the picture; w = 0: nothing. The boxes of the
                             strip's meshes, where these have a face in it */
};

/* Smooth outlines, of meshes that have neighbours and are added after outlines is set: where a face that shows its front meets one that does not,
 * the pixels that their edge cuts are blended over what the buffer holds, by any paint; a mesh in front over those behind. glint_mesh_bytes
 * counts what they take, 3 bytes a face and some 1,900, wherever there are neighbours. Stepped stay: edges that the near plane or the
 * guard band cuts (not those beside them), creases, and where parts go through each other. Without outlines no program links them. */
struct glint_use_outlines; /* const */
extern const struct glint_use_outlines glint_outlines;

/* Begins a picture of w x h pixels in strips of at most `lines` lines. distance: of the camera from z = 0, 1/16 pixel; 0: parallel
 * projection, where what lies more than 2047 pixels before or behind z = 0 counts as at 2047: of two such surfaces the one drawn first is seen.
 * Memory: glint_mesh_frame_bytes, aligned to 4 (to a pointer with GLINT_MESH_LIGHTS_BYTES), until the picture is drawn.
 * GLINT_MESH_KEPT_BYTES more for each triangle that goes on from one strip to the next spare setting it up again: with room for 18 the
 * teapot takes 8 % more cycles than with room for 50. GLINT_MESH_LIGHTS_BYTES more let points, spots and several lights light meshes, and
 * meshes have Phong's model and grain. GLINT_ERR_ARG: NULL, a size of 0 or beyond GLINT_MESH_SIZE_MAX, too few bytes, misaligned. */
#define GLINT_MESH_KEPT_BYTES 88u
#define GLINT_MESH_LIGHTS_BYTES 968u /* 11 GLINT_MESH_KEPT_BYTES */
size_t glint_mesh_frame_bytes(uint16_t w, uint16_t lines);
enum glint_err glint_mesh_begin(struct glint_mesh_frame *frame, uint16_t w, uint16_t h, uint16_t lines,
                                uint16_t distance, void *memory, size_t bytes);

/* Adds a mesh with a paint for each part, all lit by the same lights; a picture's paints have one format. Memory: glint_mesh_bytes, aligned to
 * 4, until the picture is drawn, like the paints. Under one directional light t is the quadratic above. Under points, spots and several
 * lights, for Phong and with n_across, normals are interpolated instead, and a pixel's place is that of the surface before projection. The
 * viewer is distant, also under perspective.
 * GLINT_ERR_ARG: NULL, too few bytes, misaligned, a mesh without vertices, a frame of zeros, *drawn in its picture already, a paint of zeros or never lit, paints of
 * different lights, or of another format than the picture's meshes before; no room for lights; n_across without use_grain, or not under
 * one directional light; COLOUR tables with colours of the mesh or a texture; ALBEDO tables with neither; a texture, or colours by ALBEDO
 * tables, without use. GLINT_ERR_VECTOR: a quaternion of 0. */
size_t glint_mesh_bytes(const struct glint_mesh *mesh, uint16_t h);
enum glint_err glint_mesh_add(struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn,
                              const struct glint_mesh *mesh, const struct glint_pose *pose,
                              const struct glint_paint *paints, void *memory, size_t bytes);

/* Draws lines y..y + h - 1, where the nearer hides the farther; pixels without a surface are left as they are. *target: where the
 * strip's first pixel goes, in memory and on the screen. Strips in order cost least: elsewhere faces are sorted again. GLINT_ERR_ARG: NULL,
 * lines beyond the picture or more than glint_mesh_begin was told, a stride smaller than the picture's line. */
enum glint_err glint_mesh_strip(struct glint_mesh_frame *frame, uint16_t y, uint16_t h,
                                const struct glint_surface *target);

#ifdef __cplusplus
}
#endif
#endif
