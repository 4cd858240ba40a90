/* SPDX-License-Identifier: MIT
 * What baking costs in quality. */
#ifndef GLINT_COMPARE_QUALITY_H
#define GLINT_COMPARE_QUALITY_H

#include "bake/bake.h"
#include "compare/difference.h"
#include "scene/scene.h"

enum { QUALITY_ROWS = 4 };
struct quality {
    unsigned n;
    struct difference difference; /* over all pixels with a surface, under all lights */
};
/* A highlight by the exact path from what was baked, against the same from the 16-bit normals. */
void bake_quality(const struct scene *scene, const struct baked *baked, struct quality rows[QUALITY_ROWS]);

#endif
