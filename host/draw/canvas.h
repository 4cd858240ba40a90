/* SPDX-License-Identifier: MIT
 * Scenes drawn by the library. */
#ifndef GLINT_DRAW_CANVAS_H
#define GLINT_DRAW_CANVAS_H

#include "draw/shading.h"
#include "image/levels.h"
#include "scene/scene.h"

/* A scene made ready for a material and a format, to be drawn again and again as the light moves. */
struct canvas;
struct canvas *canvas_new(const struct scene *scene, const struct shading *shading); /* the scene must outlive it */
void canvas_free(struct canvas *canvas);
/* The lamps may have changed since canvas_new, but not their kinds. All cores draw. Lines are packed; the pixels must be black at first,
 * or of the frame before. */
void canvas_draw(struct canvas *canvas, const struct shading *shading, uint8_t *pixels);

/* A backdrop as pixels of the format; NULL for NULL. malloc'd. */
uint8_t *backdrop_pixels(const uint8_t *backdrop, uint32_t width, uint32_t height, const struct shading *shading);

/* One picture, the scene's backdrop outside the mask: as the library wrote it, lines packed (malloc'd), or in levels. */
uint8_t *shade_pixels(const struct scene *scene, const struct shading *shading);
struct levels *shade_scene(const struct scene *scene, const struct shading *shading);

#endif
