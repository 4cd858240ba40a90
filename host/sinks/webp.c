/* SPDX-License-Identifier: MIT
 * Sink webp: all frames in one animated WebP, which browsers and README pages show, by libwebp. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include "base/argp.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/parse.h"
#include "image/picture.h"
#include "sinks/animation.h"
#include "sinks/frames.h"
#include "sinks/outputs.h"

/* ---- its option ---- */

enum key { KEY_QUALITY = 0x700 };
static long quality = 100;

static const struct argp_option argp_options[] = {
    {NULL, 0, NULL, 0, "Animations (--to webp):", 9},
    {"quality", KEY_QUALITY, "Q", 0,
     "Quality, 0..100: lower takes fewer bytes (default 100: every pixel as it is drawn)", 9},
    {NULL, 0, NULL, 0, NULL, 0}};

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    if (key != KEY_QUALITY)
        return ARGP_ERR_UNKNOWN;
    quality = parse_integer(state, "--quality", text, 0, 100);
    return 0;
}

static const struct argp options_argp = {argp_options, parse_option, NULL, NULL, NULL, NULL, NULL};

/* ---- the sink ---- */

enum { FRAME_MS_MAX = (1 << 24) - 1 };

struct webp {
    struct sink sink;
    struct animation animation;
    WebPAnimEncoder *encoder;
    WebPConfig config;
};

static struct sink *open_webp(const struct sink_wish *wish)
{
    struct webp *webp = allocate(1, sizeof *webp);
    WebPAnimEncoderOptions options;
    webp->sink = animation_sink(wish);
    if (webp->sink.width > WEBP_MAX_DIMENSION || webp->sink.height > WEBP_MAX_DIMENSION)
        fail("--size: %ux%u is more than the %d pixels a side of a WebP; choose a smaller --size, or --to png",
             webp->sink.width, webp->sink.height, WEBP_MAX_DIMENSION);
    if (wish->fps < 1000. / FRAME_MS_MAX)
        fail("--fps: %g is no rate of a WebP, whose frames last at most %d s; give .00006 or more", wish->fps,
             FRAME_MS_MAX / 1000);
    if ((double)wish->frames * 1000 / wish->fps > INT_MAX)
        fail("--fps: %lu frames at %g a second last longer than the 24 days of a WebP; give a higher --fps",
             wish->frames, wish->fps);
    if (!WebPConfigInit(&webp->config) || !WebPAnimEncoderOptionsInit(&options))
        fail("--to webp: the library is another version than glint was built for");
    webp->config.lossless = quality == 100;
    webp->config.quality = webp->config.lossless ? 75 : (float)quality; /* without loss: how hard it tries */
    webp->config.use_sharp_yuv = true;
    options.anim_params.loop_count = 0; /* without end */
    if (!webp->config.lossless)
        options.kmax = 1; /* each frame whole: what the encoder leaves of the one before are blocks that are seen */
    webp->encoder = WebPAnimEncoderNew(webp->sink.width, webp->sink.height, &options);
    if (!webp->encoder)
        fail("%s: no WebP of %ux%u pixels can be written", wish->output, webp->sink.width, webp->sink.height);
    animation_open(&webp->animation, wish);
    return &webp->sink;
}

/* NULL: that was the last. The time is when the frame begins. */
static void add(struct webp *webp, WebPPicture *picture)
{
    const long time_ms = animation_time(&webp->animation, webp->animation.frames, 1000);
    if (time_ms > INT_MAX)
        fail("--fps: a WebP lasts at most 24 days; give a higher one");
    if (!WebPAnimEncoderAdd(webp->encoder, picture, (int)time_ms, &webp->config))
        fail("%s: %s", webp->sink.name, WebPAnimEncoderGetError(webp->encoder));
}

static enum sink_result send_webp(struct sink *sink, const struct frame *frame, const struct piece *pieces,
                                  size_t count)
{
    (void)pieces;
    (void)count;
    struct webp *webp = (struct webp *)sink;
    struct picture *picture = frame_picture(frame);
    uint8_t *rgb = picture->channels == 4 ? NULL : picture_rgb(picture);
    WebPPicture to;
    if (!WebPPictureInit(&to))
        fail("--to webp: the library is another version than glint was built for");
    to.width = sink->width;
    to.height = sink->height;
    to.use_argb = true;
    if (!(rgb ? WebPPictureImportRGB(&to, rgb, 3 * sink->width)
              : WebPPictureImportRGBA(&to, picture->samples, 4 * sink->width)))
        fail("out of memory");
    add(webp, &to);
    webp->animation.frames++;
    WebPPictureFree(&to);
    free(rgb);
    picture_free(picture);
    return SINK_SENT;
}

static void finish_webp(struct sink *sink)
{
    struct webp *webp = (struct webp *)sink;
    if (!webp->animation.frames) /* stopped before the first: no file */
        return;
    add(webp, NULL);
    WebPData data;
    WebPDataInit(&data);
    if (!WebPAnimEncoderAssemble(webp->encoder, &data))
        fail("%s: %s", sink->name, WebPAnimEncoderGetError(webp->encoder));
    animation_write(&webp->animation, sink, data.bytes, data.size);
    WebPDataClear(&data);
}

static void close_webp(struct sink *sink)
{
    struct webp *webp = (struct webp *)sink;
    animation_discard(&webp->animation);
    WebPAnimEncoderDelete(webp->encoder);
    free(webp);
}

static char *library(void)
{
    const int version = WebPGetEncoderVersion();
    return formatted("libwebp %d.%d.%d", version >> 16, version >> 8 & 255, version & 255);
}

const struct sink_kind sink_webp = {
    .name = "webp",
    .summary = "an animated WebP, every pixel kept, argb8888 with alpha: -o FILE",
    .output = &output_one_file,
    .every_frame = true,
    .wants_fps = true,
    .options = (const struct argp *const[]){&options_argp, NULL},
    .examples = "  glint stream coin --size 240x240 --to webp -o coin.webp\n"
                "  glint stream coin --format argb8888 --cut-out --to webp -o coin.webp\n",
    .pixels = {.open = open_webp, .send = send_webp, .finish = finish_webp, .close = close_webp},
    .library = library,
};
