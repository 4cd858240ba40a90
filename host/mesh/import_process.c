/* SPDX-License-Identifier: MIT */
#include "mesh/import_process.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/message.h"

enum { SECONDS_MAX = 10, MEMORY_MAX_MB = 2048 };

/* ---- the child ---- */

static void set_limits(void)
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
}

void import_process_send(int out, const void *from, size_t bytes)
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

void import_process_start(struct import_process *process, const char *name, const char *reader,
                          void (*body)(const void *of, int out), const void *of)
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        fail("%s: no pipe for the import: %s", name, strerror(errno));
    const pid_t child = fork();
    if (child < 0)
        fail("%s: no process for the import: %s", name, strerror(errno));
    if (child == 0) {
        close(ends[0]);
        set_limits();
        body(of, ends[1]);
        _exit(0);
    }
    close(ends[1]);
    *process = (struct import_process){reader, ends[0], child, seconds_now() + SECONDS_MAX};
}

static const char *what_became(const struct import_process *process)
{
    static char text[200];
    int status = 0;
    const bool late = seconds_now() >= process->end;
    if (late)
        kill(process->child, SIGKILL);
    while (waitpid(process->child, &status, 0) < 0 && errno == EINTR)
        ;
    close(process->in);
    if (late || (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)))
        snprintf(text, sizeof text,
                 "%s did not read it within %d s; the file may be damaged: export it again, or simplify it",
                 process->reader, SECONDS_MAX);
    else if (WIFSIGNALED(status))
        snprintf(text, sizeof text,
                 "%s crashed on it (%s); the file may be damaged: export it again, or in another format",
                 process->reader, strsignal(WTERMSIG(status)));
    else
        snprintf(text, sizeof text, "%s broke off; the file may be damaged: export it again, or in another format",
                 process->reader);
    return text;
}

const char *import_process_receive(struct import_process *process, void *to, size_t bytes)
{
    for (uint8_t *at = to; bytes;) {
        struct pollfd ready = {process->in, POLLIN, 0};
        const double left = process->end - seconds_now();
        if (left <= 0)
            return what_became(process);
        if (poll(&ready, 1, (int)(1000 * left) + 1) <= 0)
            continue;
        const ssize_t got = read(process->in, at, bytes);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return what_became(process);
        at += got;
        bytes -= (size_t)got;
    }
    return NULL;
}

void import_process_end(struct import_process *process)
{
    close(process->in);
    kill(process->child, SIGKILL);
    while (waitpid(process->child, NULL, 0) < 0 && errno == EINTR)
        ;
}
