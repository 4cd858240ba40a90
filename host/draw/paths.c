/* SPDX-License-Identifier: MIT
 * The ways through the library that --path names: what makes samples, and what paints them. */
#include "draw/paths.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bake/bake.h"
#include "base/memory.h"
#include "base/message.h"
#include "image/format.h"

/* Each path: its name, its paint, its source of pixels. A palette's normals are of 16 bits. */
#define PATHS(X)                                                                                                       \
    X("exact", EXACT, INT16)                                                                                           \
    X("exact-int8", EXACT, INT8)                                                                                       \
    X("span", EXACT, SPAN)                                                                                             \
    X("colour-int16", COLOUR, INT16)                                                                                   \
    X("colour-int8", COLOUR, INT8)                                                                                     \
    X("colour-span", COLOUR, SPAN)                                                                                     \
    X("albedo-int16", ALBEDO, INT16)                                                                                   \
    X("albedo-int8", ALBEDO, INT8)                                                                                     \
    X("albedo-span", ALBEDO, SPAN)                                                                                     \
    X("palette", EXACT, PALETTE)

#define NAME(name, paint, source) name,
const char *const path_names[] = {PATHS(NAME) NULL};

#define PARTS(name, paint, source) {paint, source},
static const struct path {
    enum { EXACT, COLOUR, ALBEDO } paint;
    enum { INT16, INT8, SPAN, PALETTE } source;
} paths[] = {PATHS(PARTS)};

/* A path made ready for a scene. */
struct way {
    const struct path *path;
    struct scene scene; /* its mask holds what this path draws */
    const struct glint_vec *normals;
    bool whole; /* draws all that is to be drawn */
    struct shading shading;
    struct glint_output output;
    struct glint_paint paint;
    struct glint_light lights[GLINT_LIGHTS_MAX];
    uint8_t *chosen;  /* the scene's mask here, where it is not the scene's own */
    uint32_t *packed; /* INT8; 0: not drawn */
    uint16_t *albedo; /* for ALBEDO, as firmware keeps it */
    struct baked *palette;
    uint16_t *colors;                               /* of the palette, under the lights */
    uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4]; /* of tables, the largest */
};

enum { SPAN_PIXELS = 16 }; /* a curve is cut into spans of at most so many */

const char path_needs_grey[] =
    "needs a grey --ambient and --diffuse of at most 1 together, as --ambient .1 --diffuse .9";

/* ---- what a path cannot draw ---- */

/* Exact over normals: every model, light, format and map. */
static bool draws_all(const struct path *path)
{
    return path->paint == EXACT && (path->source == INT16 || path->source == INT8);
}

/* Of gloss, shininess and coverage. */
static bool takes_maps(const struct path *path)
{
    return path->source == INT16 || path->source == INT8;
}

bool path_draws_all(unsigned path)
{
    return draws_all(&paths[path]);
}

static bool is_frontal(const struct shading *shading)
{
    int32_t to_viewer[3];
    struct glint_vec v = {0, 0, 0};
    direction_integers(shading->view, to_viewer);
    return glint_vec_normalize(&v, to_viewer) == GLINT_OK && v.x == 0 && v.y == 0;
}

/* Of a paint by tables. */
static const char *tables_refusal(const struct path *path, const struct shading *shading)
{
    if (!format_is_565(shading->format))
        return "needs --format rgb565 or rgb565-swapped";
    if (path->paint == ALBEDO && shading->dither)
        return "cannot draw with --dither";
    if (path->paint == COLOUR && shading->dither && shading->space != GLINT_GAMMA)
        return "needs --space gamma with --dither";
    if (path->paint == ALBEDO && shading->space != GLINT_GAMMA)
        return "needs --space gamma";
    return NULL;
}

/* Of all but the exact paints over normals. */
static const char *lights_refusal(const struct shading *shading)
{
    if (!shading_is_plain(shading))
        return "takes only one --light without a colour; other lights need --path exact or exact-int8";
    return shading->model == GLINT_PHONG ? "cannot draw phong" : NULL;
}

static bool has_grain(const struct shading *shading)
{
    return shading->n_across && shading->n_across != shading->n;
}

static const char *grain_refusal(const struct path *path, const struct shading *shading)
{
    return has_grain(shading) && !draws_all(path) ? "has no grain; that needs --path exact or exact-int8" : NULL;
}

