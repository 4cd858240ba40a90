/* SPDX-License-Identifier: MIT
 * Where the light is in each frame: on an orbit, or where a file, standard input or a sensor says. */
#ifndef GLINT_STREAM_LIGHT_H
#define GLINT_STREAM_LIGHT_H

#include "stream/stream.h"

struct light_path;
/* Opens the file of lights or the sensor, where one is named. */
struct light_path *light_path_new(const struct stream_options *options);
/* The path of the shading's first directional light, else of its first point or spot about the picture's middle. */
void light_path_start(struct light_path *path, const struct stream_options *options, const struct shading *shading,
                      uint32_t width, uint32_t height);
/* Is there something to be read, so that the next call does not wait for it, within so many milliseconds? Where nothing is read: true. */
bool light_path_is_ready(const struct light_path *path, int ms);
/* Moves the light to where it is `seconds` after the start, or to the next line's; false where there is none. */
bool light_path_next(struct light_path *path, double seconds, struct shading *shading);
void light_path_free(struct light_path *path);

#endif
