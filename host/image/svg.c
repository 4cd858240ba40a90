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
#include <stdarg.h>
#include <stdlib.h>
#include <unistd.h>

#include "base/child.h"
#include "base/memory.h"
#include "image/picture.h"

enum { CHANNELS = 4, BYTES_MAX = 1 << 26 }; /* bytes of a file: a larger one is a mistake or an attack */

const char *svg_library(void)
{
    return "librsvg " LIBRSVG_VERSION;
}

/* What the child sends first; without a message the samples follow. */
struct head {
    char message[256];
    uint32_t width, height;
};
struct source {
    char *bytes;
    size_t len;
    uint32_t width, height; /* as asked; 0: its own */
};

/* ---- the child ---- */

/* librsvg brings some 40 libraries, which would make each start of glint slower, and which are then only where they can do no harm. */
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
    X(cairo_surface_flush)
#define POINTER(name) __typeof__(name) *name;
static struct {
    FUNCTIONS(POINTER)
} lib;
#define FUNCTION(name) {#name, (void **)&lib.name},
static const struct {
    const char *name;
    void **at;
} functions[] = {FUNCTIONS(FUNCTION)};

static _Noreturn __attribute__((format(printf, 2, 3))) void refuse(int out, const char *format, ...)
{
    struct head head = {.message = ""};
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(head.message, sizeof head.message, format, arguments);
    va_end(arguments);
    child_send(out, &head, sizeof head);
    _exit(0);
}

static void load(int out)
{
    void *handle = dlopen("librsvg-2.so.2", RTLD_NOW);
    bool good = handle != NULL;
    for (size_t i = 0; good && i < sizeof functions / sizeof *functions; i++)
        good = (*functions[i].at = dlsym(handle, functions[i].name)) != NULL;
    if (!good)
        refuse(
            out,
            "this is an SVG, and librsvg cannot be loaded: %.80s; install librsvg2-2, or convert it: rsvg-convert -o "
            "logo.png logo.svg",
            dlerror());
}

static _Noreturn void refuse_svg(int out, const GError *error)
{
    refuse(out, "this is not an SVG that can be drawn: %.120s; save it again, or convert it to PNG",
           error ? error->message : "it is damaged");
}

/* In pixels as it states them, else those of its viewBox. */
static void own_size(int out, RsvgHandle *svg, struct head *head)
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
        refuse(out, "this SVG states no size; give --size WxH");
    if (wide > SIDE_MAX || high > SIDE_MAX || ceil(wide) * ceil(high) > PIXELS_MAX)
        refuse(out, "this SVG states %.0fx%.0f pixels; at most %d a side and %d in all are allowed: give --size WxH",
               wide, high, SIDE_MAX, PIXELS_MAX);
    head->width = (uint32_t)ceil(wide);
    head->height = (uint32_t)ceil(high);
}

/* Cairo's pixels are words of alpha, red, green and blue, the colours times alpha. */
static void send_pixels(int out, cairo_surface_t *surface, const struct head *head)
{
    const uint8_t *lines = lib.cairo_image_surface_get_data(surface);
    const size_t stride = (size_t)lib.cairo_image_surface_get_stride(surface);
    uint16_t *const samples = allocate(head->width, CHANNELS * sizeof *samples);
    for (size_t y = 0; y < head->height; y++) {
        uint16_t *sample = samples;
        for (size_t x = 0; x < head->width; x++, sample += CHANNELS) {
            uint32_t word;
            memcpy(&word, lines + y * stride + 4 * x, sizeof word);
            const uint32_t alpha = word >> 24;
            for (int k = 0; k < 3; k++) {
                const uint32_t times_alpha = word >> (16 - 8 * k) & 255;
                sample[k] = (uint16_t)(alpha ? 257 * ((255 * times_alpha + alpha / 2) / alpha) : 0);
            }
            sample[3] = (uint16_t)(257 * alpha);
        }
        child_send(out, samples, (size_t)head->width * CHANNELS * sizeof *samples);
    }
}

static void draw(const void *of, int out)
{
    const struct source *source = of;
    struct head head = {"", source->width, source->height};
    GError *error = NULL;
    load(out);
    RsvgHandle *svg = lib.rsvg_handle_new_from_data((const guint8 *)source->bytes, source->len, &error);
    if (!svg)
        refuse_svg(out, error);
    lib.rsvg_handle_set_dpi(svg, 96);
    if (!head.width)
        own_size(out, svg, &head);
    cairo_surface_t *surface = lib.cairo_image_surface_create(CAIRO_FORMAT_ARGB32, (int)head.width, (int)head.height);
    cairo_t *cairo = lib.cairo_create(surface);
    const RsvgRectangle all = {0, 0, head.width, head.height};
    if (!lib.rsvg_handle_render_document(svg, cairo, &all, &error))
        refuse_svg(out, error);
    lib.cairo_surface_flush(surface);
    if (lib.cairo_status(cairo) != CAIRO_STATUS_SUCCESS)
        refuse(out, "could not be drawn: %s", lib.cairo_status_to_string(lib.cairo_status(cairo)));
    child_send(out, &head, sizeof head);
    send_pixels(out, surface, &head);
}

/* ---- the parent, which believes nothing ---- */

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
        bytes = enlarge(bytes, room *= 2, 1);
    }
    if (ferror(stream))
        fail("%s: could not be read: %s", name, strerror(errno));
    *length = count;
    return bytes;
}

static void receive(struct child *child, const char *name, void *to, size_t bytes)
{
    const char *wrong = child_receive(child, to, bytes);
    if (wrong)
        fail("%s: %s", name, wrong);
}

struct image *svg_read(FILE *stream, const char *name, const uint8_t *head, size_t length, uint32_t width,
                       uint32_t height)
{
    struct source source = {.len = length, .width = width, .height = height};
    struct child child;
    struct head drawn;
    if (width && !picture_size_fits(width, height))
        fail("%s: drawn at %ux%u pixels; at most %d a side and %d in all are allowed: choose a smaller --size or "
             "--filter",
             name, width, height, SIDE_MAX, PIXELS_MAX);
    source.bytes = read_all(stream, name, head, &source.len);
    child_start(&child, name, "librsvg", draw, &source);
    receive(&child, name, &drawn, sizeof drawn);
    drawn.message[sizeof drawn.message - 1] = 0;
    if (drawn.message[0])
        fail("%s: %s", name, drawn.message);
    const bool as_asked = width ? drawn.width == width && drawn.height == height
                                : drawn.width && drawn.height && picture_size_fits(drawn.width, drawn.height);
    if (!as_asked)
        fail("%s: librsvg drew it in another size; convert it to PNG", name);
    struct image *image = allocate(1, sizeof *image);
    *image = (struct image){
        .name = copied(name), .width = drawn.width, .height = drawn.height, .channels = CHANNELS, .bits = 8};
    const size_t samples = (size_t)drawn.width * drawn.height * CHANNELS;
    image->samples = allocate(samples, sizeof *image->samples);
    receive(&child, name, image->samples, samples * sizeof *image->samples);
    child_end(&child);
    free(source.bytes);
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