const char *path_refusal(const struct shading *shading)
{
    const struct path *path = &paths[shading->path];
    if (grain_refusal(path, shading))
        return grain_refusal(path, shading);
    if (draws_all(path))
        return NULL;
    if (lights_refusal(shading))
        return lights_refusal(shading);
    if (path->paint != EXACT && tables_refusal(path, shading))
        return tables_refusal(path, shading);
    if (path->source == PALETTE && !format_is_565(shading->format))
        return "needs --format rgb565 or rgb565-swapped";
    if (path->source == PALETTE && shading->dither)
        return "cannot draw with --dither";
    if (path->source == SPAN && format_byte_pixels(shading->format) > 1)
        return "cannot draw mono, grey2 and grey4, whose spans would have to start on a byte";
    if (path->source == INT8 && !is_frontal(shading))
        return "needs --view 0,0,1";
    return NULL;
}

const char *path_material_refusal(const struct shading *shading)
{
    const struct glint_material m = shading_material(shading);
    if (paths[shading->path].paint != ALBEDO)
        return NULL;
    for (unsigned k = 1; k < 3; k++)
        if (m.ambient_q16[k] != m.ambient_q16[0] || m.diffuse_q16[k] != m.diffuse_q16[0])
            return path_needs_grey;
    return m.ambient_q16[0] > 65536 || m.diffuse_q16[0] > 65536 - m.ambient_q16[0] ? path_needs_grey : NULL;
}

const char *path_of_mesh(const struct shading *shading, bool has_colors, struct mesh_path *of_mesh)
{
    const struct path *path = &paths[shading->path];
    *of_mesh = (struct mesh_path){path->paint != EXACT, path->source == INT8,
                                  path->paint == ALBEDO ? GLINT_TABLES_ALBEDO : GLINT_TABLES_COLOUR};
    if (path->source != INT16 && path->source != INT8)
        return "cannot draw a mesh; choose exact, exact-int8, colour-int16 or colour-int8, or where it has "
               "textures or its vertices colours albedo-int16 or albedo-int8";
    if (grain_refusal(path, shading))
        return grain_refusal(path, shading);
    if (has_grain(shading) &&
        (shading->lamp_count > 1 || (shading->lamp_count && shading->lamps[0].kind != LAMP_DIRECTIONAL)))
        return "draws a mesh with grain under one directional --light; leave out --across, or the others";
    if (of_mesh->by_tables && lights_refusal(shading))
        return lights_refusal(shading);
    if (of_mesh->by_tables && tables_refusal(path, shading))
        return tables_refusal(path, shading);
    if (path->paint == ALBEDO && !has_colors)
        return "is for textures and colours of vertices, which this mesh has not; choose exact, exact-int8, "
               "colour-int16 or "
               "colour-int8";
    if (path->paint == COLOUR && has_colors)
        return "holds one colour, and the mesh has more; choose exact, albedo-int16 or albedo-int8, or give one by "
               "--color";
    return NULL;
}

/* ---- made ready ---- */

static bool drawn(const struct scene *scene, size_t i)
{
    return !scene->mask || scene->mask[i];
}

static void pack(struct way *way)
{
    const size_t pixels = (size_t)way->scene.width * way->scene.height;
    way->packed = allocate(pixels, sizeof *way->packed); /* 0: no surface */
    for (size_t i = 0; i < pixels; i++)
        if (drawn(&way->scene, i))
            way->packed[i] = glint_normals_pack(GLINT_NORMALS_INT8, &way->normals[i]);
}

/* Spans and a palette are drawn here with full gloss and coverage, most paths in one colour, which becomes that of the first pixel with full
 * gloss, or else of the first one. `by_path` marks the pixels that the path draws. Returns how many are marked. */
static size_t choose(const struct scene *scene, const struct path *path, struct glint_material *material,
                     uint8_t *by_path)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    const bool any_color = path->paint == ALBEDO, has_maps = takes_maps(path);
    const uint8_t *color = NULL, *glossy = NULL;
    size_t count = 0;
    for (size_t i = 0; i < pixels; i++) {
        const uint8_t *here = scene->albedo ? &scene->albedo[3 * i] : material->albedo;
        const bool solid = has_maps || !scene->mask || scene->mask[i] == 255;
        const bool full = !scene->gloss || scene->gloss[i] == 255;
        by_path[i] = drawn(scene, i) && solid && (has_maps || full) ? (scene->mask ? scene->mask[i] : 255) : 0;
        color = by_path[i] && !color ? here : color;
        glossy = by_path[i] && full && !glossy ? here : glossy;
    }
    color = glossy ? glossy : color;
    for (size_t i = 0; i < pixels; i++) {
        if (!any_color && scene->albedo && by_path[i] && memcmp(color, &scene->albedo[3 * i], 3) != 0)
            by_path[i] = 0;
        count += by_path[i] != 0;
    }
    if (color)
        memcpy(material->albedo, color, 3);
    return count;
}

