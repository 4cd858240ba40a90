/* SPDX-License-Identifier: MIT
 * The child sends what it read through a pipe, and the parent believes nothing of it. */
#include "mesh/import.h"

#include <string.h>
#include <strings.h>

#include "base/message.h"

bool import_is_stl(const char *path)
{
    const char *dot = strrchr(path, '.');
    return dot && strcasecmp(dot, ".stl") == 0;
}

#if GLINT_WITH_MESH
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/memory.h"
#include "glint.h"
#include "mesh/import_child.h"

static const char *const endings[] = {".obj", ".stl", ".ply", ".gltf", ".glb"};

enum { SECONDS_MAX = 10, FILE_MAX_MB = 256, MEMORY_MAX_MB = 2048, PARTS_MAX = 4096 };

static void check_file(const char *path)
{
    struct stat status;
    bool known = false;
    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof endings / sizeof *endings; i++)
        known |= strcasecmp(dot, endings[i]) == 0;
    if (!known)
        fail("%s: a mesh's name ends in .obj, .stl, .ply, .gltf or .glb; rename it, or export it so", path);
    if (stat(path, &status) != 0)
        fail("%s: %s", path, strerror(errno));
    if (!S_ISREG(status.st_mode))
        fail("%s: this is not a regular file; name a mesh", path);
    if (status.st_size == 0)
        fail("%s: this file is empty; name a mesh", path);
    if (status.st_size > (off_t)FILE_MAX_MB << 20)
        fail("%s: this file has more than %d MB; simplify the mesh", path, FILE_MAX_MB);
}

/* ---- the child ---- */

static _Noreturn void run_child(const char *path, int out)
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
    import_child(path, out);
    _exit(0);
}

/* ---- the parent ---- */

struct reader {
    const char *path;
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
             reader->path, SECONDS_MAX);
    if (WIFSIGNALED(status))
        fail("%s: libassimp crashed on it (%s); the file may be damaged: export it again, or in another format",
             reader->path, strsignal(WTERMSIG(status)));
    fail("%s: libassimp broke off; the file may be damaged: export it again, or in another format", reader->path);
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

static void check_faces(const struct soup *soup)
{
    for (size_t i = 0; i < soup->face_count; i++) {
        const struct soup_face *face = &soup->faces[i];
        for (int k = 0; k < 9; k++)
            if (!(fabs(face->places[k / 3][k % 3]) < 1e30))
                fail("%s: triangle %zu has a coordinate that is not a number below 10^30; repair the mesh", soup->name,
                     i + 1);
        if (face->part >= soup->part_count)
            fail("%s: triangle %zu has no material; repair the mesh", soup->name, i + 1);
    }
}

static struct soup *receive_soup(const struct reader *reader)
{
    struct import_head head;
    receive(reader, &head, sizeof head);
    head.message[sizeof head.message - 1] = 0;
    if (head.message[0])
        fail("%s: libassimp cannot read this mesh: %s", reader->path, head.message);
    if (head.face_count == 0)
        fail("%s: has no triangles; name another mesh", reader->path);
    if (head.face_count > GLINT_MESH_FACES_MAX)
        fail("%s: has %llu triangles, and at most %u can be drawn; simplify the mesh", reader->path,
             (unsigned long long)head.face_count, GLINT_MESH_FACES_MAX);
    if (head.part_count == 0 || head.part_count > PARTS_MAX)
        fail("%s: has %llu materials; at most %d can be read; join some", reader->path,
             (unsigned long long)head.part_count, PARTS_MAX);
    struct soup *soup = allocate(1, sizeof *soup);
    *soup = (struct soup){.name = strdup(reader->path),
                          .face_count = head.face_count,
                          .has_normals = head.has_normals,
                          .has_textures = head.has_textures,
                          .part_count = (unsigned)head.part_count};
    if (!soup->name)
        fail("out of memory");
    soup->materials = allocate(soup->part_count, sizeof *soup->materials);
    soup->faces = allocate(soup->face_count, sizeof *soup->faces);
    receive(reader, soup->materials, soup->part_count * sizeof *soup->materials);
    receive(reader, soup->faces, soup->face_count * sizeof *soup->faces);
    check_faces(soup);
    return soup;
}

struct soup *import_soup(const char *path)
{
    int ends[2];
    check_file(path);
    if (pipe2(ends, O_CLOEXEC) != 0)
        fail("%s: no pipe for the import: %s", path, strerror(errno));
    const pid_t child = fork();
    if (child < 0)
        fail("%s: no process for the import: %s", path, strerror(errno));
    if (child == 0) {
        close(ends[0]);
        run_child(path, ends[1]);
    }
    close(ends[1]);
    const struct reader reader = {path, ends[0], child, seconds_now() + SECONDS_MAX};
    struct soup *soup = receive_soup(&reader);
    close(ends[0]);
    kill(child, SIGKILL); /* it has nothing more to say */
    while (waitpid(child, NULL, 0) < 0 && errno == EINTR)
        ;
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
