/* SPDX-License-Identifier: MIT
 * The ways through the library that --path names: the exact rectangle, and spans and table loops beside it. */
#include "draw/paths.h"

#include <stdlib.h>
#include <string.h>

#include "bake/bake.h"
#include "base/memory.h"
#include "base/message.h"
#include "image/format.h"

/* Each path: its name, what computes the pixels, what one call draws, and the normals that it reads. */
#define PATHS(X)                                                                                                       \
    X("exact", EXACT, RECT, INT16)                                                                                     \
    X("span", EXACT, SPAN, INT16)                                                                                      \
    X("span-c16", EXACT, SPAN_C16, INT16)                                                                              \
    X("colour-int16", COLOUR, RECT, INT16)                                                                             \
    X("colour-int10", COLOUR, RECT, INT10)                                                                             \
    X("colour-int8", COLOUR, RECT, INT8)                                                                               \
    X("colour-span", COLOUR, SPAN, INT16)                                                                              \
    X("small-int16", SMALL, RECT, INT16)                                                                               \
    X("small-int10", SMALL, RECT, INT10)                                                                               \
    X("small-int8", SMALL, RECT, INT8)                                                                                 \
    X("small-span", SMALL, SPAN, INT16)                                                                                \
    X("albedo-int16", ALBEDO, RECT, INT16)                                                                             \
    X("albedo-int10", ALBEDO, RECT, INT10)                                                                             \
    X("albedo-int8", ALBEDO, RECT, INT8)                                                                               \
    X("albedo-span", ALBEDO, SPAN, INT16)                                                                              \
    X("palette", PALETTE, RECT, INT16)

#define NAME(name, by, unit, normals) name,
const char *const path_names[] = {PATHS(NAME) NULL};

#define PARTS(name, by, unit, normals) {by, unit, GLINT_NORMALS_##normals},
static const struct path {
    enum { EXACT, COLOUR, SMALL, ALBEDO, PALETTE } by;
    enum { RECT, SPAN, SPAN_C16 } unit;
    enum glint_normals normals;
} paths[] = {PATHS(PARTS)};

/* A path made ready for a scene: what does not change when the light moves. */
struct way {
    const struct path *path;
    struct scene scene;         /* its mask holds what this path draws */
    struct glint_shader shader; /* but for the light */
    const struct glint_vec *normals;
    bool whole;       /* draws all that is to be drawn */
    void *packed;     /* normals in the path's format; 0: not drawn */
    uint16_t *albedo; /* for ALBEDO, as firmware keeps it */
    struct baked *palette;
    struct glint_tables tables;
    uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4]; /* the largest */
};

enum { SPAN_PIXELS = 16 }; /* a curve is cut into spans of at most so many */

const char path_needs_grey[] =
    "needs a grey --ambient and --diffuse of at most 1 together, as --ambient .1 --diffuse .9";

const char *path_refusal(const struct shading *shading)
{
    const struct path *path = &paths[shading->path];
    struct glint_lamp lamp;
    if (path->by == EXACT && path->unit == RECT)
        return NULL;
    if (!shading_is_plain(shading))
        return "takes only one --light without a colour; other lights need --path exact";
    if (shading->model == GLINT_PHONG)
        return "cannot draw phong";
    if (path->by != EXACT && path->by != SMALL && !format_is_565(shading->format))
        return "needs --format rgb565 or rgb565-swapped";
    if ((path->by == ALBEDO || path->by == PALETTE) && shading->dither)
        return "cannot draw with --dither";
    if (path->by == COLOUR && shading->dither && shading->space != GLINT_GAMMA)
        return "needs --space gamma with --dither";
    if (path->unit != RECT && shading->format == GLINT_MONO)
        return "cannot draw mono, whose spans would have to start on a byte";
    if ((path->by == SMALL || path->by == ALBEDO) && shading->space != GLINT_GAMMA)
        return "needs --space gamma";
    if (path->by != SMALL && path->normals == GLINT_NORMALS_INT8 && shading_lamp(shading, 0, &lamp) == GLINT_OK &&
        (lamp.light.v.x || lamp.light.v.y))
        return "needs --view 0,0,1";
    return NULL;
}

