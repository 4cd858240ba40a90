/* SPDX-License-Identifier: MIT */
#include "mesh/import_texture.h"

#if GLINT_WITH_MESH
#include <assimp/scene.h>
#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
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

/* Names are written as on the other system, too. */
static void use_slashes(char *name)
{
    for (; *name; name++)
        if (*name == '\\')
            *name = '/';
}

static bool leads_out(const char *name)
{
    if (name[0] == '/' || (isalpha((unsigned char)name[0]) && name[1] == ':') || strstr(name, "://"))
        return true;
    for (const char *at = name; at; at = strchr(at, '/')) {
        at += *at == '/';
        if (strncmp(at, "..", 2) == 0 && (at[2] == '/' || !at[2]))
            return true;
    }
    return false;
}

/* %20 and the like, which a glTF may have; in place. */
static void decode_percents(char *name)
{
    char *to = name;
    for (const char *at = name; *at; at++) {
        char digits[3] = "";
        if (at[0] == '%' && at[1]) {
            digits[0] = at[1];
            digits[1] = at[2];
        }
        const bool is_code = isxdigit((unsigned char)digits[0]) && isxdigit((unsigned char)digits[1]);
        *to++ = *at;
        if (is_code) {
            to[-1] = (char)strtoul(digits, NULL, 16);
            at += 2;
        }
    }
    *to = 0;
}

static bool is_below(const char *path, const char *folder)
{
    const size_t len = strlen(folder);
    return strncmp(path, folder, len) == 0 && (path[len] == '/' || strcmp(folder, "/") == 0);
}

/* Without links. NULL, and errno, where there is no such file; or `outside`. */
static const char outside[] = "it lies outside the mesh's folder; put it beside the mesh";
static char *whole_path(const char *folder, const char *name, const char **wrong)
{
    char *path, *real;
    *wrong = NULL;
    if (leads_out(name)) {
        *wrong = outside;
        return NULL;
    }
    if (asprintf(&path, "%s/%s", folder, name) < 0)
        _exit(1);
    real = realpath(path, NULL);
    free(path);
    if (!real)
        *wrong = strerror(errno);
    else if (!is_below(real, folder))
        *wrong = outside;
    if (!*wrong)
        return real;
    free(real);
    return NULL;
}

static void read_file(struct import_found *found, const char *path)
{
    struct stat status;
    size_t len;
    if (stat(path, &status) != 0 || !S_ISREG(status.st_mode)) {
        refuse(found, "it is not a regular file");
        return;
    }
    if (status.st_size > IMPORT_PICTURE_BYTES) {
        refuse(found, "it has too many bytes; save a smaller picture");
        return;
    }
    FILE *stream = import_files_open(path, &len);
    if (!stream) {
        refuse(found, "it cannot be opened");
        return;
    }
    uint8_t *bytes = allocate(len + 1, 1);
    found->head.len = fread(bytes, 1, len, stream);
    found->bytes = bytes;
    fclose(stream);
}

static char *folder_of(const char *path)
{
    char real[PATH_MAX];
    const char *slash = strrchr(path, '/');
    snprintf(real, sizeof real, "%.*s", slash ? (int)(slash - path) + 1 : 1, slash ? path : ".");
    return realpath(real, NULL);
}

static void take_file(const struct import_source *source, struct import_found *found)
{
    const char *wrong = NULL;
    char *name = strdup(found->key), *folder = source->path ? folder_of(source->path) : NULL, *path = NULL;
    if (!name)
        _exit(1);
    snprintf(found->head.name, sizeof found->head.name, "%.*s", (int)sizeof found->head.name - 1, name);
    use_slashes(name);
    if (!source->path)
        wrong = "it is a file, and the mesh comes from standard input; name the mesh's file";
    else if (!folder)
        wrong = strerror(errno);
    else
        path = whole_path(folder, name, &wrong);
    if (!path && folder && strchr(name, '%')) {
        decode_percents(name);
        path = whole_path(folder, name, &wrong);
    }
    if (path)
        read_file(found, path);
    else
        refuse(found, wrong);
    free(path);
    free(folder);
    free(name);
}

/* ---- both ---- */

unsigned import_pictures_find(struct import_pictures *pictures, const char *name)
{
    for (unsigned i = 0; i < pictures->count; i++)
        if (strcmp(pictures->of[i].key, name) == 0)
            return i;
    struct import_found *found = &pictures->of[pictures->count];
    *found = (struct import_found){.key = strdup(name)};
    if (!found->key)
        _exit(1);
    if (name[0] == '*')
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
