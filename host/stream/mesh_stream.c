/* SPDX-License-Identifier: MIT */
#include "stream/mesh_stream.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "draw/mesh_canvas.h"
#include "mesh/load.h"

struct mesh_stream {
    const struct stream_options *options;
    struct mesh *mesh;
    struct fitted *fitted;
    struct shading *shadings;
    struct mesh_canvas *canvas;
    struct view view; /* at the start */
};

struct mesh_stream *mesh_stream_new(const struct stream_options *options)
{
    struct mesh_stream *stream = allocate(1, sizeof *stream);
    stream->options = options;
    stream->mesh = mesh_load(&options->look.scene.mesh);
    stream->fitted = mesh_fit(stream->mesh, 0);
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
    free(stream);
}

void mesh_stream_start(struct mesh_stream *stream, const struct shading *shading, uint32_t width, uint32_t height)
{
    const struct shading_options *look = &stream->options->look;
    stream->view = view_of_options(&look->view, width, height, look->scene.mesh.built_in);
    stream->shadings = mesh_shadings(stream->mesh, shading, !look->has_color, !look->shading.n);
    stream->canvas = mesh_canvas_new(stream->fitted, stream->shadings);
}

void mesh_stream_draw(struct mesh_stream *stream, double seconds, const struct shading *shading, uint8_t *pixels)
{
    const double period = stream->options->turn_period;
    struct view view = stream->view;
    view.turn[1] += period > 0 ? 360 * fmod(seconds / period, 1) : 0;
    mesh_canvas_draw(stream->canvas, &view, shading, pixels);
}
