/* SPDX-License-Identifier: MIT
 * What baking costs, as text. compare_json.h has it as JSON. */
#ifndef GLINT_COMPARE_QUALITY_REPORT_H
#define GLINT_COMPARE_QUALITY_REPORT_H

#include <stdio.h>

#include "bake/bake.h"
#include "bake/mesh_files.h"
#include "compare/mesh_cost.h"
#include "compare/quality.h"

void quality_print(const struct baked *baked, const struct quality rows[QUALITY_ROWS], FILE *stream);
/* `cycles`: mesh_cycles, of one picture. */
void quality_print_mesh(const struct baked_mesh *baked, const struct quality rows[QUALITY_ROWS],
                        struct mesh_cycles cycles, FILE *stream);
/* Ends the program through fail() where standard output or error, which `stream` is, did not take it. */
void quality_printed(FILE *stream);

#endif