const char *path_of_mesh(const struct shading *shading, bool has_colors, struct mesh_path *of_mesh)
{
    const struct path *path = &paths[shading->path];
    *of_mesh = (struct mesh_path){path->by != EXACT, path->normals == GLINT_NORMALS_INT8,
                                  path->by == SMALL    ? GLINT_TABLES_SMALL
                                  : path->by == ALBEDO ? GLINT_TABLES_ALBEDO
                                                       : GLINT_TABLES_COLOUR};
    if (!shading_is_plain(shading))
        return "a mesh takes only one --light, without a colour";
    if (shading->model == GLINT_PHONG)
        return "cannot draw a mesh by phong; choose another --model";
    if (path->unit != RECT || path->by == PALETTE || path->normals == GLINT_NORMALS_INT10)
        return "cannot draw a mesh; choose exact, colour-int16, colour-int8, small-int16 or small-int8, or where its "
               "vertices have colours albedo-int16 or albedo-int8";
    if (of_mesh->by_tables && shading->format == GLINT_MONO)
        return "cannot draw a mesh in mono; choose another --format, or --path exact";
    if ((path->by == COLOUR || path->by == ALBEDO) && !format_is_565(shading->format))
        return "needs --format rgb565 or rgb565-swapped";
    if (path->by == ALBEDO && shading->dither)
        return "cannot draw with --dither";
    if (of_mesh->by_tables && shading->space != GLINT_GAMMA && (path->by != COLOUR || shading->dither))
        return path->by != COLOUR ? "needs --space gamma" : "needs --space gamma with --dither";
    if (path->by == ALBEDO && !has_colors)
        return "is for colours of vertices, which this mesh has not; choose exact, colour-int16, colour-int8, "
               "small-int16 or small-int8";
    if (has_colors && (path->by == COLOUR || path->by == SMALL))
        return "holds one colour, and the mesh has its vertices'; choose exact, albedo-int16 or albedo-int8, or give "
               "one colour by --color";
    return NULL;
}

static bool drawn(const struct scene *scene, size_t i)
{
    return !scene->mask || scene->mask[i];
}

static enum glint_err draw_span(const struct way *way, const struct glint_shader *shader, const struct glint_span *span,
                                size_t start, const struct glint_surface *at)
{
    switch (way->path->by) {
    case EXACT:
        return way->path->unit == SPAN_C16 ? glint_shade_span_c16(shader, span, at, NULL)
                                           : glint_shade_span(shader, span, at, NULL);
    case ALBEDO:
        return glint_tables_albedo_span(&way->tables, span, way->albedo + start, at);
    case COLOUR:
    case SMALL:
        return glint_tables_span(&way->tables, span, at);
    case PALETTE:
        break; /* has no spans */
    }
    return GLINT_ERR_ARG;
}

/* A line as spans: each goes from one pixel that is drawn to the last of those that follow it, at most SPAN_PIXELS. Its
 * curve runs from the normal of its first pixel to the normal of its last. */
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
            error = draw_span(way, shader, &span, start + x, &at);
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

/* Paths have full gloss, alpha 255, and most of them one colour, which becomes that of the first pixel with full gloss. `by_path`
 * marks the pixels that the path draws; the exact path draws the others. Returns how many are marked. */
static size_t choose(const struct scene *scene, bool any_color, struct glint_shader *shader, uint8_t *by_path)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    const uint8_t *color = NULL;
    size_t count = 0;
    for (size_t i = 0; i < pixels; i++) {
        const uint8_t *here = scene->albedo ? &scene->albedo[3 * i] : shader->material.albedo;
        const bool solid = shader->format != GLINT_ARGB8888 || !scene->mask || scene->mask[i] == 255;
        const bool full = drawn(scene, i) && solid && (!scene->gloss || scene->gloss[i] == 255);
        if (full && !color)
            color = here;
        by_path[i] = full && (any_color || memcmp(color, here, 3) == 0);
        count += by_path[i];
    }
    if (color)
        memcpy(shader->material.albedo, color, 3);
    return count;
}

