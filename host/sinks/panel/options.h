/* SPDX-License-Identifier: MIT
 * The options that describe a panel, for every sink that has one. They also stand in a bus's file. */
#ifndef GLINT_PANEL_OPTIONS_H
#define GLINT_PANEL_OPTIONS_H

#include <argp.h>

#include "panel.h"
#include "sinks/sink.h"

extern const struct argp panel_options_argp;

/* A setting from a file: `name` is that of the option without dashes, or size. False where none has this name. A wrong
 * value ends the program through fail(), named by `origin`. The command line overrides the file. */
bool panel_options_set(const char *origin, const char *name, const char *text);

/* All but the bus: as the options say, else as is usual for the controller and the size. Without a size it is the whole of the
 * controller's memory. `any_size`: also sizes that no known glass has, and the scene's own size where it fits. Ends the
 * program through fail() where the options cannot be met. */
void panel_of_options(struct panel *panel, const struct sink_wish *wish, bool any_size);

#endif
