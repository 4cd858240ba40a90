/* SPDX-License-Identifier: MIT
 * What the module holds between calls: the scene and the picture of the last page_draw. */
#ifndef GLINT_PAGE_STATE_H
#define GLINT_PAGE_STATE_H

#include "draw/canvas.h"
#include "image/levels.h"
#include "image/picture.h"
#include "scene/scene.h"

struct page_state {
    struct scene *scene;
    struct shading shading;
    struct canvas *canvas;
    uint8_t *pixels, *rgba;
    size_t pixels_bytes;
    struct levels *levels;
};
const struct page_state *page_state(void);

uint8_t *rgba_of_picture(const struct picture *picture); /* malloc'd */

#endif
