/* SPDX-License-Identifier: MIT */
#include "base/child.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "base/message.h"

enum { SECONDS_MAX = 10, MEMORY_MAX_MB = 2048 }; /* of work, and of none */

/* ---- the child ---- */

/* What the parent has already is not counted. */
static void limit_memory(void)
{
#if !defined(__SANITIZE_ADDRESS__) /* whose shadow is larger */
    unsigned long pages = 0;
    FILE *file = fopen("/proc/self/statm", "re");
    if (file && fscanf(file, "%lu", &pages) != 1)
        pages = 0;
    if (file)
        fclose(file);
    const rlim_t memory = (rlim_t)pages * (rlim_t)sysconf(_SC_PAGESIZE) + ((rlim_t)MEMORY_MAX_MB << 20);
    setrlimit(RLIMIT_AS, &(struct rlimit){memory, memory});
#endif
}

static void set_limits(void)
{
    signal(SIGXFSZ, SIG_IGN); /* a library's cache is not written */
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    setrlimit(RLIMIT_FSIZE, &(struct rlimit){0, 0});
    setrlimit(RLIMIT_CPU, &(struct rlimit){SECONDS_MAX, SECONDS_MAX});
    limit_memory();
}

/* The parent's end is not seen in a library's loop; it may have come before the system was asked. */
void child_begin(pid_t parent)
{
    for (int i = 1; i < NSIG; i++)
        signal(i, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != parent)
        _exit(1);
}

/* What the parent does at its exit is not for the child, in which a library may call exit(). */
static void leave(void)
{
    _exit(1);
}

/* Libraries write there as they like. */
static void leave_streams(void)
{
    const int null = open("/dev/null", O_RDWR | O_CLOEXEC);
    for (int i = STDIN_FILENO; i <= STDERR_FILENO; i++)
        if (null < 0 || dup2(null, i) < 0)
            _exit(1);
}

void child_send(int out, const void *from, size_t bytes)
{
    for (const uint8_t *at = from; bytes;) {
        const ssize_t sent = write(out, at, bytes);
        if (sent <= 0)
            _exit(1);
        at += sent;
        bytes -= (size_t)sent;
    }
}

/* ---- the parent ---- */

void child_start(struct child *child, const char *name, const char *reader, void (*body)(const void *of, int out),
                 const void *of)
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        fail("%s: no pipe to read it in: %s", name, strerror(errno));
    const pid_t parent = getpid(), process = fork();
    if (process < 0)
        fail("%s: no process to read it in: %s", name, strerror(errno));
    if (process == 0) {
        child_begin(parent);
        close(ends[0]);
        set_limits();
        const int out = fcntl(ends[1], F_DUPFD_CLOEXEC, STDERR_FILENO + 1); /* where the streams were closed */
        leave_streams();
        atexit(leave);
        body(of, out);
        _exit(0);
    }
    close(ends[1]);
    *child = (struct child){reader, ends[0], process, 0, 0};
}

/* Of a second in which nothing came: did the child not work, either? What works has a limit of the processor's time. So a machine that is slow,
 * or stands still, and a parent that does, end no child. */
static bool is_idle(struct child *child)
{
    clockid_t clock;
    struct timespec used = {0};
    if (clock_getcpuclockid(child->process, &clock) == 0)
        clock_gettime(clock, &used);
    const double before_s = child->used_s;
    child->used_s = (double)used.tv_sec + 1e-9 * (double)used.tv_nsec;
    return child->used_s <= before_s;
}

static const char *what_became(const struct child *child)
{
    static char text[200];
    int status = 0;
    const bool late = child->idle_s == SECONDS_MAX;
    if (late)
        kill(child->process, SIGKILL);
    while (waitpid(child->process, &status, 0) < 0 && errno == EINTR)
        ;
    close(child->in);
    if (late || (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)))
        snprintf(text, sizeof text,
                 "%s did not read it within %d s; the file may be damaged: export it again, or simplify it",
                 child->reader, SECONDS_MAX);
    else if (WIFSIGNALED(status))
        snprintf(text, sizeof text,
                 "%s crashed on it (%s); the file may be damaged: export it again, or in another format", child->reader,
                 strsignal(WTERMSIG(status)));
    else
        snprintf(text, sizeof text, "%s broke off; the file may be damaged: export it again, or in another format",
                 child->reader);
    return text;
}

const char *child_receive(struct child *child, void *to, size_t bytes)
{
    for (uint8_t *at = to; bytes;) {
        struct pollfd ready = {child->in, POLLIN, 0};
        const int polled = poll(&ready, 1, 1000);
        if (polled == 0 && is_idle(child) && ++child->idle_s == SECONDS_MAX)
            return what_became(child);
        if (polled <= 0)
            continue;
        const ssize_t got = read(child->in, at, bytes);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return what_became(child);
        at += got;
        bytes -= (size_t)got;
    }
    return NULL;
}

void child_end(struct child *child)
{
    close(child->in);
    kill(child->process, SIGKILL);
    while (waitpid(child->process, NULL, 0) < 0 && errno == EINTR)
        ;
}
