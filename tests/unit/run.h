/* SPDX-License-Identifier: MIT
 * Runs the glint command through the shell, in a scratch folder of the test program's own. */
#ifndef GLINT_RUN_H
#define GLINT_RUN_H

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "unit.h"

struct run {
    int status; /* the exit status; 128 + signal */
    char out[65536], err[8192];
};

/* Group set-up and tear-down: the scratch folder becomes the current one. In it .bin/glint is the command under test, so that
 * the shell's $GLINT is one word wherever the repository is. */
static inline int scratch_make(void **state)
{
    char name[] = "/tmp/glint-test.XXXXXX", way[sizeof name + sizeof "/.bin/glint"];
    char *command = getenv("GLINT") ? realpath(getenv("GLINT"), NULL) : NULL;
    if (!command || !mkdtemp(name) || chdir(name) != 0)
        return -1;
    snprintf(way, sizeof way, "%s/.bin/glint", name);
    const bool made = mkdir(".bin", 0700) == 0 && symlink(command, way) == 0 && setenv("GLINT", way, 1) == 0;
    free(command);
    *state = strdup(name);
    return made && *state ? 0 : -1;
}

static inline int scratch_remove(void **state)
{
    char command[64];
    snprintf(command, sizeof command, "rm -rf '%s'", (char *)*state);
    free(*state);
    return chdir("/") == 0 ? system(command) : -1;
}

static inline void read_text(const char *path, char *text, size_t size)
{
    FILE *file = fopen(path, "r");
    const size_t length = file ? fread(text, 1, size - 1, file) : 0;
    text[length] = '\0';
    if (file)
        fclose(file);
}

/* `command` is the shell's, with $GLINT for the command under test: "$GLINT eval 1 >/dev/full". */
static inline struct run *run(const char *command)
{
    static struct run result;
    char *whole;
    assert_true(asprintf(&whole, "{ %s\n} >.out 2>.err", command) > 0);
    const int status = system(whole);
    free(whole);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    read_text(".out", result.out, sizeof result.out);
    read_text(".err", result.err, sizeof result.err);
    return &result;
}

/* Has the child not ended? What waits for a state that it makes asks this, and has no other limit: tests/tally ends what hangs. */
static inline bool lives(pid_t child)
{
    siginfo_t ended = {.si_pid = 0};
    return waitid(P_PID, (id_t)child, &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0;
}

/* lib.a, plain, in the current folder: the one that is built, or one made here. */
static inline int library_make(void)
{
    return run("cp \"$GLINT_LIBRARY\" lib.a 2>/dev/null || "
               "{ mkdir -p o && cd o && gcc -O1 -std=c99 -c \"$GLINT_SOURCE\"/lib/*.c && ar rc ../lib.a *.o; }")
        ->status;
}

static inline void assert_contains(const char *text, const char *part)
{
    if (!strstr(text, part))
        fail_msg("'%s' is not in '%s'", part, text);
}

static inline const struct run *assert_ends(const char *command, int status, const char *part)
{
    const struct run *result = run(command);
    assert_contains(result->err, part);
    assert_int_equal(result->status, status);
    return result;
}

static inline void assert_one_line(const char *text)
{
    const char *newline = strchr(text, '\n');
    if (!newline || newline[1] != '\0')
        fail_msg("not one line: '%s'", text);
}

/* Exit 1 and one line on standard error that holds `part`. */
static inline void assert_fails(const char *command, const char *part)
{
    assert_one_line(assert_ends(command, 1, part)->err);
}

/* Exit 2, nothing on standard output, and one line on standard error that holds `part`. */
static inline void assert_refused(const char *command, const char *part)
{
    const struct run *result = assert_ends(command, 2, part);
    assert_one_line(result->err);
    assert_string_equal(result->out, "");
}

#endif
