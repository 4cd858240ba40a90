/* SPDX-License-Identifier: MIT
 * The mesh of the page: the built-in one, or a file's. */
#ifndef GLINT_PAGE_MESH_H
#define GLINT_PAGE_MESH_H

#include <stdint.h>

#include "draw/mesh_canvas.h"
#include "options/shading_options.h"

/* The mesh, where there is one: kept as the scene and its canvas are. */
struct page_mesh {
    struct mesh *mesh;
    struct fitted *fitted;
    struct mesh_canvas *canvas;
    struct shading *shadings; /* of its parts, as the canvas was made for them */
    struct shading *now;      /* the same with the lights as they are */
    struct view view;
};
const struct page_mesh *page_mesh(void);

/* As page_draw: `keep` is its own. Returns the shading of the first part. */
struct shading mesh_draw(const struct shading_options *look, uint32_t width, uint32_t height, uint32_t keep,
                         uint8_t *pixels);
void mesh_draw_again(uint8_t *pixels);
/* With stepped outlines, as pixels are compared. */
void mesh_draw_stepped(uint8_t *pixels);
void mesh_forget(void);

#endif
