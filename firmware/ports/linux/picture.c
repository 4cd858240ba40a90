/* SPDX-License-Identifier: MIT
 * The picture that the host has drawn: in memory, in files, on a framebuffer. */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "message.h"
#include "picture.h"
#include "picture_file.h"

static void open_framebuffer(struct picture *picture, const char *path)
{
    struct fb_var_screeninfo screen;
    struct fb_fix_screeninfo memory;
    const int file = open(path, O_RDWR | O_CLOEXEC);
    if (file < 0)
        fail("--framebuffer: %s: %s", path, strerror(errno));
    if (ioctl(file, FBIOGET_VSCREENINFO, &screen) != 0 || ioctl(file, FBIOGET_FSCREENINFO, &memory) != 0)
        fail("--framebuffer: %s is not a framebuffer: %s", path, strerror(errno));
    struct framebuffer *const framebuffer = &picture->framebuffer;
    const char *trouble = framebuffer_layout(framebuffer, &screen, &memory, picture->width, picture->height);
    if (trouble)
        fail("--framebuffer: %s, %ux%u, %u bits a pixel: %s", path, screen.xres, screen.yres, screen.bits_per_pixel,
             trouble);
    /* Mapped: Linux (6.1) does not notice a write that ends with its line. */
    uint8_t *const bytes = mmap(NULL, framebuffer->bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (bytes == MAP_FAILED)
        fail("--framebuffer: %s cannot be mapped: %s", path, strerror(errno));
    close(file);
    framebuffer->pixels = bytes + framebuffer->offset;
}

void picture_open(struct picture *picture, const struct options *options)
{
    *picture = (struct picture){
        .width = options->width, .height = options->height, .output = options->output, .each = options->each};
    picture->pixels = calloc((size_t)options->width * options->height, 3);
    if (!picture->pixels)
        fail("no memory for %ux%u pixels", options->width, options->height);
    if (options->output)
        picture_file_check(options->output);
    if (options->framebuffer)
        open_framebuffer(picture, options->framebuffer);
}

/* ---- files ---- */

bool picture_write(const struct picture *picture)
{
    return !picture->output || picture_file_write(picture->output, picture->width, picture->height, picture->pixels);
}

/* So many and no more: a host that draws for days must not fill the disk. */
static void write_next(struct picture *picture)
{
    if (picture->files == picture->each)
        return;
    char path[PATH_ROOM];
    picture_file_number(path, picture->output, ++picture->files);
    (void)picture_file_write(path, picture->width, picture->height, picture->pixels);
    if (picture->files == picture->each)
        warn("--each: that was file %u, the last one; --each=COUNT sets another limit", picture->files);
}

/* ---- what the device does with it ---- */

static void window(void *context, uint16_t x, uint16_t y, uint16_t width, uint16_t height)
{
    struct picture *picture = context;
    picture->box = (struct glint_box){x, y, width, height};
    picture->next = y;
}

static void line(void *context, const uint8_t *pixels, size_t bytes)
{
    struct picture *picture = context;
    memcpy(picture->pixels + 3 * ((size_t)picture->next * picture->width + picture->box.x), pixels, bytes);
    if (picture->framebuffer.pixels && picture->shown)
        framebuffer_put(&picture->framebuffer, picture->box.x, picture->next, picture->box.w, pixels);
    picture->next++;
}

static void end(void *context, bool whole)
{
    struct picture *picture = context;
    if (picture->each && whole)
        write_next(picture);
}

static void display(void *context, bool on, uint8_t brightness)
{
    struct picture *picture = context;
    (void)brightness;
    if (on == picture->shown)
        return;
    picture->shown = on;
    for (unsigned y = 0; picture->framebuffer.pixels && y < picture->height; y++)
        framebuffer_put(&picture->framebuffer, 0, y, picture->width,
                        on ? picture->pixels + 3 * (size_t)y * picture->width : NULL);
}

const struct gud_device_ops picture_ops = {
    .window = window, .line = line, .end = end, .display = display, .busy = NULL};