/* The scene without what the path does not draw, and the material in its one colour. Returns a warning, or NULL. */
static char *narrow(struct way *way, struct glint_material *material)
{
    char *warning = NULL;
    const struct scene scene = way->scene;
    if (scene.shininess && !takes_maps(way->path))
        fail("--path %s: takes no map of shininess, as --filter makes it; choose a path of 16 or 8 bits",
             path_names[way->shading.path]);
    const size_t pixels = (size_t)scene.width * scene.height;
    size_t wanted = 0;
    for (size_t i = 0; i < pixels; i++)
        wanted += drawn(&scene, i);
    way->scene.mask = way->chosen = allocate(pixels, 1);
    const size_t chosen = choose(&scene, way->path, material, way->chosen);
    way->whole = chosen == wanted;
    if (chosen == pixels && !scene.mask)
        way->scene.mask = NULL;
    const char *const what = way->path->paint == ALBEDO ? "pixels of full gloss"
                             : takes_maps(way->path)    ? "one colour"
                                                        : "one colour at full gloss";
    if (!way->whole)
        warning = formatted("draws %s, %zu of %zu pixels; the exact path drew the rest", what, chosen, wanted);
    return warning;
}

static void make_paint(struct way *way, const struct glint_material *material, const char *name)
{
    const enum glint_tables_kind kind = way->path->paint == ALBEDO ? GLINT_TABLES_ALBEDO : GLINT_TABLES_COLOUR;
    const enum glint_err error =
        way->path->paint == EXACT
            ? glint_paint_exact(&way->paint, material, &way->output)
            : glint_paint_tables(&way->paint, kind, material, &way->output, way->memory, sizeof way->memory);
    if (error == GLINT_ERR_ARG && way->path->paint == ALBEDO)
        fail("--path %s: %s", name, path_needs_grey);
    if (error != GLINT_OK)
        fail("--path %s: the library refused the material (error %d)", name, error);
}

struct way *way_new(const struct scene *scene, const struct shading *shading, const struct glint_vec *normals)
{
    const char *name = path_names[shading->path];
    if (path_refusal(shading)) /* which may have a scene's own grain */
        fail("--path %s: %s", name, path_refusal(shading));
    if (scene->shininess && has_grain(shading))
        fail("--filter: a surface with grain takes no map of shininess; leave out --filter, or give --across what -n "
             "has");
    struct glint_material material = shading_material(shading);
    struct way *way = allocate(1, sizeof *way);
    way->path = &paths[shading->path];
    way->scene = *scene;
    way->normals = normals;
    way->whole = true;
    way->shading = *shading;
    way->output = shading_output(shading);
    char *warning = draws_all(way->path) ? NULL : narrow(way, &material);
    make_paint(way, &material, name);
    if (warning)
        warn("--path %s: %s", name, warning);
    free(warning);
    if (way->path->paint == ALBEDO)
        way->albedo = scene_albedo_565(scene, material.albedo);
    if (way->path->source == INT8)
        pack(way);
    if (way->path->source == PALETTE) {
        way->palette = bake(&way->scene, BAKE_PALETTE, PALETTE_DEFAULT);
        way->colors = allocate(way->palette->entries, sizeof *way->colors);
    }
    return way;
}

void way_free(struct way *way)
{
    if (!way)
        return;
    free(way->chosen);
    free(way->packed);
    free(way->albedo);
    free(way->colors);
    if (way->palette)
        baked_free(way->palette);
    free(way);
}

bool way_is_whole(const struct way *way)
{
    return way->whole;
}

uint8_t *way_rest(const struct way *way, const struct scene *scene)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    uint8_t *rest = allocate(pixels, 1);
    for (size_t i = 0; i < pixels; i++)
        rest[i] = way->chosen && way->chosen[i] ? 0 : scene->mask ? scene->mask[i] : 255;
    return rest;
}

void way_light(struct way *way, const struct shading *shading)
{
    shading_light_paint(shading, &way->paint, way->lights);
    if (!way->palette)
        return;
    const struct glint_maps maps = {.normals = way->palette->normals};
    const struct glint_surface entries = {way->colors, 0, 0, 0};
    if (glint_draw_rect(&way->paint, &maps, (uint16_t)way->palette->entries, 1, &entries, NULL) != GLINT_OK)
        fail("the library refused the palette");
}

/* ---- drawn ---- */

/* A line as spans: each goes from one pixel that is drawn to the last of those that follow it, at most SPAN_PIXELS. Its
 * curve runs from the normal of its first pixel to the normal of its last. */
