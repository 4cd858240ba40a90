/* SPDX-License-Identifier: MIT */
#include "sinks/wires/device.h"

#include <dirent.h>
#include <grp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/memory.h"

char *device_permission(const char *path)
{
    struct stat status;
    const struct group *group = stat(path, &status) == 0 ? getgrgid(status.st_gid) : NULL;
    const bool shared = group && group->gr_gid != 0 && (status.st_mode & 0060) == 0060;
    return shared ? formatted(
                        "permission denied; join the group %s (`sudo usermod -aG %s $USER`, then log in again) or run "
                        "as root",
                        group->gr_name, group->gr_name)
                  : formatted("permission denied; give it to a group of yours by a udev rule (`SUBSYSTEM==\"%s\", "
                              "GROUP=\"%s\", MODE=\"0660\"`) or run as root",
                              strstr(path, "spidev") ? "spidev" : "gpio", strstr(path, "spidev") ? "spi" : "gpio");
}

unsigned device_names(const char *prefix, char ***names)
{
    struct dirent **entries;
    const int found = scandir("/dev", &entries, NULL, versionsort);
    unsigned count = 0;
    *names = allocate(found > 0 ? (size_t)found : 1, sizeof **names);
    for (int i = 0; i < found; i++) {
        const char *name = entries[i]->d_name;
        const size_t length = strlen(prefix);
        if (strncmp(name, prefix, length) == 0 && name[length] && !name[length + strspn(name + length, "0123456789.")])
            (*names)[count++] = copied(name);
        free(entries[i]);
    }
    if (found >= 0)
        free(entries);
    return count;
}

void device_names_free(char **names, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        free(names[i]);
    free(names);
}
