/* SPDX-License-Identifier: MIT
 * Sink gif: all frames in one animated GIF, by giflib. Each frame has 256 colours of its own, of RGB565; only the box that
 * changed since the frame before is written. */
#include <gif_lib.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "image/format.h"
#include "mesh/texture_palette.h"
#include "sinks/animation.h"
#include "sinks/frames.h"
#include "sinks/outputs.h"
#include "sinks/write.h"

enum { UNIT = 100, FPS_MAX = 50 }; /* times are in 1/100 s; browsers take a delay of less than two for ten */

struct gif {
    struct sink sink;
    struct animation animation;
    GifFileType *file;
    uint8_t *bytes; /* of the file, not written yet */
    size_t len, room;
    uint16_t *pixels[2]; /* of this frame and of the one before, in turn, RGB565 */
    uint8_t *indices;
};

static int keep(GifFileType *file, const GifByteType *bytes, int count)
{
    struct gif *gif = file->UserData;
    if (gif->len + (size_t)count > gif->room) {
        gif->room = 2 * (gif->len + (size_t)count);
        gif->bytes = enlarge(gif->bytes, gif->room, 1);
    }
    memcpy(gif->bytes + gif->len, bytes, (size_t)count);
    gif->len += (size_t)count;
    return count;
}

static void check(const struct gif *gif, int status)
{
    if (status != GIF_OK)
        fail("%s: %s", gif->sink.name, GifErrorString(gif->file->Error));
}

static struct sink *open_gif(const struct sink_wish *wish)
{
    frames_without_alpha(wish, "gif");
    if (wish->fps > FPS_MAX || wish->fps < UNIT / 65535.)
        fail("--fps: %g is no rate of a GIF, which shows .002 to %d frames a second", wish->fps, FPS_MAX);
    struct gif *gif = allocate(1, sizeof *gif);
    gif->sink = animation_sink(wish);
    const size_t pixels = (size_t)gif->sink.width * gif->sink.height;
    for (int i = 0; i < 2; i++)
        gif->pixels[i] = allocate(pixels, sizeof *gif->pixels[i]);
    gif->indices = allocate(pixels, 1);
    int error;
    gif->file = EGifOpen(gif, keep, &error);
    if (!gif->file)
        fail("%s: %s", gif->sink.name, GifErrorString(error));
    EGifSetGifVersion(gif->file, true);
    check(gif, EGifPutScreenDesc(gif->file, gif->sink.width, gif->sink.height, 8, 0, NULL));
    check(gif, EGifPutExtensionLeader(gif->file, APPLICATION_EXT_FUNC_CODE));
    check(gif, EGifPutExtensionBlock(gif->file, 11, "NETSCAPE2.0"));
    check(gif, EGifPutExtensionBlock(gif->file, 3, (const uint8_t[]){1, 0, 0})); /* without end */
    check(gif, EGifPutExtensionTrailer(gif->file));
    animation_open(&gif->animation, wish);
    return &gif->sink;
}

/* The least box that holds every pixel that differs; one pixel where none does, since a time needs a picture. */
static struct glint_box changed(const struct gif *gif, const uint16_t *before, const uint16_t *now)
{
    const unsigned width = gif->sink.width, height = gif->sink.height;
    unsigned left = width, right = 0, top = height, bottom = 0;
    for (unsigned y = 0; y < height; y++)
        for (unsigned x = 0; x < width; x++)
            if (before[y * width + x] != now[y * width + x]) {
                left = x < left ? x : left;
                right = x > right ? x : right;
                top = y < top ? y : top;
                bottom = y;
            }
    if (left > right)
        return (struct glint_box){0, 0, 1, 1};
    return (struct glint_box){(uint16_t)left, (uint16_t)top, (uint16_t)(right - left + 1),
                              (uint16_t)(bottom - top + 1)};
}

static ColorMapObject *color_map(const uint16_t *palette, unsigned colors)
{
    GifColorType entries[TEXTURE_COLORS] = {{0, 0, 0}};
    for (unsigned i = 0; i < colors; i++)
        entries[i] = (GifColorType){(uint8_t)(((palette[i] >> 11) * 255 + 15) / 31),
                                    (uint8_t)(((palette[i] >> 5 & 63) * 255 + 31) / 63),
                                    (uint8_t)(((palette[i] & 31) * 255 + 15) / 31)};
    const int bits = GifBitSize((int)colors); /* of 1 colour: 1 */
    ColorMapObject *map = GifMakeMapObject(1 << bits, entries);
    if (!map)
        fail("out of memory");
    return map;
}

