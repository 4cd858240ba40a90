/* SPDX-License-Identifier: MIT */
#include "unit.h"

#include "lab.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>

static char *command_line(const char *format, va_list arguments)
{
    char *command;
    assert_true(vasprintf(&command, format, arguments) >= 0);
    return command;
}

static int status_of(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int run(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *command = command_line(format, arguments);
    va_end(arguments);
    const int status = system(command);
    free(command);
    return status_of(status);
}

char *run_for_output(size_t *size, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *command = command_line(format, arguments), *text;
    va_end(arguments);
    FILE *pipe = popen(command, "r"), *memory = open_memstream(&text, size);
    assert_non_null(pipe);
    assert_non_null(memory);
    for (int c; (c = getc(pipe)) != EOF;)
        putc(c, memory);
    assert_int_equal(fclose(memory), 0);
    const int status = status_of(pclose(pipe));
    if (status != 0)
        fail_msg("status %d: %s", status, command);
    free(command);
    return text;
}
