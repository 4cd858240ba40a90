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
/* The lamps may have changed since canvas_new, but not their kinds. All cores draw. Lines are packed; pixels outside the
 * scene's mask keep their values. */
void canvas_draw(struct canvas *canvas, const struct shading *shading, uint8_t *pixels);

/* One picture, black outside the mask: as the library wrote it, lines packed (malloc'd), or in levels. */
uint8_t *shade_pixels(const struct scene *scene, const struct shading *shading);
struct levels *shade_scene(const struct scene *scene, const struct shading *shading);

#endif
