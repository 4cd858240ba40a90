/* SPDX-License-Identifier: MIT
 * gnuplot as a process: a script in, a picture out. */
#include "paper/plot.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/child.h"
#include "base/memory.h"
#include "base/message.h"

enum { COMPLAINT_BYTES = 100 };

static char *read_all(int descriptor, size_t *size)
{
    char *text = NULL;
    size_t room = 0;
    *size = 0;
    for (;;) {
        if (*size == room)
            text = enlarge(text, room = room * 2 + 65536, 1);
        const ssize_t got = read(descriptor, text + *size, room - *size);
        if (got == 0)
            return text;
        if (got < 0 && errno != EINTR)
            fail("gnuplot: its output could not be read: %s", strerror(errno));
        if (got > 0)
            *size += (size_t)got;
    }
}

/* gnuplot's complaint is the last line on its standard error that is not blank; the ones before show the place. */
static void read_complaint(int descriptor, char *complaint, size_t room)
{
    char text[4096];
    const ssize_t length = pread(descriptor, text, sizeof text - 1, 0);
    text[length > 0 ? length : 0] = '\0';
    *complaint = '\0';
    for (char *rest = text, *line; (line = strsep(&rest, "\n"));)
        if (line[strspn(line, " \t\r")])
            snprintf(complaint, room, "%s", line);
}

enum { NOT_RUN = 127 }; /* what shells say, too */

static void become(const char *directory, char *const arguments[], int output, int errors)
{
    const int null = open("/dev/null", O_RDONLY);
    if (dup2(errors, STDERR_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 && dup2(null, STDIN_FILENO) >= 0 &&
        chdir(directory) == 0)
        execvp(arguments[0], arguments);
    dprintf(errors, "%s", strerror(errno));
    _exit(NOT_RUN);
}

static char *run(const char *directory, char *const arguments[], size_t *size, int *status,
                 char complaint[COMPLAINT_BYTES])
{
    int ends[2];
    const int errors = memfd_create("gnuplot", MFD_CLOEXEC);
    if (pipe2(ends, O_CLOEXEC) != 0 || errors < 0)
        fail("gnuplot: no pipe to it: %s", strerror(errno));
    const pid_t parent = getpid(), child = fork();
    if (child < 0)
        fail("gnuplot: no process for it: %s", strerror(errno));
    if (child == 0) {
        child_begin(parent);
        become(directory, arguments, ends[1], errors);
    }
    close(ends[1]);
    char *text = read_all(ends[0], size);
    close(ends[0]);
    while (waitpid(child, status, 0) < 0)
        if (errno != EINTR)
            fail("gnuplot: %s", strerror(errno));
    read_complaint(errors, complaint, COMPLAINT_BYTES);
    close(errors);
    if (WIFEXITED(*status) && WEXITSTATUS(*status) == NOT_RUN)
        fail("gnuplot: %s; install gnuplot-nox, or pass --no-plots for the CSV files and the report alone",
             *complaint ? complaint : "it does not run");
    return text;
}

const char *plot_terminal(void)
{
    char *const arguments[] = {"gnuplot", "-d", "-e", "set print '-'; print GPVAL_TERMINALS", NULL};
    size_t size;
    int status;
    char complaint[COMPLAINT_BYTES];
    char *text = run(".", arguments, &size, &status, complaint);
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
    char complaint[COMPLAINT_BYTES];
    char *picture = run(directory, arguments, size, &status, complaint);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || *size == 0) {
        free(picture);
        fail("gnuplot: no picture from %s: %s; install gnuplot-nox again, or pass --no-plots", script,
             *complaint ? complaint : "it does not say why");
    }
    return picture;
}
