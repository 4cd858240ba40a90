/* SPDX-License-Identifier: MIT */
#include "light_protocol.h"

static uint8_t *put(uint8_t *at, uint32_t value, unsigned bytes)
{
    for (unsigned i = 0; i < bytes; i++)
        *at++ = (uint8_t)(value >> 8 * i);
    return at;
}

static uint32_t get(const uint8_t **at, unsigned bytes)
{
    uint32_t value = 0;
    for (unsigned i = 0; i < bytes; i++)
        value |= (uint32_t) * (*at)++ << 8 * i;
    return value;
}

void light_descriptor_pack(uint8_t out[LIGHT_DESCRIPTOR_BYTES], const struct light_descriptor *descriptor)
{
    out = put(out, LIGHT_MAGIC, 4);
    out = put(out, LIGHT_VERSION, 1);
    out = put(out, 0, 3);
    out = put(out, descriptor->width, 2);
    put(out, descriptor->height, 2);
}

bool light_descriptor_unpack(struct light_descriptor *descriptor, const uint8_t in[LIGHT_DESCRIPTOR_BYTES])
{
    const uint32_t magic = get(&in, 4), version = get(&in, 1);
    get(&in, 3);
    descriptor->width = (uint16_t)get(&in, 2);
    descriptor->height = (uint16_t)get(&in, 2);
    return magic == LIGHT_MAGIC && version == LIGHT_VERSION;
}

void light_material_of(struct light_material *material, const struct glint_material *from,
                       const struct glint_output *output)
{
    const struct light_material of_both = {.material = *from, .space = output->space};
    *material = of_both;
    material->material.n_across = 0;
}

void light_material_output(struct glint_output *output, const struct light_material *material)
{
    const struct glint_output of_wire = {.format = GLINT_RGB565, .space = material->space};
    *output = of_wire;
}

void light_material_pack(uint8_t out[LIGHT_MATERIAL_BYTES], const struct light_material *material)
{
    const struct glint_material *m = &material->material;
    out = put(out, m->model, 1);
    out = put(out, m->q, 1);
    out = put(out, m->n, 2);
    out = put(out, material->space, 1);
    out = put(out, m->clamp_peak ? LIGHT_CLAMP_PEAK : 0, 1);
    out = put(out, material->background, 2);
    for (unsigned k = 0; k < 3; k++)
        out = put(out, m->albedo[k], 1);
    out = put(out, 0, 1);
    for (unsigned k = 0; k < 3; k++)
        out = put(out, m->ambient_q16[k], 4);
    for (unsigned k = 0; k < 3; k++)
        out = put(out, m->diffuse_q16[k], 4);
    for (unsigned k = 0; k < 3; k++)
        out = put(out, m->specular_q16[k], 4);
}

bool light_material_unpack(struct light_material *material, const uint8_t in[LIGHT_MATERIAL_BYTES])
{
    struct glint_material *m = &material->material;
    m->model = (uint8_t)get(&in, 1);
    m->q = (uint8_t)get(&in, 1);
    m->n = (uint16_t)get(&in, 2);
    m->n_across = 0;
    material->space = (uint8_t)get(&in, 1);
    const uint32_t flags = get(&in, 1);
    m->clamp_peak = (flags & LIGHT_CLAMP_PEAK) != 0;
    material->background = (uint16_t)get(&in, 2);
    for (unsigned k = 0; k < 3; k++)
        m->albedo[k] = (uint8_t)get(&in, 1);
    get(&in, 1);
    for (unsigned k = 0; k < 3; k++)
        m->ambient_q16[k] = get(&in, 4);
    for (unsigned k = 0; k < 3; k++)
        m->diffuse_q16[k] = get(&in, 4);
    for (unsigned k = 0; k < 3; k++)
        m->specular_q16[k] = get(&in, 4);
    return (flags & ~(uint32_t)LIGHT_CLAMP_PEAK) == 0;
}

void light_message_pack(uint8_t out[LIGHT_MESSAGE_BYTES], uint32_t tag, const int32_t to_light[3])
{
    out = put(out, tag, 4);
    for (unsigned k = 0; k < 3; k++)
        out = put(out, (uint32_t)to_light[k], 4);
}

uint32_t light_message_unpack(int32_t to_light[3], const uint8_t in[LIGHT_MESSAGE_BYTES])
{
    const uint32_t tag = get(&in, 4);
    for (unsigned k = 0; k < 3; k++)
        to_light[k] = (int32_t)get(&in, 4);
    return tag;
}

void light_mesh_pack(uint8_t out[LIGHT_MESH_BYTES], const struct light_mesh *mesh)
{
    out = put(out, mesh->cksum, 4);
    out = put(out, mesh->vertices, 2);
    out = put(out, mesh->faces, 2);
    out = put(out, mesh->split, 1);
    put(out, 0, 3);
}

void light_mesh_unpack(struct light_mesh *mesh, const uint8_t in[LIGHT_MESH_BYTES])
{
    mesh->cksum = get(&in, 4);
    mesh->vertices = (uint16_t)get(&in, 2);
    mesh->faces = (uint16_t)get(&in, 2);
    mesh->split = (uint8_t)get(&in, 1);
}

static uint8_t *put_all(uint8_t *at, const int16_t *values, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        at = put(at, (uint16_t)values[i], 2);
    return at;
}

static void get_all(const uint8_t **at, int16_t *values, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        values[i] = (int16_t)get(at, 2);
}

void light_pose_pack(uint8_t out[LIGHT_POSE_BYTES], uint32_t tag, const struct light_pose *pose)
{
    out = put(out, tag, 4);
    out = put_all(out, pose->pose.turn, 4);
    out = put_all(out, pose->pose.position, 3);
    out = put(out, pose->pose.scale, 2);
    out = put_all(out, pose->to_light, 3);
    put(out, 0, 2);
}

bool light_pose_unpack(struct light_pose *pose, const uint8_t in[LIGHT_POSE_BYTES])
{
    get(&in, 4);
    get_all(&in, pose->pose.turn, 4);
    get_all(&in, pose->pose.position, 3);
    pose->pose.scale = (uint16_t)get(&in, 2);
    get_all(&in, pose->to_light, 3);
    return get(&in, 2) == 0;
}
