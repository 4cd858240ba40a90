/* SPDX-License-Identifier: MIT */
#include "unit.h"

#include "lab.h"
#include "soon.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

enum { PROCESSES_MAX = 8 };
static pid_t running[PROCESSES_MAX];

/* Puts one process in the place of another; 0: none. */
static void replace(pid_t old, pid_t new)
{
    for (size_t i = 0; i < PROCESSES_MAX; i++)
        if (running[i] == old) {
            running[i] = new;
            return;
        }
    fail_msg("more than %d programs at a time", PROCESSES_MAX);
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
    replace(0, process->pid);
    close(output);
    free(command);
    free(exec_command);
}

void process_wait_for(const struct process *process, const char *text)
{
    for (unsigned looks = 0;;) {
        size_t size;
        char *written = run_for_output(&size, "cat %s", process->output);
        const bool found = strstr(written, text);
        if (!found && !wait_more(&looks))
            fail_msg("no '%s', but:\n%s", text, written);
        free(written);
        if (found)
            return;
    }
}

int process_end(struct process *process, int signal)
{
    if (signal)
        kill(process->pid, signal);
    int status = 0;
    for (unsigned looks = 0; waitpid(process->pid, &status, WNOHANG) != process->pid;)
        if (!wait_more(&looks))
            fail_msg("the program goes on after signal %d", signal);
    replace(process->pid, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/* Asked at first, as a gadget that is killed stays on its bus. */
void processes_end(void)
{
    for (size_t i = 0; i < PROCESSES_MAX; i++) {
        if (!running[i])
            continue;
        kill(running[i], SIGTERM);
        for (unsigned looks = 0; waitpid(running[i], NULL, WNOHANG) == 0;)
            if (!wait_more(&looks))
                kill(running[i], SIGKILL);
        running[i] = 0;
    }
}

int lab_clean(void **state)
{
    (void)state;
    processes_end();
    chips_remove();
    return 0;
}

void wait_for_file(const char *path)
{
    for (unsigned looks = 0; access(path, F_OK) != 0;)
        if (!wait_more(&looks))
            fail_msg("no %s", path);
}
