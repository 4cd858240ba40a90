/* SPDX-License-Identifier: MIT
 * Fuzzes OBJ and MTL: any text is refused with a reason, or makes triangles whose parts, pictures and materials are there; those of a face are as many
 * as its corners say. Input: how much of what follows is OBJ (2), whether pictures are wanted (1), the OBJ; the rest is each MTL that it names. */
#include <math.h>
#include <string.h>

#include "fuzz.h"
#include "glint_mesh.h"
#include "mesh/obj.h"
#include "mesh/obj_materials.h"

static struct {
    const uint8_t *text;
    size_t len;
    unsigned times;
} library;

static bool read_library(struct obj_materials *materials, const char *name)
{
    check(*name);
    if (library.times++ < 4) /* long ones by many names take long */
        obj_materials_read(materials, (const char *)library.text, library.len);
    return *name != 'm';
}

static void check_text(const char *text)
{
    check(*text);
}

static void check_soup(const struct soup *soup, bool textures)
{
    check(soup->part_count >= 1 && soup->part_count <= OBJ_MATERIALS_MAX + 1);
    check(soup->picture_count < soup->part_count && (textures || soup->picture_count == 0));
    for (unsigned i = 0; i < soup->part_count; i++) {
        const struct mesh_material *material = &soup->materials[i];
        check(material->picture <= soup->picture_count && material->n <= 1000);
        for (int k = 0; k < 3; k++)
            check(material->highlight[k] >= 0 && material->highlight[k] <= 1);
    }
    for (unsigned i = 0; i < soup->picture_count; i++)
        check(soup->pictures[i].name[0]);
    check((soup->faces != NULL) == (soup->face_count > 0 && soup->face_count <= GLINT_MESH_FACES_MAX));
    for (size_t i = 0; soup->faces && i < soup->face_count; i++) {
        const struct soup_face *face = &soup->faces[i];
        check(face->part < soup->part_count);
        for (int k = 0; k < 9; k++)
            check(soup->has_normals || face->normals[k / 3][k % 3] == 0);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, data + size};
    size_t count = next_word(&input), rest = size;
    const bool textures = next_byte(&input) & 1;
    uint8_t *const text = next_bytes(&input, &count), *const more = next_bytes(&input, &rest);
    library.text = more;
    library.len = rest;
    library.times = 0;
    const struct obj_source source = {(const char *)text, count, textures, read_library, check_text, check_text};
    char wrong[120] = "";
    struct soup *soup = obj_soup(&source, wrong);
    check(soup ? !*wrong : strncmp(wrong, "line ", 5) == 0 && memchr(wrong, 0, sizeof wrong));
    if (soup)
        check_soup(soup, textures);
    soup_free(soup);
    free(text);
    free(more);
    return 0;
}
