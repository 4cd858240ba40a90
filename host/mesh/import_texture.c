/* SPDX-License-Identifier: MIT */
#include "mesh/import_texture.h"

#if GLINT_WITH_MESH
#include <assimp/scene.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "mesh/import_child.h"
#include "mesh/import_files.h"
#include "mesh/import_picture.h"
#include "base/child.h"

static void refuse(struct import_found *found, const char *text)
{
    snprintf(found->head.message, sizeof found->head.message, "%s", text);
}

/* ---- what the mesh holds: "*NUMBER" ---- */

static void take_held(const struct aiScene *scene, struct import_found *found)
{
    const unsigned long i = strtoul(found->key + 1, NULL, 10);
    const struct aiTexture *held = i < scene->mNumTextures ? scene->mTextures[i] : NULL;
    snprintf(found->head.name, sizeof found->head.name, "%lu", i + 1);
    if (held && held->mFilename.length)
        snprintf(found->head.name, sizeof found->head.name, "%.*s", (int)sizeof found->head.name - 1,
                 held->mFilename.data);
    if (!held || held->mHeight) /* pixels as they are, which no format here has */
        refuse(found, "the mesh does not hold it");
    else if (held->mWidth > IMPORT_PICTURE_BYTES)
        refuse(found, "it has too many bytes; save a smaller picture");
    else {
        found->bytes = held->pcData;
        found->head.len = held->mWidth;
    }
}

/* ---- files ---- */

static void read_file(struct import_found *found, FILE *stream, size_t len)
{
    if (len > IMPORT_PICTURE_BYTES) {
        refuse(found, "it has too many bytes; save a smaller picture");
        return;
    }
    uint8_t *bytes = allocate(len + 1, 1);
    found->head.len = fread(bytes, 1, len, stream);
    found->bytes = bytes;
}

static void take_file(const struct import_source *source, struct import_found *found)
{
    const char *wrong = NULL;
    size_t len = 0;
    snprintf(found->head.name, sizeof found->head.name, "%.*s", (int)sizeof found->head.name - 1, found->key);
    FILE *stream = import_files_open_named(source, found->key, &len, &wrong);
    if (stream) {
        read_file(found, stream, len);
        fclose(stream);
    } else {
        refuse(found, wrong);
    }
}

/* ---- both ---- */

unsigned import_pictures_find(struct import_pictures *pictures, const char *name)
{
    for (unsigned i = 0; i < pictures->count; i++)
        if (strcmp(pictures->of[i].key, name) == 0)
            return i;
    struct import_found *found = &pictures->of[pictures->count];
    *found = (struct import_found){.key = copied(name)};
    if (name[0] == '*' && pictures->scene)
        take_held(pictures->scene, found);
    else
        take_file(pictures->source, found);
    return pictures->count++;
}

void import_pictures_send(const struct import_pictures *pictures, int out)
{
    for (unsigned i = 0; i < pictures->count; i++) {
        child_send(out, &pictures->of[i].head, sizeof pictures->of[i].head);
        child_send(out, pictures->of[i].bytes, pictures->of[i].head.len);
    }
}

#endif
