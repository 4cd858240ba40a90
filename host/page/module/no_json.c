/* SPDX-License-Identifier: MIT
 * The commands' JSON needs jansson, which the page has not; it asks for text and C source only. */
#include "base/message.h"
#include "compare/compare_json.h"
#include "draw/shading_json.h"

void quality_print_json(const struct baked *baked, const struct quality rows[QUALITY_ROWS], FILE *stream)
{
    (void)baked;
    (void)rows;
    (void)stream;
    fail("--json: only the command writes JSON");
}

void quality_print_mesh_json(const struct baked_mesh *baked, const struct quality rows[QUALITY_ROWS],
                             struct mesh_cycles cycles, FILE *stream)
{
    (void)cycles;
    (void)baked;
    (void)rows;
    (void)stream;
    fail("--json: only the command writes JSON");
}

void shading_print_json(const struct shading *shading, FILE *out)
{
    (void)shading;
    (void)out;
    fail("--json: only the command writes JSON");
}
