/* SPDX-License-Identifier: MIT */
#include "mesh/obj.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "glint_mesh.h"
#include "mesh/lines.h"
#include "mesh/obj_materials.h"
#include "mesh/polygon.h"

/* What a face's corner names; the same order everywhere. */
enum { PLACE, UV, NORMAL, KINDS };

struct list {
    void *of;
    size_t count, room;
};
struct numbers {
    double at[3]; /* places far from the origin are not steps */
    float color[3];
    bool has_color;
};
struct corner {
    uint32_t of[KINDS]; /* from 1; 0: none */
};
struct face {
    size_t first, count; /* corners */
    unsigned material;   /* OBJ_MATERIALS_MAX: none */
    unsigned long line;
};
struct obj {
    struct lines lines;
    struct list numbers[KINDS], corners, faces;
    size_t triangles;
    float brightest; /* of the vertices' colours */
    struct obj_materials materials;
    unsigned material; /* now */
};

static const struct kind {
    const char *name, *what;
    unsigned min, max;
} kinds[KINDS] = {
    {"v", "a vertex has three numbers, or six with its colour", 3, 7},
    {"vt", "a place in a texture has two numbers", 1, 3},
    {"vn", "a normal has three numbers", 3, 3},
};
static const char face_wrong[] = "a face has numbers of vertices, which count from 1, or from -1 back";

/* Room for one more, which is zero. */
static void *more(struct list *list, size_t size)
{
    if (list->count == list->room) {
        list->room = list->room ? 2 * list->room : 64;
        list->of = enlarge(list->of, list->room, size);
    }
    return memset((char *)list->of + size * list->count++, 0, size);
}

/* ---- lines ---- */

/* The fourth of four numbers divides the others; of seven it is an alpha. */
static bool take_numbers(struct obj *obj, unsigned kind, char *rest)
{
    double n[8];
    unsigned count = 0;
    for (const char *word; count < 8 && (word = lines_word(&rest)); count++)
        if (!lines_number(word, &n[count]))
            return false;
    if (count < kinds[kind].min || count > kinds[kind].max || (kind == PLACE && count == 5) ||
        (kind == PLACE && count == 4 && n[3] == 0))
        return false;
    struct numbers *to = more(&obj->numbers[kind], sizeof *to);
    for (unsigned k = 0; k < 3 && k < count; k++)
        to->at[k] = kind == PLACE && count == 4 ? n[k] / n[3] : n[k];
    to->has_color = count >= 6;
    for (int k = 0; k < 3 && to->has_color; k++) {
        to->color[k] = (float)n[3 + k];
        obj->brightest = fmaxf(obj->brightest, to->color[k]);
    }
    return true;
}

/* V, V/VT, V//VN or V/VT/VN. */
static bool take_corner(const struct obj *obj, char *word, struct corner *corner)
{
    *corner = (struct corner){{0}};
    for (int i = 0; i < KINDS && word; i++) {
        char *slash = strchr(word, '/'), *end;
        if (slash)
            *slash = 0;
        const long long index = strtoll(word, &end, 10);
        const long long place = index < 0 ? (long long)obj->numbers[i].count + 1 + index : index;
        if (*end || (i == PLACE && !*word) || (*word && (place < 1 || place > UINT32_MAX)))
            return false;
        corner->of[i] = *word ? (uint32_t)place : 0;
        word = slash ? slash + 1 : NULL;
    }
    return !word; /* not a fourth one */
}

/* Points and lines are not drawn, and what is beyond the most triangles is counted only. */
static bool take_face(struct obj *obj, char *rest)
{
    struct face face = {obj->corners.count, 0, obj->material, obj->lines.number};
    for (char *word; (word = lines_word(&rest)); face.count++) {
        struct corner corner;
        if (!take_corner(obj, word, &corner))
            return false;
        memcpy(more(&obj->corners, sizeof corner), &corner, sizeof corner);
    }
    if (face.count > 2)
        obj->triangles += face.count - 2;
    if (face.count > 2 && obj->triangles <= GLINT_MESH_FACES_MAX)
        memcpy(more(&obj->faces, sizeof face), &face, sizeof face);
    else
        obj->corners.count = face.first;
    return true;
}

/* One name, which may hold blanks, or several; where none can be read it was one. A file may be named thousands of times. */
static void take_libraries(struct obj *obj, const struct obj_source *source, const char *names)
{
    enum { MOST_MB = 64 };
    const char *missing = NULL;
    if (obj->materials.bytes >> 20 >= MOST_MB) {
        source->note("names more than 64 MB of materials; what comes then is left out");
        return;
    }
    bool found = source->library(&obj->materials, names);
    char *copy = found ? NULL : copied(names), *at = copy;
    for (const char *name; at && (name = lines_word(&at));) {
        const bool good = source->library(&obj->materials, name);
        missing = missing || good ? missing : name;
        found |= good;
    }
    if (!found || missing)
        source->missing(found ? missing : names);
    free(copy);
}

/* Returns what is wrong, or NULL. */
static const char *take_line(struct obj *obj, const struct obj_source *source)
{
    char *rest;
    for (unsigned i = 0; i < KINDS; i++)
        if (lines_begins(&obj->lines, kinds[i].name, &rest))
            return take_numbers(obj, i, rest) ? NULL : kinds[i].what;
    if (lines_begins(&obj->lines, "f", &rest))
        return take_face(obj, rest) ? NULL : face_wrong;
    if (lines_begins(&obj->lines, "usemtl", &rest)) {
        obj->material = *rest ? obj_materials_find(&obj->materials, rest) : OBJ_MATERIALS_MAX;
        return *rest && obj->material == OBJ_MATERIALS_MAX ? "it uses too many materials; join some" : NULL;
    }
    if (lines_begins(&obj->lines, "mtllib", &rest) && *rest)
        take_libraries(obj, source, rest);
    return NULL;
}