static enum glint_err draw_spans(const struct way *way, uint32_t y, const struct glint_surface *line,
                                 ptrdiff_t pixel_bytes)
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
        const struct glint_maps maps = {.albedo = way->albedo ? (const uint8_t *)(way->albedo + start + x) : NULL,
                                        .albedo_format = GLINT_RGB565};
        enum glint_err error = glint_span_init(&span, &way->paint, &way->normals[start + x],
                                               &way->normals[start + end - 1], (uint16_t)(end - x));
        if (error == GLINT_OK)
            error = glint_draw_span(&way->paint, &span, way->albedo ? &maps : NULL, &at, NULL);
        if (error != GLINT_OK)
            return error;
    }
    return GLINT_OK;
}

static enum glint_err draw_all_spans(const struct way *way, uint32_t y, uint32_t lines,
                                     const struct glint_surface *surface)
{
    const ptrdiff_t pixel_bytes =
        (ptrdiff_t)format_line_bytes((enum glint_format)way->output.format, 1); /* mono has no spans */
    struct glint_surface line = *surface;
    enum glint_err error = GLINT_OK;
    for (uint32_t i = 0; i < lines && error == GLINT_OK; i++) {
        error = draw_spans(way, y + i, &line, pixel_bytes);
        line.pixels = (uint8_t *)line.pixels + line.stride;
        line.y++;
    }
    return error;
}

static enum glint_err draw_palette(const struct way *way, uint32_t y, uint32_t lines,
                                   const struct glint_surface *surface)
{
    const size_t width = way->scene.width, first = y * width;
    uint16_t *line = allocate(width, sizeof *line);
    const struct glint_surface out = {line, 0, 0, 0};
    enum glint_err error = GLINT_OK;
    for (uint32_t i = 0; i < lines && error == GLINT_OK; i++) {
        const size_t start = first + i * width;
        error = glint_draw_palette(way->colors, way->palette->offsets + start, 0, (uint16_t)width, 1, &out);
        for (size_t x = 0; x < width; x++) /* where there is no surface the loop draws, too */
            if (drawn(&way->scene, start + x))
                memcpy((uint8_t *)surface->pixels + surface->stride * (ptrdiff_t)i + 2 * x, line + x, sizeof *line);
    }
    free(line);
    return error;
}

/* A direction of any length, or a place in 1/16 pixel. */
void scene_add_grain(const struct scene *scene, const struct shading *shading, size_t first, struct glint_maps *maps)
{
    const double scale = scene->grain.kind == GLINT_GRAIN_BRUSHED ? 1 << 14 : 16;
    if (!has_grain(shading))
        return;
    maps->grain = scene->grain_map ? &scene->grain_map[first] : NULL;
    maps->grain_stride = (ptrdiff_t)scene->width;
    maps->grain_kind = scene->grain.kind;
    for (unsigned k = 0; k < 2; k++)
        maps->grain_at[k] = (int32_t)lround(scale * scene->grain.at[k]);
}

/* What a paint over normals takes of the scene from pixel `first` on. */
static struct glint_maps maps_of(const struct way *way, size_t first)
{
    const struct scene *scene = &way->scene;
    const ptrdiff_t width = (ptrdiff_t)scene->width;
    struct glint_maps maps = {.normals_format = GLINT_NORMALS_INT16};
    if (way->packed) {
        maps.normals = &way->packed[first];
        maps.normals_stride = 4 * width;
        maps.normals_format = GLINT_NORMALS_INT8;
    } else {
        maps.normals = &way->normals[first];
        maps.normals_stride = width * (ptrdiff_t)sizeof *way->normals;
    }
    if (way->path->paint == EXACT && scene->albedo) {
        maps.albedo = &scene->albedo[3 * first];
        maps.albedo_stride = 3 * width;
        maps.albedo_format = GLINT_RGB888;
    }
    if (scene->gloss) {
        maps.gloss = &scene->gloss[first];
        maps.gloss_stride = width;
    }
    if (scene->shininess) {
        maps.shininess = &scene->shininess[first];
        maps.shininess_stride = width;
    }
    if (way->albedo) {
        maps.albedo = (const uint8_t *)&way->albedo[first];
        maps.albedo_stride = 2 * width;
        maps.albedo_format = GLINT_RGB565;
    }
    scene_add_grain(scene, &way->shading, first, &maps);
    if (scene->mask) {
        maps.coverage = &scene->mask[first];
        maps.coverage_stride = width;
    }
    return maps;
}

enum glint_err way_draw(const struct way *way, uint32_t y, uint32_t lines, const struct glint_surface *surface)
{
    if (way->path->source == SPAN)
        return draw_all_spans(way, y, lines, surface);
    if (way->path->source == PALETTE)
        return draw_palette(way, y, lines, surface);
    const struct glint_maps maps = maps_of(way, (size_t)y * way->scene.width);
    return glint_draw_rect(&way->paint, &maps, (uint16_t)way->scene.width, (uint16_t)lines, surface, NULL);
}
