/* SPDX-License-Identifier: MIT
 * Sink y4m: all frames in one YUV4MPEG2 file, which players and encoders read. C444 keeps every pixel's colour; BT.601 in
 * its limited range is what the format means where it says nothing. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/output.h"
#include "sinks/frames.h"
#include "sinks/outputs.h"
#include "sinks/write.h"

static const char frame_head[] = "FRAME\n";

struct y4m {
    struct sink sink;
    struct output *output;
    char head[128];
    size_t planes_bytes;
    uint8_t *planes; /* a frame: its head, then Y, Cb, Cr */
    unsigned long frames;
};

/* The rate as a fraction: the continued fraction of `fps`, up to the first convergent that is the same to 12 digits. Numbers
 * with a few decimals end there, as 29.97 = 2997/100. */
static void rate_fraction(double fps, long *numerator, long *denominator)
{
    const double limit = 2e9; /* readers take 31 bits */
    double p[2] = {1, floor(fps)}, q[2] = {0, 1}, rest = fps - floor(fps);
    while (fabs(p[1] / q[1] - fps) > 1e-12 * fps) {
        const double whole = floor(1 / rest);
        const double next_p = whole * p[1] + p[0], next_q = whole * q[1] + q[0];
        if (next_p > limit || next_q > limit)
            break;
        rest = 1 / rest - whole;
        p[0] = p[1];
        q[0] = q[1];
        p[1] = next_p;
        q[1] = next_q;
    }
    *numerator = (long)p[1];
    *denominator = (long)q[1];
}

static struct sink *open_y4m(const struct sink_wish *wish)
{
    long numerator, denominator;
    frames_without_alpha(wish, "y4m");
    rate_fraction(wish->fps, &numerator, &denominator);
    struct y4m *y4m = allocate(1, sizeof *y4m);
    y4m->sink = (struct sink){.format = wish->format < 0 ? GLINT_RGB888 : (enum glint_format)wish->format,
                              .align_x = 1,
                              .whole_frames = true,
                              .max_bytes = SIZE_MAX,
                              .name = strcmp(wish->output, "-") == 0 ? "standard output" : wish->output};
    sink_size(&y4m->sink, wish);
    snprintf(y4m->head, sizeof y4m->head, "YUV4MPEG2 W%u H%u F%ld:%ld Ip A1:1 C444 XCOLORRANGE=LIMITED\n",
             y4m->sink.width, y4m->sink.height, numerator, denominator);
    y4m->planes_bytes = sizeof frame_head - 1 + (size_t)3 * y4m->sink.width * y4m->sink.height;
    y4m->planes = allocate(y4m->planes_bytes, 1);
    memcpy(y4m->planes, frame_head, sizeof frame_head - 1);
    y4m->output = output_open(wish->output);
    return &y4m->sink;
}

/* BT.601: Y = (299 R + 587 G + 114 B) / 1000, Cb = (B - Y) / 1.772, Cr = (R - Y) / 1.402, of 0..255. Limited range scales Y to
 * 16..235 (219 steps) and both others to 16..240 (224 steps around 128). With all decimals multiplied out these are whole
 * numbers over one denominator each, rounded once; `ROUNDED` keeps the dividend positive: the sums exceed -16 d. */
#define ROUNDED(sum, d) ((uint8_t)(((sum) + (d) / 2) / (d)))

static void convert(const uint8_t *rgb, size_t pixels, uint8_t *planes)
{
    enum { Y_OF = 1000 * 255, CB_OF = 886 * 255, CR_OF = 701 * 255 };
    for (size_t i = 0; i < pixels; i++) {
        const int r = rgb[3 * i], g = rgb[3 * i + 1], b = rgb[3 * i + 2];
        planes[i] = ROUNDED(219 * (299 * r + 587 * g + 114 * b) + 16 * Y_OF, Y_OF);
        planes[pixels + i] = ROUNDED(112 * (886 * b - 299 * r - 587 * g) + 128 * CB_OF, CB_OF);
        planes[2 * pixels + i] = ROUNDED(112 * (701 * r - 587 * g - 114 * b) + 128 * CR_OF, CR_OF);
    }
}

static enum sink_result send_y4m(struct sink *sink, const struct frame *frame, const struct piece *pieces, size_t count)
{
    (void)pieces;
    (void)count;
    struct y4m *y4m = (struct y4m *)sink;
    uint8_t *rgb = frame_rgb(frame);
    convert(rgb, (size_t)sink->width * sink->height, y4m->planes + sizeof frame_head - 1);
    free(rgb);
    const int descriptor = fileno(y4m->output->stream);
    enum sink_result result = SINK_SENT;
    if (!y4m->frames)
        result = sink_write(descriptor, sink->name, y4m->head, strlen(y4m->head));
    if (result == SINK_SENT)
        result = sink_write(descriptor, sink->name, y4m->planes, y4m->planes_bytes);
    y4m->frames += result == SINK_SENT;
    return result;
}

static void finish_y4m(struct sink *sink)
{
    struct y4m *y4m = (struct y4m *)sink;
    if (!y4m->frames) /* stopped before the first: no file */
        return;
    struct output *output = y4m->output;
    y4m->output = NULL;
    output_close(output);
}

static void close_y4m(struct sink *sink)
{
    struct y4m *y4m = (struct y4m *)sink;
    if (y4m->output)
        output_discard(y4m->output);
    free(y4m->planes);
    free(y4m);
}

const struct sink_kind sink_y4m = {
    .name = "y4m",
    .summary = "a YUV4MPEG2 video for ffmpeg and mpv: -o FILE; - is a pipe",
    .output = &output_one_file,
    .every_frame = true,
    .wants_fps = true,
    .examples = "  glint stream coin --to y4m --fps 60 -o coin.y4m\n"
                "  glint stream sphere --to y4m -o - | mpv -\n",
    .pixels = {.open = open_y4m, .send = send_y4m, .finish = finish_y4m, .close = close_y4m},
};