/* A face may name what comes later. */
static const char *check_corners(struct obj *obj)
{
    const struct face *faces = obj->faces.of;
    const struct corner *corners = obj->corners.of;
    for (size_t i = 0; i < obj->faces.count; i++)
        for (size_t k = 0; k < KINDS * faces[i].count; k++)
            if (corners[faces[i].first + k / KINDS].of[k % KINDS] > obj->numbers[k % KINDS].count) {
                obj->lines.number = faces[i].line;
                return "a face names what the file does not have";
            }
    return NULL;
}

/* ---- triangles ---- */

static const struct numbers *named(const struct obj *obj, const struct corner *corner, unsigned kind)
{
    const struct numbers *of = obj->numbers[kind].of;
    return corner->of[kind] ? &of[corner->of[kind] - 1] : NULL;
}

/* A corner without a normal has none of length 1. */
static void look_for(const struct obj *obj, struct soup *soup)
{
    const struct corner *corners = obj->corners.of;
    const struct numbers *places = obj->numbers[PLACE].of;
    for (size_t i = 0; i < obj->corners.count; i++) {
        soup->has_normals |= corners[i].of[NORMAL] != 0;
        soup->has_uv |= corners[i].of[UV] != 0;
    }
    for (size_t i = 0; i < obj->numbers[PLACE].count; i++)
        soup->has_colors |= places[i].has_color;
}

/* By what its map_Kd says; v down. */
static void lead(const struct obj_material *material, const struct numbers *place, double uv[2])
{
    for (int k = 0; k < 2; k++)
        uv[k] = material ? material->scale[k] * place->at[k] + material->move[k] : place->at[k];
    uv[1] = 1 - uv[1];
}

/* Colours go to 1, or to 255 where one is far above 1. */
static uint8_t level_of(const struct obj *obj, float part)
{
    return mesh_level(obj->brightest >= 2 ? (double)part / 255 : (double)part);
}

/* A vertex without a colour has its material's. */
static void set_corner(const struct obj *obj, const struct soup *soup, const struct corner *corner,
                       const struct obj_material *material, struct soup_face *face, int at)
{
    const struct numbers *place = named(obj, corner, PLACE), *uv = named(obj, corner, UV),
                         *normal = named(obj, corner, NORMAL);
    for (int k = 0; k < 3; k++) {
        face->places[at][k] = place->at[k];
        face->normals[at][k] = normal ? normal->at[k] : 0;
        face->colors[at][k] = !soup->has_colors  ? 0
                              : place->has_color ? level_of(obj, place->color[k])
                                                 : soup->materials[face->part].color[k];
    }
    if (uv)
        lead(material, uv, face->uv[at]);
}

/* Returns what is wrong, or NULL. */
static const char *set_faces(struct obj *obj, struct soup *soup, bool textures)
{
    struct soup_face *to = soup->faces;
    for (size_t i = 0; i < obj->faces.count; i++) {
        const struct face *face = (const struct face *)obj->faces.of + i;
        const struct corner *corners = (const struct corner *)obj->corners.of + face->first;
        const struct obj_material *material =
            face->material < OBJ_MATERIALS_MAX ? &obj->materials.of[face->material] : NULL;
        const unsigned part = material ? material->part : 0;
        double(*places)[3] = allocate(face->count, sizeof *places);
        size_t(*triangles)[3] = allocate(face->count - 2, sizeof *triangles);
        for (size_t k = 0; k < 3 * face->count; k++)
            places[k / 3][k % 3] = named(obj, &corners[k / 3], PLACE)->at[k % 3];
        const bool is_cut = polygon_cut((const double(*)[3])places, face->count, triangles);
        for (size_t k = 0; is_cut && k < face->count - 2; k++, to++) {
            to->part = (part ? part : soup->part_count) - 1;
            for (int j = 0; j < 3; j++)
                set_corner(obj, soup, &corners[triangles[k][j]], textures ? material : NULL, to, j);
        }
        free(places);
        free(triangles);
        if (!is_cut) {
            obj->lines.number = face->line;
            return "a face has too many corners and dents; cut it into triangles";
        }
    }
    return NULL;
}

static void obj_free(struct obj *obj)
{
    for (int i = 0; i < KINDS; i++)
        free(obj->numbers[i].of);
    free(obj->corners.of);
    free(obj->faces.of);
    obj_materials_free(&obj->materials);
    lines_end(&obj->lines);
}

struct soup *obj_soup(const struct obj_source *source, char wrong[120])
{
    struct obj obj = {.material = OBJ_MATERIALS_MAX, .materials.note = source->note};
    const char *what = NULL;
    struct soup *soup = NULL;
    lines_begin(&obj.lines, source->text, source->len);
    while (!what && lines_next(&obj.lines))
        what = take_line(&obj, source);
    if (!what)
        what = check_corners(&obj);
    if (!what) {
        soup = allocate(1, sizeof *soup);
        soup->face_count = obj.triangles;
        look_for(&obj, soup);
        obj_materials_give(&obj.materials, soup, source->textures);
    }
    if (soup && obj.triangles > 0 && obj.triangles <= GLINT_MESH_FACES_MAX) {
        soup->faces = allocate(obj.triangles, sizeof *soup->faces);
        what = set_faces(&obj, soup, source->textures);
    }
    if (what) {
        snprintf(wrong, 120, "line %lu: %s", obj.lines.number, what);
        soup_free(soup);
        soup = NULL;
    }
    obj_free(&obj);
    return soup;
}
