/* SPDX-License-Identifier: MIT */
#include "stream/mesh_stream.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "draw/canvas.h"
#include "draw/mesh_canvas.h"
#include "draw/mesh_in_device.h"
#include "image/format.h"
#include "mesh/load.h"

struct mesh_stream {
    const struct stream_options *options;
    struct mesh *mesh;
    struct fitted *fitted;
    struct shading *shadings;
    struct mesh_canvas *canvas;
    struct view view; /* at the start */
    uint8_t *behind;  /* or NULL */
};

static void load(struct mesh_stream *stream, const struct mesh_source *source)
{
    stream->mesh = mesh_load(source);
    stream->fitted = mesh_fit(stream->mesh, 0);
    shading_options_grain(&stream->options->look, stream->fitted);
    if (shading_options_one_color(&stream->options->look))
        fitted_forget_colors(stream->fitted);
    if (source->stepped)
        fitted_forget_neighbours(stream->fitted);
}

struct mesh_stream *mesh_stream_new(const struct stream_options *options)
{
    struct mesh_stream *stream = allocate(1, sizeof *stream);
    stream->options = options;
    load(stream, &options->look.scene.mesh);
    return stream;
}

void mesh_stream_free(struct mesh_stream *stream)
{
    if (!stream)
        return;
    mesh_canvas_free(stream->canvas);
    fitted_free(stream->fitted);
    mesh_free(stream->mesh);
    free(stream->shadings);
    free(stream->behind);
    free(stream);
}

void mesh_stream_start(struct mesh_stream *stream, const struct shading *shading, uint32_t width, uint32_t height)
{
    const struct shading_options *look = &stream->options->look;
    stream->view = view_of_options(&look->view, width, height, look->scene.mesh.built_in);
    stream->shadings = mesh_shadings(stream->mesh, shading, shading_options_own(look));
    stream->canvas = mesh_canvas_new(stream->fitted, stream->shadings);
    uint8_t *rgb = scene_backdrop(&look->scene, width, height);
    stream->behind = backdrop_pixels(rgb, width, height, shading);
    mesh_canvas_set_backdrop(stream->canvas, stream->behind);
    free(rgb);
}

static struct view view_at(const struct mesh_stream *stream, double seconds)
{
    const double period = stream->options->turn_period;
    struct view view = stream->view;
    view.turn[1] += period > 0 ? 360 * fmod(seconds / period, 1) : 0;
    return view;
}

void mesh_stream_draw(struct mesh_stream *stream, double seconds, const struct shading *shading, uint8_t *pixels)
{
    const struct view view = view_at(stream, seconds);
    mesh_canvas_draw(stream->canvas, &view, shading, pixels);
}

/* ---- a device that holds the mesh ---- */

/* As it was baked for the device, whatever --split says. */
static void split_as(struct mesh_stream *stream, unsigned degrees)
{
    struct mesh_source source = stream->options->look.scene.mesh;
    source.split = degrees;
    fitted_free(stream->fitted);
    mesh_free(stream->mesh);
    load(stream, &source);
}

/* What has a board hold the mesh. */
static const char *held_by(const struct mesh_stream *stream)
{
    static char text[PATH_MAX + 8];
    const struct mesh_source *source = &stream->options->look.scene.mesh;
    snprintf(text, sizeof text, source->built_in ? "DEMO=%s" : "MESH=%s",
             strcmp(source->name, "-") == 0 ? "FILE" : source->name);
    return text;
}

enum sink_result mesh_device_find(struct mesh_stream *stream, struct sink *sink)
{
    struct light_mesh there;
    bool holds_one;
    if (stream->fitted->mesh.part_count > 1)
        fail("--shade device: a device draws a mesh in one material, and this one has %u; leave it out",
             (unsigned)stream->fitted->mesh.part_count);
    if (stream->fitted->colors)
        fail("--shade device: a device draws a mesh in one colour, and this one has its vertices'; leave it "
             "out, or give one by --color");
    if (stream->fitted->mesh.textures)
        fail("--shade device: a device draws a mesh in one colour, and this one has textures; leave it out, or give "
             "--no-textures");
    const enum sink_result result = sink->kind->shader->find_mesh(sink, &there, &holds_one);
    if (result != SINK_SENT)
        return result;
    if (!holds_one)
        fail("--shade device: %s holds no mesh; leave it out", sink->name);
    if (!mesh_in_device(&there, stream->fitted) && !stream->canvas && there.split >= 1 && there.split <= 180)
        split_as(stream, there.split);
    if (!mesh_in_device(&there, stream->fitted))
        fail("--shade device: %s holds another mesh, of %u vertices and %u triangles; leave it out, or "
             "build the board's firmware with %s",
             sink->name, there.vertices, there.faces, held_by(stream));
    return SINK_SENT;
}

enum sink_result mesh_device_send(struct mesh_stream *stream, struct sink *sink)
{
    struct light_material material;
    const char *refusal = mesh_in_device_refusal(&stream->view, &stream->shadings[0], stream->behind, &material);
    if (refusal)
        fail("--shade device: %s", refusal);
    const enum sink_result found = mesh_device_find(stream, sink); /* it may be another one by now */
    return found == SINK_SENT ? sink->kind->shader->send_mesh(sink, &material) : found;
}

enum sink_result mesh_device_send_pose(struct mesh_stream *stream, struct sink *sink, double seconds,
                                       const struct shading *shading, struct plan_result *result)
{
    const struct view view = view_at(stream, seconds);
    const struct light_pose pose = mesh_in_device_pose(&view, shading);
    *result = (struct plan_result){.count = 1,
                                   .changed = (size_t)sink->width * sink->height,
                                   .whole_bytes = format_line_bytes(sink->format, sink->width) * sink->height};
    return sink->kind->shader->send_pose(sink, &pose, &result->bytes);
}
