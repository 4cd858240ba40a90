/* SPDX-License-Identifier: MIT */
#include "unit.h"

#include "lab.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { TENTHS = 100 };

static void sleep_a_tenth(void)
{
    nanosleep(&(struct timespec){.tv_nsec = 100000000}, NULL);
}

void process_start(struct process *process, const char *format, ...)
{
    char *command, *exec_command;
    va_list arguments;
    va_start(arguments, format);
    assert_true(vasprintf(&command, format, arguments) >= 0);
    va_end(arguments);
    assert_true(asprintf(&exec_command, "exec %s", command) >= 0);
    snprintf(process->output, sizeof process->output, "/run/tmp/process.XXXXXX");
    const int output = mkstemp(process->output);
    assert_true(output >= 0);
    process->pid = fork();
    assert_true(process->pid >= 0);
    if (process->pid == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        dup2(output, 1);
        dup2(output, 2);
        execl("/bin/sh", "sh", "-c", exec_command, (char *)NULL);
        _exit(127);
    }
    close(output);
    free(command);
    free(exec_command);
}

void process_wait_for(const struct process *process, const char *text)
{
    size_t size;
    for (int i = 0; i < TENTHS; i++) {
        char *written = run_for_output(&size, "cat %s", process->output);
        const bool found = strstr(written, text);
        free(written);
        if (found)
            return;
        sleep_a_tenth();
    }
    char *written = run_for_output(&size, "cat %s", process->output);
    fail_msg("no '%s' in ten seconds, but:\n%s", text, written);
}

int process_end(struct process *process, int signal)
{
    if (signal)
        kill(process->pid, signal);
    int status = 0;
    for (int i = 0; i < TENTHS; i++, sleep_a_tenth())
        if (waitpid(process->pid, &status, WNOHANG) == process->pid)
            return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    kill(process->pid, SIGKILL);
    fail_msg("the program goes on ten seconds after signal %d", signal);
    return -1;
}

void wait_for_file(const char *path)
{
    for (int i = 0; access(path, F_OK) != 0; i++, sleep_a_tenth())
        if (i == TENTHS)
            fail_msg("no %s in ten seconds", path);
}
