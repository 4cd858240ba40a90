/* SPDX-License-Identifier: MIT */
#include "held_mesh.h"

#if TURNS_MESH
#include "demo_mesh.h"
#include "demo_mesh_sizes.h"
#include "mesh_cksum.h"

/* All of it is drawn with one material, whatever parts the file has. */
const struct glint_mesh held_mesh = {.places = demo_mesh_places,
                                     .normals8 = demo_mesh_normals,
                                     .faces = demo_mesh_faces,
                                     .vertex_count = DEMO_MESH_VERTICES,
                                     .face_count = DEMO_MESH_FACES};

const struct light_mesh held_mesh_identity = {DEMO_MESH_CKSUM, DEMO_MESH_VERTICES, DEMO_MESH_FACES, DEMO_MESH_SPLIT};

bool held_mesh_is_intact(void)
{
    return mesh_cksum(&held_mesh) == DEMO_MESH_CKSUM;
}
#endif
