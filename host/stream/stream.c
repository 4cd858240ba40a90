/* SPDX-License-Identifier: MIT */
#include "stream/stream.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/stop.h"
#include "draw/canvas.h"
#include "draw/shading.h"
#include "image/format.h"
#include "image/picture.h"
#include "plan/plan.h"
#include "stream/device.h"
#include "stream/light.h"
#include "stream/mesh_stream.h"
#include "stream/stats.h"

enum { USUAL_WIDTH = 320, USUAL_HEIGHT = 240 }; /* of built-in scenes */

/* ---- the sink ---- */

static struct sink *open_sink; /* closed however the program ends */

static void close_sink(void)
{
    struct sink *sink = open_sink;
    open_sink = NULL;
    if (sink)
        sink_close(sink);
}

/* ---- the stream ---- */

struct stream {
    const struct stream_options *options;
    struct sink_wish wish;
    struct scene *scene;
    struct shading shading;
    struct canvas *canvas;
    struct mesh_stream *mesh; /* instead of scene and canvas; NULL: no mesh */
    struct light_path *path;
    struct plan *plan;
    struct stream_stats *stats;
    uint8_t *pixels[2]; /* of this frame and of the one before, in turn */
    bool known;         /* the sink shows the frame before */
    double sent;        /* seconds_now() of what was sent last */
};

static void choose_size(struct stream *stream, const struct scene_maps *maps)
{
    const struct scene_options *scene = &stream->options->look.scene;
    uint32_t width, height;
    scene_maps_size(maps, &width, &height);
    if (width > SIDE_MAX || height > SIDE_MAX)
        fail("the map is %ux%u pixels; a stream has at most %d a side: cut it by --size", width, height, SIDE_MAX);
    stream->wish =
        (struct sink_wish){.width = (uint16_t)scene->width,
                           .height = (uint16_t)scene->height,
                           .format = stream->options->look.has_format ? (int)stream->options->look.shading.format : -1,
                           .default_width = (uint16_t)(width ? width : USUAL_WIDTH),
                           .default_height = (uint16_t)(height ? height : USUAL_HEIGHT),
                           .fps = stream->options->fps,
                           .frames = stream->options->frames,
                           .demo = stream->options->shade_demo,
                           .output = stream->options->output};
}

static struct sink *open_wished(const struct stream *stream)
{
    return sink_open(stream->options->kind, stream->options->shade_device, &stream->wish);
}

/* Looks for the device again, which must have the same size and format as before. */
static bool find_again(struct stream *stream)
{
    const struct sink old = *open_sink;
    close_sink();
    stream->known = false;
    open_sink = open_wished(stream);
    if (!open_sink)
        return false;
    if (open_sink->width != old.width || open_sink->height != old.height || open_sink->format != old.format)
        fail("%s: came back as a display of %ux%u in %s, not %ux%u in %s; start again to use it", open_sink->name,
             open_sink->width, open_sink->height, format_names[open_sink->format], old.width, old.height,
             format_names[old.format]);
    if (stream->plan) {
        plan_free(stream->plan);
        stream->plan = plan_new(open_sink);
    }
    return true;
}

/* The device's mesh, as often as the device comes back. False where interrupted. */
static bool find_mesh(struct stream *stream)
{
    for (;;) {
        const enum sink_result found = mesh_device_find(stream->mesh, open_sink);
        if (found == SINK_SENT)
            return true;
        if (found == SINK_INTERRUPTED || !find_again(stream))
            return false;
    }
}

/* False where interrupted. */
static bool start(struct stream *stream)
{
    const struct stream_options *options = stream->options;
    struct scene_maps *maps = scene_maps_read(&options->look.scene);
    stream->mesh = options->look.scene.mesh.name ? mesh_stream_new(options) : NULL;
    stream->path = light_path_new(options); /* files are opened before anything is done to a device */
    choose_size(stream, maps);
    if (options->kind->output && options->kind->output->begin)
        options->kind->output->begin(options->output, options->frames);
    stop_when_asked(); /* until here a signal ends the program at once */
    open_sink = open_wished(stream);
    if (!open_sink) {
        scene_maps_free(maps);
        return false;
    }
    const struct sink *sink = open_sink;
    if (!stream->mesh && !options->shade_demo)
        stream->scene = scene_of_shading_options(&options->look, maps, sink->width, sink->height);
    scene_maps_free(maps);
    stream->shading =
        shading_of_options(&options->look, sink->format, stream->scene ? &stream->scene->finish : &plain_finish);
    shading_options_check(NULL, &options->look, &stream->shading);
    if (stream->mesh && sink->shades && !find_mesh(stream))
        return false;
    sink = open_sink; /* it may be another one by now */
    if (stream->mesh)
        mesh_stream_start(stream->mesh, &stream->shading, sink->width, sink->height);
    else if (stream->scene)
        stream->canvas = canvas_new(stream->scene, &stream->shading);
    light_path_start(stream->path, options, &stream->shading, sink->width, sink->height);
    stream->stats = stats_new(sink);
    if (sink->shades)
        return true;
    stream->plan = plan_new(sink);
    for (unsigned i = 0; i < 2; i++)
        stream->pixels[i] = allocate(sink->height, format_line_bytes(sink->format, sink->width));
    return true;
}

static void end(struct stream *stream)
{
    close_sink();
    plan_free(stream->plan);
    stats_free(stream->stats);
    light_path_free(stream->path);
    canvas_free(stream->canvas);
    mesh_stream_free(stream->mesh);
    scene_free(stream->scene);
    free(stream->pixels[0]);
    free(stream->pixels[1]);
}

