/* SPDX-License-Identifier: MIT
 * The picture that the host has drawn: in memory, in files, on a framebuffer. */
#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <png.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "gadget.h"

static void open_framebuffer(struct picture *picture, const char *path)
{
    struct fb_var_screeninfo screen;
    struct fb_fix_screeninfo memory;
    const int file = open(path, O_RDWR | O_CLOEXEC);
    if (file < 0)
        fail("--framebuffer: %s: %s", path, strerror(errno));
    if (ioctl(file, FBIOGET_VSCREENINFO, &screen) != 0 || ioctl(file, FBIOGET_FSCREENINFO, &memory) != 0)
        fail("--framebuffer: %s is not a framebuffer: %s", path, strerror(errno));
    if (screen.bits_per_pixel != 16 && screen.bits_per_pixel != 24 && screen.bits_per_pixel != 32)
        fail("--framebuffer: %s has %u bits a pixel; 16, 24 and 32 are known", path, screen.bits_per_pixel);
    if (screen.xres < picture->width || screen.yres < picture->height)
        fail("--framebuffer: %s has %ux%u pixels, fewer than the display's %ux%u; give --size", path, screen.xres,
             screen.yres, picture->width, picture->height);
    /* Mapped: Linux (6.1) does not notice a write that ends with its line. */
    picture->framebuffer = mmap(NULL, memory.smem_len, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (picture->framebuffer == MAP_FAILED)
        fail("--framebuffer: %s cannot be mapped: %s", path, strerror(errno));
    close(file);
    picture->framebuffer += (size_t)screen.yoffset * memory.line_length + screen.xoffset * screen.bits_per_pixel / 8;
    picture->framebuffer_bits = screen.bits_per_pixel;
    picture->framebuffer_line = memory.line_length;
}

enum { PATH_ROOM = 4096 };

/* Pictures are written beside their place, and then put there. */
static FILE *open_part(const char *path, char part[PATH_ROOM])
{
    snprintf(part, PATH_ROOM, "%s.part", path);
    return fopen(part, "we");
}

/* Now, not when the first picture is there. And only files: what is put in the place of a device is in everybody's way. */
static void check_output(const char *path)
{
    struct stat there;
    if (stat(path, &there) == 0 && !S_ISREG(there.st_mode))
        fail("-o: %s is not a file: name one that is, or a new one", path);
    char part[PATH_ROOM];
    FILE *stream = open_part(path, part);
    if (!stream)
        fail("-o: %s cannot be written: %s", path, strerror(errno));
    fclose(stream);
    unlink(part);
}

void picture_open(struct picture *picture, const struct options *options)
{
    *picture = (struct picture){
        .width = options->width, .height = options->height, .output = options->output, .each = options->each};
    picture->pixels = calloc((size_t)options->width * options->height, 3);
    if (!picture->pixels)
        fail("no memory for %ux%u pixels", options->width, options->height);
    if (options->output)
        check_output(options->output);
    if (options->framebuffer)
        open_framebuffer(picture, options->framebuffer);
}

/* Little-endian r, g, b from the top bit down, as nearly every framebuffer has them. */
static void show_line(const struct picture *picture, unsigned x, unsigned y, unsigned width)
{
    const uint8_t *in = picture->pixels + 3 * ((size_t)y * picture->width + x);
    const unsigned bytes = picture->framebuffer_bits / 8;
    uint8_t *out = picture->framebuffer + (size_t)y * picture->framebuffer_line + (size_t)x * bytes;
    for (unsigned i = 0; i < width; i++, in += 3, out += bytes) {
        const unsigned rgb565 = ((unsigned)in[0] >> 3) << 11 | ((unsigned)in[1] >> 2) << 5 | (unsigned)in[2] >> 3;
        const uint32_t value = bytes == 2 ? rgb565 : (uint32_t)in[0] << 16 | (uint32_t)in[1] << 8 | in[2];
        for (unsigned b = 0; b < bytes; b++)
            out[b] = (uint8_t)(value >> 8 * b);
    }
}

/* ---- files ---- */

static const char *suffix(const char *path)
{
    const char *name = strrchr(path, '/');
    const char *dot = strrchr(name ? name : path, '.');
    return dot ? dot : path + strlen(path);
}

static bool write_pixels(const struct picture *picture, FILE *stream)
{
    const char *kind = suffix(picture->output);
    if (strcmp(kind, ".png") == 0) {
        png_image image = {
            .version = PNG_IMAGE_VERSION, .width = picture->width, .height = picture->height, .format = PNG_FORMAT_RGB};
        return png_image_write_to_stdio(&image, stream, 0, picture->pixels, 0, NULL);
    }
    if (strcmp(kind, ".ppm") == 0)
        fprintf(stream, "P6 %u %u 255\n", picture->width, picture->height);
    const size_t count = (size_t)picture->width * picture->height;
    return fwrite(picture->pixels, 3, count, stream) == count;
}

static bool write_file(const struct picture *picture, const char *path)
{
    char part[PATH_ROOM];
    FILE *stream = open_part(path, part);
    if (!stream) {
        warn("%s: %s", path, strerror(errno));
        return false;
    }
    const bool good = write_pixels(picture, stream) && !ferror(stream);
    if (fclose(stream) == 0 && good && rename(part, path) == 0)
        return true;
    warn("%s: could not be written: %s", path, strerror(errno));
    unlink(part);
    return false;
}

bool picture_write(const struct picture *picture)
{
    return !picture->output || write_file(picture, picture->output);
}

static void write_next(struct picture *picture)
{
    char path[PATH_ROOM];
    const char *kind = suffix(picture->output);
    snprintf(path, sizeof path, "%.*s-%06u%s", (int)(kind - picture->output), picture->output, ++picture->files, kind);
    (void)write_file(picture, path);
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
    if (picture->framebuffer)
        show_line(picture, picture->box.x, picture->next, picture->box.w);
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
    picture->shown = on;
}

const struct gud_device_ops picture_ops = {
    .window = window, .line = line, .end = end, .display = display, .busy = NULL};
