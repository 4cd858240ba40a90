/* SPDX-License-Identifier: MIT */
#include "bake/mesh_files.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "bake/c_source.h"
#include "base/memory.h"
#include "scene/scene.h"

size_t baked_mesh_bytes(const struct baked_mesh *baked)
{
    return fitted_bytes(baked->fitted, baked->normals8);
}

static const struct glint_mesh *mesh_of(const struct baked_mesh *baked)
{
    return &baked->fitted->mesh;
}

/* ---- materials ---- */

/* Values of 0..1 in Q16. */
static void set_all(uint32_t out[3], const double values[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (uint32_t)(65536 * values[k] + .5);
}

/* The plain finish, but for what the file says. */
struct glint_material *mesh_materials(const struct mesh *mesh)
{
    static const uint8_t usual[3] = {200, 200, 200};
    struct glint_material *materials = allocate(mesh->part_count, sizeof *materials);
    for (unsigned i = 0; i < mesh->part_count; i++) {
        const struct mesh_material *from = &mesh->materials[i];
        materials[i].model = GLINT_MSH;
        materials[i].n = (uint16_t)(from->n ? from->n : plain_finish.n);
        struct finish finish = plain_finish;
        mesh_material_look(from, finish.ambient, finish.diffuse, finish.specular);
        set_all(materials[i].ambient_q16, finish.ambient);
        set_all(materials[i].diffuse_q16, finish.diffuse);
        set_all(materials[i].specular_q16, finish.specular);
        memcpy(materials[i].albedo, from->has_color ? from->color : usual, sizeof usual);
    }
    return materials;
}

/* ---- source ---- */

static void write_note(const struct baked_mesh *baked, FILE *out)
{
    const struct fitted *f = baked->fitted;
    fprintf(out,
            "/* Written by glint bake, version " GLINT_VERSION_STRING
            ": a mesh of %u vertices and %u triangles, %zu bytes.\n"
            " * 1 in the file is %g here, and %g, %g, %g there is the origin. */\n",
            f->mesh.vertex_count, f->mesh.face_count, baked_mesh_bytes(baked), f->unit, f->middle[0], f->middle[1],
            f->middle[2]);
}

/* Value i of an array of numbers that differ in their type. */
typedef int value_at(const struct baked_mesh *baked, size_t i);

static int place_at(const struct baked_mesh *baked, size_t i)
{
    return mesh_of(baked)->places[i];
}

static int normal_at(const struct baked_mesh *baked, size_t i)
{
    return baked->normals8 ? mesh_of(baked)->normals8[i] : mesh_of(baked)->normals[i];
}

static int corner_at(const struct baked_mesh *baked, size_t i)
{
    return mesh_of(baked)->faces[i];
}

static int neighbour_at(const struct baked_mesh *baked, size_t i)
{
    return mesh_of(baked)->neighbours[i];
}

static int color_at(const struct baked_mesh *baked, size_t i)
{
    return baked->fitted->colors[i / 3][i % 3];
}

static int uv_at(const struct baked_mesh *baked, size_t i)
{
    return mesh_of(baked)->uv[i];
}

static int end_at(const struct baked_mesh *baked, size_t i)
{
    return mesh_of(baked)->ends[i];
}

static void write_array(const struct baked_mesh *baked, const char *storage, const char *type, const char *name,
                        const char *suffix, size_t count, value_at *at, FILE *out)
{
    c_begin_array(storage, type, name, suffix, out);
    for (size_t i = 0; i < count; i++)
        fprintf(out, "%s%d%s", i % 18 ? " " : "\n    ", at(baked, i), i + 1 < count ? "," : "");
    fputs("\n};\n", out);
}

static void write_materials(const struct baked_mesh *baked, const char *storage, const char *name, FILE *out)
{
    c_begin_array(storage, "struct glint_material", name, "_materials", out);
    for (unsigned i = 0; i < mesh_of(baked)->part_count; i++) {
        const struct glint_material *m = &baked->materials[i];
        const uint32_t *const sums[3] = {m->ambient_q16, m->diffuse_q16, m->specular_q16};
        fprintf(out, "\n    {GLINT_MSH, 0, %u, 0, ", m->n);
        for (int j = 0; j < 3; j++)
            fprintf(out, "{%" PRIu32 ", %" PRIu32 ", %" PRIu32 "}, ", sums[j][0], sums[j][1], sums[j][2]);
        fprintf(out, "{%u, %u, %u}, false},", m->albedo[0], m->albedo[1], m->albedo[2]);
    }
    fputs("\n};\n", out);
}

/* ---- textures ---- */

/* Those that parts have: a picture of which none is left has no name. */
static const struct texture *texture_number(const struct baked_mesh *baked, unsigned i)
{
    const struct fitted *fitted = baked->fitted;
    return mesh_of(baked)->textures && i < fitted->texture_count && fitted->textures[i].name ? &fitted->textures[i]
                                                                                             : NULL;
}

static void write_numbers(const char *name, const char *suffix, unsigned number, const void *values, bool words,
                          size_t count, FILE *out)
{
    char whole[32];
    snprintf(whole, sizeof whole, "%s%u", suffix, number);
    c_begin_array("static ", words ? "uint16_t" : "uint8_t", name, whole, out);
    for (size_t i = 0; i < count; i++)
        fprintf(out, "%s%u%s", i % 18 ? " " : "\n    ",
                words ? (unsigned)((const uint16_t *)values)[i] : (unsigned)((const uint8_t *)values)[i],
                i + 1 < count ? "," : "");
    fputs("\n};\n", out);
}

static void write_textures(const struct baked_mesh *baked, const char *name, FILE *out)
{
    for (unsigned i = 0; i < baked->fitted->texture_count; i++) {
        const struct texture *texture = texture_number(baked, i);
        if (!texture)
            continue;
        if (texture->colors)
            write_numbers(name, "_palette", i + 1, texture->palette, true, texture->colors, out);
        write_numbers(name, "_texture", i + 1, texture->texture.pixels, !texture->colors, texture_pixels(texture), out);
    }
    c_begin_array("static ", "struct glint_texture", name, "_textures", out);
    for (unsigned i = 0; i < mesh_of(baked)->part_count; i++) {
        const struct glint_texture *of_part = &mesh_of(baked)->textures[i];
        const unsigned number = baked->mesh->materials[i].picture;
        if (!of_part->pixels) {
            fputs("\n    {NULL, NULL, 0, 0, 0, false},", out);
            continue;
        }
        fprintf(out, "\n    {%s_texture%u, ", name, number);
        if (of_part->palette)
            fprintf(out, "%s_palette%u, ", name, number);
        else
            fputs("NULL, ", out);
        fprintf(out, "%u, %u, %u, %s},", of_part->w, of_part->h, of_part->levels,
                of_part->is_smooth ? "true" : "false");
    }
    fputs("\n};\n", out);
}

/* ---- all of it ---- */

/* Everything that is defined; its storage is "static ", or "" where the header declares it. */
static void write_all(const struct baked_mesh *baked, const char *storage, const char *name, FILE *out)
{
    const struct glint_mesh *mesh = mesh_of(baked);
    const bool parts = mesh->part_count > 1;
    write_array(baked, "static ", "int16_t", name, "_places", (size_t)3 * mesh->vertex_count, place_at, out);
    write_array(baked, "static ", baked->normals8 ? "int8_t" : "int16_t", name, "_normals",
                (size_t)3 * mesh->vertex_count, normal_at, out);
    write_array(baked, "static ", "uint16_t", name, "_faces", (size_t)3 * mesh->face_count, corner_at, out);
    if (mesh->neighbours)
        write_array(baked, "static ", "uint16_t", name, "_neighbours", (size_t)3 * mesh->face_count, neighbour_at, out);
    if (parts)
        write_array(baked, "static ", "uint16_t", name, "_ends", mesh->part_count, end_at, out);
    if (baked->fitted->colors)
        write_array(baked, "static ", "uint8_t", name, "_colors", (size_t)3 * mesh->vertex_count, color_at, out);
    if (mesh->textures) {
        write_array(baked, "static ", "uint16_t", name, "_uv", (size_t)2 * mesh->vertex_count, uv_at, out);
        write_textures(baked, name, out);
    }
    write_materials(baked, storage, name, out);
    fprintf(out, "\n%sconst struct glint_mesh %s = {\n    %s_places, %s%s%s, %s_faces, ", storage, name, name,
            baked->normals8 ? "NULL, " : "", name, baked->normals8 ? "_normals" : "_normals, NULL", name);
    if (parts)
        fprintf(out, "%s_ends, ", name);
    else
        fputs("NULL, ", out);
    fprintf(out, "%u, %u, %u, ", mesh->vertex_count, mesh->face_count, parts ? mesh->part_count : 0u);
    if (baked->fitted->colors)
        fprintf(out, "%s_colors, NULL, ", name);
    else
        fputs("NULL, NULL, ", out);
    if (mesh->textures)
        fprintf(out, "%s_textures, %s_uv, %u, ", name, name, mesh->uv_bits);
    else
        fputs("NULL, NULL, 0, ", out);
    fprintf(out, "%s, ", mesh->textures || baked->fitted->colors ? "&glint_use_mesh_albedo" : "NULL");
    if (mesh->neighbours)
        fprintf(out, "%s_neighbours, ", name);
    else
        fputs("NULL, ", out);
    fprintf(out, "{%d, %d, %d}, NULL};\n", mesh->grain[0], mesh->grain[1], mesh->grain[2]);
}

void bake_mesh_write_c(const struct baked_mesh *baked, const char *name, FILE *out)
{
    write_note(baked, out);
    fputs("#include <stddef.h>\n\n#include \"glint_mesh.h\"\n", out);
    fprintf(out, "\nenum { %s_parts = %u };\n", name, mesh_of(baked)->part_count);
    write_all(baked, "static ", name, out);
}

void bake_mesh_write_header(const struct baked_mesh *baked, const char *name, FILE *out)
{
    const struct c_capitals capitals = c_capitals(name);
    const char *macro = capitals.text;
    const struct glint_mesh *mesh = mesh_of(baked);
    write_note(baked, out);
    c_begin_header(name, "<stddef.h>\n\n#include \"glint_mesh.h\"", out);
    fprintf(
        out,
        "\n#define %s_VERTICES %u\n#define %s_FACES %u\n#define %s_PARTS %u /* each with a material, and a paint of "
        "glint_mesh_add's */\n",
        macro, mesh->vertex_count, macro, mesh->face_count, macro, mesh->part_count);
    c_begin_externs(out);
    fprintf(out, "extern const struct glint_mesh %s;\nextern const struct glint_material %s_materials[%s_PARTS];\n",
            name, name, macro);
    c_end_externs(out);
    c_end_header(out);
}

void bake_mesh_write_definitions(const struct baked_mesh *baked, const char *name, const char *header, FILE *out)
{
    write_note(baked, out);
    fprintf(out, "#include \"%s\"\n", header);
    write_all(baked, "", name, out);
}

/* ---- bytes ---- */

static uint8_t *put(uint8_t *at, unsigned value, unsigned bytes)
{
    for (unsigned i = 0; i < bytes; i++)
        *at++ = (uint8_t)(value >> 8 * i);
    return at;
}

static uint8_t *put_all(uint8_t *at, const struct baked_mesh *baked, size_t count, value_at *value, unsigned bytes)
{
    for (size_t i = 0; i < count; i++)
        at = put(at, (unsigned)value(baked, i), bytes);
    return at;
}

enum { RAW_COLORS = 256, RAW_NEIGHBOURS = 512, RAW_TEXTURES = 1024 };

/* Of all textures with their numbers. */
static size_t raw_texture_bytes(const struct baked_mesh *baked)
{
    size_t sum = 4 + (size_t)4 * mesh_of(baked)->vertex_count + (size_t)4 * mesh_of(baked)->part_count;
    for (unsigned i = 0; i < baked->fitted->texture_count; i++) {
        const struct texture *texture = texture_number(baked, i);
        sum += 8 + (texture ? (texture_bytes(texture) + 1) / 2 * 2 : 0);
    }
    return sum;
}

static uint8_t *put_textures(uint8_t *at, const struct baked_mesh *baked)
{
    const struct glint_mesh *mesh = mesh_of(baked);
    at = put(at, mesh->uv_bits, 2);
    at = put(at, baked->fitted->texture_count, 2);
    at = put_all(at, baked, (size_t)2 * mesh->vertex_count, uv_at, 2);
    for (unsigned i = 0; i < mesh->part_count; i++) {
        at = put(at, mesh->textures[i].pixels ? baked->mesh->materials[i].picture : 0, 2);
        at = put(at, mesh->textures[i].is_smooth, 2);
    }
    for (unsigned i = 0; i < baked->fitted->texture_count; i++) {
        const struct texture *texture = texture_number(baked, i);
        const size_t pixels = texture ? texture_pixels(texture) : 0;
        at = put(at, texture ? texture->texture.w : 0, 2);
        at = put(at, texture ? texture->texture.h : 0, 2);
        at = put(at, texture ? texture->texture.levels : 0, 2);
        at = put(at, texture ? texture->colors : 0, 2);
        for (unsigned j = 0; texture && j < texture->colors; j++)
            at = put(at, texture->palette[j], 2);
        for (size_t j = 0; j < pixels; j++)
            at = texture->colors ? put(at, texture->indices[j], 1) : put(at, texture->pixels[j], 2);
        at = put(at, 0, texture && texture->colors && pixels % 2);
    }
    return at;
}

uint8_t *bake_mesh_raw(const struct baked_mesh *baked, size_t *len)
{
    const struct glint_mesh *mesh = mesh_of(baked);
    const size_t vertices = (size_t)3 * mesh->vertex_count, corners = (size_t)3 * mesh->face_count;
    const unsigned normal = baked->normals8 ? 1 : 2;
    const bool odd = (vertices * normal) % 2, has_colors = baked->fitted->colors != NULL;
    const bool has_textures = mesh->textures != NULL, colors_odd = has_textures && has_colors && vertices % 2;
    const size_t neighbours = mesh->neighbours ? corners : 0;
    *len = 8 + 2 * vertices + normal * vertices + odd + 2 * corners + 2 * neighbours + (size_t)6 * mesh->part_count +
           (has_colors ? vertices : 0) + colors_odd + (has_textures ? raw_texture_bytes(baked) : 0);
    uint8_t *bytes = allocate(*len, 1), *at = bytes;
    at = put(at, mesh->vertex_count, 2);
    at = put(at, mesh->face_count, 2);
    at = put(at, mesh->part_count, 2);
    at = put(at,
             normal + (has_colors ? RAW_COLORS : 0) + (neighbours ? RAW_NEIGHBOURS : 0) +
                 (has_textures ? RAW_TEXTURES : 0),
             2);
    at = put_all(at, baked, vertices, place_at, 2);
    at = put_all(at, baked, vertices, normal_at, normal);
    at = put(at, 0, odd);
    at = put_all(at, baked, corners, corner_at, 2);
    at = put_all(at, baked, neighbours, neighbour_at, 2);
    at = put_all(at, baked, mesh->part_count, end_at, 2);
    for (unsigned i = 0; i < mesh->part_count; i++) {
        for (int k = 0; k < 3; k++)
            at = put(at, baked->materials[i].albedo[k], 1);
        at = put(at, baked->mesh->materials[i].unlit, 1);
    }
    if (has_colors)
        at = put_all(at, baked, vertices, color_at, 1);
    at = put(at, 0, colors_odd);
    if (has_textures)
        put_textures(at, baked);
    return bytes;
}
