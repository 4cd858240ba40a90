/* SPDX-License-Identifier: MIT
 * Meshes of the page: binary STL files, read as libassimp reads them for the command, OBJ by the command's own reader with what was given
 * together with it, and glTF files that hold all they need. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/memory.h"
#include "base/message.h"
#include "files.h"
#include "glint.h"
#include "gltf.h"
#include "image/read.h"
#include "mesh/import.h"
#include "mesh/import_picture.h"
#include "mesh/obj.h"
#include "mesh/obj_materials.h"

enum { COMMENT = 80, HEAD = 84, FACET = 50, HAS_COLOR = 0x8000 };

static uint32_t get(const uint8_t *at, unsigned bytes)
{
    uint32_t value = 0;
    for (unsigned i = bytes; i-- > 0;)
        value = value << 8 | at[i];
    return value;
}

static double number(const uint8_t *at)
{
    const uint32_t bits = get(at, 4);
    float value;
    memcpy(&value, &bits, sizeof value);
    return (double)value;
}

/* What the comment says: COLOR= and four bytes; colours of facets are in its place. Else white, which tells no colour. */
static struct mesh_material material_of(const uint8_t *stl, bool has_colors)
{
    static const char word[] = "COLOR=";
    enum { WORD = sizeof word - 1 };
    struct mesh_material material = {.color = {255, 255, 255}};
    for (unsigned i = 0; !has_colors && i + WORD + 4 <= COMMENT; i++)
        if (memcmp(stl + i, word, WORD) == 0) {
            memcpy(material.color, stl + i + WORD, sizeof material.color);
            material.has_color = (material.color[0] & material.color[1] & material.color[2]) != 255;
            break;
        }
    return material;
}

static uint32_t count_of(const char *path, const uint8_t *stl, size_t len)
{
    const uint32_t count = len >= HEAD ? get(stl + COMMENT, 4) : 0;
    if (len < HEAD || len != HEAD + (uint64_t)FACET * count)
        fail("%s: this is not a whole binary STL; export the mesh as one, or use glint render --mesh", path);
    return count;
}

/* Of 8 bits, as encoded: the command makes others so by libpng. Alpha is ignored. */
struct mesh_picture import_picture(const char *path)
{
    struct image *image = image_read(path);
    const size_t pixels = (size_t)image->width * image->height;
    if (image->bits > 8)
        fail("%s: has %u bits a sample; the page takes textures of 8; save it so, or use glint render", path,
             image->bits);
    struct mesh_picture picture = {strdup(path), image->width, image->height, allocate(pixels, 3)};
    if (!picture.name)
        fail("out of memory");
    for (size_t i = 0; i < 3 * pixels; i++)
        picture.rgb[i] = (uint8_t)(image->samples[i / 3 * image->channels + (image->channels > 2 ? i % 3 : 0)] / 257);
    image_free(image);
    return picture;
}

/* ---- OBJ ---- */

static const char *obj_name;

static bool is_separator(char c)
{
    return c == '/' || c == '\\';
}

static const char *base_of(const char *name)
{
    for (const char *at = name; *at; at++)
        if (is_separator(*at))
            name = at + 1;
    return name;
}

/* What came with the OBJ has its name before its own, without folders. */
static char *key_of(const char *name)
{
    char *key;
    if (asprintf(&key, "%s/%s", obj_name, base_of(name)) < 0)
        fail("out of memory");
    return key;
}

/* The first name of each file that came with the OBJ. */
static struct named {
    char *name;
    struct named *next;
} * named;

static void forget_names(void)
{
    while (named) {
        struct named *first = named;
        named = first->next;
        free(first->name);
        free(first);
    }
}

static bool is_same(const char *a, const char *b)
{
    a += a[0] == '.' && is_separator(a[1]) ? 2 : 0;
    b += b[0] == '.' && is_separator(b[1]) ? 2 : 0;
    for (; *a && (*a == *b || (is_separator(*a) && is_separator(*b))); a++)
        b++;
    return *a == *b;
}

