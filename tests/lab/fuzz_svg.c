/* SPDX-License-Identifier: MIT
 * Fuzzes what glint does around librsvg: its child beside a librsvg that answers anything, and what a child sends that a file has taken over. A picture of a size that
 * is allowed comes of it, or a reason. Input: which of both (1), the size that is asked for (2), the file's bytes up to a zero, then the answers. */
#include "fuzz_child.h"

#include <dlfcn.h>
#define dlopen(name, flags) ((void *)&rsvg)
#define dlsym(handle, name) stand_in(name)
static struct input rsvg;
static void *stand_in(const char *name);
#include "../../host/image/svg.c"

/* ---- a librsvg ---- */

enum { PIXELS_HELD = 4096, STRIDE_MORE = 8 };
static struct {
    bool bad; /* as where there is no memory */
    uint8_t *data;
    int stride;
} surface;
static GError error = {0, 0, (char *)"an error"};

static double next_real(void)
{
    double value;
    uint8_t bytes[sizeof value];
    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (uint8_t)next_byte(&rsvg);
    memcpy(&value, bytes, sizeof value);
    return value;
}

static RsvgHandle *new_from_data(const guint8 *data, gsize len, GError **wrong)
{
    unsigned sum = 0;
    for (gsize i = 0; i < len; i++)
        sum += data[i];
    const unsigned answer = next_byte(&rsvg) + (sum & 0);
    *wrong = answer == 1 ? &error : NULL;
    return answer < 2 ? NULL : (RsvgHandle *)&rsvg;
}

static void set_dpi(RsvgHandle *svg, double dpi)
{
    check(svg && dpi > 0);
}

static gboolean size_in_pixels(RsvgHandle *svg, gdouble *wide, gdouble *high)
{
    check(svg);
    *wide = next_real();
    *high = next_real();
    return (gboolean)(next_byte(&rsvg) & 1);
}

static void dimensions(RsvgHandle *svg, gboolean *has_width, RsvgLength *width, gboolean *has_height,
                       RsvgLength *height, gboolean *has_box, RsvgRectangle *box)
{
    check(svg);
    *has_width = *has_height = FALSE;
    *width = *height = (RsvgLength){0, RSVG_UNIT_PX};
    *has_box = (gboolean)(next_byte(&rsvg) & 1);
    *box = (RsvgRectangle){0, 0, next_real(), next_real()};
}

static gboolean render(RsvgHandle *svg, cairo_t *cairo, const RsvgRectangle *all, GError **wrong)
{
    check(svg && cairo && all->width > 0 && all->height > 0);
    const unsigned answer = next_byte(&rsvg);
    *wrong = answer == 1 ? &error : NULL;
    return answer >= 2;
}

static cairo_surface_t *create(cairo_format_t format, int width, int height)
{
    check(format == CAIRO_FORMAT_ARGB32 && width > 0 && height > 0);
    surface.bad = (int64_t)width * height > PIXELS_HELD || next_byte(&rsvg) == 1;
    surface.stride = 4 * width + STRIDE_MORE;
    surface.data = surface.bad ? NULL : malloc((size_t)surface.stride * (size_t)height - STRIDE_MORE);
    for (size_t i = 0; surface.data && i < (size_t)surface.stride * (size_t)height - STRIDE_MORE; i++)
        surface.data[i] = (uint8_t)next_byte(&rsvg);
    return (cairo_surface_t *)&surface;
}

static unsigned char *get_data(cairo_surface_t *of)
{
    check((void *)of == &surface && !surface.bad);
    return surface.data;
}

static int get_stride(cairo_surface_t *of)
{
    check((void *)of == &surface);
    return surface.stride;
}

static cairo_t *new_cairo(cairo_surface_t *of)
{
    return (cairo_t *)of;
}

static cairo_status_t status_of(cairo_t *cairo)
{
    check(cairo);
    return surface.bad ? CAIRO_STATUS_NO_MEMORY : CAIRO_STATUS_SUCCESS;
}

static const char *text_of(cairo_status_t status)
{
    check(status);
    return "no memory";
}

static void flush(cairo_surface_t *of)
{
    check(of);
}

static void *stand_in(const char *name)
{
    static const struct {
        const char *name;
        void *function;
    } all[] = {{"rsvg_handle_new_from_data", (void *)new_from_data},
               {"rsvg_handle_set_dpi", (void *)set_dpi},
               {"rsvg_handle_get_intrinsic_size_in_pixels", (void *)size_in_pixels},
               {"rsvg_handle_get_intrinsic_dimensions", (void *)dimensions},
               {"rsvg_handle_render_document", (void *)render},
               {"cairo_image_surface_create", (void *)create},
               {"cairo_image_surface_get_data", (void *)get_data},
               {"cairo_image_surface_get_stride", (void *)get_stride},
               {"cairo_create", (void *)new_cairo},
               {"cairo_status", (void *)status_of},
               {"cairo_status_to_string", (void *)text_of},
               {"cairo_surface_flush", (void *)flush}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (strcmp(all[i].name, name) == 0)
            return all[i].function;
    return NULL;
}

/* ---- */

struct asked {
    uint32_t width, height;
    bool answers;
    FILE *file;
    uint8_t first[8];
    size_t first_len;
};

static void read_svg(void *of)
{
    struct asked *asked = of;
    if (asked->answers)
        child_answers(rsvg.at, (size_t)(rsvg.end - rsvg.at));
    struct image *image = svg_read(asked->file, "a.svg", asked->first, asked->first_len, asked->width, asked->height);
    check(image->width && image->height && picture_size_fits(image->width, image->height) && image->channels == 4);
    check(!asked->width || (image->width == asked->width && image->height == asked->height));
    unsigned sum = 0;
    for (size_t i = 0; i < (size_t)4 * image->width * image->height; i++)
        sum += image->samples[i];
    image->bits += sum & 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, data + size};
    struct asked asked = {.answers = next_byte(&input) & 1};
    asked.width = next_byte(&input) & 63;
    asked.height = next_byte(&input) & 63;
    asked.width = asked.height ? asked.width : 0;
    asked.height = asked.width ? asked.height : 0;
    const uint8_t *const end = memchr(input.at, 0, (size_t)(input.end - input.at));
    size_t len = (size_t)((end ? end : input.end) - input.at);
    uint8_t *const text = next_bytes(&input, &len);
    rsvg = input;
    if (end)
        next_byte(&rsvg);
    asked.first_len = len < sizeof asked.first ? len : sizeof asked.first;
    memcpy(asked.first, text, asked.first_len);
    asked.file = unwind_stream(text + asked.first_len, len - asked.first_len);
    (void)svg_begins(text, asked.first_len);
    unwind_run(read_svg, &asked);
    child_forget();
    fclose(asked.file);
    free(text);
    return 0;
}
