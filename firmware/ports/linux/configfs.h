/* SPDX-License-Identifier: MIT
 * The gadget in configfs, and the FunctionFS mount that goes with it. */
#ifndef CONFIGFS_H
#define CONFIGFS_H

#include <stdbool.h>

#include "options.h"

/* Creates the gadget and mounts its FunctionFS; returns the mount point. Fails with what is missing. However the program
 * exits, both are removed. */
const char *configfs_create(const struct options *options);
void configfs_remove(void);
/* On the bus and off; false where the controller is not there. */
bool configfs_plug(void);
bool configfs_unplug(void);
bool configfs_is_lost(void); /* plugged by this program, unbound by another or with its controller */
const char *configfs_udc(void);

#endif
