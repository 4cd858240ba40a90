/* SPDX-License-Identifier: MIT
 * The child sends what it read through a pipe, and the parent believes nothing of it. */
#include "mesh/import.h"

#include "base/message.h"

#if GLINT_WITH_MESH
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/memory.h"
#include "base/output.h"
#include "mesh/import_child.h"
#include "mesh/import_files.h"
#include "mesh/import_source.h"

enum { SECONDS_MAX = 10, MEMORY_MAX_MB = 2048, PARTS_MAX = 4096 };

/* ---- the child ---- */

static _Noreturn void run_child(const struct import_source *source, int out)
{
    for (int i = 1; i < NSIG; i++)
        signal(i, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    setrlimit(RLIMIT_FSIZE, &(struct rlimit){0, 0});
    setrlimit(RLIMIT_CPU, &(struct rlimit){SECONDS_MAX, SECONDS_MAX});
#if !defined(__SANITIZE_ADDRESS__) /* whose shadow is larger */
    const rlim_t memory = (rlim_t)MEMORY_MAX_MB << 20;
    setrlimit(RLIMIT_AS, &(struct rlimit){memory, memory});
#endif
    close(STDIN_FILENO);
    import_child(source, out);
    _exit(0);
}

/* ---- the parent ---- */

struct reader {
    const struct import_source *source;
    int in;
    pid_t child;
    double end; /* of its time */
};

static _Noreturn void fail_child(const struct reader *reader)
{
    int status = 0;
    const bool late = seconds_now() >= reader->end;
    if (late)
        kill(reader->child, SIGKILL);
    while (waitpid(reader->child, &status, 0) < 0 && errno == EINTR)
        ;
    if (late || (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)))
        fail("%s: libassimp did not read it within %d s; the file may be damaged: export it again, or simplify it",
             reader->source->name, SECONDS_MAX);
    if (WIFSIGNALED(status))
        fail("%s: libassimp crashed on it (%s); the file may be damaged: export it again, or in another format",
             reader->source->name, strsignal(WTERMSIG(status)));
    fail("%s: libassimp broke off; the file may be damaged: export it again, or in another format",
         reader->source->name);
}

static void receive(const struct reader *reader, void *to, size_t bytes)
{
    for (uint8_t *at = to; bytes;) {
        struct pollfd ready = {reader->in, POLLIN, 0};
        const double left = reader->end - seconds_now();
        if (left <= 0)
            fail_child(reader);
        if (poll(&ready, 1, (int)(1000 * left) + 1) <= 0)
            continue;
        const ssize_t got = read(reader->in, at, bytes);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            fail_child(reader);
        at += got;
        bytes -= (size_t)got;
    }
}

static void receive_files(const struct reader *reader, uint64_t count)
{
    struct import_file file;
    if (count > IMPORT_FILES_MAX)
        fail("%s: libassimp read more than %d files; export it again, in one file", reader->source->name,
             IMPORT_FILES_MAX);
    for (uint64_t i = 0; i < count; i++) {
        receive(reader, &file, sizeof file);
        output_never_number(file.device, file.number);
    }
}

static struct soup *receive_soup(const struct reader *reader)
{
    struct import_head head;
    receive(reader, &head, sizeof head);
    head.message[sizeof head.message - 1] = 0;
    if (head.message[0])
        fail("%s: libassimp cannot read this mesh: %s", reader->source->name, head.message);
    receive_files(reader, head.file_count);
    soup_check_count(reader->source->name, head.face_count);
    if (head.part_count == 0 || head.part_count > PARTS_MAX)
        fail("%s: has %llu materials; at most %d can be read; join some", reader->source->name,
             (unsigned long long)head.part_count, PARTS_MAX);
    struct soup *soup = allocate(1, sizeof *soup);
    *soup = (struct soup){.name = strdup(reader->source->name),
                          .face_count = head.face_count,
                          .has_normals = head.has_normals,
                          .has_textures = head.has_textures,
                          .has_colors = head.has_colors,
                          .has_facet_colors = head.has_facet_colors,
                          .is_stl = strcmp(reader->source->ending, ".stl") == 0,
                          .part_count = (unsigned)head.part_count};
    if (!soup->name)
        fail("out of memory");
    soup->materials = allocate(soup->part_count, sizeof *soup->materials);
    soup->faces = allocate(soup->face_count, sizeof *soup->faces);
    receive(reader, soup->materials, soup->part_count * sizeof *soup->materials);
    receive(reader, soup->faces, soup->face_count * sizeof *soup->faces);
    soup_check_faces(soup);
    return soup;
}

struct soup *import_soup(const char *path)
{
    int ends[2];
    struct import_source *source = import_source_open(path);
    if (pipe2(ends, O_CLOEXEC) != 0)
        fail("%s: no pipe for the import: %s", source->name, strerror(errno));
    const pid_t child = fork();
    if (child < 0)
        fail("%s: no process for the import: %s", source->name, strerror(errno));
    if (child == 0) {
        close(ends[0]);
        run_child(source, ends[1]);
    }
    close(ends[1]);
    const struct reader reader = {source, ends[0], child, seconds_now() + SECONDS_MAX};
    struct soup *soup = receive_soup(&reader);
    close(ends[0]);
    kill(child, SIGKILL); /* it has nothing more to say */
    while (waitpid(child, NULL, 0) < 0 && errno == EINTR)
        ;
    import_source_free(source);
    return soup;
}

#define TEXT(x) #x
#define TEXT_OF(x) TEXT(x)
const char *import_library(void)
{
    return "libassimp " TEXT_OF(GLINT_WITH_MESH);
}

#else

struct soup *import_soup(const char *path)
{
    fail("%s: glint was built without libassimp, which reads meshes; install libassimp-dev and build glint again",
         path);
}

const char *import_library(void)
{
    return NULL;
}

#endif
