/* SPDX-License-Identifier: MIT
 * Maps made smaller, and what their details become: Toksvig, "Mipmapping Normal Maps", 2005. */
#ifndef GLINT_SCENE_FILTER_H
#define GLINT_SCENE_FILTER_H

#include "scene/scene.h"

/* Each times x times pixels become one, of the means of what is drawn; lines and columns that fill no pixel are left out. Of the normals' means
 * `lengths` keeps how long they were. */
void scene_shrink(struct scene *scene, unsigned times);
/* Where the lengths are known: makes the map of shininess for a material of shininess n, and scales the gloss, so that a highlight is as
 * wide and as bright as the details' would be in the mean; and the albedo (without one `color`), since details shade each other. */
void scene_soften(struct scene *scene, unsigned n, const uint8_t color[3]);

#endif
