/* SPDX-License-Identifier: MIT */
#include "glint_mesh.h"

enum glint_err glint_mesh_check(const struct glint_mesh *mesh)
{
    if (!mesh || !mesh->places || !mesh->faces || !(mesh->normals || mesh->normals8) || mesh->vertex_count == 0 ||
        mesh->face_count > GLINT_MESH_FACES_MAX || (mesh->part_count && !mesh->ends))
        return GLINT_ERR_ARG;
    for (size_t i = 0; i < (size_t)3 * mesh->face_count; i++)
        if (mesh->faces[i] >= mesh->vertex_count)
            return GLINT_ERR_ARG;
    for (size_t i = 0; !mesh->normals && i < (size_t)3 * mesh->vertex_count; i++)
        if (mesh->normals8[i] == INT8_MIN)
            return GLINT_ERR_ARG;
    for (unsigned i = 1; i < mesh->part_count; i++)
        if (mesh->ends[i] < mesh->ends[i - 1])
            return GLINT_ERR_ARG;
    if (mesh->part_count && mesh->ends[mesh->part_count - 1] != mesh->face_count)
        return GLINT_ERR_ARG;
    return GLINT_OK;
}
