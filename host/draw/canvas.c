/* SPDX-License-Identifier: MIT */
#include "draw/canvas.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/stop.h"
#include "draw/paths.h"
#include "image/format.h"

struct canvas {
    const struct scene *scene;
    struct glint_vec *normals;
    struct way *way, *below; /* below: what draws the pixels that the way does not; NULL: there are none */
    struct scene rest;       /* those pixels alone */
    uint8_t *behind;         /* what the picture is drawn over; NULL: nothing is seen of it */
};

/* What is flat and lit by ambient light alone has its albedo. */
static uint8_t *backdrop_lines(const uint8_t *backdrop, uint32_t width, uint32_t top, uint32_t height,
                               const struct shading *shading)
{
    if (!backdrop)
        return NULL;
    const size_t bytes = format_line_bytes(shading->format, width);
    const struct glint_output output = {(uint8_t)shading->format, GLINT_GAMMA, shading->dither};
    const struct shading flat = {.model = GLINT_MSH, .n = 1, .ambient = {1, 1, 1}};
    const struct glint_material material = shading_material(&flat);
    static const int32_t to_viewer[3] = {0, 0, 1};
    struct glint_vec *normals = allocate(width, sizeof *normals);
    uint8_t *pixels = allocate(height, bytes);
    struct glint_paint paint;
    enum glint_err error = glint_paint_exact(&paint, &material, &output);
    if (error == GLINT_OK)
        error = glint_paint_light(&paint, NULL, 0, to_viewer);
    for (size_t x = 0; x < width; x++)
        normals[x].z = INT16_MAX;
    for (uint32_t y = 0; y < height && error == GLINT_OK; y++) {
        const struct glint_maps maps = {
            .normals = normals, .albedo = &backdrop[(size_t)3 * width * y], .albedo_format = GLINT_RGB888};
        const struct glint_surface line = {&pixels[y * bytes], 0, 0, (uint16_t)(top + y)};
        error = glint_draw_rect(&paint, &maps, (uint16_t)width, 1, &line, NULL);
    }
    free(normals);
    if (error != GLINT_OK)
        fail("the library refused the background (error %d)", error);
    return pixels;
}

uint8_t *backdrop_pixels(const uint8_t *backdrop, uint32_t width, uint32_t height, const struct shading *shading)
{
    return backdrop_lines(backdrop, width, 0, height, shading);
}

static bool has_soft_edges(const struct scene *scene)
{
    for (size_t i = 0; scene->mask && i < (size_t)scene->width * scene->height; i++)
        if (scene->mask[i] && scene->mask[i] < 255)
            return true;
    return false;
}

struct canvas *canvas_new(const struct scene *scene, const struct shading *shading)
{
    struct canvas *canvas = allocate(1, sizeof *canvas);
    struct shading exact = *shading;
    exact.path = 0;
    canvas->scene = scene;
    canvas->normals = scene_normals_q15(scene);
    canvas->way = way_new(scene, shading, canvas->normals);
    if (!way_is_whole(canvas->way)) {
        canvas->rest = *scene;
        canvas->rest.mask = way_rest(canvas->way, scene);
        canvas->below = way_new(&canvas->rest, &exact, canvas->normals);
    }
    if (scene->mask)
        canvas->behind = backdrop_lines(scene->backdrop, scene->width, scene->top, scene->height, shading);
    if (!canvas->behind && has_soft_edges(scene))
        canvas->behind = allocate(scene->height, format_line_bytes(shading->format, scene->width));
    return canvas;
}

void canvas_free(struct canvas *canvas)
{
    if (!canvas)
        return;
    way_free(canvas->way);
    way_free(canvas->below);
    free(canvas->normals);
    free(canvas->behind);
    free(canvas->rest.mask);
    free(canvas);
}

/* Some lines, for a thread. */
static enum glint_err draw_lines(const struct canvas *canvas, const struct shading *shading, uint32_t y, uint32_t lines,
                                 uint8_t *pixels)
{
    const size_t bytes = format_line_bytes(shading->format, canvas->scene->width);
    const struct glint_surface surface = {&pixels[y * bytes], (ptrdiff_t)bytes, 0, (uint16_t)(canvas->scene->top + y)};
    enum glint_err error = GLINT_OK;
    if (canvas->below)
        error = way_draw(canvas->below, y, lines, &surface);
    return error ? error : way_draw(canvas->way, y, lines, &surface);
}

/* The picture in bands, one after the other to whichever thread is free: a band with much highlight takes longer. */
void canvas_draw(struct canvas *canvas, const struct shading *shading, uint8_t *pixels)
{
    enum { BAND = 8 }; /* lines */
    const uint32_t height = canvas->scene->height;
    enum glint_err worst = GLINT_OK;
    sigset_t before;
    way_light(canvas->way, shading);
    if (canvas->below)
        way_light(canvas->below, shading);
    if (canvas->behind)
        memcpy(pixels, canvas->behind, height * format_line_bytes(shading->format, canvas->scene->width));
    signals_hold_but_faults(&before); /* so that only the first thread takes them: they end its waiting */
#pragma omp parallel for schedule(dynamic) reduction(min : worst)
    for (uint32_t y = 0; y < height; y += BAND) {
        const enum glint_err error = draw_lines(canvas, shading, y, height - y < BAND ? height - y : BAND, pixels);
        if (error < worst)
            worst = error;
    }
    signals_release(&before);
    if (worst != GLINT_OK)
        fail("the library refused the rectangle (error %d)", worst);
}

uint8_t *shade_pixels(const struct scene *scene, const struct shading *shading)
{
    struct canvas *canvas = canvas_new(scene, shading);
    uint8_t *pixels = allocate(scene->height, format_line_bytes(shading->format, scene->width));
    canvas_draw(canvas, shading, pixels);
    canvas_free(canvas);
    return pixels;
}

struct levels *shade_scene(const struct scene *scene, const struct shading *shading)
{
    uint8_t *pixels = shade_pixels(scene, shading);
    struct levels *levels = levels_of_pixels(scene->width, scene->height, shading->format, pixels);
    free(pixels);
    return levels;
}
