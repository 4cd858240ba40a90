/* SPDX-License-Identifier: MIT
 * A mesh that turns, frame after frame. */
#ifndef GLINT_MESH_STREAM_H
#define GLINT_MESH_STREAM_H

#include "plan/plan.h"
#include "stream/stream.h"

struct mesh_stream;
struct mesh_stream *mesh_stream_new(const struct stream_options *options); /* reads the mesh */
void mesh_stream_free(struct mesh_stream *stream);
/* Once the size and the format are known. */
void mesh_stream_start(struct mesh_stream *stream, const struct shading *shading, uint32_t width, uint32_t height);
/* The picture so many seconds after the start, under the shading's light. */
void mesh_stream_draw(struct mesh_stream *stream, double seconds, const struct shading *shading, uint8_t *pixels);

/* To a device that holds the mesh: looks for it, before the start, and ends the program where it holds none or another; what it draws it by; where the
 * mesh is so many seconds after the start. */
enum sink_result mesh_device_find(struct mesh_stream *stream, struct sink *sink);
enum sink_result mesh_device_send(struct mesh_stream *stream, struct sink *sink);
enum sink_result mesh_device_send_pose(struct mesh_stream *stream, struct sink *sink, double seconds,
                                       const struct shading *shading, struct plan_result *result);

#endif
