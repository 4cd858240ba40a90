/* SPDX-License-Identifier: MIT
 * A mesh that turns, frame after frame. */
#ifndef GLINT_MESH_STREAM_H
#define GLINT_MESH_STREAM_H

#include "stream/stream.h"

struct mesh_stream;
struct mesh_stream *mesh_stream_new(const struct stream_options *options); /* reads the mesh */
void mesh_stream_free(struct mesh_stream *stream);
/* Once the size and the format are known. */
void mesh_stream_start(struct mesh_stream *stream, const struct shading *shading, uint32_t width, uint32_t height);
/* The picture so many seconds after the start, under the shading's light. */
void mesh_stream_draw(struct mesh_stream *stream, double seconds, const struct shading *shading, uint8_t *pixels);

#endif
