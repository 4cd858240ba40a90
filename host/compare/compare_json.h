/* SPDX-License-Identifier: MIT
 * Comparisons as JSON. */
#ifndef GLINT_COMPARE_COMPARE_JSON_H
#define GLINT_COMPARE_COMPARE_JSON_H

#include <stdio.h>

#include "bake/mesh_files.h"
#include "compare/compare.h"
#include "compare/mesh_cost.h"
#include "compare/mesh_scene.h"
#include "compare/quality.h"

/* `shading` and `levels` as they were compared. `coverage`: a mesh's, else NULL. */
void comparison_print_json(const struct comparison *comparison, const struct shading *shading,
                           const struct levels *levels, const struct mesh_coverage *coverage, FILE *stream);
void quality_print_json(const struct baked *baked, const struct quality rows[QUALITY_ROWS], FILE *stream);
void quality_print_mesh_json(const struct baked_mesh *baked, const struct quality rows[QUALITY_ROWS],
                             struct mesh_cycles cycles, FILE *stream);

#endif