/* In other folders they are other files. */
static void check_name(const char *name, const char *where)
{
    struct named *at = named;
    while (at && strcmp(base_of(at->name), base_of(name)) != 0)
        at = at->next;
    if (at) {
        if (!is_same(at->name, name))
            warn("%s: names %s and %s, which the page takes for one file, since it knows no folders; rename one, and "
                 "change its name in the %s",
                 obj_name, at->name, name, where);
        return;
    }
    at = allocate(1, sizeof *at);
    *at = (struct named){strdup(name), named};
    if (!at->name)
        fail("out of memory");
    named = at;
}

static bool ends_in(const char *path, const char *ending)
{
    const char *dot = strrchr(path, '.');
    return dot && strcasecmp(dot, ending) == 0;
}

static void warn_not_here(const char *name)
{
    warn("%s: names %s, which is not here: drop or choose it together with the mesh", obj_name, name);
}

static bool read_library(struct obj_materials *materials, const char *name)
{
    size_t len;
    char *key = key_of(name);
    const uint8_t *text = files_mesh(key, &len);
    if (text) {
        check_name(name, "OBJ");
        obj_materials_read(materials, (const char *)text, len);
    }
    free(key);
    return text != NULL;
}

static void say_note(const char *text)
{
    warn("%s: %s", obj_name, text);
}

/* Parts whose picture is not here have their colour. */
static void take_pictures(struct soup *soup)
{
    for (unsigned i = 0; i < soup->picture_count; i++) {
        struct mesh_picture *to = &soup->pictures[i];
        char *key = key_of(to->name);
        if (files_has_image(key)) {
            check_name(to->name, "MTL");
            struct mesh_picture picture = import_picture(key);
            free(picture.name);
            picture.name = to->name;
            *to = picture;
        } else if (ends_in(to->name, ".png")) {
            warn_not_here(to->name);
        } else {
            warn(
                "%s: names %s, but the page reads PNG textures only; convert it to PNG, and change its name in the MTL",
                obj_name, to->name);
        }
        free(key);
    }
}

static struct soup *obj_of(const char *path, const uint8_t *bytes, size_t len, bool textures)
{
    const struct obj_source source = {(const char *)bytes, len, textures, read_library, warn_not_here, say_note};
    char wrong[120];
    obj_name = path;
    forget_names();
    struct soup *soup = obj_soup(&source, wrong);
    if (!soup)
        fail("%s: glint cannot read this mesh: %s", path, wrong);
    soup->name = strdup(path);
    if (!soup->name)
        fail("out of memory");
    soup_check_count(soup->name, soup->face_count);
    soup_check_faces(soup);
    take_pictures(soup);
    return soup;
}

struct soup *import_soup(const char *path, bool textures, const char *allowed)
{
    (void)allowed;
    size_t len;
    const uint8_t *stl = files_mesh(path, &len);
    if (!stl)
        fail("%s: this mesh is not here; drop or choose the file", path);
    if ((ends_in(path, ".gltf") || ends_in(path, ".glb")) && gltf_is(stl, len))
        return gltf_soup(path, (const void *)stl, textures);
    if (ends_in(path, ".obj"))
        return obj_of(path, stl, len, textures);
    struct soup *soup = allocate(1, sizeof *soup);
    *soup =
        (struct soup){.name = strdup(path), .face_count = count_of(path, stl, len), .is_stl = true, .part_count = 1};
    if (!soup->name)
        fail("out of memory");
    soup_check_count(soup->name, soup->face_count);
    soup->faces = allocate(soup->face_count, sizeof *soup->faces);
    for (size_t i = 0; i < soup->face_count; i++) {
        const uint8_t *facet = stl + HEAD + FACET * i;
        for (size_t k = 0; k < 9; k++) /* after the facet's normal */
            soup->faces[i].places[k / 3][k % 3] = number(facet + 12 + 4 * k);
        soup->has_facet_colors |= (get(facet + FACET - 2, 2) & HAS_COLOR) != 0;
    }
    soup->materials = allocate(1, sizeof *soup->materials);
    *soup->materials = material_of(stl, soup->has_facet_colors);
    soup_check_faces(soup);
    return soup;
}
