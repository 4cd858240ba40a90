/* SPDX-License-Identifier: MIT */
#include "mesh/import_source.h"

#if GLINT_WITH_MESH
#include <ctype.h>
#include <errno.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "mesh/stl_check.h"

enum { FILE_MAX_MB = 256, FIRST_BYTES = 1 << 16 };
static const char obj[] = ".obj", stl[] = ".stl", ply[] = ".ply", gltf[] = ".gltf", glb[] = ".glb";
static const char *const endings[] = {obj, stl, ply, gltf, glb};

/* ---- files ---- */

static const char *ending_of(const char *path)
{
    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof endings / sizeof *endings; i++)
        if (strcasecmp(dot, endings[i]) == 0)
            return endings[i];
    fail("%s: a mesh's name ends in .obj, .stl, .ply, .gltf or .glb; rename it, or export it in one of these formats",
         path);
}

static size_t utf8_mark_len(const char *bytes, size_t len)
{
    return len >= 3 && memcmp(bytes, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
}

/* What is in UTF-16, as some shells write what is sent into a file, none of the readers takes for text. */
static size_t mark_len(const char *name, const char *bytes, size_t len)
{
    const bool is_low = len >= 4 && memcmp(bytes, "\xFF\xFE", 2) == 0 && bytes[2] && !bytes[3];
    if (is_low || (len >= 4 && memcmp(bytes, "\xFE\xFF", 2) == 0 && !bytes[2] && bytes[3]))
        fail("%s: is text in UTF-16; save it as UTF-8", name);
    return utf8_mark_len(bytes, len);
}

/* For what does not begin as its name says libassimp looks among all its readers, and no check of ours fits these. STL and PLY have one reader each, by
 * name. */
static void check_beginning(const char *path, const char *ending)
{
    char bytes[256] = "";
    FILE *file = fopen(path, "rb");
    if (!file)
        return; /* or the child says why it cannot be opened */
    const size_t len = fread(bytes, 1, sizeof bytes, file);
    const char *at = bytes, *const end = bytes + len;
    fclose(file);
    at += mark_len(path, bytes, len);
    while (at < end && isspace((unsigned char)*at))
        at++;
    if ((ending == gltf && (at == end || *at != '{')) || (ending == glb && memcmp(bytes, "glTF", 4) != 0))
        fail("%s: does not begin as a %s does; give it the ending of its format", path, ending);
}

static void check_file(const char *path)
{
    struct stat status;
    if (stat(path, &status) != 0)
        fail("%s: %s", path, strerror(errno));
    if (!S_ISREG(status.st_mode))
        fail("%s: this is not a regular file; name a mesh", path);
    if (status.st_size == 0)
        fail("%s: this file is empty; name a mesh", path);
    if (status.st_size > (off_t)FILE_MAX_MB << 20)
        fail("%s: this file has more than %d MB; simplify the mesh", path, FILE_MAX_MB);
}

/* ---- standard input ---- */

static void read_input(struct import_source *source)
{
    const size_t max = (size_t)FILE_MAX_MB << 20;
    size_t room = FIRST_BYTES, got;
    source->bytes = allocate(room, 1);
    while ((got = fread(source->bytes + source->len, 1, room - source->len, stdin)) > 0) {
        source->len += got;
        if (source->len > max)
            fail("%s: has more than %d MB; simplify the mesh", source->name, FILE_MAX_MB);
        if (source->len < room)
            continue;
        room *= 2;
        source->bytes = enlarge(source->bytes, room, 1);
    }
    if (ferror(stdin))
        fail("%s: could not be read: %s", source->name, strerror(errno));
    if (source->len == 0)
        fail("%s: is empty; send a mesh", source->name);
}

/* Whether a line begins with `word`, after blanks, and a blank follows. */
static bool has_line(const struct import_source *source, const char *word)
{
    const char *at = source->bytes, *const end = at + source->len;
    const size_t len = strlen(word);
    while (at < end) {
        while (at < end && isspace((unsigned char)*at))
            at++;
        if ((size_t)(end - at) > len && strncasecmp(at, word, len) == 0 && isspace((unsigned char)at[len]))
            return true;
        while (at < end && *at != '\n' && *at != '\r')
            at++;
    }
    return false;
}

/* By what each format's files begin with; an OBJ may begin with anything, but has a line of a vertex. */
static const char *ending_by_bytes(const struct import_source *source)
{
    const char *at = source->bytes, *const end = at + source->len;
    const size_t len = source->len;
    if (len >= 4 && memcmp(at, "glTF", 4) == 0)
        return glb;
    const char *const ply_at = at + utf8_mark_len(at, len);
    if (end - ply_at >= 4 && memcmp(ply_at, "ply", 3) == 0 && isspace((unsigned char)ply_at[3]))
        return ply;
    if (stl_binary_len(at, len)) /* no text: its count would be of more than may be sent */
        return stl;
    at += mark_len(source->name, at, len);
    while (at < end && isspace((unsigned char)*at))
        at++;
    const bool is_solid = end - at > 5 && strncasecmp(at, "solid", 5) == 0 && isspace((unsigned char)at[5]);
    if (is_solid || (has_line(source, "facet") && has_line(source, "vertex")))
        return stl;
    if (memchr(source->bytes, 0, len) == NULL) {
        if (at < end && *at == '{')
            return gltf;
        if (has_line(source, "v"))
            return obj;
    }
    fail("%s: this is not an OBJ, STL, PLY or glTF; send a mesh, or name its file", source->name);
}

/* ---- both ---- */

struct import_source *import_source_open(const char *path)
{
    struct import_source *source = allocate(1, sizeof *source);
    if (strcmp(path, "-") == 0) {
        source->name = "standard input";
        output_never(stdin);
        read_input(source);
        source->ending = ending_by_bytes(source);
    } else {
        *source = (struct import_source){.name = path, .path = path, .ending = ending_of(path)};
        check_file(path);
        check_beginning(path, source->ending);
    }
    return source;
}

void import_source_free(struct import_source *source)
{
    free(source->bytes);
    free(source);
}

#endif
