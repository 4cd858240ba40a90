/* SPDX-License-Identifier: MIT */
#include "mesh/import_obj.h"

#if GLINT_WITH_MESH
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/child.h"
#include "base/memory.h"
#include "glint_mesh.h"
#include "mesh/import_child.h"
#include "mesh/import_files.h"
#include "mesh/import_texture.h"
#include "mesh/obj.h"
#include "mesh/obj_materials.h"

enum { LIBRARY_BYTES = 1 << 24 };

static const struct import_source *mesh;
static char notes[sizeof((struct import_head *)NULL)->notes];
static const char *why_missing; /* the last MTL that could not be read */

/* Each once, and no more than there is room for. */
static void add_note(const char *text)
{
    const size_t len = strlen(notes);
    char line[320];
    snprintf(line, sizeof line, "%.300s", text);
    for (char *at = line; *at; at++)
        if (*at == '\n')
            *at = ' ';
    strcat(line, "\n");
    if (!strstr(notes, line) && len + strlen(line) < sizeof notes)
        strcpy(notes + len, line);
}

static bool read_library(struct obj_materials *materials, const char *name)
{
    const char *why;
    size_t len = 0;
    FILE *stream = import_files_open_named(mesh, name, &len, &why);
    if (stream && len > LIBRARY_BYTES) {
        fclose(stream);
        stream = NULL;
        why = "it has more than 16 MB";
    }
    if (!stream) {
        why_missing = why;
        return false;
    }
    char *text = import_files_read_all(stream, &len);
    obj_materials_read(materials, text, len);
    free(text);
    return true;
}

/* The mesh has plain colours. */
static void miss_library(const char *name)
{
    char text[300];
    snprintf(text, sizeof text, "names %.*s, which is left out: %s", 150, name, why_missing);
    add_note(text);
}

static struct soup *read_mesh(char wrong[120])
{
    struct obj_source from = {mesh->bytes, mesh->len, mesh->textures, read_library, miss_library, add_note};
    const char *why = NULL;
    FILE *stream = mesh->path ? import_files_open(mesh->path, &from.len, &why) : NULL;
    if (why) {
        snprintf(wrong, 120, "%s", why);
        return NULL;
    }
    char *bytes = stream ? import_files_read_all(stream, &from.len) : NULL;
    if (bytes)
        from.text = bytes;
    struct soup *soup = obj_soup(&from, wrong);
    free(bytes);
    return soup;
}

const char *import_obj(const struct import_source *source, int out)
{
    static char wrong[120];
    const struct import_file *files;
    mesh = source;
    import_files(source);
    struct soup *soup = read_mesh(wrong);
    if (!soup)
        return wrong;
    struct import_pictures pictures = {NULL, source, 0, allocate(soup->picture_count + 1, sizeof *pictures.of)};
    for (unsigned i = 0; i < soup->picture_count; i++)
        import_pictures_find(&pictures, soup->pictures[i].name);
    struct import_head head = {.face_count = soup->face_count,
                               .part_count = soup->part_count,
                               .file_count = import_files_read(&files),
                               .picture_count = pictures.count,
                               .has_normals = soup->has_normals,
                               .has_uv = soup->has_uv,
                               .has_colors = soup->has_colors};
    memcpy(head.notes, notes, sizeof head.notes);
    child_send(out, &head, sizeof head);
    child_send(out, files, head.file_count * sizeof *files);
    if (!soup->faces)
        return NULL; /* the parent says why */
    child_send(out, soup->materials, soup->part_count * sizeof *soup->materials);
    import_pictures_send(&pictures, out);
    child_send(out, soup->faces, soup->face_count * sizeof *soup->faces);
    return NULL;
}

#else

const char *import_obj(const struct import_source *source, int out)
{
    (void)source;
    (void)out;
    return NULL;
}

#endif
