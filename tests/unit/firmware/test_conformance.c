/* SPDX-License-Identifier: MIT
 * The conformance image's checks of meshes with outlines: a mesh that the library refuses would be the same on every machine, too. */
#include "unit.h"

#include "glint_mesh.h"

static unsigned refused, added;

static enum glint_err add(struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn, const struct glint_mesh *mesh,
                          const struct glint_pose *pose, const struct glint_paint *paints, void *memory, size_t bytes)
{
    const enum glint_err err = glint_mesh_add(frame, drawn, mesh, pose, paints, memory, bytes);
    refused += err != GLINT_OK;
    added += err == GLINT_OK && frame->outlines && mesh->neighbours;
    return err;
}
/* clang-format off */
#include "../../../firmware/conformance/conformance_random.c"
#include "../../../firmware/conformance/conformance_tables.c"
#include "../../../firmware/conformance/conformance_scenes.c"
#include "../../../firmware/conformance/conformance_paints.c"
#define glint_mesh_add add
#include "../../../firmware/conformance/conformance_meshes.c"
/* clang-format on */

static void every_mesh_with_outlines_is_drawn(void **state_)
{
    static const struct conformance_size small = {4, 8191, 6, 4, 1, 20};
    (void)state_;
    for (unsigned tables = 0; tables < 2; tables++) {
        refused = added = 0;
        conform_begin();
        conform_mesh_outlines(&small, tables);
        if (refused || added < GLINT_MODEL_COUNT)
            fail_msg("%s: %u meshes refused, %u added", tables ? "by tables" : "exactly", refused, added);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_mesh_with_outlines_is_drawn)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
