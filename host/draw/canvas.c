/* SPDX-License-Identifier: MIT */
#include "draw/canvas.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/stop.h"
#include "draw/paths.h"
#include "image/format.h"

struct canvas {
    const struct scene *scene;
    struct glint_vec *normals;
    struct way *way; /* NULL: the exact rectangle */
};

struct canvas *canvas_new(const struct scene *scene, const struct shading *shading)
{
    struct canvas *canvas = allocate(1, sizeof *canvas);
    canvas->scene = scene;
    canvas->normals = scene_normals_q15(scene);
    if (shading->path) {
        const struct glint_shader shader = shading_shader(shading);
        canvas->way = way_new(scene, shading, &shader, canvas->normals);
    }
    return canvas;
}

void canvas_free(struct canvas *canvas)
{
    if (!canvas)
        return;
    way_free(canvas->way);
    free(canvas->normals);
    free(canvas);
}

/* Some lines, for a thread. */
static enum glint_err draw_lines(const struct canvas *canvas, const struct shading *shading,
                                 const struct glint_shader *shader, const struct glint_lamp *lamps, uint32_t y,
                                 uint32_t lines, uint8_t *pixels)
{
    const struct scene *scene = canvas->scene;
    const size_t width = scene->width, first = y * width, bytes = format_line_bytes(shading->format, width);
    const struct glint_source source = {.normals = &canvas->normals[first],
                                        .normals_stride = (ptrdiff_t)(width * sizeof *canvas->normals),
                                        .albedo = scene->albedo ? &scene->albedo[3 * first] : NULL,
                                        .albedo_stride = (ptrdiff_t)(3 * width),
                                        .gloss = scene->gloss ? &scene->gloss[first] : NULL,
                                        .gloss_stride = (ptrdiff_t)width,
                                        .mask = scene->mask ? &scene->mask[first] : NULL,
                                        .mask_stride = (ptrdiff_t)width};
    const struct glint_surface surface = {&pixels[y * bytes], (ptrdiff_t)bytes, 0, (uint16_t)y};
    const uint16_t w = (uint16_t)width, h = (uint16_t)lines;
    enum glint_err error = GLINT_OK;
    if (canvas->way && way_is_whole(canvas->way))
        ; /* nothing would be left of it */
    else if (shading_is_plain(shading))
        error = glint_shade_rect(shader, &source, w, h, &surface, NULL);
    else
        error = glint_shade_lights(shader, lamps, shading->lamp_count, &source, w, h, &surface, NULL);
    if (error == GLINT_OK && canvas->way)
        error = way_draw(canvas->way, &shader->light, y, lines, &surface);
    return error;
}

/* The picture in bands, one after the other to whichever thread is free: a band with much highlight takes longer. */
void canvas_draw(const struct canvas *canvas, const struct shading *shading, uint8_t *pixels)
{
    enum { BAND = 8 }; /* lines */
    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    shading_lamps(shading, lamps);
    const struct glint_shader shader = shading_shader(shading);
    const uint32_t height = canvas->scene->height;
    enum glint_err worst = GLINT_OK;
    sigset_t before;
    signals_hold(&before); /* so that only the first thread takes them: they end its waiting */
#pragma omp parallel for schedule(dynamic) reduction(min : worst)
    for (uint32_t y = 0; y < height; y += BAND) {
        const enum glint_err error =
            draw_lines(canvas, shading, &shader, lamps, y, height - y < BAND ? height - y : BAND, pixels);
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
    uint8_t *pixels =
        allocate(scene->height, format_line_bytes(shading->format, scene->width)); /* black where a mask leaves it */
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
