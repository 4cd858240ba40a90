/* SPDX-License-Identifier: MIT
 * The built-in scenes. */
#ifndef GLINT_SCENE_SCENES_H
#define GLINT_SCENE_SCENES_H

#include "scene/scene.h"

extern const char *const scene_names[];                                      /* ends with NULL */
struct scene *scene_draw(const char *name, uint32_t width, uint32_t height); /* NULL: no scene has that name */
/* Its own material; the plain one where no scene has that name, or it is NULL. */
const struct finish *scene_finish(const char *name);

#endif
