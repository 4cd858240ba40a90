/* SPDX-License-Identifier: MIT */
#include "mesh/import_files.h"

#if GLINT_WITH_MESH
#include <assimp/cfileio.h>
#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"

const char import_files_input[] = "standard input";
static const struct import_source *source;
static struct import_file read_files[IMPORT_FILES_MAX];
static unsigned read_count;

struct opened {
    struct aiFile file; /* first: libassimp knows the address of this */
    FILE *stream;
    size_t len;
};

static bool remember(const struct stat *status)
{
    const struct import_file file = {status->st_dev, status->st_ino};
    for (unsigned i = 0; i < read_count; i++)
        if (read_files[i].device == file.device && read_files[i].number == file.number)
            return true;
    if (read_count == IMPORT_FILES_MAX)
        return false;
    read_files[read_count++] = file;
    return true;
}

/* ---- which files may be read: the mesh, and what lies in its folder or in the one that the user allows, or below them ---- */

static const char *outside;    /* what is wrong with a file elsewhere */
static char *roots[2];         /* without links */
static struct stat mesh;       /* which the user names: it may be a link to anywhere */
static char refused[PATH_MAX]; /* the first one that libassimp asked for */

static char *folder_of(const char *path)
{
    char folder[PATH_MAX];
    const char *slash = strrchr(path, '/');
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - path) + 1 : 1, slash ? path : ".");
    return realpath(folder, NULL);
}

static bool is_below(const char *path, const char *folder)
{
    const size_t len = strlen(folder);
    return strncmp(path, folder, len) == 0 && (path[len] == '/' || strcmp(folder, "/") == 0);
}

/* By the name that the system has for what was opened, after all links: nothing can change between this and the reading. */
static bool is_allowed(const char *of_descriptor)
{
    char real[PATH_MAX];
    const ssize_t len = readlink(of_descriptor, real, sizeof real - 1);
    real[len < 0 ? 0 : len] = 0;
    for (size_t i = 0; i < sizeof roots / sizeof *roots; i++)
        if (roots[i] && is_below(real, roots[i]))
            return true;
    return false;
}

/* A descriptor that cannot be read yet does nothing to a pipe, which would be waited for, or to a device. */
static int open_allowed(const char *path, struct stat *status, const char **wrong)
{
    char name[64];
    int descriptor = -1;
    const int found = open(path, O_PATH | O_CLOEXEC);
    snprintf(name, sizeof name, "/proc/self/fd/%d", found);
    *wrong = NULL;
    if (found < 0 || fstat(found, status) != 0)
        *wrong = strerror(errno);
    else if (status->st_dev == mesh.st_dev && status->st_ino == mesh.st_ino)
        descriptor = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    else if (!is_allowed(name))
        *wrong = outside;
    else if (S_ISREG(status->st_mode))
        descriptor = open(name, O_RDONLY | O_NOCTTY | O_CLOEXEC);
    if (!*wrong && descriptor < 0)
        *wrong = S_ISREG(status->st_mode) ? strerror(errno) : "it is not a regular file";
    if (found >= 0)
        close(found);
    return descriptor;
}

FILE *import_files_open(const char *path, size_t *len, const char **wrong)
{
    struct stat status;
    FILE *stream = NULL;
    const int descriptor = open_allowed(path, &status, wrong);
    if (descriptor < 0)
        return NULL;
    if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && remember(&status))
        stream = fdopen(descriptor, "rb");
    if (stream) {
        *len = (size_t)status.st_size;
    } else {
        *wrong = "it cannot be opened";
        close(descriptor);
    }
    return stream;
}

const char *import_files_outside(const struct import_source *of)
{
    if (!of->path)
        return "it is a file, and the mesh comes from standard input; name the mesh's file";
    return access("/proc/self/fd", F_OK) == 0
               ? "it lies outside the mesh's folder; put it beside the mesh, or give --allow-files its folder"
               : "where it lies cannot be told without /proc; mount it";
}

const char *import_files_refused(void)
{
    return refused[0] ? refused : NULL;
}

/* ---- names in meshes ---- */

/* Names are written as on the other system, too. */
static void use_slashes(char *name)
{
    for (; *name; name++)
        if (*name == '\\')
            *name = '/';
}

