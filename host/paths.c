/* SPDX-License-Identifier: MIT
 * The ways through the library that --path names: the exact rectangle, and spans and table loops beside it. */
#include <stdlib.h>
#include <string.h>

#include "host.h"
#include "shade.h"

const char *const path_names[] = {"exact",       "span",        "colour-int16", "colour-int10", "colour-int8",
                                  "colour-span", "small-int16", "small-int10",  "small-int8",   "small-span",
                                  NULL};

/* What a path is made of. */
static const struct path {
    enum { EXACT, COLOUR, SMALL } by;
    enum { RECT, SPAN } unit;
    enum glint_normals normals;
} paths[] = {{EXACT, RECT, GLINT_NORMALS_INT16},  {EXACT, SPAN, GLINT_NORMALS_INT16},
             {COLOUR, RECT, GLINT_NORMALS_INT16}, {COLOUR, RECT, GLINT_NORMALS_INT10},
             {COLOUR, RECT, GLINT_NORMALS_INT8},  {COLOUR, SPAN, GLINT_NORMALS_INT16},
             {SMALL, RECT, GLINT_NORMALS_INT16},  {SMALL, RECT, GLINT_NORMALS_INT10},
             {SMALL, RECT, GLINT_NORMALS_INT8},   {SMALL, SPAN, GLINT_NORMALS_INT16}};

enum { SPAN_PIXELS = 16 }; /* a curve is cut into spans of at most so many */

const char *path_refusal(const struct shading *shading)
{
    const struct path *path = &paths[shading->path];
    struct glint_lamp lamp;
    if (path->by == EXACT && path->unit == RECT)
        return NULL;
    if (!shading_is_plain(shading))
        return "takes one --light without a colour; others need --path exact";
    if (shading->model == GLINT_PHONG)
        return "takes any model but phong";
    if (path->by == COLOUR && (shading->format > GLINT_RGB565_SWAPPED || shading->dither))
        return "needs --format rgb565 or rgb565-swapped, and no --dither";
    if (path->unit == SPAN && shading->format == GLINT_MONO)
        return "takes any format but mono, whose spans would have to start on a byte";
    if (path->by == SMALL && shading->space != GLINT_GAMMA)
        return "needs --space gamma";
    if (path->by == COLOUR && path->normals == GLINT_NORMALS_INT8 && shading_lamp(shading, 0, &lamp) == GLINT_OK &&
        (lamp.light.v.x || lamp.light.v.y))
        return "needs --view 0,0,1";
    return NULL;
}

static bool drawn(const struct scene *scene, size_t i)
{
    return !scene->mask || scene->mask[i];
}

/* A line as spans between normals that lie at most SPAN_PIXELS apart. */
static void draw_spans(const struct scene *scene, const struct glint_shader *shader, const struct glint_tables *tables,
                       const struct glint_vec *normals, uint32_t y, const struct glint_surface *line,
                       ptrdiff_t pixel_bytes)
{
    const size_t start = (size_t)y * scene->width;
    for (uint32_t x = 0, end; x < scene->width; x = end) {
        end = x + 1;
        if (!drawn(scene, start + x))
            continue;
        while (end < scene->width && end - x < SPAN_PIXELS && drawn(scene, start + end))
            end++;
        struct glint_span span;
        struct glint_surface at = *line;
        at.pixels = (uint8_t *)line->pixels + pixel_bytes * (ptrdiff_t)x;
        at.x = (uint16_t)(at.x + x);
        enum glint_err error =
            glint_span_init(&span, &shader->light, &normals[start + x], &normals[start + end - 1], (uint16_t)(end - x));
        if (error == GLINT_OK)
            error = tables ? glint_tables_span(tables, &span, &at) : glint_shade_span(shader, &span, &at, NULL);
        if (error != GLINT_OK)
            fail("the library refused a span (error %d)", error);
    }
}

static void draw_packed(const struct scene *scene, const struct glint_tables *tables,
                        const struct glint_tables_light *light, enum glint_normals format,
                        const struct glint_vec *normals, const struct glint_surface *surface)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    const bool words = format != GLINT_NORMALS_INT16;
    const size_t size = words ? sizeof(uint32_t) : sizeof(struct glint_vec);
    void *held = allocate(pixels, size); /* 0: no surface */
    for (size_t i = 0; i < pixels; i++) {
        if (!drawn(scene, i))
            continue;
        if (words)
            ((uint32_t *)held)[i] = glint_normals_pack(format, &normals[i]);
        else
            ((struct glint_vec *)held)[i] = normals[i];
    }
    const enum glint_err error = glint_tables_rect(tables, light, format, held, (ptrdiff_t)(size * scene->width),
                                                   (uint16_t)scene->width, (uint16_t)scene->height, surface);
    if (error != GLINT_OK)
        fail("the library refused the rectangle (error %d)", error);
    free(held);
}

/* Tables hold one colour and full gloss: the first there is. Everything else stays with the exact path, and masks here
 * what the tables are to draw; returns how many pixels those are. */
static size_t choose(const struct scene *scene, struct glint_shader *shader, uint8_t *by_tables)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    const uint8_t *color = NULL;
    size_t count = 0;
    for (size_t i = 0; i < pixels; i++) {
        const uint8_t *here = scene->albedo ? &scene->albedo[3 * i] : shader->material.albedo;
        const bool full = drawn(scene, i) && (!scene->gloss || scene->gloss[i] == 255);
        if (full && !color)
            color = here;
        by_tables[i] = full && memcmp(color, here, 3) == 0;
        count += by_tables[i];
    }
    if (color)
        memcpy(shader->material.albedo, color, 3);
    return count;
}

void path_draw(const struct scene *scene, const struct shading *shading, const struct glint_shader *shader,
               const struct glint_vec *normals, const struct glint_surface *surface)
{
    static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4];
    static const ptrdiff_t sizes[] = {2, 2, 3, 1, 0}; /* of a pixel, by format; mono's spans start anywhere */
    const struct path *path = &paths[shading->path];
    struct glint_tables tables;
    struct glint_tables_light light;
    const size_t pixels = (size_t)scene->width * scene->height;
    struct glint_shader plain = *shader;
    struct scene part = *scene; /* as the tables see it */
    part.mask = allocate(pixels, 1);
    const size_t chosen = choose(scene, &plain, part.mask);
    if (chosen < pixels)
        warn("--path %s: draws one colour at full gloss, %zu of %zu pixels; the exact path drew the rest",
             path_names[shading->path], chosen, pixels);
    shader = &plain;
    scene = &part;
    if (path->by != EXACT) {
        const enum glint_tables_kind kind = path->by == COLOUR ? GLINT_TABLES_COLOUR : GLINT_TABLES_SMALL;
        if (glint_tables_fill(&tables, kind, shader, memory, sizeof memory) != GLINT_OK ||
            glint_tables_light(&light, &tables, &shader->light) != GLINT_OK)
            fail("--path %s: the library refused the tables", path_names[shading->path]);
    }
    if (path->unit == RECT) {
        draw_packed(scene, &tables, &light, path->normals, normals, surface);
        free(part.mask);
        return;
    }
    for (uint32_t y = 0; y < scene->height; y++) {
        struct glint_surface line = *surface;
        line.pixels = (uint8_t *)surface->pixels + surface->stride * (ptrdiff_t)y;
        line.y = (uint16_t)(surface->y + y);
        draw_spans(scene, shader, path->by == EXACT ? NULL : &tables, normals, y, &line, sizes[shading->format]);
    }
    free(part.mask);
}
