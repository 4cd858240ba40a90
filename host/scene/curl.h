/* SPDX-License-Identifier: MIT
 * Which way the green of a normal map points. */
#ifndef GLINT_SCENE_CURL_H
#define GLINT_SCENE_CURL_H

#include <stdbool.h>
#include <stddef.h>

#include "scene/scene.h"

/* Summed over parts of a surface. */
struct curl {
    double as_it_is, flipped;
    size_t count;
};
void curl_add(struct curl *curl, const struct scene *scene, const uint8_t *mask);
bool curl_is_flipped(const struct curl *curl);

/* Would the scene's normals fit a surface much better with y the other way? `mask` (NULL: none) leaves pixels out. */
bool curl_says_flipped(const struct scene *scene, const uint8_t *mask);

#endif
