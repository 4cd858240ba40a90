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

/* A path made ready for a scene: what does not change when the light moves. */
struct way {
    const struct path *path;
    struct scene scene;         /* its mask holds what this path draws */
    struct glint_shader shader; /* but for the light */
    const struct glint_vec *normals;
    bool whole;   /* draws all that is to be drawn */
    void *packed; /* normals in the path's format; 0: not drawn */
    struct glint_tables tables;
    uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4];
};

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
static enum glint_err draw_spans(const struct way *way, const struct glint_shader *shader, uint32_t y,
                                 const struct glint_surface *line, ptrdiff_t pixel_bytes)
{
    const struct scene *scene = &way->scene;
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
        enum glint_err error = glint_span_init(&span, &shader->light, &way->normals[start + x],
                                               &way->normals[start + end - 1], (uint16_t)(end - x));
        if (error == GLINT_OK)
            error = way->path->by == EXACT ? glint_shade_span(shader, &span, &at, NULL)
                                           : glint_tables_span(&way->tables, &span, &at);
        if (error != GLINT_OK)
            return error;
    }
    return GLINT_OK;
}

static size_t normal_bytes(const struct path *path)
{
    return path->normals == GLINT_NORMALS_INT16 ? sizeof(struct glint_vec) : sizeof(uint32_t);
}

static void pack(struct way *way)
{
    const size_t pixels = (size_t)way->scene.width * way->scene.height;
    way->packed = allocate(pixels, normal_bytes(way->path)); /* 0: no surface */
    for (size_t i = 0; i < pixels; i++) {
        if (!drawn(&way->scene, i))
            continue;
        if (way->path->normals == GLINT_NORMALS_INT16)
            ((struct glint_vec *)way->packed)[i] = way->normals[i];
        else
            ((uint32_t *)way->packed)[i] = glint_normals_pack(way->path->normals, &way->normals[i]);
    }
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

struct way *way_new(const struct scene *scene, const struct shading *shading, const struct glint_shader *shader,
                    const struct glint_vec *normals)
{
    struct way *way = allocate(1, sizeof *way);
    way->path = &paths[shading->path];
    way->scene = *scene;
    way->shader = *shader;
    way->normals = normals;
    const size_t pixels = (size_t)scene->width * scene->height;
    way->scene.mask = allocate(pixels, 1);
    const size_t chosen = choose(scene, &way->shader, way->scene.mask);
    size_t wanted = 0;
    for (size_t i = 0; i < pixels; i++)
        wanted += drawn(scene, i);
    way->whole = chosen == wanted;
    if (!way->whole)
        warn("--path %s: draws one colour at full gloss, %zu of %zu pixels; the exact path drew the rest",
             path_names[shading->path], chosen, wanted);
    const enum glint_tables_kind kind = way->path->by == COLOUR ? GLINT_TABLES_COLOUR : GLINT_TABLES_SMALL;
    if (way->path->by != EXACT &&
        glint_tables_fill(&way->tables, kind, &way->shader, way->memory, sizeof way->memory) != GLINT_OK)
        fail("--path %s: the library refused the tables", path_names[shading->path]);
    if (way->path->unit == RECT)
        pack(way);
    return way;
}

void way_free(struct way *way)
{
    if (!way)
        return;
    free(way->scene.mask);
    free(way->packed);
    free(way);
}

bool way_is_whole(const struct way *way)
{
    return way->whole;
}

enum glint_err way_draw(const struct way *way, const struct glint_light *light, uint32_t y, uint32_t lines,
                        const struct glint_surface *surface)
{
    static const ptrdiff_t sizes[] = {2, 2, 3, 1, 0}; /* of a pixel, by format; mono's spans start anywhere */
    struct glint_tables_light tables_light;
    enum glint_err error = GLINT_OK;
    if (way->path->by != EXACT)
        error = glint_tables_light(&tables_light, &way->tables, light);
    if (way->path->unit == RECT) {
        const size_t stride = normal_bytes(way->path) * way->scene.width;
        return error ? error
                     : glint_tables_rect(&way->tables, &tables_light, way->path->normals,
                                         (const uint8_t *)way->packed + y * stride, (ptrdiff_t)stride,
                                         (uint16_t)way->scene.width, (uint16_t)lines, surface);
    }
    struct glint_shader shader = way->shader;
    shader.light = *light;
    struct glint_surface line = *surface;
    for (uint32_t i = 0; i < lines && error == GLINT_OK; i++) {
        error = draw_spans(way, &shader, y + i, &line, sizes[shader.format]);
        line.pixels = (uint8_t *)line.pixels + line.stride;
        line.y++;
    }
    return error;
}
