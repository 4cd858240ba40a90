/* SPDX-License-Identifier: MIT
 * Frames as files: their names, and their pixels as pictures. */
#ifndef GLINT_SINK_FRAMES_H
#define GLINT_SINK_FRAMES_H

#include "sinks/sink.h"

/* The name of frame `index`, malloc'd: `pattern` with the number where it has its %d or %04d. */
char *frame_name(const char *pattern, unsigned long index);
/* Is there a place for a number in it? Refuses a pattern that has two, or a % of another kind. */
bool frame_pattern(const struct argp_state *state, const char *option, const char *pattern);
/* Fails where one of so many frames would get the name of a file that is read; 0: their number is unknown. */
void frames_check(const char *pattern, unsigned long count);
struct picture *frame_picture(const struct frame *frame); /* image/picture.h; with the format's alpha */
uint8_t *frame_rgb(const struct frame *frame);            /* RGB888, malloc'd */
/* For what shows or holds no alpha: without it the colours of soft edges would be wrong. Fails where the format has one. */
void frames_without_alpha(const struct sink_wish *wish, const char *sink);

#endif
