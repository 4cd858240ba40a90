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
static char refused[200]; /* the first file elsewhere that it names */

/* One that is not there is no error: the mesh has plain colours. */
static void read_library(struct obj_materials *materials, const char *name)
{
    const char *wrong;
    size_t len = 0;
    FILE *stream = import_files_open_named(mesh, name, &len, &wrong);
    if (!stream && wrong == import_files_outside(mesh) && !refused[0])
        snprintf(refused, sizeof refused, "%s", name);
    if (!stream)
        return;
    if (len > LIBRARY_BYTES)
        len = LIBRARY_BYTES;
    char *text = import_files_read_all(stream, &len);
    obj_materials_read(materials, text, len);
    free(text);
}

static struct soup *read_mesh(char wrong[120])
{
    struct obj_source from = {mesh->bytes, mesh->len, mesh->textures, read_library};
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
    memcpy(head.refused, refused, sizeof head.refused);
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