/* On another system's drive, or on the web. */
static bool is_elsewhere(const char *name)
{
    return (isalpha((unsigned char)name[0]) && name[1] == ':') || strstr(name, "://");
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

/* Names are in the folder of the mesh unless they are whole. */
static FILE *open_named(const struct import_source *of, const char *name, size_t *len, const char **wrong)
{
    const char *slash = strrchr(of->path, '/');
    if (is_elsewhere(name)) {
        *wrong = outside;
        return NULL;
    }
    char *path = formatted("%.*s%s", slash && name[0] != '/' ? (int)(slash - of->path) + 1 : 0, of->path, name);
    FILE *stream = import_files_open(path, len, wrong);
    free(path);
    return stream;
}

FILE *import_files_open_named(const struct import_source *of, const char *key, size_t *len, const char **wrong)
{
    *wrong = outside;
    if (!of->path)
        return NULL;
    char *name = copied(key);
    use_slashes(name);
    FILE *stream = open_named(of, name, len, wrong);
    if (!stream && strchr(name, '%')) {
        decode_percents(name);
        stream = open_named(of, name, len, wrong);
    }
    free(name);
    return stream;
}

char *import_files_read_all(FILE *stream, size_t *len)
{
    char *bytes = allocate(*len + 1, 1);
    *len = fread(bytes, 1, *len, stream);
    fclose(stream);
    return bytes;
}

/* ---- libassimp's files ---- */

static bool is_mesh(const char *path)
{
    return source->path ? strcmp(path, source->path) == 0
                        : strncmp(path, import_files_input, strlen(import_files_input)) == 0;
}

static size_t read_opened(struct aiFile *file, char *to, size_t size, size_t count)
{
    return fread(to, size, count, ((struct opened *)file)->stream);
}

static size_t write_opened(struct aiFile *file, const char *from, size_t size, size_t count)
{
    (void)file;
    (void)from;
    (void)size;
    (void)count;
    return 0; /* meshes are read only */
}

static size_t tell_opened(struct aiFile *file)
{
    return (size_t)ftell(((struct opened *)file)->stream);
}

static size_t size_of_opened(struct aiFile *file)
{
    return ((struct opened *)file)->len;
}

static enum aiReturn seek_opened(struct aiFile *file, size_t to, enum aiOrigin origin)
{
    const int whence = origin == aiOrigin_SET ? SEEK_SET : origin == aiOrigin_CUR ? SEEK_CUR : SEEK_END;
    return fseek(((struct opened *)file)->stream, (long)to, whence) == 0 ? aiReturn_SUCCESS : aiReturn_FAILURE;
}

static void flush_opened(struct aiFile *file)
{
    (void)file;
}

/* libassimp leaves %20 and the like in a glTF's names as they are; they are not in that of its folder. */
static FILE *open_asked(const char *path, size_t *len, const char **wrong)
{
    FILE *stream = import_files_open(path, len, wrong);
    const char *slash = source->path ? strrchr(source->path, '/') : NULL;
    const size_t folder = slash ? (size_t)(slash - source->path) + 1 : 0;
    if (stream || (folder && strncmp(path, source->path, folder) != 0) || !strchr(path + folder, '%'))
        return stream;
    char *name = copied(path);
    decode_percents(name + folder);
    stream = import_files_open(name, len, wrong);
    free(name);
    return stream;
}

static struct aiFile *open_any(struct aiFileIO *io, const char *path, const char *mode)
{
    (void)io;
    const char *wrong = NULL;
    struct opened *opened = calloc(1, sizeof *opened);
    if (!opened || mode[0] != 'r') {
        free(opened);
        return NULL;
    }
    if (source->bytes && is_mesh(path)) {
        opened->stream = fmemopen(source->bytes, source->len, "rb");
        opened->len = source->len;
    } else {
        opened->stream = open_asked(path, &opened->len, &wrong);
        if (wrong == outside && !refused[0])
            snprintf(refused, sizeof refused, "%s", path);
    }
    if (!opened->stream) {
        free(opened);
        return NULL;
    }
    opened->file = (struct aiFile){.ReadProc = read_opened,
                                   .WriteProc = write_opened,
                                   .TellProc = tell_opened,
                                   .FileSizeProc = size_of_opened,
                                   .SeekProc = seek_opened,
                                   .FlushProc = flush_opened};
    return (struct aiFile *)opened;
}

static void close_opened(struct aiFileIO *io, struct aiFile *file)
{
    (void)io;
    fclose(((struct opened *)file)->stream);
    free(file);
}

struct aiFileIO *import_files(const struct import_source *of)
{
    static struct aiFileIO io = {.OpenProc = open_any, .CloseProc = close_opened};
    source = of;
    outside = import_files_outside(of);
    if (of->path && stat(of->path, &mesh) == 0)
        roots[0] = folder_of(of->path);
    if (of->path && of->allowed)
        roots[1] = realpath(of->allowed, NULL);
    return &io;
}

unsigned import_files_read(const struct import_file **files)
{
    *files = read_files;
    return read_count;
}

#endif