static void fill(struct way *way, const char *name)
{
    static const enum glint_tables_kind kinds[] = {
        [COLOUR] = GLINT_TABLES_COLOUR, [SMALL] = GLINT_TABLES_SMALL, [ALBEDO] = GLINT_TABLES_ALBEDO};
    if (way->path->by == EXACT || way->path->by == PALETTE)
        return;
    const enum glint_err error =
        glint_tables_fill(&way->tables, kinds[way->path->by], &way->shader, way->memory, sizeof way->memory);
    if (error == GLINT_ERR_ARG && way->path->by == ALBEDO)
        fail("--path %s: %s", name, path_needs_grey);
    if (error != GLINT_OK)
        fail("--path %s: the library refused the tables", name);
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
    const bool any_color = way->path->by == ALBEDO;
    const size_t chosen = choose(scene, any_color, &way->shader, way->scene.mask);
    size_t wanted = 0;
    for (size_t i = 0; i < pixels; i++)
        wanted += drawn(scene, i);
    way->whole = chosen == wanted;
    const char *name = path_names[shading->path];
    fill(way, name);
    if (!way->whole)
        warn("--path %s: draws %s full gloss, %zu of %zu pixels; the exact path drew the rest", name,
             any_color ? "pixels of" : "one colour at", chosen, wanted);
    if (way->path->by == ALBEDO)
        way->albedo = scene_albedo_565(scene, way->shader.material.albedo);
    if (way->path->by == PALETTE)
        way->palette = bake(&way->scene, BAKE_PALETTE, PALETTE_DEFAULT);
    else if (way->path->unit == RECT)
        pack(way);
    return way;
}

void way_free(struct way *way)
{
    if (!way)
        return;
    free(way->scene.mask);
    free(way->packed);
    free(way->albedo);
    if (way->palette)
        baked_free(way->palette);
    free(way);
}

bool way_is_whole(const struct way *way)
{
    return way->whole;
}

/* The palette shaded by the exact path, then looked up. */
static enum glint_err draw_palette(const struct way *way, const struct glint_shader *shader, uint32_t y, uint32_t lines,
                                   const struct glint_surface *surface)
{
    const size_t width = way->scene.width, first = y * width;
    const struct baked *palette = way->palette;
    uint16_t *colors = allocate(palette->entries, sizeof *colors), *line = allocate(width, sizeof *line);
    const struct glint_source source = {.normals = palette->normals};
    const struct glint_surface entries = {colors, 0, 0, 0}, out = {line, 0, 0, 0};
    enum glint_err error = glint_shade_rect(shader, &source, (uint16_t)palette->entries, 1, &entries, NULL);
    for (uint32_t i = 0; i < lines && error == GLINT_OK; i++) {
        const size_t start = first + i * width;
        error = glint_palette_rect(colors, palette->offsets + start, 0, (uint16_t)width, 1, &out);
        for (size_t x = 0; x < width; x++) /* where there is no surface the loop draws, too */
            if (drawn(&way->scene, start + x))
                memcpy((uint8_t *)surface->pixels + surface->stride * (ptrdiff_t)i + 2 * x, line + x, sizeof *line);
    }
    free(colors);
    free(line);
    return error;
}

static enum glint_err draw_packed(const struct way *way, const struct glint_tables_light *light, uint32_t y,
                                  uint32_t lines, const struct glint_surface *surface)
{
    const size_t width = way->scene.width, stride = normal_bytes(way->path) * width;
    const enum glint_normals format = way->path->normals;
    const void *normals = (const uint8_t *)way->packed + y * stride;
    const uint16_t w = (uint16_t)width, h = (uint16_t)lines;
    return way->albedo ? glint_tables_albedo_rect(&way->tables, light, format, normals, (ptrdiff_t)stride,
                                                  way->albedo + y * width, (ptrdiff_t)(2 * width), w, h, surface)
                       : glint_tables_rect(&way->tables, light, format, normals, (ptrdiff_t)stride, w, h, surface);
}

enum glint_err way_draw(const struct way *way, const struct glint_light *light, uint32_t y, uint32_t lines,
                        const struct glint_surface *surface)
{
    struct glint_tables_light tables_light;
    struct glint_shader shader = way->shader;
    shader.light = *light;
    if (way->palette)
        return draw_palette(way, &shader, y, lines, surface);
    enum glint_err error = GLINT_OK;
    if (way->path->by != EXACT)
        error = glint_tables_light_init(&tables_light, &way->tables, light);
    if (way->path->unit == RECT)
        return error ? error : draw_packed(way, &tables_light, y, lines, surface);
    const ptrdiff_t pixel_bytes =
        (ptrdiff_t)format_line_bytes((enum glint_format)shader.format, 1); /* mono has no spans */
    struct glint_surface line = *surface;
    for (uint32_t i = 0; i < lines && error == GLINT_OK; i++) {
        error = draw_spans(way, &shader, y + i, &line, pixel_bytes);
        line.pixels = (uint8_t *)line.pixels + line.stride;
        line.y++;
    }
    return error;
}
