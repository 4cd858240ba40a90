/* SPDX-License-Identifier: MIT
 * The last picture as what a device that shades by itself is sent to draw it. */
#include <stdlib.h>

#include "bake/bake.h"
#include "base/message.h"
#include "draw/mesh_in_device.h"
#include "draw/shading_device.h"
#include "image/picture.h"
#include "light_protocol.h"
#include "mesh.h"
#include "mesh/load.h"
#include "page.h"
#include "state.h"

uint32_t page_device_size(const uint8_t *bytes)
{
    struct light_descriptor descriptor;
    const bool is_known = light_descriptor_unpack(&descriptor, bytes);
    free((void *)(uintptr_t)bytes);
    return is_known && picture_size_fits(descriptor.width, descriptor.height)
               ? (uint32_t)descriptor.width << 16 | descriptor.height
               : 0;
}

const uint8_t *page_device_material(void)
{
    static uint8_t bytes[LIGHT_MATERIAL_BYTES];
    const struct page_state *now = page_state();
    struct light_material material;
    const char *refusal =
        now->scene ? device_refusal(now->scene, &now->shading, &material)
                   : mesh_in_device_refusal(&page_mesh()->view, &now->shading, page_mesh()->behind, &material);
    if (refusal)
        fail("%s", refusal);
    light_material_pack(bytes, &material);
    return bytes;
}

const uint8_t *page_device_map(void)
{
    static struct baked *baked;
    if (baked)
        baked_free(baked);
    baked = bake(page_state()->scene, BAKE_INT8, 0);
    return (const uint8_t *)baked->words; /* WebAssembly is little-endian, as the wire is */
}

const uint8_t *page_device_light(uint32_t tag)
{
    static uint8_t bytes[LIGHT_MESSAGE_BYTES];
    int32_t to_light[3];
    direction_integers(page_state()->shading.lamps[0].direction, to_light);
    light_message_pack(bytes, tag, to_light);
    return bytes;
}

/* ---- the mesh that it holds ---- */

uint32_t page_device_mesh(const uint8_t *held, char *words, size_t bytes)
{
    struct mesh_source source = page_parse(words, bytes).scene.mesh;
    struct light_mesh there;
    bool is_this = false;
    light_mesh_unpack(&there, held);
    free((void *)(uintptr_t)held);
    source.split = there.split;
    if (source.name && there.split >= 1 && there.split <= 180) {
        source.faces_most = there.faces;
        struct mesh *mesh = there.faces ? mesh_load(&source) : NULL;
        if (mesh) {
            struct fitted *fitted = mesh_fit(mesh, 0);
            is_this = mesh_in_device(&there, fitted);
            fitted_free(fitted);
            mesh_free(mesh);
        }
    }
    free(words);
    return is_this ? there.split : 0;
}

uint32_t page_draws_mesh(void)
{
    return page_mesh() != NULL;
}

const uint8_t *page_device_pose(uint32_t tag)
{
    static uint8_t bytes[LIGHT_POSE_BYTES];
    const struct light_pose pose = mesh_in_device_pose(&page_mesh()->view, &page_state()->shading);
    light_pose_pack(bytes, tag, &pose);
    return bytes;
}
