/* SPDX-License-Identifier: MIT
 * How far a picture is from the double-precision reference. */
#ifndef GLINT_COMPARE_H
#define GLINT_COMPARE_H

#include <stdio.h>

#include "compare/difference.h"
#include "draw/shading.h"
#include "image/levels.h"
#include "scene/scene.h"

/* The picture against references in doubles, rounded to the picture's format (an ideal renderer's picture) and not (the
 * true values: even the ideal picture misses them by what `rounding` says). */
struct comparison {
    struct difference rounded, unrounded;             /* against the same model */
    struct difference blinn_rounded, blinn_unrounded; /* against Blinn with the same n and q */
    struct difference rounding;                       /* the same model's reference, rounded, against its true values */
};

/* What the picture was drawn over, where something is seen through it; NULL elsewhere. */
struct levels *levels_behind(const struct scene *scene, const struct shading *shading);
/* Line y of the reference (reference.h), over what is behind it. */
void wanted_line(const struct scene *scene, const struct shading *shading, enum glint_model model,
                 const struct levels *behind, uint32_t y, double *values);

/* `shading`: of each of the scene's parts, which agree in all but the material and n. */
void compare(const struct scene *scene, const struct shading *shading, const struct levels *levels,
             struct comparison *comparison);
/* `shading` and `levels` as they were compared. */
void comparison_print(const struct comparison *comparison, const struct shading *shading, const struct levels *levels,
                      FILE *stream);

/* The absolute difference from the unrounded reference of `model`, times `amplification`; RGB or grey. */
struct picture *error_map(const struct scene *scene, const struct shading *shading, const struct levels *levels,
                          enum glint_model model, unsigned amplification);
/* The largest power of two that leaves the largest error within white, at least 1. */
unsigned error_map_amplification(const struct difference *difference);

#endif
