/* SPDX-License-Identifier: MIT
 * Running the built command from a test, in an empty directory of its own. */
#ifndef GLINT_COMMAND_H
#define GLINT_COMMAND_H

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "unit.h"

/* What the last command said, standard output and standard error together. */
static char said[1 << 16];

/* GLINT and GLINT_SOURCE are set by tier.mk, absolute. */
static inline const char *from_environment(const char *name)
{
    const char *value = getenv(name);
    if (!value)
        fail_msg("%s is not set: run the tests by make", name);
    return value;
}

/* Runs "glint ARGUMENTS" by the shell; its exit status. */
static inline int glint(const char *arguments)
{
    char line[4096];
    snprintf(line, sizeof line, "'%s' %s 2>&1", from_environment("GLINT"), arguments);
    FILE *pipe = popen(line, "r");
    assert_non_null(pipe);
    const size_t len = fread(said, 1, sizeof said - 1, pipe);
    said[len] = 0;
    const int status = pclose(pipe);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static inline bool says(const char *text)
{
    return strstr(said, text) != NULL;
}

/* One line that begins as every message does and holds `text`. */
static inline void assert_one_line_about(const char *text)
{
    if (strncmp(said, "glint", 5) != 0 || strchr(said, '\n') != said + strlen(said) - 1 || !says(text))
        fail_msg("expected one line about '%s', got:\n%s", text, said);
}

/* As argp ends: a line that says what is wrong, a line that points to --help, exit status 2. */
static inline void assert_usage_error(const char *arguments, const char *text)
{
    const int status = glint(arguments);
    if (status != 2 || !says(text) || !says("--help"))
        fail_msg("expected a usage error about '%s' for: %s\ngot status %d and:\n%s", text, arguments, status, said);
}

static inline void assert_quiet_success(const char *arguments)
{
    const int status = glint(arguments);
    if (status != 0 || said[0])
        fail_msg("glint %s: status %d, said:\n%s", arguments, status, said);
}

static inline void assert_failure(const char *arguments, const char *about)
{
    const int status = glint(arguments);
    if (status != 1)
        fail_msg("glint %s: status %d, said:\n%s", arguments, status, said);
    assert_one_line_about(about);
}

static inline size_t read_file(const char *path, uint8_t *bytes, size_t room)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t len = fread(bytes, 1, room, file);
    fclose(file);
    return len;
}

/* Into `said`, as if glint() had run the command. */
static inline void read_words(const char *path)
{
    const size_t len = read_file(path, (uint8_t *)said, sizeof said - 1);
    said[len] = 0;
}

static inline bool same_file(const char *a, const char *b)
{
    static uint8_t in_a[1 << 20], in_b[1 << 20];
    const size_t len = read_file(a, in_a, sizeof in_a);
    assert_true(len > 0 && len < sizeof in_a);
    return read_file(b, in_b, sizeof in_b) == len && memcmp(in_a, in_b, len) == 0;
}

static inline void assert_same_file(const char *a, const char *b)
{
    if (!same_file(a, b))
        fail_msg("%s and %s differ", a, b);
}

static inline bool exists(const char *path)
{
    return access(path, F_OK) == 0;
}

/* Files in a directory, hidden ones counted. */
static inline int files_in(const char *directory)
{
    char line[200];
    snprintf(line, sizeof line, "ls -A '%s' | wc -l", directory);
    FILE *pipe = popen(line, "r");
    assert_non_null(pipe);
    int count = -1;
    assert_int_equal(fscanf(pipe, "%d", &count), 1);
    pclose(pipe);
    return count;
}

/* Group fixtures. */
static char own_directory[] = "/tmp/glint-test-XXXXXX";

static inline int enter_own_directory(void **state)
{
    (void)state;
    return mkdtemp(own_directory) && chdir(own_directory) == 0 ? 0 : -1;
}

static inline int leave_own_directory(void **state)
{
    (void)state;
    char line[64];
    snprintf(line, sizeof line, "rm -rf '%s'", own_directory);
    return chdir("/") == 0 && system(line) == 0 ? 0 : -1;
}

#endif
