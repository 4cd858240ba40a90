/* SPDX-License-Identifier: MIT
 * The built-in scenes. */
#ifndef GLINT_SCENE_SCENES_H
#define GLINT_SCENE_SCENES_H

#include <stdbool.h>

#include "scene/scene.h"

extern const char *const scene_names[];                                      /* ends with NULL */
struct scene *scene_draw(const char *name, uint32_t width, uint32_t height); /* NULL: no scene has that name */
/* The same, made of something of this colour: the ball, the coin, the watch's case; NULL: as it comes. `cut`: without the wall behind it:
 * the mask is its coverage. */
struct scene *scene_draw_in(const char *name, uint32_t width, uint32_t height, const uint8_t body[3], bool cut);
/* Lines of it alone. */
struct scene *scene_draw_lines(const char *name, uint32_t width, uint32_t height, const uint8_t body[3], bool cut,
                               uint32_t top, uint32_t lines);
/* Its own material; the plain one where no scene has that name, or it is NULL. */
const struct finish *scene_finish(const char *name);

#endif
