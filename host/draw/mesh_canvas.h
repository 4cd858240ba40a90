/* SPDX-License-Identifier: MIT
 * Meshes drawn by the library. */
#ifndef GLINT_DRAW_MESH_CANVAS_H
#define GLINT_DRAW_MESH_CANVAS_H

#include "draw/shading.h"
#include "draw/view.h"
#include "mesh/fit.h"

/* The shading of each part: as it is given, but for what the mesh's materials say and the user does not: their colour, shininess, and light
 * from everywhere, diffuse and mirrored. */
struct mesh_own {
    bool color, n, look;
};
struct shading *mesh_shadings(const struct mesh *mesh, const struct shading *shading, struct mesh_own own);

/* A mesh made ready for its parts' shadings, to be drawn again and again as it turns or the light moves. */
struct mesh_canvas;
struct mesh_canvas *mesh_canvas_new(const struct fitted *fitted, const struct shading *shadings);
void mesh_canvas_free(struct mesh_canvas *canvas);
/* What is behind the mesh from now on, pixels of the format as backdrop_pixels makes them, which stay the caller's; NULL: black. */
void mesh_canvas_set_backdrop(struct mesh_canvas *canvas, const uint8_t *pixels);
/* The whole picture, the backdrop behind the mesh, lines packed. `light`: the shading whose light counts; NULL: as it was. */
void mesh_canvas_draw(struct mesh_canvas *canvas, const struct view *view, const struct shading *light,
                      uint8_t *pixels);

/* The same with stepped outlines: what is compared pixel by pixel. */
void mesh_canvas_draw_stepped(struct mesh_canvas *canvas, const struct view *view, uint8_t *pixels);

/* The number of the face that the library draws at each pixel, plus 1; 0: none. malloc'd. */
uint32_t *mesh_faces_drawn(const struct fitted *fitted, const struct view *view);
/* Of a mesh with textures, the one that it takes the nearest pixel of at each pixel: its number in the chain, y and x, as one number. malloc'd. */
uint32_t *mesh_texels_drawn(const struct fitted *fitted, const struct view *view);
static inline uint32_t mesh_texel(unsigned level, uint32_t x, uint32_t y)
{
    return level << 22 | y << 11 | x;
}

#endif
