/* SPDX-License-Identifier: MIT */
/* The first program of the guest, on the host's files: runs one command and powers off. The folder in the environment
 * variable LAB_JOB has argv, env (each NUL-separated), cwd and seconds; stdout and stderr are written there, and last
 * of all status: the command's, 128 + its signal, 124 when it took too long, 126 and 127 as a shell's. */
#include <errno.h>
#include <fcntl.h>
#include <linux/random.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/reboot.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* /tmp stays the host's, as sources may be there. What /run hides are the host's services. */
static const struct {
    const char *type, *place, *options;
} MOUNTS[] = {
    {"proc", "/proc", NULL},
    {"sysfs", "/sys", NULL},
    {"devtmpfs", "/dev", NULL},
    {"devpts", "/dev/pts", "ptmxmode=0666"},
    {"tmpfs", "/dev/shm", NULL},
    {"tmpfs", "/run", NULL},
    {"configfs", "/sys/kernel/config", NULL},
    {"debugfs", "/sys/kernel/debug", NULL},
    {"tracefs", "/sys/kernel/tracing", NULL},
};

static _Noreturn void power_off(void)
{
    sync();
    reboot(RB_POWER_OFF);
    abort();
}

static _Noreturn void fail(const char *what)
{
    fprintf(stderr, "lab init: %s: %s\n", what, strerror(errno));
    power_off();
}

/* The whole file with a NUL behind it. */
static char *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "r");
    if (!file)
        fail(path);
    char *text = NULL;
    FILE *memory = open_memstream(&text, size);
    for (int c; (c = getc(file)) != EOF;)
        putc(c, memory);
    putc(0, memory);
    fclose(memory);
    fclose(file);
    return text;
}

static char **read_strings(const char *path)
{
    size_t size, count = 0;
    char *text = read_file(path, &size), **strings = calloc(size + 1, sizeof *strings);
    for (char *at = text; at < text + size - 1; at += strlen(at) + 1)
        strings[count++] = at;
    return strings;
}

/* No interrupts of real devices feed the guest's random numbers; programs would wait for them. */
static void seed_random(void)
{
    struct {
        int bits, size;
        unsigned char seed[64];
    } pool = {512, 64, {1}};
    const int random = open("/dev/random", O_RDWR);
    if (random < 0 || ioctl(random, RNDADDENTROPY, &pool) < 0)
        fail("/dev/random");
    close(random);
}

static void redirect(const char *path, int to)
{
    const int fd = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
    if (fd < 0 || dup2(fd, to) < 0)
        fail(path);
    close(fd);
}

static _Noreturn void run(char **argv, char **env, const char *folder)
{
    setsid();
    redirect("stdout", 1);
    redirect("stderr", 2);
    if (chdir(folder) != 0 || dup2(open("/dev/null", O_RDONLY), 0) < 0) {
        perror(folder);
        _exit(126);
    }
    execvpe(argv[0], argv, env);
    const int error = errno;
    perror(argv[0]);
    _exit(error == ENOENT ? 127 : 126);
}

/* Of the command; whatever else ends is waited for, too. */
static int wait_for(pid_t command, long seconds)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    const time_t end = now.tv_sec + seconds;
    sigset_t child;
    sigemptyset(&child);
    sigaddset(&child, SIGCHLD);
    for (;;) {
        int status;
        for (pid_t ended; (ended = waitpid(-1, &status, WNOHANG)) > 0;)
            if (ended == command)
                return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        clock_gettime(CLOCK_MONOTONIC, &now);
        if (now.tv_sec >= end)
            return 124;
        sigtimedwait(&child, NULL, &(struct timespec){1, 0});
    }
}

int main(void)
{
    const char *job = getenv("LAB_JOB");
    if (!job || chdir(job) != 0)
        fail("LAB_JOB");
    for (size_t i = 0; i < sizeof MOUNTS / sizeof *MOUNTS; i++) {
        mkdir(MOUNTS[i].place, 0755);
        if (mount(MOUNTS[i].type, MOUNTS[i].place, MOUNTS[i].type, 0, MOUNTS[i].options) != 0)
            fail(MOUNTS[i].place);
    }
    mkdir("/run/tmp", 01777);
    seed_random();

    size_t size;
    char **argv = read_strings("argv"), **env = read_strings("env");
    const char *folder = read_file("cwd", &size);
    const long seconds = atol(read_file("seconds", &size));
    sigset_t child;
    sigemptyset(&child);
    sigaddset(&child, SIGCHLD);
    sigprocmask(SIG_BLOCK, &child, NULL);
    const pid_t command = fork();
    if (command < 0)
        fail("fork");
    if (command == 0) {
        sigprocmask(SIG_UNBLOCK, &child, NULL);
        run(argv, env, folder);
    }
    const int status = wait_for(command, seconds);
    kill(-1, SIGKILL);
    while (wait(NULL) > 0)
        ;
    FILE *file = fopen("status", "w");
    if (!file || fprintf(file, "%d\n", status) < 0 || fclose(file) != 0)
        fail("status");
    power_off();
}