static void put_box(struct gif *gif, const struct glint_box *box, const uint16_t *pixels)
{
    uint16_t palette[TEXTURE_COLORS];
    const size_t count = (size_t)box->w * box->h;
    uint16_t *part = allocate(count, sizeof *part);
    for (size_t y = 0; y < box->h; y++)
        memcpy(part + y * box->w, pixels + (box->y + y) * gif->sink.width + box->x, box->w * sizeof *part);
    const unsigned colors = texture_palette(part, count, palette, gif->indices);
    ColorMapObject *map = color_map(palette, colors);
    check(gif, EGifPutImageDesc(gif->file, box->x, box->y, box->w, box->h, false, map));
    for (size_t y = 0; y < box->h; y++)
        check(gif, EGifPutLine(gif->file, gif->indices + y * box->w, box->w));
    GifFreeMapObject(map);
    free(part);
}

/* A frame at a time: a long stream's file is not held in memory. */
static enum sink_result write_kept(struct gif *gif)
{
    const int descriptor = fileno(gif->animation.output->stream);
    const enum sink_result result = sink_write(descriptor, gif->sink.name, gif->bytes, gif->len);
    gif->len = 0;
    return result;
}

static enum sink_result send_gif(struct sink *sink, const struct frame *frame, const struct piece *pieces, size_t count)
{
    (void)pieces;
    (void)count;
    struct gif *gif = (struct gif *)sink;
    struct animation *animation = &gif->animation;
    const unsigned long number = animation->frames++;
    uint8_t *rgb = frame_rgb(frame);
    uint16_t *now = gif->pixels[number % 2];
    for (size_t i = 0; i < (size_t)sink->width * sink->height; i++)
        now[i] = format_nearest_565(&rgb[3 * i]);
    const struct glint_box all = {0, 0, sink->width, sink->height};
    const struct glint_box box = number ? changed(gif, gif->pixels[(number + 1) % 2], now) : all;
    GifByteType block[8];
    const GraphicsControlBlock control = {
        .DisposalMode = DISPOSE_DO_NOT,
        .DelayTime = (int)(animation_time(animation, number + 1, UNIT) - animation_time(animation, number, UNIT)),
        .TransparentColor = NO_TRANSPARENT_COLOR};
    const size_t bytes = EGifGCBToExtension(&control, block);
    check(gif, EGifPutExtension(gif->file, GRAPHICS_EXT_FUNC_CODE, (int)bytes, block));
    put_box(gif, &box, now);
    free(rgb);
    return write_kept(gif);
}

static void finish_gif(struct sink *sink)
{
    struct gif *gif = (struct gif *)sink;
    if (!gif->animation.frames) /* stopped before the first: no file */
        return;
    int error;
    GifFileType *file = gif->file;
    gif->file = NULL;
    if (EGifCloseFile(file, &error) != GIF_OK)
        fail("%s: %s", sink->name, GifErrorString(error));
    animation_write(&gif->animation, sink, gif->bytes, gif->len);
}

static void close_gif(struct sink *sink)
{
    struct gif *gif = (struct gif *)sink;
    int error;
    animation_discard(&gif->animation);
    if (gif->file)
        EGifCloseFile(gif->file, &error);
    free(gif->bytes);
    free(gif->pixels[0]);
    free(gif->pixels[1]);
    free(gif->indices);
    free(gif);
}

static char *library(void)
{
    return formatted("giflib %d.%d.%d", GIFLIB_MAJOR, GIFLIB_MINOR, GIFLIB_RELEASE);
}

const struct sink_kind sink_gif = {
    .name = "gif",
    .summary = "an animated GIF, in 256 colours a frame: -o FILE.gif",
    .output = &output_one_file,
    .every_frame = true,
    .wants_fps = true,
    .examples = "  glint stream teapot --size 160x120 --to gif --fps 20 -o teapot.gif\n",
    .pixels = {.open = open_gif, .send = send_gif, .finish = finish_gif, .close = close_gif},
    .library = library,
};
