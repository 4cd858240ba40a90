/* SPDX-License-Identifier: MIT
 * A regular file is written beside its name and then renamed, so that it is whole or not there. */
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "base/stop.h"

enum { OPEN_MAX_FILES = 8 };
static char *unfinished[OPEN_MAX_FILES]; /* names to remove if the program ends early; read by the signal handler */

static void remember(char *name)
{
    static bool registered;
    if (!registered) {
        registered = true;
        atexit(output_discard_all);
        stop_undo(output_discard_all);
    }
    for (int i = 0; i < OPEN_MAX_FILES; i++) {
        if (!unfinished[i]) {
            unfinished[i] = name;
            return;
        }
    }
    fail("%s: more than %d output files are open", name, OPEN_MAX_FILES);
}

static void forget(const char *name)
{
    for (int i = 0; i < OPEN_MAX_FILES; i++)
        if (unfinished[i] == name)
            unfinished[i] = NULL;
}

static void discard(const char *name)
{
    for (int i = 0; i < OPEN_MAX_FILES; i++) {
        if (unfinished[i] == name) {
            unlink(name);
            unfinished[i] = NULL;
        }
    }
}

void output_discard_all(void)
{
    for (int i = 0; i < OPEN_MAX_FILES; i++) {
        if (unfinished[i])
            unlink(unfinished[i]);
        unfinished[i] = NULL;
    }
}

