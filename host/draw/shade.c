/* SPDX-License-Identifier: MIT
 * A scene through the library into levels, and those into a picture. */
#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/stop.h"
#include "draw/shade.h"
#include "image/format.h"
#include "image/levels.h"

void direction_integers(const double direction[3], int32_t out[3])
{
    const double longest = fmax(fabs(direction[0]), fmax(fabs(direction[1]), fabs(direction[2])));
    for (unsigned k = 0; k < 3; k++)
        out[k] = longest > 0 ? (int32_t)lround(direction[k] / longest * (1 << 30)) : 0;
}

static uint32_t to_q16(double value)
{
    return (uint32_t)lround(value * 65536);
}

static int32_t to_sixteenths(double pixels)
{
    return (int32_t)lround(16 * pixels);
}

static int32_t cosine_q30(double degrees)
{
    return (int32_t)lround(cos(degrees * M_PI / 180) * (double)GLINT_T_ONE);
}

enum glint_err shading_lamp(const struct shading *shading, unsigned i, struct glint_lamp *out)
{
    const struct lamp *lamp = &shading->lamps[i];
    int32_t to_light[3], to_viewer[3], position[3];
    for (unsigned k = 0; k < 3; k++)
        position[k] = to_sixteenths(lamp->position[k]);
    const int32_t target[3] = {to_sixteenths(lamp->target[0]), to_sixteenths(lamp->target[1]), 0};
    const uint32_t range = (uint32_t)to_sixteenths(lamp->range);
    enum glint_err error = GLINT_ERR_ARG;
    switch (lamp->kind) {
    case GLINT_DIRECTIONAL:
        direction_integers(lamp->direction, to_light);
        direction_integers(shading->view, to_viewer);
        error = glint_lamp_directional(out, to_light, to_viewer);
        break;
    case GLINT_POINT:
        error = glint_lamp_point(out, position, range);
        break;
    case GLINT_SPOT:
        error = glint_lamp_spot(out, position, target, range, cosine_q30(lamp->cone[0]), cosine_q30(lamp->cone[1]));
        break;
    }
    for (unsigned k = 0; k < 3; k++)
        out->color_q16[k] = to_q16(lamp->color[k]);
    return error;
}

bool shading_is_plain(const struct shading *shading)
{
    const struct lamp *lamp = &shading->lamps[0];
    return shading->lamp_count == 1 && lamp->kind == GLINT_DIRECTIONAL && lamp->color[0] == 1 && lamp->color[1] == 1 &&
           lamp->color[2] == 1;
}

static struct glint_shader shader_of(const struct shading *shading, struct glint_lamp lamps[GLINT_LAMPS_MAX])
{
    struct glint_shader shader = {.format = (uint8_t)shading->format,
                                  .space = (uint8_t)shading->space,
                                  .dither = shading->dither,
                                  .clamp_peak = shading->clamp_peak};
    glint_lobe_init(&shader.lobe, shading->model, shading->n, shading->q);
    for (unsigned i = 0; i < shading->lamp_count; i++)
        if (shading_lamp(shading, i, &lamps[i]) != GLINT_OK)
            fail("the library refused light %u", i + 1);
    int32_t to_viewer[3];
    direction_integers(shading->view, to_viewer);
    if (shading_is_plain(shading))
        shader.light = lamps[0].light;
    else if (glint_vec_normalize(&shader.light.v, to_viewer) != GLINT_OK)
        fail("the viewer has no direction");
    for (unsigned k = 0; k < 3; k++) {
        shader.material.ambient_q16[k] = to_q16(shading->ambient[k]);
        shader.material.diffuse_q16[k] = to_q16(shading->diffuse[k]);
        shader.material.specular_q16[k] = to_q16(shading->specular[k]);
        shader.material.albedo[k] = shading->color[k];
    }
    return shader;
}

struct glint_shader shading_shader(const struct shading *shading)
{
    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    return shader_of(shading, lamps);
}

/* ---- drawing again and again ---- */

struct canvas {
    const struct scene *scene;
    struct glint_vec *normals;
    struct way *way; /* NULL: the exact rectangle */
};

struct canvas *canvas_new(const struct scene *scene, const struct shading *shading)
{
    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    struct canvas *canvas = allocate(1, sizeof *canvas);
    canvas->scene = scene;
    canvas->normals = scene_normals_q15(scene);
    if (shading->path) {
        const struct glint_shader shader = shader_of(shading, lamps);
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

void canvas_draw(const struct canvas *canvas, const struct shading *shading, uint8_t *pixels)
{
    enum { BAND = 8 }; /* lines */
    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    const struct glint_shader shader = shader_of(shading, lamps);
    const uint32_t height = canvas->scene->height;
    enum glint_err worst = GLINT_OK;
    sigset_t before;
    signals_hold(&before); /* the first thread alone takes them, so that they end its waiting */
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

struct levels *shade_scene(const struct scene *scene, const struct shading *shading)
{
    struct canvas *canvas = canvas_new(scene, shading);
    uint8_t *pixels =
        allocate(scene->height, format_line_bytes(shading->format, scene->width)); /* black where a mask leaves it */
    canvas_draw(canvas, shading, pixels);
    canvas_free(canvas);
    struct levels *levels = levels_of_pixels(scene->width, scene->height, shading->format, pixels);
    free(pixels);
    return levels;
}
