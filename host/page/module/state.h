/* SPDX-License-Identifier: MIT
 * What the module holds between calls: the scene or mesh, and the picture of the last page_draw. */
#ifndef GLINT_PAGE_STATE_H
#define GLINT_PAGE_STATE_H

#include "draw/canvas.h"
#include "image/levels.h"
#include "image/picture.h"
#include "options/shading_options.h"
#include "scene/scene.h"

struct page_state {
    struct scene *scene; /* NULL: a mesh */
    struct canvas *canvas;
    uint32_t width, height;
    struct shading shading; /* of a mesh: its first part's */
    uint8_t *pixels, *rgba;
    size_t pixels_bytes;
    struct levels *levels;
};
const struct page_state *page_state(void);

/* By the words of `glint render`, into which it points. */
struct shading_options page_parse(char *text, size_t bytes);

uint8_t *rgba_of_picture(const struct picture *picture); /* malloc'd */

#endif