/* A file that exists keeps its mode; a new one gets what the umask allows. */
static mode_t wanted_mode(bool exists, const struct stat *status)
{
    if (exists)
        return status->st_mode & 07777;
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/* Where a symbolic link leads; NULL: it is none. */
static char *link_target(const char *path)
{
    char link[PATH_MAX];
    const ssize_t length = readlink(path, link, sizeof link - 1);
    if (length < 0)
        return NULL;
    link[length] = '\0';
    const char *slash = *link == '/' ? NULL : strrchr(path, '/');
    const int folder = slash ? (int)(slash - path) + 1 : 0;
    return formatted("%.*s%s", folder, path, link);
}

/* Where the name leads: a symbolic link stays one, also one whose file is not there yet. */
static char *resolve(const char *path)
{
    char *target = realpath(path, NULL);
    if (target || errno != ENOENT)
        return target;
    char *next = link_target(path);
    target = next ? resolve(next) : copied(path); /* ends: a loop of links is ELOOP to realpath */
    free(next);
    return target;
}

/* The path up to its last slash; without one the current folder. */
static char *folder_of(const char *path, const char *slash)
{
    return slash ? copied_part(path, (size_t)(slash - path) + 1) : copied(".");
}

/* Of the name of a file that leads to an open descriptor, as /dev/stderr and /dev/fd/3, its number; else -1. */
static int descriptor_of(const char *path)
{
    char own[32];
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    char *folder = folder_of(path, slash), *real = realpath(folder, NULL), *next = NULL;
    snprintf(own, sizeof own, "/proc/%d/fd", (int)getpid());
    int found = real && strcmp(real, own) == 0 ? (int)strtol(name, NULL, 10) : -1;
    if (found < 0 && (next = link_target(path)))
        found = descriptor_of(next);
    free(folder);
    free(real);
    free(next);
    return found;
}

static bool same_status(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/* The folder of `path`, which ends with a name in it. */
static bool folder_status(const char *path, const char *slash, struct stat *status)
{
    char *folder = folder_of(path, slash);
    const bool good = stat(folder, status) == 0;
    free(folder);
    return good;
}

/* Names of files that are not there: the same name in one folder. */
static bool same_place(const char *a, const char *b)
{
    const char *slash_a = strrchr(a, '/'), *slash_b = strrchr(b, '/');
    struct stat of_a, of_b;
    return strcmp(slash_a ? slash_a + 1 : a, slash_b ? slash_b + 1 : b) == 0 && folder_status(a, slash_a, &of_a) &&
           folder_status(b, slash_b, &of_b) && same_status(&of_a, &of_b);
}

bool output_same(const char *a, const char *b)
{
    struct stat of_a, of_b;
    const bool a_exists = stat(a, &of_a) == 0, b_exists = stat(b, &of_b) == 0;
    if (a_exists || b_exists)
        return a_exists && b_exists && same_status(&of_a, &of_b);
    char *target_a = resolve(a), *target_b = target_a ? resolve(b) : NULL;
    const bool same = target_b && same_place(target_a, target_b);
    free(target_a);
    free(target_b);
    return same;
}

/* ---- files that are read ---- */

static struct input {
    dev_t device;
    ino_t file;
    struct input *next;
} * inputs;

void output_never(FILE *input)
{
    struct stat status;
    if (fstat(fileno(input), &status) != 0 || !S_ISREG(status.st_mode))
        return; /* pipes and devices are not replaced */
    output_never_number(status.st_dev, status.st_ino);
}

void output_never_number(dev_t device, ino_t file)
{
    struct input *kept = allocate(1, sizeof *kept);
    *kept = (struct input){device, file, inputs};
    inputs = kept;
}

static bool is_input(const struct stat *status)
{
    const struct input *input = inputs;
    while (input && (input->device != status->st_dev || input->file != status->st_ino))
        input = input->next;
    return input != NULL;
}

static void refuse_input(const char *path, const struct stat *status)
{
    if (is_input(status))
        fail("%s: this file is also an input; name another for the output", path);
}

void output_check(const char *path)
{
    struct stat status;
    if (inputs && stat(path, &status) == 0)
        refuse_input(path, &status);
}

/* ---- files that are written ---- */

/* A new file in the target's folder, under a name of its own until it is whole. */
static int open_beside(struct output *output)
{
    const char *slash = strrchr(output->target, '/');
    const int folder = slash ? (int)(slash - output->target) + 1 : 0;
    output->temporary = formatted("%.*s.glint-XXXXXX", folder, output->target);
    /* A signal in between would leave a file behind. */
    sigset_t before;
    signals_hold(&before);
    const int descriptor = mkstemp(output->temporary);
    if (descriptor < 0)
        fail("%s: cannot create a file there: %s", output->path, strerror(errno));
    remember(output->temporary);
    signals_release(&before);
    return descriptor;
}

/* Under whatever name, as /dev/stdout: another file in its place would lose what >> kept and what others write there. */
static bool is_standard_output(const struct stat *status)
{
    struct stat standard;
    return fstat(STDOUT_FILENO, &standard) == 0 && same_status(status, &standard);
}

/* A terminal takes both; of other devices, as /dev/null, nobody reads what is mixed. */
bool output_is_standard(const char *path)
{
    struct stat status;
    return strcmp(path, "-") == 0 || (stat(path, &status) == 0 && is_standard_output(&status) &&
                                      (!S_ISCHR(status.st_mode) || isatty(STDOUT_FILENO)));
}

struct output *output_open(const char *path)
{
    struct output *output = allocate(1, sizeof *output);
    output->path = copied(path);
    if (strcmp(path, "-") == 0) {
        output->stream = stdout;
        return output;
    }
    struct stat status;
    const bool exists = stat(path, &status) == 0;
    if (exists && S_ISDIR(status.st_mode))
        fail("%s: this is a folder; name a file", path);
    if (exists)
        refuse_input(path, &status);
    if (exists && S_ISREG(status.st_mode) && is_standard_output(&status)) {
        output->stream = stdout;
        return output;
    }
    const int open_already = exists && S_ISREG(status.st_mode) ? descriptor_of(path) : -1;
    if (open_already >= 0) {
        const int descriptor = fcntl(open_already, F_DUPFD_CLOEXEC, 0);
        output->stream = descriptor < 0 ? NULL : fdopen(descriptor, "wb");
        if (!output->stream)
            fail("%s: %s", path, strerror(errno));
        return output;
    }
    if (exists && !S_ISREG(status.st_mode)) {
        if (stream_stopped()) /* by a signal that came before, which ends no waiting */
            exit(stop_status());
        output->stream = fopen(path, "wb"); /* of a pipe: waits for its reader */
        if (!output->stream) {
            stop_if_interrupted(errno);
            fail("%s: %s", path, strerror(errno));
        }
        return output;
    }
    output->target = resolve(path);
    if (!output->target || (exists && access(path, W_OK) != 0))
        fail("%s: %s", path, strerror(errno));
    const int descriptor = open_beside(output);
    if (exists && fchown(descriptor, status.st_uid, status.st_gid) != 0)
        errno = 0; /* it becomes ours: only root can give files away */
    if (fchmod(descriptor, wanted_mode(exists, &status)) != 0 || !(output->stream = fdopen(descriptor, "wb")))
        fail("%s: %s", path, strerror(errno));
    return output;
}

static void free_output(struct output *output)
{
    free(output->temporary);
    free(output->target);
    free(output->path);
    free(output);
}

static const char *name_of(const struct output *output)
{
    return strcmp(output->path, "-") == 0 ? "standard output" : output->path;
}

void output_check_written(struct output *output)
{
    errno = 0;
    if (fflush(output->stream) == 0 && !ferror(output->stream))
        return;
    int reason = errno;
    stop_if_interrupted(reason);
    if (!reason && output->stream != stdout && write(fileno(output->stream), "", 1) < 0) /* fails as before */
        reason = errno;
    fail("%s: could not be written: %s", name_of(output), reason ? strerror(reason) : "write error");
}

void output_close(struct output *output)
{
    output_check_written(output);
    if (output->stream != stdout && fclose(output->stream) != 0)
        fail("%s: could not be written: %s", name_of(output), strerror(errno));
    if (output->temporary) {
        if (rename(output->temporary, output->target) != 0)
            fail("%s: %s", name_of(output), strerror(errno));
        forget(output->temporary);
    }
    free_output(output);
}

void output_discard(struct output *output)
{
    if (output->stream != stdout)
        fclose(output->stream); /* whether it could be written does not matter now */
    if (output->temporary)
        discard(output->temporary);
    free_output(output);
}
