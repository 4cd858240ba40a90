/* SPDX-License-Identifier: MIT */
#include "mesh/soup.h"

#include <math.h>
#include <stdlib.h>

#include "base/message.h"
#include "glint_mesh.h"

void soup_free(struct soup *soup)
{
    if (!soup)
        return;
    free(soup->name);
    free(soup->faces);
    free(soup->materials);
    mesh_pictures_free(soup->pictures, soup->picture_count);
    free(soup);
}

void soup_check_count(const char *name, uint64_t face_count)
{
    if (face_count == 0)
        fail("%s: has no triangles; name another mesh", name);
    if (face_count > GLINT_MESH_FACES_MAX)
        fail("%s: has %llu triangles, and at most %u can be drawn; simplify the mesh", name,
             (unsigned long long)face_count, GLINT_MESH_FACES_MAX);
}

void soup_check_faces(const struct soup *soup)
{
    for (size_t i = 0; i < soup->face_count; i++) {
        const struct soup_face *face = &soup->faces[i];
        for (int k = 0; k < 9; k++)
            if (!(fabs(face->places[k / 3][k % 3]) < 1e30))
                fail("%s: triangle %zu has a coordinate that is not a number below 10^30; repair the mesh", soup->name,
                     i + 1);
        if (face->part >= soup->part_count)
            fail("%s: triangle %zu has no material; repair the mesh", soup->name, i + 1);
    }
}

void soup_check_uv(const struct soup *soup)
{
    for (size_t i = 0; i < 6 * soup->face_count; i++)
        if (!(fabs(soup->faces[i / 6].uv[i / 2 % 3][i % 2]) < 1e6))
            fail("%s: triangle %zu has a texture coordinate that is not a number below 10^6; repair the mesh, or give "
                 "--no-textures",
                 soup->name, i / 6 + 1);
}