/* To a device that shades: the scene if it does not have it yet and shows not its own, and the light, or the mesh's pose. */
static bool send_light(struct stream *stream, double seconds, bool is_new)
{
    struct plan_result result;
    for (;;) {
        enum sink_result sent = SINK_SENT;
        if (!stream->known && !stream->options->shade_demo)
            sent = stream->mesh ? mesh_device_send(stream->mesh, open_sink)
                                : device_send_scene(open_sink, stream->scene, &stream->shading);
        if (sent == SINK_SENT && stream->options->board_lights)
            sent = device_read_light(open_sink, &stream->shading);
        if (sent == SINK_SENT)
            sent = stream->mesh ? mesh_device_send_pose(stream->mesh, open_sink, seconds, &stream->shading, &result)
                                : device_send_light(open_sink, &stream->shading, &result);
        if (sent == SINK_SENT) {
            stream->known = true;
            if (is_new)
                stats_add(stream->stats, &result);
            return true;
        }
        if (sent == SINK_INTERRUPTED || !find_again(stream))
            return false;
    }
}

/* What is sent of a frame. Of one that changed nothing a little once a second, where nothing else tells that the display is gone or
 * was reset. */
static struct plan_result to_send(const struct stream *stream, const uint8_t *last, const struct frame *frame)
{
    const struct plan_result result = plan_frame(stream->plan, last, frame);
    if (result.count || !open_sink->kind->may_go || seconds_now() < stream->sent + 1)
        return result;
    return plan_little(stream->plan, frame);
}

/* A frame after the one with the pixels `before`, if the sink shows that. */
static bool send_pixels(struct stream *stream, const uint8_t *before, const uint8_t *pixels, bool is_new)
{
    for (;;) {
        struct sink *sink = open_sink;
        const struct frame frame = {sink->width, sink->height, sink->format,
                                    format_line_bytes(sink->format, sink->width), pixels};
        const struct plan_result result = to_send(stream, stream->known ? before : NULL, &frame);
        enum sink_result sent = SINK_SENT;
        if (result.count)
            stream->sent = seconds_now();
        if (result.count || sink->kind->every_frame)
            sent = sink->kind->pixels.send(sink, &frame, result.pieces, result.count);
        if (sent == SINK_SENT) {
            stream->known = true;
            if (is_new)
                stats_add(stream->stats, &result);
            return true;
        }
        if (sent == SINK_INTERRUPTED || !find_again(stream))
            return false;
    }
}

static double seconds_of(const struct stream *stream, unsigned long index)
{
    return (double)index / (stream->options->fps > 0 ? stream->options->fps : USUAL_FPS);
}

/* Until the light of frame `index` is there. Meanwhile the frame before is sent again, once a second, where nothing else tells that the display is
 * gone; the light of a board's own picture is not, which is to expire. */
static bool wait_for_light(struct stream *stream, unsigned long index)
{
    enum { AGAIN_MS = 1000 };
    const uint8_t *shown = stream->pixels[(index + 1) % 2];
    while (!light_path_is_ready(stream->path, AGAIN_MS)) {
        if (!stream->known || !open_sink->kind->may_go || stream->options->shade_demo)
            continue;
        if (!(stream->options->shade_device ? send_light(stream, seconds_of(stream, index - 1), false)
                                            : send_pixels(stream, shown, shown, false)))
            return false;
    }
    return true;
}

/* Frame `index`; false where it is the end. */
static bool send_frame(struct stream *stream, unsigned long index)
{
    const double seconds = seconds_of(stream, index);
    if (stream_stopped() || !wait_for_light(stream, index) ||
        !light_path_next(stream->path, seconds, &stream->shading) || stream_stopped())
        return false;
    if (stream->options->shade_device)
        return send_light(stream, seconds, true);
    uint8_t *pixels = stream->pixels[index % 2];
    if (stream->mesh)
        mesh_stream_draw(stream->mesh, seconds, &stream->shading, pixels);
    else
        canvas_draw(stream->canvas, &stream->shading, pixels);
    return send_pixels(stream, stream->pixels[(index + 1) % 2], pixels, true);
}

static void run(struct stream *stream)
{
    enum { LATE_S = 1 };
    const struct stream_options *options = stream->options;
    const bool paced = options->fps > 0 && options->kind->paced;
    const bool covered = sink_takes_standard_output(options->kind, options->output) && isatty(STDOUT_FILENO);
    double began = seconds_now();
    for (unsigned long i = 0; !options->frames || i < options->frames; i++) {
        if (paced) {
            wait_until(began + (double)i / options->fps);
            const double late = seconds_now() - (began + (double)i / options->fps);
            if (late > LATE_S) /* after a pause, or by a display that is slower: it goes on, and does not rush */
                began += late;
        }
        if (!send_frame(stream, i))
            break;
        if (options->stats && !covered) /* by frames on the same terminal */
            stats_show(stream->stats);
    }
    progress_end();
}

int stream_run(const struct stream_options *options)
{
    struct stream stream = {.options = options};
    atexit(close_sink); /* after fail(), too */
    if (start(&stream)) {
        run(&stream);
        if (open_sink)
            sink_finish(open_sink);
        close_sink();
        if (options->stats || options->json)
            stats_print(stream.stats, options->json,
                        sink_takes_standard_output(options->kind, options->output) ? stderr : stdout);
    }
    end(&stream);
    return stop_status();
}
