/* SPDX-License-Identifier: MIT */
#include "mesh/import_files.h"

#if GLINT_WITH_MESH
#include <assimp/cfileio.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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

/* A pipe would be waited for, a device might never end. */
FILE *import_files_open(const char *path, size_t *len)
{
    struct stat status;
    const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    FILE *stream = NULL;
    if (descriptor >= 0 && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && remember(&status))
        stream = fdopen(descriptor, "rb");
    if (!stream && descriptor >= 0)
        close(descriptor);
    if (stream)
        *len = (size_t)status.st_size;
    return stream;
}

static bool is_input(const char *path)
{
    return !source->path && strncmp(path, import_files_input, strlen(import_files_input)) == 0;
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

static struct aiFile *open_any(struct aiFileIO *io, const char *path, const char *mode)
{
    (void)io;
    struct opened *opened = calloc(1, sizeof *opened);
    if (!opened || mode[0] != 'r') {
        free(opened);
        return NULL;
    }
    if (is_input(path)) {
        opened->stream = fmemopen(source->bytes, source->len, "rb");
        opened->len = source->len;
    } else {
        opened->stream = import_files_open(path, &opened->len);
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
    return &io;
}

unsigned import_files_read(const struct import_file **files)
{
    *files = read_files;
    return read_count;
}

#endif
