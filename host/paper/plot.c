/* SPDX-License-Identifier: MIT
 * gnuplot as a process: a script in, a picture out. */
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/message.h"
#include "paper/paper.h"

extern char **environ;

static char *read_all(int descriptor, size_t *size)
{
    char *text = NULL;
    size_t room = 0;
    *size = 0;
    for (;;) {
        if (*size == room && !(text = realloc(text, room = room * 2 + 65536)))
            fail("out of memory");
        const ssize_t got = read(descriptor, text + *size, room - *size);
        if (got == 0)
            return text;
        if (got < 0 && errno != EINTR)
            fail("gnuplot: its output could not be read: %s", strerror(errno));
        if (got > 0)
            *size += (size_t)got;
    }
}

/* Its standard error is dropped: gnuplot's complaints take many lines; the script is kept for whoever wants to see them. */
static char *run(const char *directory, char *const arguments[], size_t *size, int *status)
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        fail("gnuplot: no pipe to it: %s", strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addchdir_np(&actions, directory);
    pid_t child;
    const int error = posix_spawnp(&child, arguments[0], &actions, NULL, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (error)
        fail("gnuplot: %s; install gnuplot-nox, or pass --no-plots for the CSV files and the report alone",
             strerror(error));
    char *text = read_all(ends[0], size);
    close(ends[0]);
    while (waitpid(child, status, 0) < 0)
        if (errno != EINTR)
            fail("gnuplot: %s", strerror(errno));
    return text;
}

const char *plot_terminal(void)
{
    char *const arguments[] = {"gnuplot", "-d", "-e", "set print '-'; print GPVAL_TERMINALS", NULL};
    size_t size;
    int status;
    char *text = run(".", arguments, &size, &status);
    const bool good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    const char *terminal = NULL;
    if (good && memmem(text, size, " pngcairo ", 10))
        terminal = "pngcairo";
    else if (good && memmem(text, size, " svg ", 5))
        terminal = "svg";
    free(text);
    if (!terminal)
        fail("gnuplot: it runs, but draws neither PNG (pngcairo) nor SVG; install gnuplot-nox, or pass --no-plots");
    return terminal;
}

char *plot_run(const char *directory, const char *script, size_t *size)
{
    char *const arguments[] = {"gnuplot", "-d", (char *)script, NULL};
    int status;
    char *picture = run(directory, arguments, size, &status);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || *size == 0) {
        free(picture);
        fail("gnuplot: no picture from %s/%s; run `gnuplot %s` there to see why, or pass --no-plots", directory, script,
             script);
    }
    return picture;
}
