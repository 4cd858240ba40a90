/* SPDX-License-Identifier: MIT */
#include "image/svg.h"

#include <string.h>

#include "base/message.h"

bool svg_begins(const uint8_t *head, size_t length)
{
    size_t at = length >= 3 && memcmp(head, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    while (at < length && head[at] && strchr(" \t\r\n", head[at]))
        at++;
    return at < length && head[at] == '<';
}

#if GLINT_WITH_SVG
#include <dlfcn.h>
#include <errno.h>
#include <librsvg/rsvg.h>
#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "image/picture.h"

enum { BYTES_MAX = 1 << 26 }; /* of a file: a larger one is a mistake or an attack */

const char *svg_library(void)
{
    return "librsvg " LIBRSVG_VERSION;
}

/* librsvg brings some 40 libraries, which would make each start of glint slower: they are loaded for the first SVG. */
#define FUNCTIONS(X)                                                                                                   \
    X(rsvg_handle_new_from_data)                                                                                       \
    X(rsvg_handle_set_dpi)                                                                                             \
    X(rsvg_handle_get_intrinsic_size_in_pixels)                                                                        \
    X(rsvg_handle_get_intrinsic_dimensions)                                                                            \
    X(rsvg_handle_render_document)                                                                                     \
    X(cairo_image_surface_create)                                                                                      \
    X(cairo_image_surface_get_data)                                                                                    \
    X(cairo_image_surface_get_stride)                                                                                  \
    X(cairo_create)                                                                                                    \
    X(cairo_status)                                                                                                    \
    X(cairo_status_to_string)                                                                                          \
    X(cairo_surface_flush)                                                                                             \
    X(cairo_destroy)                                                                                                   \
    X(cairo_surface_destroy)                                                                                           \
    X(g_object_unref)
#define POINTER(name) __typeof__(name) *name;
static struct {
    FUNCTIONS(POINTER)
} lib;

static void load(const char *picture)
{
    void *handle = dlopen("librsvg-2.so.2", RTLD_NOW);
    bool good = handle != NULL;
#define FIND(name) good = good && (*(void **)&lib.name = dlsym(handle, #name)) != NULL;
    FUNCTIONS(FIND)
    if (!good)
        fail("%s: this is an SVG, and librsvg cannot be loaded: %s; install librsvg2-2, or convert it: rsvg-convert -o "
             "logo.png logo.svg",
             picture, dlerror());
}

static char *read_all(FILE *stream, const char *name, const uint8_t *head, size_t *length)
{
    size_t room = 1 << 16, count = *length;
    char *bytes = allocate(room, 1);
    memcpy(bytes, head, count);
    for (size_t got; (got = fread(bytes + count, 1, room - count, stream)) > 0; count += got) {
        if (count + got < room)
            continue;
        if (room >= BYTES_MAX)
            fail("%s: an SVG of more than %d MB; convert it to PNG", name, BYTES_MAX >> 20);
        if (!(bytes = realloc(bytes, room *= 2)))
            fail("out of memory");
    }
    if (ferror(stream))
        fail("%s: could not be read: %s", name, strerror(errno));
    *length = count;
    return bytes;
}

static _Noreturn void fail_svg(const char *name, const GError *error)
{
    fail("%s: this is not an SVG that can be drawn: %s; save it again, or convert it to PNG", name,
         error ? error->message : "it is damaged");
}

/* In pixels as it states them, else those of its viewBox. */
static void own_size(RsvgHandle *svg, const char *name, uint32_t *width, uint32_t *height)
{
    gdouble wide = 0, high = 0;
    gboolean has_width, has_height, has_box;
    RsvgLength lengths[2];
    RsvgRectangle box;
    if (!lib.rsvg_handle_get_intrinsic_size_in_pixels(svg, &wide, &high)) {
        lib.rsvg_handle_get_intrinsic_dimensions(svg, &has_width, &lengths[0], &has_height, &lengths[1], &has_box,
                                                 &box);
        wide = has_box ? box.width : 0;
        high = has_box ? box.height : 0;
    }
    if (!(wide > 0 && high > 0))
        fail("%s: this SVG states no size; give --size WxH", name);
    if (wide > SIDE_MAX || high > SIDE_MAX || ceil(wide) * ceil(high) > PIXELS_MAX)
        fail("%s: this SVG states %.0fx%.0f pixels; at most %d a side and %d in all are allowed: give --size WxH", name,
             wide, high, SIDE_MAX, PIXELS_MAX);
    *width = (uint32_t)ceil(wide);
    *height = (uint32_t)ceil(high);
}

/* Cairo's pixels are words of alpha, red, green and blue, the colours times alpha. */
static void take_pixels(cairo_surface_t *surface, struct image *image)
{
    const uint8_t *lines = lib.cairo_image_surface_get_data(surface);
    const size_t stride = (size_t)lib.cairo_image_surface_get_stride(surface);
    uint16_t *sample = image->samples;
    for (size_t y = 0; y < image->height; y++)
        for (size_t x = 0; x < image->width; x++, sample += 4) {
            uint32_t word;
            memcpy(&word, lines + y * stride + 4 * x, sizeof word);
            const uint32_t alpha = word >> 24;
            for (int k = 0; k < 3; k++) {
                const uint32_t times_alpha = word >> (16 - 8 * k) & 255;
                sample[k] = (uint16_t)(alpha ? 257 * ((255 * times_alpha + alpha / 2) / alpha) : 0);
            }
            sample[3] = (uint16_t)(257 * alpha);
        }
}

struct image *svg_read(FILE *stream, const char *name, const uint8_t *head, size_t length, uint32_t width,
                       uint32_t height)
{
    GError *error = NULL;
    load(name);
    char *bytes = read_all(stream, name, head, &length);
    RsvgHandle *svg = lib.rsvg_handle_new_from_data((const guint8 *)bytes, length, &error);
    if (!svg)
        fail_svg(name, error);
    lib.rsvg_handle_set_dpi(svg, 96);
    if (!width)
        own_size(svg, name, &width, &height);
    cairo_surface_t *surface = lib.cairo_image_surface_create(CAIRO_FORMAT_ARGB32, (int)width, (int)height);
    cairo_t *cairo = lib.cairo_create(surface);
    const RsvgRectangle all = {0, 0, width, height};
    if (!lib.rsvg_handle_render_document(svg, cairo, &all, &error))
        fail_svg(name, error);
    lib.cairo_surface_flush(surface);
    if (lib.cairo_status(cairo) != CAIRO_STATUS_SUCCESS)
        fail("%s: could not be drawn: %s", name, lib.cairo_status_to_string(lib.cairo_status(cairo)));
    struct image *image = allocate(1, sizeof *image);
    *image = (struct image){strdup(name), width, height, 4, 8, false, NULL};
    if (!image->name)
        fail("out of memory");
    image->samples = allocate((size_t)width * height, 4 * sizeof *image->samples);
    take_pixels(surface, image);
    lib.cairo_destroy(cairo);
    lib.cairo_surface_destroy(surface);
    lib.g_object_unref(svg);
    free(bytes);
    return image;
}

#else

const char *svg_library(void)
{
    return NULL;
}

struct image *svg_read(FILE *stream, const char *name, const uint8_t *head, size_t length, uint32_t width,
                       uint32_t height)
{
    (void)stream;
    (void)head;
    (void)length;
    (void)width;
    (void)height;
    fail("%s: this is an SVG, and glint was built without librsvg; convert it: rsvg-convert -o logo.png logo.svg, or "
         "install librsvg2-dev and build glint again",
         name);
}

#endif
