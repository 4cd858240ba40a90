/* SPDX-License-Identifier: MIT */
#include "gltf.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"

/* As src/gltf.ts has them. */
enum { MAGIC, FACES, PARTS, PICTURES, NORMALS, UV, COLORS, HEAD };
enum { SOUP_MAGIC = 20260001 };

bool gltf_is(const uint8_t *bytes, size_t len)
{
    const double magic = SOUP_MAGIC;
    return len >= HEAD * sizeof magic && memcmp(bytes, &magic, sizeof magic) == 0;
}

static const double *take_material(struct mesh_material *material, const double *at, bool textures)
{
    *material = (struct mesh_material){.has_color = true, .factor = {1, 1, 1}};
    for (int k = 0; k < 3; k++)
        material->color[k] = (uint8_t)*at++;
    material->unlit = *at++ != 0;
    material->roughness = *at++;
    material->metallic = *at++;
    material->has_roughness = material->metallic < 1 || material->roughness < 1;
    const unsigned look_picture = (unsigned)*at++, picture = (unsigned)*at++;
    const bool clamps = *at++ != 0, is_nearest = *at++ != 0;
    if (textures)
        material->look_picture = look_picture;
    if (textures && picture) {
        material->picture = picture;
        material->clamps = clamps;
        material->is_nearest = is_nearest;
        memcpy(material->factor, at, sizeof material->factor);
    }
    return at + 3;
}

static const double *take_face(struct soup_face *face, const double *at)
{
    memcpy(face->places, at, sizeof face->places);
    memcpy(face->normals, at += 9, sizeof face->normals);
    memcpy(face->uv, at += 9, sizeof face->uv);
    at += 6;
    for (int k = 0; k < 9; k++)
        face->colors[k / 3][k % 3] = (uint8_t)*at++;
    face->part = (uint32_t)*at++;
    return at;
}

static void take_picture(struct mesh_picture *picture, unsigned number, const uint8_t *rgb)
{
    const size_t bytes = (size_t)3 * picture->width * picture->height;
    if (asprintf(&picture->name, "%u", number + 1) < 0)
        fail("out of memory");
    picture->rgb = allocate(bytes, 1);
    memcpy(picture->rgb, rgb, bytes);
}

struct soup *gltf_soup(const char *name, const double *numbers, bool textures)
{
    const double *at = numbers + HEAD;
    struct soup *soup = allocate(1, sizeof *soup);
    *soup = (struct soup){.name = strdup(name),
                          .face_count = (size_t)numbers[FACES],
                          .has_normals = numbers[NORMALS] != 0,
                          .has_uv = numbers[UV] != 0,
                          .has_colors = numbers[COLORS] != 0,
                          .part_count = (unsigned)numbers[PARTS],
                          .picture_count = textures ? (unsigned)numbers[PICTURES] : 0};
    if (!soup->name)
        fail("out of memory");
    soup_check_count(soup->name, soup->face_count);
    soup->materials = allocate(soup->part_count, sizeof *soup->materials);
    soup->pictures = allocate(soup->picture_count + 1, sizeof *soup->pictures);
    soup->faces = allocate(soup->face_count, sizeof *soup->faces);
    for (unsigned i = 0; i < soup->part_count; i++)
        at = take_material(&soup->materials[i], at, textures);
    for (unsigned i = 0; i < soup->picture_count; i++) {
        soup->pictures[i].width = (uint32_t)at[(size_t)2 * i];
        soup->pictures[i].height = (uint32_t)at[2 * i + 1];
    }
    at += 2 * (size_t)numbers[PICTURES];
    for (size_t i = 0; i < soup->face_count; i++)
        at = take_face(&soup->faces[i], at);
    const uint8_t *rgb = (const uint8_t *)at;
    for (unsigned i = 0; i < soup->picture_count; i++) {
        take_picture(&soup->pictures[i], i, rgb);
        rgb += (size_t)3 * soup->pictures[i].width * soup->pictures[i].height;
    }
    soup_check_faces(soup);
    return soup;
}
