/* SPDX-License-Identifier: MIT
 * Of the path, some folders may exist and the rest not. A work folder is made beside the first that does not exist, the
 * rest of the path within it, and one rename at the end gives all of them their names. Where the whole path exists, the
 * work folder lies within it, and each file is renamed: a folder that holds other files cannot be replaced. */
#include "base/folder.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/stop.h"

struct folder {
    char *path;             /* as the user named it */
    char *target;           /* the first folder of the path that does not exist; NULL: all exist */
    char *top;              /* the work folder */
    char *work;             /* where the files lie: top, or folders within it */
    char **files, **finals; /* each file's path in the work folder, and in the end */
    size_t count, room;
};

static struct folder *volatile unfinished; /* read by the signal handler */

/* May run in a signal handler: it only reads what is complete, and removes. */
static void discard(void)
{
    struct folder *folder = unfinished;
    unfinished = NULL;
    if (!folder)
        return;
    for (size_t i = 0; i < folder->count; i++)
        unlink(folder->files[i]);
    /* From `work` up to `top`: each is empty then. */
    for (size_t length = strlen(folder->work), least = strlen(folder->top); length >= least; length--)
        if (folder->work[length] == '\0' || folder->work[length] == '/') {
            folder->work[length] = '\0';
            rmdir(folder->work);
        }
}

static bool is_folder(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

static char *joined(const char *folder, const char *name)
{
    return formatted("%s/%s", folder, name);
}

/* The length of the shortest part of the path that does not exist; 0 where all of it does. */
static size_t missing_length(const char *path)
{
    char *part = copied(path);
    size_t missing = 0;
    for (size_t length = 1; !missing && path[length - 1]; length++) {
        if (path[length] && path[length] != '/')
            continue;
        part[length] = '\0';
        struct stat status;
        if (lstat(part, &status) != 0 && errno == ENOENT)
            missing = length;
        else if (stat(part, &status) != 0)
            fail("%s: cannot create the folder: %s", part, strerror(errno));
        else if (!S_ISDIR(status.st_mode))
            fail("%s: this is a file; name a folder", part);
        part[length] = path[length];
    }
    free(part);
    return missing;
}

/* mkdtemp's folders are for their owner alone. */
static void give_usual_mode(const char *path)
{
    const mode_t mask = umask(0);
    umask(mask);
    chmod(path, 0777 & ~mask);
}

/* Makes the work folder. A signal in between would leave a folder that nobody removes. */
static void make_top(struct folder *folder)
{
    const char *missing = folder->target;
    char *name = formatted("%s%s.glint-XXXXXX", missing ? missing : folder->path, missing ? "" : "/");
    sigset_t before;
    signals_hold(&before);
    if (!mkdtemp(name))
        fail("%s: cannot write there: %s", folder->path, strerror(errno));
    folder->top = name;
    folder->work = formatted("%s%s", name, missing ? folder->path + strlen(missing) : "");
    unfinished = folder;
    signals_release(&before);
}

/* The folders of the path that follow the first missing one. */
static void make_rest(struct folder *folder)
{
    for (size_t length = strlen(folder->top); folder->work[length]; length++) {
        const size_t next = length + 1 + strcspn(folder->work + length + 1, "/");
        const char kept = folder->work[next];
        folder->work[next] = '\0';
        if (strcmp(folder->work + length, "/..") == 0)
            fail("%s: %s does not exist, so '..' cannot follow it", folder->path, folder->target);
        if (mkdir(folder->work, 0777) != 0 && errno != EEXIST) /* as in a//b and a/./b */
            fail("%s: cannot create the folder: %s", folder->path, strerror(errno));
        folder->work[next] = kept;
        length = next - 1;
    }
}

struct folder *folder_open(const char *path)
{
    struct folder *folder = allocate(1, sizeof *folder);
    folder->path = copied(path);
    for (size_t length = strlen(path); length > 1 && path[length - 1] == '/'; length--)
        folder->path[length - 1] = '\0';
    const size_t missing = missing_length(folder->path);
    if (missing)
        folder->target = copied_part(folder->path, missing);
    static bool registered;
    if (!registered) {
        registered = true;
        atexit(discard);
        stop_undo(discard);
    }
    make_top(folder);
    if (missing) {
        give_usual_mode(folder->top);
        make_rest(folder);
    }
    return folder;
}

const char *folder_work(const struct folder *folder)
{
    return folder->work;
}

static char **longer(char **list, size_t count, size_t room)
{
    char **copy = allocate(room, sizeof *copy);
    if (count)
        memcpy(copy, list, count * sizeof *copy);
    return copy;
}

/* A signal's handler finds one list or the other. */
static void make_room(struct folder *folder)
{
    const size_t room = folder->room ? 2 * folder->room : 16;
    char **files = longer(folder->files, folder->count, room), **finals = longer(folder->finals, folder->count, room);
    char **const old_files = folder->files, **const old_finals = folder->finals;
    sigset_t before;
    signals_hold(&before);
    folder->files = files;
    folder->finals = finals;
    folder->room = room;
    signals_release(&before);
    free(old_files);
    free(old_finals);
}

char *folder_file(struct folder *folder, const char *name)
{
    char *file = joined(folder->work, name), *path = copied(file), *final = joined(folder->path, name);
    if (is_folder(final))
        fail("%s: is a folder; move it away, or name another folder", final);
    if (folder->count == folder->room)
        make_room(folder);
    sigset_t before;
    signals_hold(&before);
    folder->files[folder->count] = file;
    folder->finals[folder->count++] = final;
    signals_release(&before);
    return path;
}

static void rename_all(const struct folder *folder)
{
    if (folder->target && rename(folder->top, folder->target) != 0)
        fail("%s: cannot get its name: %s", folder->target, strerror(errno));
    if (folder->target)
        return;
    for (size_t i = 0; i < folder->count; i++)
        if (rename(folder->files[i], folder->finals[i]) != 0)
            fail("%s: cannot get its name: %s", folder->finals[i], strerror(errno));
    rmdir(folder->top);
}

void folder_close(struct folder *folder)
{
    sigset_t before;
    signals_hold(&before); /* until all have their names */
    rename_all(folder);
    unfinished = NULL;
    signals_release(&before);
    for (size_t i = 0; i < folder->count; i++) {
        free(folder->files[i]);
        free(folder->finals[i]);
    }
    free(folder->files);
    free(folder->finals);
    free(folder->path);
    free(folder->target);
    free(folder->top);
    free(folder->work);
    free(folder);
}
