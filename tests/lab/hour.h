/* SPDX-License-Identifier: MIT
 * A stream that goes on for an hour of the guest's time: does it grow? */
#ifndef LAB_HOUR_H
#define LAB_HOUR_H

#include "unit.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

struct process_has {
    unsigned memory_kb, descriptors;
};

static inline struct process_has process_has(pid_t pid)
{
    struct process_has has = {0, 0};
    char path[64], line[200];
    snprintf(path, sizeof path, "/proc/%d/status", (int)pid);
    FILE *status = fopen(path, "r");
    assert_non_null(status);
    while (fgets(line, sizeof line, status))
        if (strncmp(line, "VmRSS:", 6) == 0)
            sscanf(line + 6, "%u", &has.memory_kb);
    fclose(status);
    assert_true(has.memory_kb > 0);
    snprintf(path, sizeof path, "/proc/%d/fd", (int)pid);
    DIR *folder = opendir(path);
    assert_non_null(folder);
    while (readdir(folder))
        has.descriptors++;
    closedir(folder);
    return has;
}

/* Begun just now; it goes on afterwards. */
static inline void keeps_what_it_has_for_an_hour(pid_t pid)
{
    sleep(360);
    const struct process_has begun = process_has(pid);
    sleep(3240);
    const struct process_has now = process_has(pid);
    if (now.memory_kb > begun.memory_kb + 256 || now.descriptors > begun.descriptors)
        fail_msg("after six minutes %u KB and %u descriptors, after an hour %u and %u", begun.memory_kb,
                 begun.descriptors, now.memory_kb, now.descriptors);
}

#endif
