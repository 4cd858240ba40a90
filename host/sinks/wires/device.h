/* SPDX-License-Identifier: MIT
 * Devices in /dev: which there are, and who may open them. */
#ifndef GLINT_WIRES_DEVICE_H
#define GLINT_WIRES_DEVICE_H

/* What to do where a device may not be opened, malloc'd: "join the group gpio: ...". */
char *device_permission(const char *path);
/* The names in /dev that begin with `prefix` and end with digits or dots, in order; malloc'd, as each is. */
unsigned device_names(const char *prefix, char ***names);
void device_names_free(char **names, unsigned count);

#endif
