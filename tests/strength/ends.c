/* SPDX-License-Identifier: MIT
 * Linked into what is counted: programs that end without exit() write their counters first, also where files may not grow. */
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

void __gcov_dump(void) __attribute__((weak)); /* libgcov's, taken by -u */
void __real__exit(int status) __attribute__((noreturn));
int __real_setrlimit(int resource, const struct rlimit *limit);
int __real_kill(pid_t pid, int number);
void __wrap__exit(int status) __attribute__((noreturn));
int __wrap_setrlimit(int resource, const struct rlimit *limit);
int __wrap_kill(pid_t pid, int number);
int __real_raise(int number);
int __wrap_raise(int number);

/* Where files may not grow (ulimit -f), counters would be written in part only and spoil those of all other runs. */
static bool files_may_grow(void)
{
    struct rlimit limit;
    return getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
}

static void write_counters(void)
{
    if (__gcov_dump && files_may_grow())
        __gcov_dump();
}

/* A child that is about to end has a second for it, since it dies with its parent: any of ours, or that one. */
static void await(idtype_t which, pid_t pid)
{
    for (int i = 0; i < 100; i++) {
        siginfo_t info = {0};
        if (waitid(which, (id_t)pid, &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid)
            break;
        usleep(10000);
    }
}

/* Before libgcov writes them by itself; it would complain on standard error of each that it cannot write. */
static void leave(int status, void *unused)
{
    (void)unused;
    await(P_ALL, 0);
    if (!files_may_grow()) {
        fflush(NULL);
        __real__exit(status);
    }
}

void __wrap__exit(int status)
{
    write_counters();
    __real__exit(status);
}

int __wrap_setrlimit(int resource, const struct rlimit *limit)
{
    return resource == RLIMIT_FSIZE && limit->rlim_cur == 0 ? 0 : __real_setrlimit(resource, limit);
}

int __wrap_kill(pid_t pid, int number)
{
    if (pid > 0 && number == SIGKILL)
        await(P_PID, pid);
    return __real_kill(pid, number);
}

int __wrap_raise(int number)
{
    write_counters();
    return __real_raise(number);
}

static void end(int number)
{
    signal(number, SIG_DFL);
    raise(number);
}

__attribute__((constructor)) static void begin(void)
{
    signal(SIGTERM, end); /* main() mostly has another way */
    on_exit(leave, NULL); /* first in, last out */
}
