/* SPDX-License-Identifier: MIT */
#include "demo_teapot.h"

#if TEAPOT
#include "demo_mesh.h"
#include "mesh_cksum.h"

const struct glint_mesh demo_teapot = {demo_mesh_places,
                                       NULL,
                                       demo_mesh_normals,
                                       demo_mesh_faces,
                                       NULL,
                                       sizeof demo_mesh_places / (3 * sizeof *demo_mesh_places),
                                       sizeof demo_mesh_faces / (3 * sizeof *demo_mesh_faces),
                                       0};

const struct light_mesh demo_teapot_identity = {
    DEMO_MESH_CKSUM, sizeof demo_mesh_places / (3 * sizeof *demo_mesh_places),
    sizeof demo_mesh_faces / (3 * sizeof *demo_mesh_faces), DEMO_MESH_SPLIT};

bool demo_teapot_is_intact(void)
{
    return mesh_cksum(&demo_teapot) == DEMO_MESH_CKSUM;
}
#endif
